#!/bin/sh
# SPDX-License-Identifier: MIT
# The path of friction-laws.yaml on disks by each friction law and by the exact half-plane, and the error of each. CSV.
# usage: exact-path.sh TRUNDLE
set -eu
export LC_ALL=C
trundle=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

sed 's/^laws:/&\n  - {friction: exact, mu: 0.3}/' "${0%/*}/friction-laws.yaml" >"$work/case.yaml"
"$trundle" run "$work/case.yaml" -o "$work/run" --force --set output.curves=no >"$work/said" 2>&1 || { cat "$work/said" >&2; exit 1; }
echo 'law,step,segment,P_over_P0,q,error' # Q and Q - Q_exact over mu P0
awk '/friction: / {print $2 == "-" ? $4 : $2}' "$work/run/case.yaml" >"$work/laws"
sort -t, -k1,1n -k2,2n "$work/run/contact.csv" | awk '
    NR == FNR {name[n++] = $1; next}
    FNR == 1 {FS = ","; $0 = $0}
    !/^[0-9]/ {next}
    $1 == 0 {exact[$2] = $7}
    {printf "%s,%d,%d,%.10g,%.10g,%.10g\n", name[$1], $2, $3, $6/1e4, $7/3e3, ($7 - exact[$2])/3e3}' "$work/laws" -
