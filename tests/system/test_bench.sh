#!/bin/sh
# SPDX-License-Identifier: MIT
# trundle bench on a small sample: its form, never its speed. And README's example of an error is the real one.
set -u
here=$(dirname "$0")
# shellcheck source=tests/system/tap.sh
. "$here/tap.sh"
root=$(cd "$here/../.." && pwd)

"$TRUNDLE" bench --set sample.disks=60 --set shear.strain_end=0.01 >"$work/out" 2>"$work/err"
check 'it runs' equals $? 0
check 'exactly one line of the form NN.N M contact updates/s' equals "$(grep -cE '^[0-9]+\.[0-9] M contact updates/s$' "$work/out")" 1
check 'it is the last' sh -c "tail -n 1 '$work/out' | grep -q 'contact updates/s$'"
check 'with rolling, eight passes' equals "$(sed '/^without/,$d' "$work/out" | grep -c 'ns per contact')" 9
check 'without, two fewer' equals "$(sed '1,/^without/d' "$work/out" | grep -c 'ns per contact')" 7
bytes() { sed -n "s/^$1.* \([0-9]*\) bytes per disk$/\1/p" "$work/out"; }
check 'and less memory' test "$(bytes without)" -lt "$(bytes 'as given')"
check 'a case of bodies is refused' equals "$("$TRUNDLE" bench "$root/cases/pure-rolling.yaml" 2>&1)" 'error: bench needs a case of kind: biaxial'
"$TRUNDLE" bench --set sample.disks=60 --set shear.strain_end=0.05 --set boundary=periodic >"$work/out" 2>"$work/err"
check 'a periodic cell runs' equals $? 0

# ---- what features cost
"$TRUNDLE" bench --features --set sample.disks=60 --set shear.strain_end=0.4 -o "$work/features.csv" >"$work/out" 2>"$work/err"
code=$?
# A machine may be slow, but the exit code follows the printed claims. With an expensive normal law the left-out parts
# are small, and fails.
claimed() { if grep -q '^FAILED: a bare scene takes' "$1"; then echo 1; else echo 0; fi; }
check 'the exit code is that of the claims' equals $code "$(claimed "$work/out")"
"$TRUNDLE" bench --features --set sample.disks=60 --set shear.strain_end=0.05 --set contact.normal=hertz-line >"$work/expensive" 2>&1
check 'the exit code is that of the claims: an expensive normal law' equals $? "$(claimed "$work/expensive")"
check 'no array without a law that needs it' grep -q '^ok: no history array' "$work/out"
check 'a law for the other shape is named, with the reason' grep -qx 'without contact.normal=hertz-sphere: the law hertz-sphere is for spheres, .*' "$work/out"
# column N ROW: of the CSV
column() { awk -F, -v n="$1" -v row="$2" '$2 == row {print $n}' "$work/features.csv"; }
check 'features one at a time' equals "$(awk -F, '$1 == "feature" {printf "%s;", $2}' "$work/features.csv" | sed 's/every [0-9]* steps/every N steps/')" \
    'linear only;+ coulomb-spring;+ wang-spring;+ energy ledger;+ a frame every N steps;'
# "SLOT LAW" of the registry, but for those of the scene, none, and exact, which only kind: contact has.
laws() { "$TRUNDLE" laws | sed -n 's/^\([a-z]*\):$/\1/p; s/^  \([a-z-]*\) .*/  \1/p' | awk '/^[a-z]/ {slot = $1; next} {print slot, $1}'; }
laws | grep -vE ' (linear|coulomb-spring|wang-spring|none|exact)$' | sort >"$work/laws"
{
    awk -F, '$1 ~ /^(normal|friction|rolling)$/ && $2 !~ / / {print $1, $2}' "$work/features.csv"
    sed -n 's/^without contact\.\([a-z]*\)=\([a-z-]*\): .*/\1 \2/p' "$work/out"
} | sort >"$work/rows"
check 'every law of the registry is a row, or told to be left out' diff "$work/laws" "$work/rows"
check 'few are left out' test "$(grep -cE '^(normal|friction|rolling),' "$work/features.csv")" -ge 10
check 'creep by the rolling of wang is a row' grep -q '^friction,dahlberg-alfredsson (wang),' "$work/features.csv"
check 'numbers in order: quartiles about the median, above zero' awk -F, \
    'NR > 1 && !($4 > 0 && $4 <= $3 && $3 <= $5 && $6 > 0 && $7 > 0 && $8 > 0 && $9 > 0 && $10 >= 0) {print; bad = 1} END {exit bad}' "$work/features.csv"
