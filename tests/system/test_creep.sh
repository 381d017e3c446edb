#!/bin/sh
# SPDX-License-Identifier: MIT
# The comparison of two kinds of rolling resistance: its verdicts on made-up numbers, and its page from a small test.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
here=$PWD/figures/creep student=$PWD/figures/student.awk

# ---- Student's distribution: published tables, four digits ----
t() { awk -f "$student" -f /dev/stdin <<AWK
BEGIN { printf "%.4f", student($1, $2) }
AWK
}
check '1 degree of freedom: tan' equals "$(t 0.05 1)" 12.7062
check '2' equals "$(t 0.05 2)" 4.3027
check '3' equals "$(t 0.01 3)" 5.8409
check '10' equals "$(t 0.05 10)" 2.2281
check '23' equals "$(t 0.05 23)" 2.0687
check '120' equals "$(t 0.001 120)" 3.3735

# ---- verdicts ----
# points SEEDS CREEP SPREAD: creep changes all numbers by CREEP + SPREAD (-1)^seed, the contact moment by 0.1, without
# spread; all
# scatter from seed to seed.
points() {
    for file in laws kuhn; do
        awk -v n="$1" -v c="$2" -v w="$3" -v file=$file 'BEGIN {
            key = file == "laws" ? "contact.friction" : "contact.creep_roll"
            print "contact.mu_r," key ",seed,sin_phi_peak,sin_phi_residual,e0,e_residual,rolling_share_residual"
            split(file == "laws" ? "coulomb-spring dahlberg-alfredsson" : "kuhn", law, " ")
            for (s = 1; s <= n; s++) for (m = 0; m <= 0.5; m += 0.5) for (k = 1; k in law; k++) {
                x = 0.3 + 0.05*s + 0.2*m + (law[k] == "coulomb-spring" ? 0 : c + w*(s%2 ? 1 : -1))
                printf "%g,%s,%d,%.9g,%.9g,0.2,%.9g,%.9g\n", m, law[k], s, x, x, 0.2 + x, x
            } }' >"$work/$file.csv"
    done
    awk -f "$student" -f "$here/effects.awk" "$work/laws.csv" "$work/kuhn.csv" >"$work/effects.csv"
}
told() { awk -F, -v q="$1" -v of="$2" -v by="$3" -v i="$4" '$1 == q && $2 == of && $3 == by {print $i}' "$work/effects.csv"; }
points 4 0.01 0
check 'a change of all seeds alike: raises' \
    equals "$(told 'residual sin φ' creep 'contact moment' 9)" 'raises; within 0.02'
check 'beyond the margin' equals "$(told 'dilatancy e − e0' creep 'contact moment' 9)" raises
check 'the contact moment' \
    equals "$(told 'peak sin φ' 'contact moment' creep 5) $(told 'peak sin φ' 'contact moment' creep 9)" '0.1000 raises'
check 'both less each alone' equals "$(told 'peak sin φ' together 'both less each alone' 5)" 0.0000
check 'has no verdict' equals "$(told 'peak sin φ' together 'both less each alone' 9)" ''
check 'creep by both kinds of rolling alike' \
    equals "$(told 'peak sin φ' "Kuhn's rolling less Wang's" 'contact moment' 9)" 'within 0.02'
check '24 verdicts' equals "$(awk -F, 'NR > 1 && $9 != ""' "$work/effects.csv" | wc -l)" 24
points 4 -0.03 0
check 'downwards' equals "$(told 'residual sin φ' creep 'no contact moment' 9)" lowers
# W = 0.001: s/sqrt(n) = 0.001 sqrt(4/3)/2. Of 3 degrees of freedom t(0.05) = 3.18245, t(0.05/24) = 9.8 (P = 0.00208).
points 4 0.004 0.001
check 'the 95 % interval of one' equals "$(told 'peak sin φ' creep 'contact moment' 6)" 0.0018
check 'that of all is wider: undecided whether there is a change, but it is small' \
    equals "$(told 'peak sin φ' creep 'contact moment' 9)" 'within 0.02'
points 4 0.004 0.01
check 'undecided' equals "$(told 'peak sin φ' creep 'contact moment' 9)" undecided
check 'one seed has no interval' not points 1 0.01 0
points 4 0.01 0
sed '2s/,[^,]*,\([^,]*,[^,]*,[^,]*\)$/,,\1/' "$work/laws.csv" >"$work/hole.csv"
awk -f "$student" -f "$here/effects.awk" "$work/hole.csv" "$work/kuhn.csv" >"$work/effects.csv"
check 'a seed that lacks a number does not count' equals "$(told 'peak sin φ' creep 'contact moment' 4)" 3

# ---- the page of a small test ----
sed 's/disks: 400/disks: 80/; s/strain_end: 0.20/strain_end: 0.01/; s/inertial_number: 1e-3/inertial_number: 1e-2/; s/frames: 200/frames: 3/' \
    cases/biaxial-creep.yaml >"$work/small.yaml"
page=$work/page/index.html
check 'the page is made' "$here/creep.sh" "$TRUNDLE" "$work/page" 2 "$work/small.yaml"
check 'it is there, and no part of it is left' test -s "$page" -a ! -e "$page.part"
check 'no number is missing' is_silent grep -nwiE 'nan|inf' "$page"
check 'it names the program' says "$page" "$("$TRUNDLE" --version)"
check 'and says that undecided is not equal' says "$page" '<b>not</b> “no effect”'
check 'the film is of the slip' says "$work/page/film/case.yaml" 'color: slip'
if command -v xmllint >/dev/null; then check 'it is well formed' xmllint --noout "$page"; else skip 'it is well formed' 'no xmllint'; fi
links() { for link in $(grep -o 'src="[^"]*"' "$page" | cut -d'"' -f2); do test -s "$work/page/$link" || { echo "no $link"; return 1; }; done; }
check 'its pictures and its film are there' links
cp "$page" "$work/first.html"
"$here/creep.sh" "$TRUNDLE" "$work/page" 2 "$work/small.yaml" >/dev/null
check 'the same page again' cmp "$work/first.html" "$page"
cp "$work/page/curves.csv" "$work/first.csv"
again() { "$here/creep.sh" "$TRUNDLE" "$work/page" "$1" "$2" >"$work/complaint" 2>&1; }
check 'a seed more' again 3 "$work/small.yaml"
check 'gives other curves' not cmp -s "$work/first.csv" "$work/page/curves.csv"
check 'with less again' again 2 "$work/small.yaml"
check 'the curves are those of the seeds that are asked for' cmp "$work/first.csv" "$work/page/curves.csv"
sed 's/^  mu: 0.5/  mu: 0.4/' "$work/small.yaml" >"$work/other.yaml"
check 'another case' again 2 "$work/other.yaml"
check 'has a film of its own' sh -c 'grep -q "^  mu: 0.4" "$0"' "$work/page/film/case.yaml"
check 'one seed is refused, before any run' not again 1 "$work/other.yaml"
check 'with the reason' says "$work/complaint" 'at least two seeds'
finish
