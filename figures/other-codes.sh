#!/bin/sh
# SPDX-License-Identifier: MIT
# What a rigid rotation does to friction in other codes as the overlap grows, and by which factors YADE's coefficients
# differ for unequal radii. The sliding velocities are those that `trundle identify` names for the measured answers (tests/interop).
# CSV: rotation, overlap/R, V_s/(R omega) of each; factor, R1/R2, the factors. usage: other-codes.sh TRUNDLE
set -eu
export LC_ALL=C
trundle=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Two disks of radius 1 cm that turn as one body by 1 rad/s.
awk 'BEGIN {
    print "case,R1,R2,x1x,x1y,x2x,x2y,v1x,v1y,v2x,v2y,w1,w2"
    for (k = 0; k <= 20; k++) {L = 0.02*(1 - k/400); printf "%g,0.01,0.01,0,0,%.17g,0,0,0,0,%.17g,1,1\n", k/200, L, L}
}' >"$work/motions.csv"
"$trundle" measures "$work/motions.csv" | awk -F, '
    NR == 1 {for (i = 1; i <= NF; i++) column[$i] = i; next}
    {printf "rotation,%s,%s,%s,%s\n", $1, 100*$column["Vs_full_radii"], 100*$column["Vs_midpoint"],
        100*$column["Vs_alonso"]}'
for ratio in 1 1.2 1.5 2 3 4 5 7 10; do
    "$trundle" laws wang-spring --in yade --radii "$(awk "BEGIN {print 0.01*$ratio}"),0.01" |
        awk -v r=$ratio '$1 == "k_r" {k = $3} $1 == "mu_r" {print "factor," r "," k "," $3}'
done
