#!/bin/sh
# SPDX-License-Identifier: MIT
# What a run writes: which files, their headers and keys, the same bytes every time, and what --force may touch.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
cases=$PWD/cases
cd "$work" || exit 1
write_small_case small.yaml
write_bodies_case bodies.yaml

# ---- the cases that are shipped ----
for case in "$cases"/*.yaml; do
    case $case in */sweep*) continue ;; esac # no case, but many
    check "run --check passes $(basename "$case")" run_gives 0 --check "$case"
done
check 'run --check writes nothing' not test -e out

# ---- which files ----
# What needs gnuplot or ffmpeg is listed only where they are.
expected() {
    echo case.yaml
    [ "$1" = biaxial ] && command -v gnuplot >/dev/null && printf '%s\n' biaxial.svg biaxial.png
    [ "$1" = biaxial ] && command -v gnuplot >/dev/null && echo plot.gp
    [ "$1" = biaxial ] && echo disks.csv
    [ "$2" -gt 0 ] && command -v ffmpeg >/dev/null && printf '%s\n' "$1.mp4" "$1.gif"
    [ "$1" = bodies ] && [ "$2" -gt 0 ] && echo still.png
    i=0
    while [ "$i" -lt "$2" ]; do
        printf 'frames/%05d.png\n' "$i"
        i=$((i + 1))
    done
    printf '%s\n' contacts.csv history.csv summary.json
}
writes() { # KIND FRAMES DIR
    expected "$1" "$2" | sort >wanted
    listing "$3" | diff wanted -
}
check 'a biaxial test runs' run_gives 0 small.yaml -o plain
check 'it writes these files and no other' writes biaxial 0 plain
check 'without frames there is no directory for them' not test -e plain/frames
check 'with two frames it runs' run_gives 0 small.yaml -o framed --frames 2
check 'and writes these files' writes biaxial 2 framed
check 'frames change no number' cmp plain/history.csv framed/history.csv
check 'without curves it runs' run_gives 0 small.yaml -o bare-biaxial --frames 2 --set output.curves=no
check 'and draws none' equals "$(listing bare-biaxial)" "$(listing framed | grep -v '^biaxial.[sp]\|gp$')"
check 'its numbers are the same' cmp plain/history.csv bare-biaxial/history.csv
check 'with increments it runs' run_gives 0 small.yaml -o increments --set output.increments=yes
same_and_more() { cut -d, -f "1-$(head -n 1 plain/history.csv | tr , '\n' | wc -l)" increments/history.csv | cmp - plain/history.csv; }
check 'they change no number' same_and_more
check 'and are a pass of their own' grep -q '"increments"' increments/summary.json
check 'which is there only when asked for' not grep -q '"increments"' plain/summary.json
check 'bodies run' run_gives 0 bodies.yaml -o bodies --frames 3
check 'and write these files' writes bodies 3 bodies
check "one frame" run_gives 0 bodies.yaml -o one --frames 1
is_png() { [ "$(head -c 8 "$1" | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a ]; }
check 'a frame is a PNG' is_png framed/frames/00001.png
check 'without -o results go to out/ and the name of the case' run_gives 0 bodies.yaml
check 'there they are' test -e out/bodies/summary.json

# ---- no number: an empty cell, null, no word ----
# A cell that is pulled apart faster than its stress can follow, and a wheel that creeps over a rolling of 0.
run small.yaml -o wild --set boundary=periodic --set shear.lateral_pressure=0.1 --set shear.inertial_number=1 \
    --set contact.mu=10 --set shear.strain_end=0.009 --set output.rows=400 --set output.increments=yes
cat stdout stderr >wild/said
cat >still.yaml <<'CASE'
kind: bodies
time_end: 1 ms
contact: {k_n: 1 MPa, mu: 0.5, mu_r: 0.1}
disks: [{radius: 10 mm, x: 0, y: 9.99 mm, motion: prescribed}]
walls: [{nx: 0, ny: 1}]
checks:
  - {what: creepage, contact: wall0-0, exact: 1, tolerance: 1}
  - {what: energy-lost, disk: 0, exact: 0, tolerance: 1}
CASE
run still.yaml -o still
cat stdout stderr >still/said
check 'a check that has no number fails' equals "$code" 1
check 'and says that there is none' says still/said 'creepage               wall0-0: never happened, exact 1, allowed 1.0e+00: FAILED'
check 'its number is null' equals "$(grep -c '"measured": null' still/summary.json)" 2
check 'no output says nan or inf' is_silent grep -rnwiE -- '-?(nan|inf)' wild still
# sin phi beyond 1: a stress pulls. Else tan phi = (s1 - s2)/(2 sqrt(s1 s2)), to the nine digits of the stresses over 1
# - sin phi
angles() {
    awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
             { s1 = $column["stress_1_Pa"]; s2 = $column["stress_2_Pa"]; phi = $column["sin_phi"]; t = $column["tan_phi"] }
             phi^2 >= 1 { none++; if (t != "") { print "tan phi for sin phi " phi; bad = 1 } }
             phi^2 < 0.99 && s1 + s2 > 0 {
                 some++; d = t - (s1 - s2)/(2*sqrt(s1*s2))
                 if (t == "" || d*d > 1e-12) { print "tan phi " t " for " s1 ", " s2; bad = 1 }
             }
             END { if (!none || !some) print none + 0 " without, " some + 0 " with"; exit bad || !none || !some }' wild/history.csv
}
check 'tan phi where there is one, and else an empty cell' angles

# ---- a contact along a path ----
contact_files() {
    printf '%s\n' case.yaml contact.csv
    command -v gnuplot >/dev/null && printf '%s\n' contact.png contact.svg plot.gp
    echo summary.json
}
check 'a contact runs' run_gives 0 "$cases/contact-reversal.yaml" -o contact
check 'it writes these files' equals "$(listing contact)" "$(contact_files)"
check 'curves only where they are wanted' run_gives 0 "$cases/contact-reversal.yaml" -o bare --set output.curves=no
check 'it writes these files' equals "$(listing bare)" "$(contact_files | grep -v 'png$\|svg$\|gp$')"
check 'the header of contact.csv' equals "$(head -n 1 contact/contact.csv)" \
    'law,step,segment,u_slide_m,u_roll_m,P_N_per_m,Q_N_per_m,q,a_m,moment_1_N,moment_2_N,f_r_N_per_m,overlap_m,R1,R2,x1x,x1y,x2x,x2y,v1x,v1y,v2x,v2y,w1,w2,dt_s'
# Another code that is moved so goes the same path: of each law the sums of its velocities are the ways, to rounding.
moves() { awk -F, 'NR > 1 {
        k = $1; slide[k] += ($14*$24 + $15*$25)*$26; roll[k] += ($15*$25 - $14*$24)/2*$26
        gap = $18 + $13 - $14 - $15; if (k in x) x[k] += $22*$26; else x[k] = $18
        off = slide[k] - $4; if (off*off > 1e-30) bad = 1
        off = roll[k] - $5; if (off*off > 1e-30) bad = 1
        if (gap*gap > 1e-30 || (x[k] - $18)^2 > 1e-30) bad = 1; n++ }
    END { exit bad || n < 100 }' contact/contact.csv; }
check 'places, velocities and spins are those of the path' moves
check 'a row for each law and step' equals "$(($(wc -l <contact/contact.csv) - 1))" 3200
within() { awk -F, 'NR > 1 && !($8 >= -1 - 1e-15 && $8 <= 1 + 1e-15 && $8*$7 >= 0) { print; bad = 1 } END { exit bad }' contact/contact.csv; }
check 'friction within its bound' within
check 'it has no frames' run_gives 2 "$cases/contact-reversal.yaml" -o no --frames 2
check 'and says so' says stderr '`output.frames` is not for `kind: contact`; allowed here: curves'
check 'a law that depends on the rate is not guessed at' run_gives 2 "$cases/contact-reversal.yaml" -o no --check \
    --set laws.0.rolling=star-displacement-damping --set laws.0.damping=yes --set bodies.density=2700
check 'it asks for the time' says stderr '`path.0.time` is missing: rolling law star-displacement-damping of `laws.0` depends on the rate'

# ---- inside a contact ----
cat >patch.yaml <<'EOF'
kind: patch
bodies: {R1: 10 mm, R2: 10 mm, E: 70 GPa, nu: 0.3}
mu: 0.3
elements: 20
path:
  - {force: 10 kN/m, tangential: 0.6*mu*P, steps: 10}
  - {force: P, tangential: 0.6*mu*P, roll: a, steps: 10}
output: {frames: 3, snapshots: 4}
EOF
check 'the inside of a contact runs' run_gives 0 patch.yaml -o patch
patch_files() {
    printf '%s\n' case.yaml contact.csv
    command -v gnuplot >/dev/null && printf '%s\n' contact.png contact.svg
    printf '%s\n' frames/00000.png frames/00001.png frames/00002.png patch.csv
    command -v ffmpeg >/dev/null && printf '%s\n' patch.gif patch.mp4
    command -v gnuplot >/dev/null && echo plot.gp
    echo summary.json
}
check 'it writes these files' equals "$(listing patch)" "$(patch_files)"
check 'without curves it runs' run_gives 0 patch.yaml -o bare-patch --set output.curves=no
check 'and draws none' equals "$(listing bare-patch)" "$(patch_files | grep -v '^contact.[sp]\|gp$')"
check 'its contact.csv is that of laws, and four columns' equals "$(head -n 1 patch/contact.csv)" \
    "$(head -n 1 contact/contact.csv | sed 's/,R1,/,p_max_Pa,stick_m,creepage,dissipated_J_per_m&/')"
check 'a row for each step' equals "$(($(wc -l <patch/contact.csv) - 1))" 20
check 'the header of patch.csv' equals "$(head -n 1 patch/patch.csv)" 'snapshot,step,x_m,p_Pa,tau_Pa,slip_m,stick'
check 'a row for each element and snapshot' equals "$(($(wc -l <patch/patch.csv) - 1))" 80
coulomb() { awk -F, 'NR > 1 && ($5*$5 > 0.09*$4*$4*(1 + 1e-9) || ($7 && $6 != 0) || $6*$5 < 0) { print; bad = 1 } END { exit bad }' patch/patch.csv; }
check 'friction within its bound, no slip where it sticks, slip along traction' coulomb
check 'the same bits again' sh -c '"$0" run patch/case.yaml -o patch-again >/dev/null && cmp patch/patch.csv patch-again/patch.csv' "$TRUNDLE"
check 'a path from a file' sh -c 'sed "/path:/,\$d" patch.yaml >file.yaml && echo "path: patch/contact.csv" >>file.yaml &&
    "$0" run file.yaml -o file --set output.frames=0 >/dev/null && test "$(wc -l <file/contact.csv)" -eq 21' "$TRUNDLE"

# ---- tables ----
begins() {
    head -n 1 "$1" | grep -q "^$2" || { head -n 1 "$1"; false; }
}
check 'header of history.csv' begins plain/history.csv \
    'strain,stress_1_Pa,stress_2_Pa,sin_phi,void_ratio,n_contacts,coordination,sliding_fraction,rolling_share,opposed_fraction,'
check 'header of contacts.csv' begins plain/contacts.csv 'time_s,strain,a,b,x_m,y_m,'
for column in f_n_N_per_m f_t_N_per_m moment_a_N v_s_m_per_s v_r_m_per_s mobilisation v_r_bagi_kuhn_m_per_s v_s_full_radius_m_per_s; do
    check "contacts.csv has $column" sh -c "head -n 1 plain/contacts.csv | tr , '\n' | grep -qx $column"
done
check 'header of disks.csv' begins plain/disks.csv 'time_s,disk,x_m,y_m,angle_rad,'
# Each disk once; the ends of disk-disk contacts are two and of wall-disk contacts one, as contacts.csv lists them.
ends() { awk -F, 'FNR == 1 {next} FILENAME ~ /disks/ {n++; ends -= $12; next} {ends += $3 < 0 ? 1 : 2} END {exit !(n == 60 && ends == 0)}' "$@"; }
check 'a row for each disk, with its contacts' ends plain/disks.csv plain/contacts.csv
check 'rows as asked' equals "$(($(wc -l <plain/history.csv) - 1))" 20
# Every line as many cells as the header, every cell a finite number.
is_table() {
    awk -F, 'NR == 1 { n = NF; next }
        NF != n { print "line " NR ": " NF " cells, not " n; bad = 1 }
        { for (i = 1; i <= NF; i++) if ($i !~ /^-?[0-9.]+(e[-+][0-9]+)?$/) { print "line " NR ": " $i; bad = 1 } }
        END { exit bad || NR < 2 }' "$1"
}
for table in plain/history.csv increments/history.csv plain/contacts.csv plain/disks.csv bodies/history.csv bodies/contacts.csv contact/contact.csv; do
    check "$table holds finite numbers only" is_table "$table"
done
# A hyphen is a minus to pandas, R and csvgrep.
identifiers() { head -qn 1 "$@" | tr , '\n' | grep -vE '^[A-Za-z][A-Za-z0-9_]*$'; }
check 'column names are identifiers' not identifiers plain/*.csv increments/*.csv bodies/*.csv contact/*.csv patch/*.csv
ends_at() { # the last strain is the asked one, overshot by less than a step
    awk -F, 'END { exit !($1 >= 0.01 && $1 < 0.0101) }' "$1"
}
check 'the last row is at the end of the test' ends_at plain/history.csv
check 'three instants of contacts, the last at the end' run_gives 0 small.yaml -o three --set output.contacts=3
check 'they are three' equals "$(tail -n +2 three/contacts.csv | cut -d, -f1 | sort -u | wc -l)" 3
check 'disks too' equals "$(tail -n +2 three/disks.csv | cut -d, -f1 | uniq -c | wc -l)" 3
check 'no contacts asked, no table' run_gives 0 small.yaml -o none --set output.contacts=0
check 'it is not there' not test -e none/contacts.csv -o -e none/disks.csv

# ---- summary.json ----
keys='version seed n_disks e0 e_residual sin_phi_peak sin_phi_residual rolling_share_residual opposed_fraction_residual inertial_number stiffness_ratio dt_s steps
contact_updates energy_residual_over_work passes left_out timing'
for key in $keys; do check "summary.json has $key" grep -q "\"$key\":" plain/summary.json; done
check 'timing has wall_s' says plain/summary.json '"wall_s":'
check 'timing has contact_updates_per_s' says plain/summary.json '"contact_updates_per_s":'
if command -v jq >/dev/null; then
    check 'summary.json is JSON' jq -e . plain/summary.json
    check 'its numbers are numbers' jq -e '.n_disks == 60 and .seed == 3 and (.["e0"] | type) == "number" and
        .["e0"] > 0.1 and .["e0"] < 0.4 and .stiffness_ratio == 1000 and .inertial_number == 0.002' plain/summary.json
    check 'nothing is null' jq -e '[.. | select(. == null)] | length == 0' plain/summary.json
else
    for what in 'summary.json is JSON' 'its numbers are numbers' 'nothing is null'; do skip "$what" 'no jq'; done
fi

# ---- energy that a law makes ----
sed 's/mu_r: 0.5/mu_r: 2, k_r: 10*k_t, rolling_velocity: alonso-min/' small.yaml >made.yaml
check 'a run whose rolling law makes energy' run_gives 0 made.yaml -o made
check 'says so in plain words' says stderr 'note: the rolling law wang-spring made energy: '
check 'and why' says stderr 'its moments do not fit the rolling_velocity'
check 'one that makes none says nothing' run_gives 0 small.yaml -o none-made
check 'nothing at all' not grep -q 'made energy' stderr
# The last column of history.csv against summary.json: 9 digits against 15.
rolling_made() {
    json=$(sed -n '/"rolling": {/,/}/s/.*"made_J_per_m": \([^,]*\).*/\1/p' made/summary.json)
    awk -F, -v json="$json" '
        NR == 1 {for (i = 1; i <= NF; i++) n[$i] = i; next} {made = $n["rolling_made_J_per_m"]; net = $n["rolling_J_per_m"]}
        END {print made, net, json; exit !(made > 0 && made >= -net && (made - json)^2 < 1e-16*made^2)}' made/history.csv
}
check 'summary.json and history.csv agree on how much' rolling_made
check 'a sweep can collect it' says made/summary.json '"made_over_work":'
check 'without the ledger' run_gives 0 made.yaml -o no-ledger --set output.energy=no
check 'nothing is said of energy' not grep -q '"energy[_"]' no-ledger/summary.json
check 'neither on the way' not grep -q 'made energy' stderr
check 'also not in history.csv' not grep -q 'J_per_m' no-ledger/history.csv

# ---- the same bytes ----
without_timing() { sed '/"timing"/,/}/d' "$1"; }
same() { # DIR DIR: all but the timing, the curves that gnuplot drew from the same numbers included
    for file in $(listing "$1"); do
        case $file in
        summary.json)
            without_timing "$1/$file" >left
            without_timing "$2/$file" | cmp left - || return 1
            ;;
        *) cmp "$1/$file" "$2/$file" || return 1 ;;
        esac
    done
    listing "$1" >left
    listing "$2" | diff left -
}
check 'the same case again' run_gives 0 small.yaml -o again --frames 2
check 'gives the same bytes' same framed again
check 'the resolved case' run_gives 0 framed/case.yaml -o resolved
check 'gives the same bytes' same framed resolved
check 'the contact again' run_gives 0 "$cases/contact-reversal.yaml" -o contact --force
check 'and its resolved case' run_gives 0 contact/case.yaml -o contact2
check 'give the same bytes' same contact contact2
check 'the resolved case of bodies' run_gives 0 bodies/case.yaml -o bodies2
check 'gives the same numbers' cmp bodies/history.csv bodies2/history.csv
check '--frames is --set output.frames' run_gives 0 small.yaml -o set --set output.frames=2
check 'same bytes' same framed set
check '--seed' run_gives 0 small.yaml -o seed --seed 4
check '--set seed' run_gives 0 small.yaml -o seed2 --set seed=4
check 'same bytes' same seed seed2
check 'another seed, another sample' not cmp -s plain/history.csv seed/history.csv
check 'the seed is in the summary' says seed/summary.json '"seed": 4'
check 'the last --set wins' run_gives 0 small.yaml -o last --seed 9 --seed 4
check 'same bytes' same seed last
check 'the largest seed' run_gives 0 small.yaml -o large --seed 18446744073709551615
check 'comes through whole' says large/summary.json 18446744073709551615

