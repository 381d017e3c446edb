#!/bin/sh
# SPDX-License-Identifier: MIT
# trundle converge: the errors that it reports hold the true ones, where those are known in closed form; it goes on where
# it was stopped; it keeps to its budget; what is wrong is told.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
root=$PWD
cd "$work" || exit 1
# All programs but gnuplot: pictures would take most of the time; one case below has them.
everything=$PATH
mkdir bin
for folder in $(echo "$PATH" | tr : ' '); do ln -s "$folder"/* bin/ 2>/dev/null; done
rm -f bin/gnuplot*
PATH=$work/bin

# converge_gives CODE ARGUMENTS...
converge_gives() {
    wanted=$1
    shift
    "$TRUNDLE" converge "$@" >stdout 2>stderr </dev/null
    code=$?
    [ "$code" -eq "$wanted" ] || { echo "exit code $code, not $wanted"; cat stdout stderr; false; }
}
# refused TEXT ARGUMENTS...: code 2, and a message with the text
refused() {
    text=$1
    shift
    converge_gives 2 "$@" && says stderr "$text"
}
# column DIR NUMBER CAUSE COLUMN: a cell of converge.csv
column() {
    awk -F, -v number="$2" -v cause="$3" -v name="$4" '
        NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) k = i }
        $1 == number && $2 == cause { print $k }' "$1/converge.csv"
}
# holds DIR NUMBER CAUSE EXACT [MOST]: the value is within its error of the exact one, the limit within its own, and the
# error is at most MOST times the true one
holds() {
    awk -v v="$(column "$1" "$2" "$3" value)" -v e="$(column "$1" "$2" "$3" error)" -v exact="$4" -v most="${5:-1e9}" \
        -v l="$(column "$1" "$2" "$3" limit)" -v u="$(column "$1" "$2" "$3" limit_error)" '
        function abs(x) { return x < 0 ? -x : x }
        BEGIN {
            print "value", v, "error", e, "limit", l, "unsure", u, "exact", exact
            exit !(e != "" && abs(v - exact) <= e && abs(l - exact) <= u && e <= most * abs(v - exact))
        }'
}
between() { awk -v x="$1" -v low="$2" -v high="$3" 'BEGIN { print x; exit !(x != "" && x >= low && x <= high) }'; }

# ---- true errors ----
# An oscillator on a spring: v0 |cos wt|. Leapfrog is of second order; here sqrt(k/m) T = 6.5.
cat >spring.yaml <<'CASE'
kind: bodies
gravity: {y: -9.81 m/s^2}
time_end: 20 ms
contact: {k_n: 1 MPa, damping_ratio: 0, friction: none, rolling: none}
disks:
  - {radius: 50 mm, density: 1200, x: 0, y: radius - density*pi*radius^2*9.81 m/s^2/contact.k_n, vy: 1 mm/s}
walls: [{nx: 0, ny: 1}]
checks: [{what: speed, disk: 0, at: 20 ms, exact: 1 mm/s, tolerance: 1 mm/s}]
CASE
spring=$(awk 'BEGIN { pi = atan2(0, -1); printf "%.12g", 1e-3 * cos(sqrt(1e6 / (1200 * pi * 0.05 ^ 2)) * 0.02) }')
check 'an oscillator runs' converge_gives 0 spring.yaml -o spring -j 2
check 'its reported error holds the true one, and is at most twice that' holds spring checks.0.measured step "$spring" 2
check 'the order of leapfrog is seen: 2' between "$(column spring checks.0.measured step order)" 1.9 2.1
check 'and told' says stdout 'Order 1.9'

# Two disks that stick: the tangential rebound, cos(pi sqrt(3 k_t/k_n)), depends on when the contact ends, which is between
# two steps.
cat >oblique.yaml <<'CASE'
kind: bodies
time_end: 3 ms
contact: {k_n: 1 MPa, damping_ratio: 0, friction: coulomb-spring, mu: 100, k_t: 0.2*k_n, rolling: none}
disks:
  - {radius: 10 mm, density: 1000, x: 0, y: 0, vx: 10 um/s, vy: -3 um/s}
  - {radius: 10 mm, density: 1000, x: 20.000002 mm, y: 0, vx: -10 um/s, vy: 3 um/s}
checks: [{what: spin, disk: 0, at: 3 ms, exact: 3e-4, tolerance: 1}]
CASE
spin=$(awk 'BEGIN { pi = atan2(0, -1); printf "%.12g", 2 / 3 * (1 - cos(pi * sqrt(0.6))) * 3e-6 / 0.01 }')
for gap in 2 2.5 3.7 5.1; do
    sed "s/20.000002/20.00000$(echo "$gap" | tr -d .)/" oblique.yaml >gap.yaml
    check "an oblique impact runs, gap $gap" converge_gives 0 gap.yaml -o "oblique-$gap" -j 2
    check 'its reported error holds the true one' holds "oblique-$gap" checks.0.measured step "$spin"
done
check 'an impact has no order: where it ends falls between two steps' \
    not equals "$(column oblique-2 checks.0.measured step verdict)" order

# Free flight has no error of the step: leapfrog is exact for a constant force.
cat >flight.yaml <<'CASE'
kind: bodies
gravity: {y: -9.81 m/s^2}
time_end: 20 ms
contact: {k_n: 1 MPa, friction: none, rolling: none}
disks: [{radius: 50 mm, density: 1200, x: 0, y: 0, vx: 1 m/s}]
CASE
check 'a flight runs' converge_gives 0 flight.yaml -o flight -j 2
check 'an exact integrator has no error but rounding' \
    between "$(column flight history.0.vx_m_per_s@end step error)" 0 1e-12
check 'with gravity too: g t' between "$(column flight history.0.vy_m_per_s@end step value)" -0.1962001 -0.1961999
check 'it is said that no number varies' says stdout 'No number changes with any setting'

# ---- a path ----
cat >path.yaml <<'CASE'
kind: contact
bodies: {R1: 10 mm, R2: 10 mm, E: 70 GPa, nu: 0.3}
laws:
  - {friction: dahlberg-alfredsson, mu: 0.3, k_t: pi*E_star/11.4}
  - {friction: dahlberg-alfredsson, mu: 0.3, k_t: pi*E_star/11.4, step: exact}
  - {friction: coulomb-spring, mu: 0.3, k_t: pi*E_star/11.4}
path: [{force: 10 kN/m, slide: 0.1 um, roll: 2*a, steps: 40}]
CASE
check 'a path runs' converge_gives 0 path.yaml -o path -j 2
check 'backward Euler is of first order' between "$(column path laws.0.Q_end_N_per_m step order)" 0.9 1.1
check 'the exact step of a law has no error' between "$(column path laws.1.Q_end_N_per_m step error)" 0 1e-6
check 'nor has a spring' between "$(column path laws.2.Q_end_N_per_m step error)" 0 1e-6
exact=$(column path laws.1.Q_end_N_per_m step value)
check 'backward Euler goes to the exact step' holds path laws.0.Q_end_N_per_m step "$exact" 2
Q_end=$(column path laws.0.Q_end_N_per_m step value)
check 'a cell of the table, at the end of the first segment' \
    converge_gives 0 path.yaml -o path --of contact.0.Q_N_per_m@1 -j 2
check 'is the number at the end' equals "$(column path contact.0.Q_N_per_m@1 step value)" "$Q_end"

# The bed of a law keeps 16 breakpoints. A path that needs more merges some; one that needs fewer has no such cause.
sed '/dahlberg/d; s/coulomb-spring/cattaneo-mindlin/; s/, k_t: pi.E_star.11.4//; /^path/d' path.yaml >bed.yaml
cat >>bed.yaml <<'CASE'
path:
  - {force: 10 kN/m, slide: 0.1 um, steps: 40}
  - {force: 20 kN/m, slide: -0.06 um, roll: 0.3*a, steps: 40}
  - {force: 35 kN/m, slide: 0.02 um, roll: 0.3*a, steps: 40}
CASE
sed '$d' bed.yaml | sed '$d' >short.yaml
causes() { awk -F, 'NR > 1 { print $2 }' "$1/converge.csv" | sort -u | tr '\n' ' '; }
check 'a bed that merges' converge_gives 0 bed.yaml -o bed -j 2 --budget 20s
check 'has that cause' equals "$(causes bed)" 'merging step '
differs() { awk -F, '$1 == "laws.0.Q_end_N_per_m" && $2 == "merging" { print $3, $5 }' bed/levels.csv | awk '
    { print; if (NR == 1) first = $2 } END { exit !(NR == 5 && first != $2 && $1 == 16) }'; }
check 'with 4 breakpoints its answer is another one than with 16' differs
check 'a bed that does not' converge_gives 0 short.yaml -o short -j 2 --budget 20s
check 'has it not' equals "$(causes short)" 'step '

# ---- what it leaves ----
files='comment.txt
converge.csv
converge.md
levels.csv'
left() { (cd spring && find . -maxdepth 1 \( -name '*.csv' -o -name '*.md' -o -name comment.txt \) | sed 's|./||' | sort); }
check 'tables, text and a comment' equals "$(left)" "$files"
check 'without gnuplot it says so' says spring/converge.md 'gnuplot is not installed'
PATH=$everything
if command -v gnuplot >/dev/null; then
    check 'with it: the same command' converge_gives 0 spring.yaml -o spring -j 2
    check 'pictures' test -s spring/converge-time.png -a -s spring/converge-time.svg -a -s spring/converge-parts.png
else
    skip 'pictures' 'no gnuplot'
fi
PATH=$work/bin
check 'the comment can stand in the case' sh -c "cat spring.yaml spring/comment.txt >commented.yaml"
check 'which is the same case' run_gives 0 commented.yaml --check
stamps() { find "$1/points" -name summary.json -exec ls -l --time-style=full-iso {} + | sort; }
before=$(stamps spring)
check 'again: nothing runs' converge_gives 0 spring.yaml -o spring -j 2
check 'indeed' equals "$(stamps spring)" "$before"
a_level() {
    "$TRUNDLE" sweep spring/sweeps/step1.yaml -o spring/points >stdout 2>stderr &&
        says stdout '1: 1 finished before'
}
check 'a level is a sweep' a_level
rm -rf spring/points/safety=0.05
check 'a run that is gone is made again' converge_gives 0 spring.yaml -o spring -j 2
check 'to the same answer' holds spring checks.0.measured step "$spring" 2

# ---- comments in cases, as make converge writes them ----
comments() { "$root/figures/converge/comments.sh" "$TRUNDLE" "$work/out" 60s "$work/shipped.yaml"; }
blocks() { grep -c '^# --- What the numbers are good to' shipped.yaml; }
cp spring.yaml shipped.yaml
mkdir out
check 'a block of comment is added' comments
cp shipped.yaml first.yaml
check 'and replaced' comments
check 'there is one' equals "$(blocks)" 1
check 'the same' cmp shipped.yaml first.yaml
check 'all else is as it was' equals "$(head -n "$(wc -l <spring.yaml)" shipped.yaml)" "$(cat spring.yaml)"

# ---- stopped ----
sed 's/steps: 40/steps: 400000/' path.yaml >long.yaml
stopped() {
    "$TRUNDLE" converge long.yaml -o long -j 2 >stdout 2>stderr </dev/null &
    pid=$!
    sleep 2
    kill -INT "$pid"
    wait "$pid"
    equals $? 130 && says stderr 'the same command goes on'
}
check 'Ctrl-C: 130' stopped

# ---- a sample ----
write_small_case small.yaml
sed -i 's/disks: 60/disks: 40/; s/unbalanced: 1e-2/unbalanced: 0.05/; s/number: 2e-3/number: 0.9/' small.yaml
check 'a plan runs nothing' converge_gives 0 small.yaml -o plan --plan
check 'and names causes, keys and times' says stdout '| compaction | compaction.unbalanced |'
check 'no directory' not test -e plan
check 'a biaxial test' converge_gives 0 small.yaml -o small -j 2 --budget 60s
check 'a cause for each setting, and the sample' \
    equals "$(awk -F, '$1 == "sin_phi_peak" { print $2 }' small/converge.csv | tr '\n' ' ')" \
    'step inertia stiffness compaction size sample '
check 'a level that no case can have is named, and the others go on' says stdout 'shear.inertial_number = 1.8: '
check 'the power is told' says stdout 'with a power of 80 %'
check 'a level has the seeds of the case' says small/sweeps/step1.yaml 'seeds: 3-'
same_as_seed() { cmp small/points/kind=biaxial,seed=4/history.csv hand/history.csv; }
check 'a seed by hand' run_gives 0 small.yaml --seed 4 -o hand
check 'is the point' same_as_seed

# ---- the budget ----
kept() {
    start=$(date +%s)
    refused 'a budget of 3 s is too small for one run of' "$root/cases/biaxial.yaml" -o dear --budget 3s &&
        test $(($(date +%s) - start)) -le 4 # a second for the clock, which counts whole ones
}
check 'a budget that ends in the first run: it is told, and kept' kept

# ---- wrong input ----
# shellcheck disable=SC2016 # the backticks are the message's
check 'a number that does not exist: those that do' \
    refused 'no number `sin_phi_peek` (did you mean `sin_phi_peak`?); there are: ' small.yaml -o no --of sin_phi_peek
check 'a column that does not exist' refused 'no column' flight.yaml -o no --of history.0.nothing@end
check 'a cell that is none' refused 'history.DISK.COLUMN@TIME' flight.yaml -o no --of history.vx@0
check 'an instant that is not reached' refused 'does not reach' flight.yaml -o no --of history.0.vx_m_per_s@5
check 'a disk that does not exist' refused 'has no rows' flight.yaml -o no --of history.7.vx_m_per_s@end
check 'no name' refused '--of names no number' small.yaml -o no --of ''
check 'a name twice' refused 'twice' small.yaml -o no --of e0,e0
check 'a budget that is too small' refused 'too small for one run' small.yaml -o tiny --budget 0.001s
check 'no case' refused 'which case?'
check 'two cases' refused 'one case at a time' small.yaml path.yaml
# shellcheck disable=SC2016
check 'an error of nothing' refused 'not `0`' small.yaml --to 0
check 'an error as large as the number' refused '1 % is 0.01' small.yaml --to 1
check 'a budget without a unit that is known' refused '90 s, 10min or 2 h' small.yaml --budget 1week
check 'a sign as a word of its own' converge_gives 0 spring.yaml -o spring -j 2 --to 1 %
check 'and in one' converge_gives 0 spring.yaml -o spring -j 2 --to '0.1 %'
check 'which is asked for' says stdout 'For an error of 0.1 %'
# The coarser step is above the bound: it is told, the rest goes on.
sed '/^contact/a step: {safety: 0.9}' spring.yaml >edge.yaml
check 'a step near its bound' converge_gives 0 edge.yaml -o edge -j 2
sed '/^contact/a step: {dt: 4 ms}' spring.yaml >above.yaml
check 'a level that fails is named, and the others go on' converge_gives 0 above.yaml -o above -j 2
check 'indeed' says stdout 'step.dt = 0.008: '
finish
