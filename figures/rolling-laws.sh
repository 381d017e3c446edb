#!/bin/sh
# SPDX-License-Identifier: MIT
# Moment against relative rotation of all rolling laws on the path of rolling-laws.yaml, at constant normal force, and
# with the force rising to 20 kN/m on the way back and falling to 5 kN/m after that. CSV.
# usage: rolling-laws.sh TRUNDLE
set -eu
export LC_ALL=C
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# follow PATH [--set ...]
follow() {
    path=$1
    shift
    "$trundle" run "$case" -o "$work/run" --force --set output.curves=no "$@" >"$work/said" 2>&1 || { cat "$work/said" >&2; exit 1; }
    sort -t, -k1,1n -k2,2n "$work/run/contact.csv" | awk -F, -v path="$path" '
        BEGIN {
            split("wang-spring,conjugate-spring of bagi-kuhn,star-displacement-damping,star-displacement-damping with dashpot," \
                  "star-constant-torque,star-force-proportional", name, ",")
            R_star = 0.005
        }
        $2 + 0 > 0 {printf "%s,%s,%.10g,%s,%.10g,%.10g\n", path, name[$1 + 1], -$5/R_star, $6, $10, $11}'
}
trundle=$1
case=${0%.sh}.yaml
echo 'force,law,rotation_rad,P_N_per_m,moment_1_N,moment_2_N'
follow constant
follow changing --set 'path.1.force=20 kN/m' --set 'path.2.force=5 kN/m'
