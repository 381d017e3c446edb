#!/bin/sh
# SPDX-License-Identifier: MIT
# Film and still of what the contacts of Kuhn's assemblies do [Kuhn2014 sec. 3.2], large and small contacts at equal
# strain, with creep; and what the fields say, as numbers.
#
#     figures/kuhn/film.sh TRUNDLE DIR
#
# 400 disks, so that a contact is seen from the back of a room; up to 10 % strain, in intervals of 0.1 % as in kuhn.sh,
# an instant of contacts each. Runs that are there are not run again.
set -eu
export LC_ALL=C
trundle=$1 out=$2
here=$(cd "$(dirname "$0")" && pwd)
fields=$out/fields
instants=100
mkdir -p "$out"
run() { # NAME SETTING
    "$trundle" run "$here/../../cases/kuhn-disks.yaml" -o "$out/$1" --resume --set sample.disks=400 --set shear.strain_end=0.1 \
        --set output.rows=$((instants + 1)) --set output.contacts=$instants --set "$2" >"$out/$1.said"
}
run large 'contact.E_star=95*compaction.pressure'
run small compaction.inertial_number=3e-2
awk -F, -v classes="$out/classes.csv" -f "$here/fields.awk" "$out/large/contacts.csv" "$out/small/contacts.csv" >"$out/correlations.csv"

command -v gnuplot >/dev/null || { echo "no pictures: gnuplot is not installed; the numbers are in $out" >&2; exit 0; }
rm -rf "$fields"
mkdir "$fields"
for size in large small; do
    awk -F, -v out="$fields/$size" -f "$here/film.awk" "$out/$size/disks.csv" "$out/$size/contacts.csv"
done
draw() { # FIRST PICTURE WIDTH,HEIGHT SCALE
    gnuplot -d -e "runs = '$out'; fields = '$fields'; first = $1; last = $instants; picture = '$2'" \
        -e "set terminal pngcairo size $3 font 'DejaVu Sans,13' enhanced rounded fontscale $4 linewidth $4" "$here/film.gp"
}
draw $instants "$out/slip-fields.png" 1280,720 1
if command -v ffmpeg >/dev/null; then
    draw 1 "$fields/%03d.png" 1920,1080 1.5
    ffmpeg -nostdin -loglevel error -framerate 8 -i "file:$fields/%03d.png" -c:v libx264 -threads 2 -pix_fmt yuv420p \
        -flags:v +bitexact -fflags +bitexact -movflags +faststart -f mp4 -y "file:$out/slip-fields.mp4"
else
    echo "no film: ffmpeg is not installed; the still is $out/slip-fields.png" >&2
fi
rm -r "$fields"
