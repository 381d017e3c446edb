#!/bin/sh
# SPDX-License-Identifier: MIT
# Traction inside the contact on its way from Cattaneo to Carter under a constant push, the closed form of Carter (roll
# `carter`), and the distance left to it. CSV.
# usage: cattaneo-to-carter.sh TRUNDLE
set -eu
export LC_ALL=C
trundle=$1
case=${0%.sh}.yaml
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# follow CASE [--set KEY=VALUE]...
follow() {
    "$trundle" run "$@" --force --set output.curves=no >"$work/said" 2>&1 || { cat "$work/said" >&2; exit 1; }
}
sed 's/half-plane/carter/; /steps: 1}/d; s/snapshots: .*}/snapshots: 1}/' "$case" >"$work/carter.yaml"
echo 'what,q,roll_over_a,x_over_a,value' # value: traction over mu p0, or L1 distance to Carter's over that at the start
for q in 0.3 0.6 0.9; do
    follow "$case" -o "$work/run" --set "path.0.tangential=$q*mu*P" --set "path.1.tangential=$q*mu*P"
    follow "$work/carter.yaml" -o "$work/carter" --set "path.0.tangential=$q*mu*P"
    awk -F, -v q=$q '
        FNR == 1 {file++; next}
        file == 1 {a = $9; p0 = 2*$6/(3.14159265358979*a); next}
        file == 2 {carter[$3] = $5; if (q == 0.6) printf "carter,%s,inf,%.10g,%.10g\n", q, $3/a, $5/(0.3*p0); next}
        {roll = ($2 - 1)/100; distance[roll] += $5 > carter[$3] ? $5 - carter[$3] : carter[$3] - $5}
        q == 0.6 && roll ~ /^(0|0.25|0.5|1|2|4)$/ {printf "traction,%s,%s,%.10g,%.10g\n", q, roll, $3/a, $5/(0.3*p0)}
        END {
            for (step = 0; step <= 400; step++)
                printf "distance,%s,%s,,%.10g\n", q, step/100, distance[step/100]/distance[0]
        }' "$work/run/contact.csv" "$work/carter/patch.csv" "$work/run/patch.csv"
done
