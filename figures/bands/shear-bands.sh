#!/bin/sh
# SPDX-License-Identifier: MIT
# Draws the shear bands of the two runs DIR/mu_r-0 and DIR/mu_r-0.5 of cases/shear-bands.yaml, and writes beside the
# picture, as CSV, whether rotations and rolling gather in bands.
# usage: shear-bands.sh DIR PICTURE.png
set -eu
export LC_ALL=C
dir=$1 picture=$2
here=$(dirname "$0")
{
    echo 'mu_r,quantity,value'
    for mu_r in 0 0.5; do
        awk -F, -f "$here/localisation.awk" "$dir/mu_r-$mu_r/disks.csv" | sed "s/^/$mu_r,/"
    done
} >"${picture%.png}.csv"
# words of "rotation" or "rolling", a word for each mu_r
words() {
    awk -F, -v p="$1" '$2 == p "gini" {g = $3} $2 == p "length" {printf "Gini %s, length %s ", g, $3}' "${picture%.png}.csv" |
        sed 's/Gini \([^ ]*\) length \([^ ]*\) /"Gini \1 correlation length \2" /g'
}
fact() { sed -n "s/.*\"$1\": \"*\([^\",]*\).*/\1/p" "$dir/mu_r-0/summary.json"; }
strain=$(awk -v s="$(fact strain_end)" 'BEGIN {printf "%g", 100*s}')
caption="Biaxial test, $(fact n_disks) disks, axial strain $strain %, I = $(fact inertial_number), seed $(fact seed), trundle $(fact version)"
gnuplot -d -e "dir = '$dir'; caption = '$caption'; rotation = '$(words '')'; rolling = '$(words rolling_)'; set output '$picture'" \
    -e 'set terminal pngcairo size 1100,1050 font "DejaVu Sans,15" enhanced' "$here/shear-bands.gp"
