#!/bin/sh
# SPDX-License-Identifier: MIT
# The definitions of the rolling velocity side by side: pure motions, closed cycles, one contact, an assembly. Tables,
# pictures, one page.
#
#     figures/definitions/definitions.sh TRUNDLE DIR [SEEDS [CASE]]
#
# SEEDS: 3 by default. CASE: the biaxial test, cases/biaxial.yaml by default. DIR is made again, except runs that are
# there.
set -eu
export LC_ALL=C
trundle=$1 out=$2 seeds=${3:-3}
here=$(cd "$(dirname "$0")" && pwd)
base=$(realpath "${4:-$here/../../cases/biaxial.yaml}")
mkdir -p "$out"

# The program names its definitions where one is not known.
names=$("$trundle" run "$base" --check --set contact.rolling_velocity=no-such 2>&1 | sed -n 's/.*allowed is //p' | tr -d '|' | xargs) || true
[ -n "$names" ] || { echo "error: $trundle does not name its definitions of the rolling velocity" >&2; exit 1; }

# 1, 2: motions and cycles
"$here/../definitions.sh" "$trundle" >"$out/motions.csv"
awk -v names="$names" -v kinematics="$out/kinematics.csv" -v energy="$out/energy.csv" -f "$here/motions.awk" "$out/motions.csv"

# 3: one contact
{
    cat "$here/contact.yaml"
    for name in $names; do echo "  - {rolling: wang-spring, rolling_velocity: $name, mu_r: 0.01, k_r: 1 MPa}"; done
} >"$out/contact.yaml"
"$trundle" run "$out/contact.yaml" -o "$out/contact" --force --set output.curves=no >"$out/said" 2>&1 || { cat "$out/said" >&2; exit 1; }
sort -t, -k1,1n -k2,2n "$out/contact/contact.csv" | awk -v names="$names" -v rows="$out/path.csv" -v table="$out/contact.csv" -f "$here/contact.awk"

# 4: an assembly
cat >"$out/strength.yaml" <<CASE
# One packing a seed for all definitions.
kind: sweep
base: $base
seeds: 1-$seeds
vary: {contact.rolling_velocity: [$(echo "$names" | sed 's/ /, /g')]}
set: {output.frames: 0, output.curves: no, output.rows: 200, step.safety: 0.8}
compare: {key: contact.rolling_velocity, to: wang}
collect: [sin_phi_peak, sin_phi_residual, e_residual, energy.rolling.made_over_work]
CASE
"$trundle" sweep "$out/strength.yaml" -o "$out/strength" >"$out/said" 2>&1 || { cat "$out/said" >&2; exit 1; }
awk -f "$here/strength.awk" "$out/strength/collect.csv" >"$out/strength.csv"

rm -f "$out"/*.png
if command -v gnuplot >/dev/null; then
    terminal='set terminal pngcairo size 1350,1080 font "DejaVu Sans,20" enhanced rounded linewidth 1.5'
    gnuplot -d -e "csv = '$out/motions.csv'; set output '$out/motions.png'; $terminal" "$here/../definitions.gp"
    gnuplot -d -e "csv = '$out/path.csv'; names = '$names'; set output '$out/contact.png'; $terminal" "$here/style.gp" "$here/contact.gp"
    gnuplot -d -e "csv = '$out/strength/collect.csv'; table = '$out/strength.csv'; names = '$names'; set output '$out/strength.png'" \
        -e "set terminal pngcairo size 1350,700 font 'DejaVu Sans,18' enhanced rounded linewidth 1.5" "$here/style.gp" "$here/strength.gp"
else
    echo 'no pictures: gnuplot is not installed' >&2
fi
"$here/page.sh" "$out" "$seeds" "$("$trundle" --version)" "$names" >"$out/index.html.part"
mv "$out/index.html.part" "$out/index.html"
rm "$out/said"
