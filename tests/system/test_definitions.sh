#!/bin/sh
# SPDX-License-Identifier: MIT
# The comparison of the definitions of rolling: its verdicts on made-up numbers, and its page from a small test.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
here=$PWD/figures/definitions

# ---- verdicts ----
# collected SEEDS T DIFFERENCE ERROR: of the peak, of one definition beside wang, with Student's quantile T
collected() {
    awk -v n="$1" -v t="$2" -v d="$3" -v e="$4" 'BEGIN {
        print "contact.rolling_velocity,quantity,minus,seeds,mean,standard_error,low_95,high_95"
        split("sin_phi_peak sin_phi_residual e_residual", q, " ")
        for (k = 1; k <= 3; k++) {
            printf "wang,%s,,%d,0.5,%g,%.9g,%.9g\n", q[k], n, e, 0.5 - t*e, 0.5 + t*e
            printf "other,%s,,%d,%.9g,%g,%.9g,%.9g\n", q[k], n, 0.5 + d, e, 0.5 + d - t*e, 0.5 + d + t*e
            printf "other,%s,contact.rolling_velocity=wang,%d,%.9g,%g,%.9g,%.9g\n", q[k], n, d, e, d - t*e, d + t*e
        }
    }' >"$work/collect.csv"
    awk -f "$here/strength.awk" "$work/collect.csv" >"$work/strength.csv"
}
told() { awk -F, -v what="$1" -v i="$2" '$1 == what && $2 == "other" {print $i}' "$work/strength.csv"; }
t3=4.302653
collected 3 $t3 0.03 0.002
check 'the interval leaves out 0: differs' equals "$(told 'peak sin φ' 5)" differs
check 'mean and interval' equals "$(told 'peak sin φ' 4)" '0.0300 ± 0.0086'
collected 3 $t3 -0.03 0.002
check 'the same downwards' equals "$(told 'peak sin φ' 4) $(told 'peak sin φ' 5)" '−0.0300 ± 0.0086 differs'
collected 3 $t3 0.004 0.002
check 'it lies within 0.02: equal within that' equals "$(told 'residual sin φ' 5)" 'equal within 0.02'
check 'but not within that of the void ratio: undecided, which is not equal' equals "$(told 'residual void ratio' 5)" undecided
collected 3 $t3 0.004 0.01
check 'it holds 0 and more than 0.02: undecided' equals "$(told 'peak sin φ' 5)" undecided
# A million trials each, normal differences, two-sided test at 5 %: found in 80 of 100 from 3.26, 0.996 and 0.512
# standard deviations on. times the scatter of residuals, 0.0527; three digits are printed.
check 'what 3 seeds can detect' equals "$(told 'residual sin φ' 6)" 0.172
collected 10 2.262157 0.004 0.01
check 'and 10' equals "$(told 'residual sin φ' 6)" 0.052
collected 32 2.039513 0.004 0.01
check 'and 32' equals "$(told 'residual sin φ' 6)" 0.027
check 'one seed has no interval' not collected 1 1 0.004 0.01

# ---- the page of a small test ----
write_small_case "$work/small.yaml"
page=$work/page/index.html
check 'the page is made' "$here/definitions.sh" "$TRUNDLE" "$work/page" 2 "$work/small.yaml"
check 'it is there, and no part of it is left' test -s "$page" -a ! -e "$page.part"
names=$("$TRUNDLE" run "$work/small.yaml" --check --set contact.rolling_velocity=none-such 2>&1 | sed -n 's/.*allowed is //p' | tr -d '|')
for definition in $names; do
    for table in kinematics energy contact strength; do
        check "$definition is in $table.csv" grep -q "$definition" "$work/page/$table.csv"
    done
done
check 'as many definitions as the program has' equals "$(echo "$names" | wc -w)" "$(awk -F, 'NR > 1 {n[$2]} END {for (k in n) m++; print m}' "$work/page/kinematics.csv")"
check 'all rows of a table are as wide' is_silent awk -F, 'FNR == 1 {n = NF} NF != n {print FILENAME ": " $0}' \
    "$work/page/kinematics.csv" "$work/page/energy.csv" "$work/page/contact.csv" "$work/page/strength.csv"
check 'no number is missing' is_silent grep -nwiE 'nan|inf' "$page"
check 'it names the program' says "$page" "$("$TRUNDLE" --version)"
check 'and says that undecided is not equal' says "$page" 'which is <b>not</b> “equal”'
if command -v xmllint >/dev/null; then check 'it is well formed' xmllint --noout "$page"; else skip 'it is well formed' 'no xmllint'; fi
pictures() { for link in $(grep -o 'src="[^"]*"' "$page" | cut -d'"' -f2); do test -s "$work/page/$link" || { echo "no $link"; return 1; }; done; }
check 'its pictures are there' pictures
cp "$page" "$work/first.html"
"$here/definitions.sh" "$TRUNDLE" "$work/page" 2 "$work/small.yaml" >/dev/null
check 'the same page again' cmp "$work/first.html" "$page"

# A program whose spring has another moment: the page is not made in silence.
awk -F, 'BEGIN {OFS = ","} NR > 1 {$10 *= 1.01} {print}' "$work/page/contact/contact.csv" | sort -t, -k1,1n -k2,2n >"$work/wrong.csv"
check 'a moment that is not the one by hand is told' not awk -v names="$(echo "$names" | xargs)" -v rows="$work/rows" -v table="$work/table" \
    -f "$here/contact.awk" "$work/wrong.csv"
sed 's/^\(PS,bagi-kuhn,10\),-/\1,/' "$work/page/motions.csv" >"$work/wrong.csv"
check 'a velocity that is not its closed form is told' not awk -v names="$(echo "$names" | xargs)" -v kinematics="$work/rows" -v energy="$work/table" \
    -f "$here/motions.awk" "$work/wrong.csv"
finish
