#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs by two and three threads of more than 4000 disks, where they share the work, with frames, under ThreadSanitizer.
# A race ends one with
# code 66 and is printed. The packing is made by the plain program: it takes ten times as long under the sanitizer.
# usage: tests/tsan/run.sh TRUNDLE TRUNDLE-OF-THE-SANITIZER
set -eu
plain=$(realpath "$1") trundle=$(realpath "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat >"$work/case.yaml" <<'CASE'
kind: biaxial
seed: 1
sample: {disks: 4100, r_min: 0.76 mm, r_max: 1.52 mm}
contact: {k_n: 50 MPa, mu: 0.5, mu_r: 0.5}
compaction: {pressure: 160 kPa, inertial_number: 0.05, unbalanced: 0.1}
shear: {inertial_number: 0.01, strain_end: 0.01}
output: {frames: 6, rows: 4, contacts: 1, curves: no}
CASE
"$plain" run "$work/case.yaml" -o "$work/plain" --sample "$work/sample.bin" --threads 2 >/dev/null 2>&1

for threads in 2 3; do
    code=0
    "$trundle" run "$work/case.yaml" -o "$work/$threads" --sample "$work/sample.bin" --threads $threads >"$work/said" 2>&1 || code=$?
    [ $code -eq 0 ] || { cat "$work/said"; exit $code; }
    cmp "$work/plain/history.csv" "$work/$threads/history.csv"
    echo "no race: 4100 disks, $threads threads, 6 frames; the rows are those of the plain program"
done
