#!/bin/sh
# SPDX-License-Identifier: MIT
# figures/wang/verdicts.awk, and figures/kuhn/tables.awk, on numbers made up so that the answers are known: means,
# Student's intervals, verdicts, seeds to decide.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
here=$PWD/figures/wang student=$PWD/figures/student.awk
check 'the sweep of the figures: 12 coefficients, 4 models, 32 seeds' \
    equals "$("$TRUNDLE" sweep "$here/strength.yaml" --list | wc -l)" 1536
cd "$work" || exit 1

# Five seeds, s = 1 ... 5. All of wang has sin phi 0.4 + s/100 and e = 0.3. Others differ by D, and by D + W (s - 3) at
# mu_r < 0.2, so that the interval there is D +- 2.776445 W sqrt(2.5/5).
points() { # D W E: points.csv, where void ratios of others are E times those of wang
    echo 'contact.mu_r,contact.rolling_velocity,seed,sin_phi_residual,sin_phi_peak,e0,e_residual,opposed_fraction_residual'
    awk -v d="$1" -v w="$2" -v e="$3" 'BEGIN {
        split("0 0.05 0.1 0.15 0.2 0.3 0.4 0.5 0.7 1 1.5 2", mu_r, " ")
        split("wang bagi-kuhn alonso-min alonso-mean", model, " ")
        for (s = 1; s <= 5; s++) for (m = 1; m <= 12; m++) for (k = 1; k <= 4; k++) {
            other = k > 1
            more = other*(mu_r[m] < 0.2 ? d + w*(s - 3) : d)
            printf "%s,%s,%d,%g,%g,%g,%g,%g\n", mu_r[m], model[k], s, 0.4 + s/100 + more, 0.7 - more, 0.2,
                other ? 0.3*e : 0.3, mu_r[m] < 0.2 ? 0.1 : 0.3
        } }'
}
# verdict CLAIM MODEL: number, interval, seeds, verdict, seeds to decide
verdict() { awk -F, -v c="$1" -v m="$2" 'index($1, c) && $2 == m {print $3, $4, $5, $8, $9, $10}' verdicts.csv; }
judge() { points "$@" >points.csv && awk -F, -f "$student" -f "$here/verdicts.awk" points.csv >verdicts.csv; }
claims() { awk -F, 'NR > 1 {n[$9]++} END {print n["holds"] + 0, n["fails"] + 0, n["undecided"] + 0}' verdicts.csv; }

judge -0.01 0.002 0.96
# 0.002*2.776445*sqrt(0.5) = 0.003926
check 'below 0.2: within the range' equals "$(verdict 'almost the same' alonso-min)" '-0.0100 -0.0139 -0.0061 5 holds '
check 'above 0.2: wang is higher, by the same for each seed' equals "$(verdict 'residual sin phi of wang less that of the model' alonso-min)" '0.0100 0.0100 0.0100 5 holds '
check 'the peak has the other sign' equals "$(verdict 'peak sin phi of wang' alonso-min)" '-0.0100 -0.0100 -0.0100 5 fails '
check 'void ratio 4 % lower' equals "$(verdict '4 % lower' alonso-mean)" '-0.0400 -0.0400 -0.0400 5 holds '
check 'dilation' equals "$(verdict 'all samples dilate' bagi-kuhn)" '0.0880 0.0880 0.0880 5 holds '
check 'contacts that run opposite ways' equals "$(verdict 'there are such' wang)" '0.3000 0.3000 0.3000 5 holds '
check 'and how many more' equals "$(verdict 'more of them' wang)" '0.2000 0.2000 0.2000 5 holds '

judge -0.03 0.01 1
# half an interval: 0.019632, 0.01 from the edge at -0.02: 5*(1.9632)^2 + 1 = 20 seeds
check 'on the edge: undecided' equals "$(verdict 'almost the same' alonso-mean)" '-0.0300 -0.0496 -0.0104 5 undecided 20'
check 'void ratio the same: 4 % lower fails' equals "$(verdict '4 % lower' alonso-mean)" '0.0000 0.0000 0.0000 5 fails '

judge 0.05 0.001 1.1
check 'outside: fails' equals "$(verdict 'almost the same' bagi-kuhn)" '0.0500 0.0480 0.0520 5 fails '
# below 0.2 and above 0.2 fail for 3 models, 4 % lower for 2, twice
check 'each claim has one verdict' equals "$(claims)" '18 10 0'

