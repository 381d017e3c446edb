#!/bin/sh
# SPDX-License-Identifier: MIT
# Each rolling velocity over Wang's pure motions, and the energy it makes in two closed cycles, against R2/R1. CSV.
# usage: definitions.sh TRUNDLE
#
# Motions [Wang2015 eqs. 1-6] of touching disks: rolling or sliding at U = 1 mm/s, RBR at that speed; divided by U.
# tordesillas is an angle: times half the smaller radius, which for equal disks is R1R2/(R1+R2).
# Cycles: see definitions.yaml. Work of the contact on the disks, by the trapezoidal rule (exact for springs), of
#   dW = M1 dth1 + M2 dth2 - f_r dslide,   dth1 = (dslide/2 - droll)/R1,   dth2 = (dslide/2 + droll)/R2
# and with conjugate moments on the same T = -M1/R_eff of -T (A dth1 + B dth2), where V_r = A w1 + B w2 + C Vt
# (README.md, question 2). Divided by k_r R_eff du dth1 where disk 2 slides and disk 1 spins, by k_r R1 dth1 du_roll
# where disk 1 spins and both roll.
set -eu
export LC_ALL=C
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The program names its definitions where one is not known; those of definitions.yaml take their places,
# conjugate-spring is last.
names=$("$1" run "${0%.sh}.yaml" --check --set laws.0.rolling_velocity=no-such 2>&1 | sed -n 's/.*allowed is //p' | tr -d '|' | xargs) || true
[ -n "$names" ] || { echo "error: $1 does not name its definitions of the rolling velocity" >&2; exit 1; }
case=$work/definitions.yaml
awk -v names="$names" '
    /wang-spring, rolling_velocity: wang,/ {
        n = split(names, name, " ")
        for (i = 1; i <= n; i++) {line = $0; sub(/velocity: wang/, "velocity: " name[i], line); print line}
    }
    !/rolling: wang-spring/' "${0%.sh}.yaml" >"$case"
ratios=$(awk 'BEGIN {for (k = -10; k <= 10; k++) printf "%.17g\n", 10^(k/10)}')

echo "$ratios" | awk '
    BEGIN {print "case,R1,R2,x1x,x1y,x2x,x2y,v1x,v1y,v2x,v2y,w1,w2"}
    {
        R1 = 0.01; R2 = R1*$1; L = R1 + R2; U = 1e-3
        move("RBR", U/L, U/L, U/L)
        move("PR", 0, U/R1, -U/R2)
        move("PR + RBR", -U/R1, 0, -U/R2 - U/R1)
        move("PS", 0, U/L, U/L)
        move("PS + RBR", -U/L, 0, 0)
    }
    function move(name, beta, w1, w2) {
        printf "%s,%.17g,%.17g,0,0,%.17g,0,0,0,0,%.17g,%.17g,%.17g\n", name, R1, R2, L, beta*L, w1, w2
    }' >"$work/motions.csv"
"$1" measures "$work/motions.csv" >"$work/measures.csv"

for ratio in $ratios; do
    "$1" run "$case" --set output.curves=no --set "bodies.R2=$ratio*bodies.R1" -o "$work/run" --force >"$work/said" 2>&1 || { cat "$work/said" >&2; exit 1; }
    sed "1d; s/^/$ratio,/" "$work/run/contact.csv"
done >"$work/cycles.csv"

echo 'motion,definition,R2_over_R1,value'
{
    awk -F, '
        NR == 1 {for (i = 1; i <= NF; i++) at[$i] = i; next}
        {
            R1 = $at["R1"]; R2 = $at["R2"]
            for (column in at) if (column ~ /^Vr(oll)?_/) {
                name = column; sub(/^Vr(oll)?_/, "", name); gsub(/_/, "-", name)
                say(name, $at[column]*(name == "tordesillas" ? (R1 < R2 ? R1 : R2)/2 : 1))
            }
        }
        function say(name, v) {printf "%s,%s,%.10g,%.10g\n", $1, name, R2/R1, v/1e-3}' "$work/measures.csv"
    awk -F, -v names="$names" '
        BEGIN {n = split(names, name, " "); name[n + 1] = "conjugate-spring of bagi-kuhn"; R1 = 0.01; k_r = 1e6; u = 1e-6}
        $3 == 1 {slide[$2] = roll[$2] = M1[$2] = M2[$2] = f[$2] = 0; R_eff = R1*$1/(1 + $1)}
        {
            i = $2; R2 = $1*R1; dslide = $5 - slide[i]; droll = $6 - roll[i]
            dth1 = (dslide/2 - droll)/R1; dth2 = (dslide/2 + droll)/R2
            work[i] += (M1[i] + $11)/2*dth1 + (M2[i] + $12)/2*dth2 - (f[i] + $13)/2*dslide
            conjugate[i] += (M1[i] + $11)/(2*R_eff)*rolled(name[i + 1], R1*dth1, -R2*dth2)
            slide[i] = $5; roll[i] = $6; M1[i] = $11; M2[i] = $12; f[i] = $13
        }
        $3 == 16 {say("slide and spin", R2/(R1 + R2))} # R_eff/R1
        $3 == 32 {say("spin and roll", 1)}
        function say(motion, lever) {
            printf "%s,%s,%.10g,%.10g\n", motion, name[i + 1], $1, work[i]/(k_r*u*u*lever)
            if (worked_out(name[i + 1])) printf "%s conjugate,%s,%.10g,%.10g\n", motion, name[i + 1], $1, conjugate[i]/(k_r*u*u*lever)
            work[i] = conjugate[i] = 0
        }
        # Of these A and B are worked out here.
        function worked_out(of) {return of ~ /^(wang|bagi-kuhn|alonso-min|alonso-mean)$/}
        # A dth1 + B dth2 of a step, from the arcs over both rims; below 1e-13 m they are rounding, a step is 2.5e-7 m
        function rolled(of, s1, s2) {
            if (of == "wang") return (R2*s1 + R1*s2)/(R1 + R2)
            if (of == "bagi-kuhn") return (s1 + s2)/2
            if (s1*s2 < 1e-26) return 0
            return of == "alonso-mean" ? (s1 + s2)/2 : s1*s1 < s2*s2 ? s1 : s2
        }' "$work/cycles.csv"
} | sort -t, -k1,1 -k2,2 -k3,3g
