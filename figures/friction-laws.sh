#!/bin/sh
# SPDX-License-Identifier: MIT
# Friction force of all friction laws along the path of friction-laws.yaml, for disks and, with their own springs and
# unit of sliding, for spheres. CSV.
# usage: friction-laws.sh TRUNDLE
set -eu
export LC_ALL=C
trundle=$1
case=${0%.sh}.yaml
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# follow SHAPE CASE
follow() {
    "$trundle" run "$2" -o "$work/run" --force --set output.curves=no >"$work/said" 2>&1 || { cat "$work/said" >&2; exit 1; }
    awk '/friction: / {print $2 == "-" ? $4 : $2}' "$work/run/case.yaml" >"$work/laws"
    sort -t, -k1,1n -k2,2n "$work/run/contact.csv" | awk -v shape="$1" '
        NR == FNR {name[n++] = $1; next}
        FNR == 1 {FS = ","; $0 = $0}
        $2 + 0 > 0 {printf "%s,%s,%d,%d,%.10g,%.10g\n", shape, name[$1], $2, $3, $6, $7/0.3}' "$work/laws" -
}
# Spheres: no line contact, so no depth; no law of Carter's creep; their own first stiffness and unit of sliding.
sed -e 's/bodies: {/bodies: {shape: sphere, /; s/, Lambda: 4//; /dahlberg/d' \
    -e 's|pi\*E_star/8|4*E_star*path.0.a*(1 - nu)/(2 - nu)|' -e 's|10 kN/m|100 N|' \
    -e 's|slide: 2\*.*4.5|slide: 0.3*(2 - nu)/(2*(1 - nu))*path.0.a^2/R_star|' "$case" >"$work/sphere.yaml"
echo 'shape,law,step,segment,P,Q_over_mu'
follow disk "$case"
follow sphere "$work/sphere.yaml"