# Two seeds more, with other numbers: one has an empty cell, one lacks a point.
cp verdicts.csv five.csv
awk -F, -v OFS=, '{ print } $3 == 5 { $4 += 0.1; $3 = 6; if ($1 == 1 && $2 == "wang") $5 = ""; print; $3 = 7; if ($1 != 2) print }' points.csv >seven.csv
awk -F, -f "$student" -f "$here/verdicts.awk" seven.csv >verdicts.csv
check 'a seed that lacks a number or a point is left out' cmp verdicts.csv five.csv

# One seed has no interval, so nothing is decided.
awk -F, 'NR == 1 || $3 == 5' points.csv >one.csv
awk -F, -f "$student" -f "$here/verdicts.awk" one.csv >verdicts.csv
check 'one seed: a number alone' equals "$(verdict 'almost the same' bagi-kuhn)" '0.0520   1 undecided 2 or more'
check 'and no verdict on any claim' equals "$(claims)" '0 0 28'
check 'nor a number that cannot be' not grep -qE '[0-9]{7}|inf|nan' verdicts.csv

# Kuhn's assemblies: rows of 0.1 % strain up to 30 %, so four blocks from 10 % on. Of the small contacts rolling is twice that of the large
# ones, and D more in the first of the four blocks; creep changes sin phi by E.
kuhn=$here/../kuhn/tables.awk
rows() { # DIR ROLL MORE SIN_PHI
    mkdir -p "$1"
    awk -v r="$2" -v d="$3" -v p="$4" 'BEGIN {
        print "strain,stress_1_Pa,stress_2_Pa,sin_phi,void_ratio,coordination,a_over_R,roll_over_slide_median,creep_over_slide_median"
        for (k = 0; k <= 300; k++) {
            s = k/1000
            printf "%g,%g,%g,%g,%g,%g,%g,%g,%g\n", s, 110 + k%2, 90 + k%2, p, (!k ? 0.15 : s > 0.2051 && s < 0.2551 ? 0.2 : 0.3), k ? 3 : 4, 0.01, (s > 0.0999 && s < 0.1499 ? r + d : r), 0.1
        } }' >"$1/history.csv"
}
rows disks-large-cattaneo-mindlin 3 0 0.3
rows disks-small-cattaneo-mindlin 6 0.3 0.3
rows disks-large-kuhn-creep 3 0 0.325
rows disks-small-kuhn-creep 6 0 0.31
awk -F, -v tables=tables.csv -f "$student" -f "$kuhn" ./*/history.csv >verdicts.csv
# 22 % strain is in a block and in the rows of the table
sed -i 's/^\(0.22,.*\),[^,]*,\([^,]*\)$/\1,,\2/' disks-large-*/history.csv
awk -F, -v tables=holes.csv -f "$student" -f "$kuhn" ./*/history.csv >holes-verdicts.csv
holes() { grep -q '^0.22,.*,,0.1$' disks-large-kuhn-creep/history.csv && cmp holes.csv tables.csv && cmp holes-verdicts.csv verdicts.csv; }
check 'an empty cell is no 0' holes
kuhn_says() { awk -F, -v c="$1" -v r="$2" 'index($1, c) && index($2, r) {print $4, $5, $6, $9, $10}' verdicts.csv; }
# ratios 2.1, 2, 2, 2: mean 2.025, deviation 0.05, half an interval 3.182446*0.05/2 = 0.07956
check 'small contacts roll twice as much, by blocks' \
    equals "$(kuhn_says 'small contacts roll more' disks-small-cattaneo)" '2.025 1.945 2.105 4 holds'
check 'what creep adds to the strength, within the range' equals "$(kuhn_says 'change the strength' disks-small-kuhn)" '0.01 0.01 0.01 4 holds'
check 'and beyond it' equals "$(kuhn_says 'change the strength' disks-large-kuhn)" '0.025 0.025 0.025 4 fails'
check 'on the edge: undecided' equals "$(kuhn_says 'rolling slightly' disks-small | cut -d' ' -f 5)" undecided
check 'a run that is not there has no verdict' equals "$(grep -c 'spheres\|mu-0.3' verdicts.csv)" 0
# contacts per particle are half of the coordination; stress is 100 and 101 in turn: 0.5/100.5
check 'the table' equals "$(awk -F, '$1 == "disks-small-kuhn-creep" {print $2, $3, $4, $5, $6, $7, $8, $10, $13}' tables.csv)" \
    '0.15 2 4 0.01 0.005 0.2 3 0.31 6'
finish
