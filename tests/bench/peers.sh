#!/bin/sh
# SPDX-License-Identifier: MIT
# One packing with the same laws and the same motion in trundle and in LAMMPS, in turn, on one core each: time of a
# step, and the states, to show that it is the same work. What is the same and what is not: src/study/bench_packing.c.
# usage: peers.sh TRUNDLE OUT.csv [REPEATS]
#
# Times are those of the processor (LAMMPS: loop time x CPU use), of the last 5000 steps. States are compared after the
# first 1000: later the two drift apart, as any two roundings of a granular flow do. Tolerances: the arms of friction
# differ by half an overlap, 1e-3 of a radius; gran/hooke/history also has another damping between disks of unequal
# size.
set -eu
export LC_ALL=C OMP_NUM_THREADS=1
trundle=$1 out=$2 repeats=${3:-9} here=$(dirname "$0")
command -v lmp >/dev/null 2>&1 || { echo 'no LAMMPS here (apt-get install lammps): nothing compared'; exit 0; }
lmp -h | grep -qw GRANULAR || { echo 'this LAMMPS has no package GRANULAR: nothing compared'; exit 0; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# our LAW SETTING: runs it, leaves the packing for LAMMPS
ours() {
    "$trundle" bench --packing "$work" --set "contact.rolling=$2" >"$work/said"
    awk -v row="$repeat,trundle,$1" '
        / us per step$/ {us = $3}
        $1 == 1000 || $1 == 6000 {s = s "," $2 "," $3 "," $4 "," $5 "," $6}
        END {print row "," us s}' "$work/said"
}
# theirs LAW STYLE
theirs() {
    lmp -in "$here/peer.lmp" -log none -var dir "$work" -var law "$2" -var compared 1000 -var timed 5000 >"$work/said" ||
        { cat "$work/said" >&2; exit 1; }
    awk -v row="$repeat,lammps-$2,$1" '
        /^Loop time/ {loop = $4; steps = $9}
        /CPU use with/ {us = 1e6*loop*$1/100/steps}
        $1 == 1000 || $1 == 6000 {if (NF == 6 && !seen[$1]++) s = s "," $2 "," $3 "," $4 "," $5 "," $6}
        END {print row "," us s}' "$work/said"
}
{
    echo 'repeat,code,law,us_per_step,touching,kinetic,spinning,xx,yy,touching_end,kinetic_end,spinning_end,xx_end,yy_end'
    repeat=0
    while [ "$repeat" -lt "$repeats" ]; do
        repeat=$((repeat + 1))
        ours rolling wang-spring
        theirs rolling rolling
        ours off none
        theirs off granular
        theirs off gran
    done
} >"$work/peers.csv"
mv "$work/peers.csv" "$out"
awk -f "$here/peers.awk" "$out"
