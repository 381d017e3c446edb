#!/bin/sh
# SPDX-License-Identifier: MIT
# Kuhn's Fig. 4: friction over its bound against rolling at constant creepage from rest, by the law of Dahlberg and
# Alfredsson and by the exact half-plane. CSV.
# usage: kuhn-fig4.sh TRUNDLE
set -eu
export LC_ALL=C
trundle=$1
case=${0%.sh}.yaml
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

echo 'mu,creepage,roll_over_a,q,q_exact'
for creepage in 0.001 0.004; do
    "$trundle" run "$case" -o "$work/run" --force --set output.curves=no --set "path.0.slide=$creepage*roll" >"$work/said" 2>&1 ||
        { cat "$work/said" >&2; exit 1; }
    sort -t, -k2,2n -k1,1n "$work/run/contact.csv" | awk -F, -v creepage=$creepage '
        BEGIN {mu[1] = 0.1; mu[3] = 0.3; print mu[1] "," creepage ",0,0,0\n" mu[3] "," creepage ",0,0,0"}
        $1 in mu {printf "%s,%s,%.10g,%.10g,%.10g\n", mu[$1], creepage, $5/1e-4, q, $8}
        {q = $8}'
done
