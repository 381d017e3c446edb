#!/bin/sh
# SPDX-License-Identifier: MIT
# The data of figures/: against closed forms written out here, and the same bytes from run to run.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"

for script in figures/*.sh; do
    figure=$(basename "$script" .sh)
    check "$figure: writes its data" sh -c '"$0" "$1" >"$2/$3.csv"' "$script" "$TRUNDLE" "$work" "$figure"
    "$script" "$TRUNDLE" >"$work/again.csv"
    check "$figure: the same bytes again" cmp "$work/$figure.csv" "$work/again.csv"
    check "$figure: has a script that draws it" test -s "figures/$figure.gp"
done

# closed_forms FILE ROWS AWK: the program gives `is` and `want` of a row, which agree to 1e-9 (10 digits are printed) in all
# of that many rows
closed_forms() {
    awk -F, "NR > 1 {want = \"\"; $3; if (want == \"\") next; rows++
        if (is - want > 1e-9 || want - is > 1e-9) {print \$0 \": expected \" want; bad = 1}}
        END {if (rows != $2) {print rows \" rows, not $2\"; bad = 1}; exit bad}" "$work/$1.csv"
}
definition='m = $1; d = $2; r = $3; is = $4; mean = (1 - r)/(2*(1 + r))' # r = R2/R1
check 'rigid rotation: nobody sees rolling' closed_forms definitions 147 "$definition; if (m == \"RBR\") want = 0"
check 'rolling: all agree but an angle and a sense' closed_forms definitions 294 "$definition
    if (m ~ /^PR/) want = d == \"kuhn\" ? -1 : d == \"tordesillas\" ? (1 + (r < 1 ? r : 1/r))/2 : 1"
check 'sliding: the mean flow sees rolling' closed_forms definitions 294 "$definition
    if (m ~ /^PS/) want = d == \"bagi-kuhn\" ? mean : d == \"kuhn\" ? -mean : 0"
check 'slide and spin: energy of the mean flow alone' closed_forms definitions 105 "$definition
    if (m == \"slide and spin\") want = d == \"bagi-kuhn\" ? -mean : 0"
check 'spin and roll: energy of model 2 also' closed_forms definitions 105 "$definition
    if (m == \"spin and roll\") want = d == \"bagi-kuhn\" ? -mean : d ~ /alonso/ ? r/(1 + r) : 0"
# Bounds: mu_r P R/2 for equal disks, mu_r P R of the law that takes the arm.
check 'rolling laws: at the bound at the end of each way forward' closed_forms rolling-laws 20 'is = -$5
    if ($2 !~ /dashpot/ && $3 > 0.0999999) want = ($2 ~ /prop/ ? 0.001 : 0.0005)*$4'
finish
