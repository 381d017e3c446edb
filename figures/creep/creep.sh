#!/bin/sh
# SPDX-License-Identifier: MIT
# Kuhn's two kinds of rolling resistance in the biaxial test: a contact moment (Wang's), and creep (Dahlberg and
# Alfredsson's friction with Carter's creepage). Each off and on, the creep by both meanings of rolling. Tables,
# pictures, a film, one page.
#
#     figures/creep/creep.sh TRUNDLE DIR [SEEDS [CASE]]
#
# SEEDS: 24 by default, at least 2. CASE: cases/biaxial-creep.yaml by default. Continues with the finished runs. The
# rule of the verdicts is in effects.awk, and was written before the runs.
set -eu
export LC_ALL=C
trundle=$1 out=$2 seeds=${3:-24}
here=$(cd "$(dirname "$0")" && pwd)
[ "$seeds" -ge 2 ] || { echo 'error: at least two seeds are needed' >&2; exit 2; }
base=$(realpath "${4:-$here/../../cases/biaxial-creep.yaml}")
mkdir -p "$out"

# sweep NAME: one packing a seed for all its points
sweep() {
    {
        printf 'kind: sweep\nbase: %s\nseeds: 1-%d\n' "$base" "$seeds"
        cat
        echo 'set: {output.frames: 0, output.curves: no, output.energy: no, output.rows: 201, step.safety: 0.8}'
        echo 'collect: [sin_phi_peak, sin_phi_residual, e0, e_residual, rolling_share_residual]'
    } >"$out/$1.yaml"
    "$trundle" sweep "$out/$1.yaml" -o "$out/$1" >"$out/said" 2>&1 || { cat "$out/said" >&2; exit 1; }
}
sweep laws <<'CASE'
vary: {contact.mu_r: [0, 0.5], contact.friction: [coulomb-spring, dahlberg-alfredsson]}
CASE
sweep kuhn <<'CASE'
vary: {contact.mu_r: [0, 0.5], contact.creep_roll: [kuhn]}
CASE
awk -v used="$out/seeds" -f "$here/../student.awk" -f "$here/effects.awk" "$out/laws/points.csv" "$out/kuhn/points.csv" \
    >"$out/effects.csv"
# rows DIRECTORY: history.csv of the seeds that count
rows() { while read -r seed; do echo "$1,seed=$seed/history.csv"; done <"$out/seeds"; }
for run in 'spring|laws|coulomb-spring' 'creep|laws|dahlberg-alfredsson' 'kuhn|kuhn|kuhn'; do
    IFS='|' read -r name sweep value <<NAMES
$run
NAMES
    for mu_r in 0 0.5; do
        rows "$(echo "$out/$sweep/mu_r=$mu_r,"*"=$value,seed=1" | sed 's/,seed=1$//')" | tr '\n' '\0' |
            xargs -0 awk -f "$here/../student.awk" -f "$here/curve.awk" -v mu_r="$mu_r" -v friction="$name"
    done
done >"$out/curves.csv"

"$trundle" run "$base" -o "$out/film" --force >"$out/said" 2>&1 || { cat "$out/said" >&2; exit 1; }
rm -f "$out"/*.png "$out/said" "$out/seeds"
if command -v gnuplot >/dev/null; then
    for picture in curves effects; do
        gnuplot -d -e "dir = '$out'; set output '$out/$picture.png'" \
            -e "set terminal pngcairo size 1350,1080 font 'DejaVu Sans,20' enhanced rounded linewidth 1.5" "$here/$picture.gp"
    done
else
    echo 'no pictures: gnuplot is not installed' >&2
fi
"$here/page.sh" "$out" "$("$trundle" --version)" >"$out/index.html.part"
mv "$out/index.html.part" "$out/index.html"
