#!/bin/sh
# SPDX-License-Identifier: MIT
# What friction laws err on the paths that contacts of assemblies have: 400 disks between walls, and Kuhn's periodic
# assemblies with small and with large contacts, each replayed contact by contact.
#
#     figures/replay/replay.sh TRUNDLE DIR [SEED]
#
# All three to 20 % strain at I = 1e-3, 1000 instants, each disk between two plates (depth 0; `make kuhn` has less).
# Small contacts roll by 14 elements from one to the next, so they have half as many, which leaves 0.0014 mu P. Started
# again it does what is missing.
set -eu
export LC_ALL=C
trundle=$1 out=$2 seed=${3:-1}
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$out"

run() {
    name=$1 case=$2
    shift 2
    "$trundle" run "$here/../../cases/$case.yaml" -o "$out/$name" --resume --seed "$seed" "$@" >"$out/$name.said"
}
kuhn() {
    name=$1
    shift
    run "$name" kuhn-disks --set sample.disks=400 --set output.path_rows=1000 --set output.increments=no \
        --set shear.inertial_number=1e-3 --set shear.strain_end=0.2 --set contact.depth=0 "$@"
}
kuhn small --set compaction.inertial_number=3e-2 & small=$!
run walled biaxial-replay & walled=$!
kuhn large --set 'contact.E_star=95*compaction.pressure' & large=$!
for job in $small $walled $large; do wait "$job" || failed=$?; done
[ -z "${failed:-}" ] || exit "$failed"

for name in walled small large; do
    case $name in small) elements=30 ;; *) elements=60 ;; esac
    [ -e "$out/$name/replay-stress.csv" ] || "$trundle" replay "$out/$name" -n $elements >"$out/$name-replay.said"
done
awk -F, -f "$here/tables.awk" "$out"/*/replay.csv "$out"/*/replay-errors.csv "$out"/*/replay-stress.csv >"$out/tables.csv"
column -s, -t "$out/tables.csv" 2>/dev/null || cat "$out/tables.csv"
command -v gnuplot >/dev/null || { echo "no pictures: gnuplot is not installed; the numbers are in $out" >&2; exit 0; }
draw() {
    gnuplot -d -e "dir = '$out$2'; set output '$out/$3.png'" \
        -e 'set terminal pngcairo size 1500,1200 font "DejaVu Sans,18" enhanced rounded' "$here/$1.gp"
}
for name in walled small large; do draw replay "/$name" "$name"; done
draw sizes '' sizes
