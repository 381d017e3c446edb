#!/bin/sh
# SPDX-License-Identifier: MIT
# Kuhn's Fig. 5: friction over its bound against sliding (a) and against rolling (b), for ratios 1/xi of rolling to
# sliding. CSV.
# usage: kuhn-fig5.sh TRUNDLE
set -eu
export LC_ALL=C
trundle=$1
case=${0%.sh}.yaml
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# follow PANEL RATIO SLIDE ROLL
follow() {
    "$trundle" run "$case" -o "$work/run" --force --set output.curves=no --set "path.0.slide=$3" --set "path.0.roll=$4" >"$work/said" 2>&1 ||
        { cat "$work/said" >&2; exit 1; }
    awk -F, -v panel="$1" -v ratio="$2" '
        BEGIN {OFS = ","; print panel, ratio, 0, 0, 0}
        NR > 1 {print panel, ratio, $4/1e-6, $5/1e-4, $8}' "$work/run/contact.csv" # over the indentation, over a
}
echo 'panel,inverse_creepage,slide_over_indentation,roll_over_a,q'
for ratio in 0 1 10 30 100 300 1000; do follow a $ratio '3e-4*bodies.R1' "$ratio*slide"; done
for ratio in 1 10 30 100 300 1000; do follow b $ratio "roll/$ratio" '0.12*bodies.R1'; done
follow b inf 0 '0.12*bodies.R1'
