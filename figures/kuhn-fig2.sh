#!/bin/sh
# SPDX-License-Identifier: MIT
# Tractions, slip and stick of a contact that is pushed (Cattaneo-Mindlin) and of one that rolls on under the push
# (steady-state creep), from the run of cattaneo-to-carter.yaml. CSV.
# usage: kuhn-fig2.sh TRUNDLE
set -eu
export LC_ALL=C
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$1" run "$(dirname "$0")/cattaneo-to-carter.yaml" -o "$work/run" --force --set output.curves=no >"$work/said" 2>&1 || { cat "$work/said" >&2; exit 1; }
echo 'state,x_over_a,bound,traction,slip_nm,stick' # bound mu p and traction over mu p0
awk -F, '
    FNR == 1 {file++; next}
    file == 1 {a = $9; p0 = 2*$6/(3.14159265358979*a); next}
    $2 == 1 || $2 == 401 {
        printf "%s,%.10g,%.10g,%.10g,%.10g,%d\n", $2 == 1 ? "pushed" : "rolling", $3/a, $4/p0, $5/(0.3*p0), 1e9*$6, $7
    }' "$work/run/contact.csv" "$work/run/patch.csv"