# ---- a finished run and --force ----
before=$(cat framed/* framed/frames/* 2>/dev/null | cksum)
check 'a finished run is refused' run_gives 3 small.yaml -o framed
check 'the message names --force' says stderr '--force'
check 'nothing changed' equals "$(cat framed/* framed/frames/* 2>/dev/null | cksum)" "$before"
check 'five frames' run_gives 0 bodies.yaml -o forced --frames 5
echo mine >forced/notes.txt
echo mine >forced/frames/7.png
touch forced/history.csv.part forced/frames/00003.png.part
check 'then two with --force' run_gives 0 bodies.yaml -o forced --frames 2 --force
check 'stale frames and parts are gone' equals "$(ls forced/frames | tr '\n' ' ')" '00000.png 00001.png 7.png '
check 'no part is left' no_parts forced
check 'foreign files are as they were' equals "$(cat forced/notes.txt forced/frames/7.png)" 'mine
mine'
check 'then none' run_gives 0 bodies.yaml -o forced --force
check 'the foreign file in frames/ is still there' equals "$(ls forced/frames)" 7.png
check 'a stale film and GIF are gone' is_silent find forced -name 'bodies.*'
rm forced/summary.json
check 'an unfinished run is replaced without --force' run_gives 0 bodies.yaml -o forced
mkdir own
cp bodies.yaml own/case.yaml
check 'a case is not written over by its own run' run_gives 3 own/case.yaml -o own --force
check 'it is as it was' cmp bodies.yaml own/case.yaml
check 'nothing else is written' equals "$(ls own)" case.yaml

# ---- more asked than there are steps ----
check 'more rows than steps' run_gives 0 small.yaml -o few --set shear.strain_end=2e-5 --set output.contacts=1000 --frames 50
check 'is said' says stderr 'note: the run has only'
steps=$(sed -n 's/.*"steps": \([0-9]*\).*/\1/p' few/summary.json)
check 'a row for each step and the start' equals "$(($(wc -l <few/history.csv) - 1))" "$((steps + 1))"
check 'a frame for each' equals "$(ls few/frames | wc -l)" "$((steps + 1))"
check 'contacts at each step' equals "$(tail -n +2 few/contacts.csv | cut -d, -f1 | sort -u | wc -l)" "$steps"
check 'a table of contacts that never touch' run_gives 0 bodies.yaml -o apart --set gravity.y=0 --set disks.0.y=20mm
check 'has its header' begins apart/contacts.csv 'time_s,a,b,'
finish
