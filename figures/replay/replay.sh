#!/bin/sh
# SPDX-License-Identifier: MIT
# What friction laws err on the paths that contacts of assemblies have: 400 disks between walls, and Kuhn's periodic assemblies with
# small and with large contacts, each replayed contact by contact.
#
#     figures/replay/replay.sh TRUNDLE DIR [SEED]
#
# All three to 20 % strain at I = 1e-3, 1000 instants. Started again it does what is missing.
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
        --set shear.inertial_number=1e-3 --set shear.strain_end=0.2 "$@"
}
kuhn small --set compaction.inertial_number=3e-2 & small=$!
run walled biaxial-replay & walled=$!
kuhn large --set 'contact.E_star=95*compaction.pressure' & large=$!
wait $small && wait $walled && wait $large

for name in walled small large; do
    [ -e "$out/$name/replay-stress.csv" ] || "$trundle" replay "$out/$name" >"$out/$name/replay.said"
    cat "$out/$name/replay.said"
done
awk -F, -f "$here/tables.awk" "$out"/*/replay.csv "$out"/*/replay-errors.csv "$out"/*/replay-stress.csv >"$out/tables.csv"
column -s, -t "$out/tables.csv" 2>/dev/null || cat "$out/tables.csv"
command -v gnuplot >/dev/null || { echo "no pictures: gnuplot is not installed; the numbers are in $out" >&2; exit 0; }
for name in walled small large; do
    gnuplot -d -e "dir = '$out/$name'; set output '$out/$name.png'" \
        -e 'set terminal pngcairo size 1500,1200 font "DejaVu Sans,18" enhanced rounded' "$here/replay.gp"
done
