#!/bin/sh
# SPDX-License-Identifier: MIT
# The tables, the verdicts and the picture of the runs of kuhn.sh that are finished: tables.sh DIR
set -eu
export LC_ALL=C
out=$1
here=$(cd "$(dirname "$0")" && pwd)
awk -F, -v tables="$out/tables.csv" -f "$here/../student.awk" -f "$here/tables.awk" "$out"/*/history.csv >"$out/verdicts.csv"
column -s, -t "$out/verdicts.csv" 2>/dev/null || cat "$out/verdicts.csv"
command -v gnuplot >/dev/null || { echo "no picture: gnuplot is not installed; the numbers are in $out" >&2; exit 0; }
# As the resolved case has it; a run that stopped early has no summary.
fact() { sed -n "s/^ *$2: *\([^ ]*\).*/\1/p" "$out/disks-$1-kuhn-creep/case.yaml" | tail -n 1; }
caption="large: $(fact large disks) disks, I = $(fact large inertial_number); small: $(fact small disks), $(fact small inertial_number); mean stress held"
gnuplot -d -e "dir = '$out'; caption = '$caption'; set output '$out/fig6.png'" \
    -e 'set terminal pngcairo size 1350,1080 font "DejaVu Sans,20" enhanced rounded linewidth 1.5' "$here/fig6.gp"