# A block of steps changes a packing little; without friction a shear of its own would have it 16 % above the full
# one's.
check 'the same packing: touching contacts within 5 %' awk -F, '
    FNR == NR {if ($2 == "+ energy ledger") full = $8; next}
    FNR > 1 && ($8 > 1.05*full || $8 < 0.95*full) {print; bad = 1}
    END {exit bad}' "$work/features.csv" "$work/features.csv"
# Smooth walls: Q, T of the disks; the ledger's 6 of them and 2 of the walls.
arrays() { column 10 "$1"; }
check 'history arrays' equals "$(arrays 'linear only') $(arrays '+ coulomb-spring') $(arrays '+ wang-spring') $(arrays '+ energy ledger')" '0 1 2 10'
check 'what is there takes memory' sh -c "test \"\$1\" -lt \"\$2\" && test \"\$2\" -lt \"\$3\"" - \
    "$(column 9 'linear only' | cut -d. -f1)" "$(column 9 '+ wang-spring' | cut -d. -f1)" "$(column 9 '+ energy ledger' | cut -d. -f1)"
check 'the full scene is the whole' equals "$(column 6 '+ energy ledger')" 1
check 'without friction it is refused' equals "$("$TRUNDLE" bench --features --set contact.friction=none 2>&1)" \
    'error: --features needs a case with friction and rolling resistance'
check 'refused with code 2' sh -c '"$0" bench --features --set contact.rolling=none; test $? -eq 2' "$TRUNDLE"
check 'a table of nothing is refused' sh -c '"$0" bench -o "$1"; test $? -eq 2' "$TRUNDLE" "$work/none.csv"

# ---- cost against the number of disks
"$TRUNDLE" bench --sizes 4000 --set compaction.inertial_number=0.1 --set compaction.unbalanced=1e-2 --set shear.inertial_number=8e-3 \
    -o "$work/sizes.csv" >"$work/out" 2>"$work/err"
check '--sizes runs' equals $? 0
check 'every size up to the largest' equals "$(awk -F, 'NR > 1 {printf "%s ", $1}' "$work/sizes.csv")" '100 200 400 1000 4000 '
check 'quartiles about the median, shares below 1' awk -F, \
    'NR > 1 && !($3 > 0 && $3 <= $2 && $2 <= $4 && $6 > 0 && $6 <= $5 && $5 <= $7 && $12 > 0 && $12 < 1 && $13 > 0) {print; bad = 1}
    END {exit bad}' "$work/sizes.csv"
# In each cycle; medians may be of two cycles, of different speed while the machine does other things too. So the
# quartiles overlap, with 10 % for the contacts, which are a mean.
check 'time of a step is that of its contacts' awk -F, \
    'NR > 1 && (0.9*$3/$8*1e3 > $7 || 1.1*$4/$8*1e3 < $6) {print; bad = 1} END {exit bad}' "$work/sizes.csv"
check 'a line with the slope' grep -qE '^time of a step ~ N\^[0-9.]+ for N = 1000 to 4000$' "$work/out"
check 'too few disks are refused' sh -c '"$0" bench --sizes 99; test $? -eq 2' "$TRUNDLE"

