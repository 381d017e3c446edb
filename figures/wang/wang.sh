#!/bin/sh
# SPDX-License-Identifier: MIT
# Wang's Figs. 5 and 6 by sweeps, what the paper leaves open, a verdict on each of its claims, and the pictures.
#
#     figures/wang/wang.sh TRUNDLE DIR [SEEDS]
#
# Started again it does what is missing; more seeds go on from fewer. SEEDS: 32 by default, half of it where one thing
# after the other is changed. With fewer than 16 only the figures of the paper and the verdicts are made: 3 take a
# minute, and decide little.
set -eu
export LC_ALL=C
trundle=$1 out=$2 seeds=${3:-32}
here=$(cd "$(dirname "$0")" && pwd)
base=$here/../../cases/biaxial.yaml
half=$(((seeds + 1) / 2))
mkdir -p "$out"

# sweep NAME SEEDS: the sweep $out/NAME.yaml, whose first lines are written here
sweep() {
    { printf 'kind: sweep\nbase: %s\nseeds: 1-%d\n' "$base" "$2" && cat; } >"$out/$1.yaml"
    "$trundle" sweep "$out/$1.yaml" -o "$out/$1" >"$out/$1.said"
}
cheap='output.frames: 0, output.energy: no, output.curves: no, output.rows: 200'
strength='sin_phi_residual, sin_phi_peak, e_residual'

sed '/^kind\|^base\|^seeds/d' "$here/strength.yaml" | sweep strength "$seeds"

# What the paper does not give, one after the other: NAME|WORDS|SETTINGS. A lever of 2 R_eff is twice mu_r and k_r.
unstated="
given|as in the figures|
kr-small|k_r = k_t/10|contact.k_r: 0.1*k_t,
kr-large|k_r = 10 k_t|contact.k_r: 10*k_t,
mu-small|μ = 0.3|contact.mu: 0.3,
mu-large|μ = 0.8|contact.mu: 0.8,
rough|rough walls|shear.walls: rough,
soft|κ = 300|contact.k_n: 48 MPa,
hard|κ = 3000|contact.k_n: 480 MPa,
lever|lever 2 R_{eff}|contact.k_r: 2*k_t,"
# Is the answer that of slow tests with hard disks, and of no step? NAME|QUANTITY|VALUE|SETTINGS
independence="
I-1e-2|I|1e-2|shear.inertial_number: 1e-2
I-3e-3|I|3e-3|shear.inertial_number: 3e-3
I-1e-3|I|1e-3|shear.inertial_number: 1e-3
I-3e-4|I|3e-4|shear.inertial_number: 3e-4
I-1e-4|I|1e-4|shear.inertial_number: 1e-4
kappa-300|kappa|300|contact.k_n: 48 MPa
kappa-1000|kappa|1000|contact.k_n: 160 MPa
kappa-3000|kappa|3000|contact.k_n: 480 MPa
dt-0.8|dt|0.8|step.safety: 0.8
dt-0.4|dt|0.4|step.safety: 0.4
dt-0.2|dt|0.2|step.safety: 0.2"
change_one_thing() {
    echo "$unstated" | while IFS='|' read -r name words settings; do
        [ -n "$name" ] || continue
        mu_r='0.5, 2'
        [ "$name" != lever ] || mu_r='1, 4'
        sweep "unstated-$name" "$half" <<CASE
vary: {contact.mu_r: [$mu_r], contact.rolling_velocity: [wang, alonso-min, alonso-mean]}
set: {$settings $cheap, step.safety: 0.8}
compare: {key: contact.rolling_velocity, to: wang}
collect: [$strength]
CASE
    done
    echo "$independence" | while IFS='|' read -r name quantity value settings; do
        [ -n "$name" ] || continue
        case $quantity in dt) ;; *) settings="$settings, step.safety: 0.8" ;; esac
        sweep "independence-$name" "$half" <<CASE
vary: {contact.mu_r: [0.5], contact.rolling_velocity: [wang, alonso-min]}
set: {$settings, $cheap}
compare: {key: contact.rolling_velocity, to: wang}
collect: [$strength]
CASE
    done
}

# rows OF: "LABEL,..." of each sweep of a group, with what was changed in front
rows() {
    echo "$2" | while IFS='|' read -r name words rest; do
        [ -n "$name" ] || continue
        case $1 in independence) words="$words,${rest%%|*}" ;; esac
        awk -v words="$words" 'NR > 1 {print words "," $0}' "$out/$1-$name/collect.csv"
    done
}
columns='mu_r,model,quantity,minus,seeds,mean,standard_error,low_95,high_95'
figures='fig5 fig6 reason'
if [ "$seeds" -ge 16 ]; then
    change_one_thing
    { echo "changed,$columns" && rows unstated "$unstated"; } >"$out/unstated.csv"
    { echo "changed,value,$columns" && rows independence "$independence"; } >"$out/independence.csv"
    figures="$figures unstated independence"
fi
awk -F, -f "$here/../student.awk" -f "$here/../student.awk" -f "$here/verdicts.awk" "$out/strength/points.csv" >"$out/verdicts.csv"

fact() { sed -n "s/.*\"$1\": \"*\([^\",]*\).*/\1/p" "$out/strength/mu_r=0,rolling_velocity=wang,seed=1/summary.json"; }
facts="$(fact n_disks) disks, I = $(fact inertial_number), κ = $(fact stiffness_ratio | sed 's/\.0$//'), trundle $(fact version)"
command -v gnuplot >/dev/null || { echo "no pictures: gnuplot is not installed; the numbers are in $out" >&2; exit 0; }
for figure in $figures; do
    seeds_of=$seeds
    case $figure in unstated | independence) seeds_of=$half ;; esac
    gnuplot -d -e "dir = '$out'; caption = '$facts, $seeds_of seeds, bars: 95 %'; set output '$out/$figure.png'" \
        -e 'set terminal pngcairo size 1350,1080 font "DejaVu Sans,20" enhanced rounded linewidth 1.5' \
        "$here/models.gp" "$here/$figure.gp"
done
column -s, -t "$out/verdicts.csv" 2>/dev/null || cat "$out/verdicts.csv"