# ---- the same packing in LAMMPS
peers=$root/tests/bench
mkdir "$work/packing"
"$TRUNDLE" bench --packing "$work/packing" --set sample.disks=60 --set contact.mu_r=0.25 >"$work/out" 2>"$work/err"
check '--packing runs' equals $? 0
# density x sphere of LAMMPS against 2700 kg/m^3 x pi R^2 x 1 m
check 'masses are those of disks' awk 'NF == 7 && /^[0-9]/ && $3 > 0 && $4 > 1000 {
        n++; R = $3/2; m = $4*4/3*3.14159265358979*R^3/(2700*3.14159265358979*R^2); if (m > 1 + 1e-9 || m < 1 - 1e-9) bad = 1
    } END {exit bad || n != 60}' "$work/packing/packing.data"
check 'some disks are held, some not' equals "$(awk 'NF == 7 && $4 > 1000 {type[$2] = 1} END {print type[1] type[2]}' "$work/packing/packing.data")" 11
check 'parameters are those of the case' equals "$(awk '/k_n|mu_r|k_t/ {printf "%s %g ", $2, $4}' "$work/packing/packing.lmp")" \
    'k_n 1.6e+08 k_t 8e+07 mu_r 0.25 '
# alpha(e) of Tsuji in the form in which LAMMPS prints it; 2 zeta = 0.6
check 'restitution for the damping ratio' awk '/variable e / {e = $4; a = 1.2728 - 4.2783*e + 11.087*e^2 - 22.348*e^3 + 27.467*e^4 - 18.022*e^5 + 4.8218*e^6}
    END {print a; exit !(a > 0.6 - 1e-9 && a < 0.6 + 1e-9)}' "$work/packing/packing.lmp"
check 'a law that LAMMPS does not have is refused' sh -c '"$0" bench --packing "$1" --set contact.normal=hertz-line; test $? -eq 2' "$TRUNDLE" "$work/packing"
made_up() {
    echo 'repeat,code,law,us_per_step,touching,kinetic,spinning,xx,yy,touching_end'
    for repeat in 1 2 3; do
        echo "$repeat,trundle,off,$repeat,700,1,1,100,200,700"
        echo "$repeat,lammps-gran,off,$((repeat * repeat + 4)),700,1,1,100,$1,700"
    done
}
made_up 200.1 >"$work/made-up.csv" # times 1 2 3 and 5 8 13: ratios 5, 4, 13/3
check 'ratio of the times, repeat by repeat' sh -c 'awk -f "$0" "$1" | grep -qF ", 4.33 (4.33 to 5.00) times trundle"' "$peers/peers.awk" "$work/made-up.csv"
made_up 210 >"$work/made-up.csv"
check 'other stresses are other work' not awk -f "$peers/peers.awk" "$work/made-up.csv"
mkdir "$work/none"
for tool in sh dirname; do ln -s "$(command -v "$tool")" "$work/none/"; done
check 'without LAMMPS it says so' equals "$(PATH=$work/none "$peers/peers.sh" "$TRUNDLE" "$work/peers.csv" && echo done)" \
    "no LAMMPS here (apt-get install lammps): nothing compared
done"
if command -v lmp >/dev/null 2>&1; then
    check 'LAMMPS does the same work' "$peers/peers.sh" "$TRUNDLE" "$work/peers.csv" 1
else
    skip 'LAMMPS does the same work' 'no lammps here'
fi

# cases/README.md lists what a check can measure of a contact and of a disk, as `run --keys` does.
for of in contact disk; do
    listed=$("$TRUNDLE" run --keys bodies | sed -n "s/^| \`$of\` .*(for \`what: \(.*\)\`).*/\1/p" | sed 's/, /`, `/g')
    check "README lists what a check can measure of a $of" grep -qF "| \`$of\` | \`$listed\` |" "$root/cases/README.md"
done

# cases/README.md shows a mistake in cases/biaxial.yaml and what the tool says of it.
mkdir "$work/cases"
sed 's/^  mu_r:/  mu_R:/' "$root/cases/biaxial.yaml" >"$work/cases/biaxial.yaml"
(cd "$work" && "$TRUNDLE" run cases/biaxial.yaml --check) >/dev/null 2>"$work/said"
while IFS= read -r line; do
    check "README shows: $line" grep -qF "    $line" "$root/cases/README.md"
done <"$work/said"
finish
