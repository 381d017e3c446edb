#!/bin/sh
# SPDX-License-Identifier: MIT
# Contacts that are pressed too deep: the message names the key of the normal law and a value, and with that value the
# run holds.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
cd "$work" || exit 1

cat >test.yaml <<'CASE'
kind: biaxial
sample: {disks: 40, r_min: 0.76 mm, r_max: 1.52 mm}
contact: {k_n: 8 MPa, mu: 0.5, k_t: 4 MPa, mu_r: 0.1, k_r: 4 MPa}
compaction: {pressure: 160 kPa, inertial_number: 0.02, unbalanced: 1e-2}
shear: {inertial_number: 5e-3, strain_end: 0.2, walls: rough}
output: {frames: 0, rows: 20, curves: no}
CASE
cat >impact.yaml <<'CASE'
kind: bodies
time_end: 0.2 s
contact: {k_n: 1 MPa, damping_ratio: 0, friction: none, rolling: none}
disks: [{radius: 1, x: 0, y: 0, vx: 20}, {radius: 0.5, x: 1.6, y: 0, vx: -20}]
output: {frames: 0, rows: 20}
CASE
sed 's/^disks.*/disks: [{radius: 1, x: 0, y: 1}]\nwalls: [{nx: 0, ny: 1}]\ngravity: {y: -300}/; s/0.2 s/0.5 s/; s/ratio: 0/ratio: 0.3/' impact.yaml >weight.yaml

# soft CASE KEY ARGUMENTS...: fails, names KEY; then holds with what is named
soft() {
    case=$1 key=$2
    shift 2
    run_gives 4 "$case" -o out --force "$@" || return
    says stderr "contact.$key = " || return
    value=$(sed -n 's/.*from about \([^ ]*\) .* it would hold.*/\1/p' stderr)
    [ -n "$value" ] || { echo 'no value is named'; cat stderr; return 1; }
    run_gives 0 "$case" -o out --force "$@" --set "contact.$key=$value"
}
for seed in 1 2; do
    check "a biaxial test of seed $seed holds with the k_n that is named" soft test.yaml k_n --seed $seed
    check 'it says what is soft' run_gives 4 test.yaml -o out --force --seed $seed
    check 'and for what' says stderr 'contact.k_n = 8e+06 Pa is too soft for these stresses'
done
check 'in a periodic cell' soft test.yaml k_n --set boundary=periodic --set shear.walls=smooth --set contact.k_n='3 MPa'
check 'hertz-line: E_star' soft test.yaml E_star --set contact.normal=hertz-line --set contact.E_star='10 MPa'
sed 's/^contact.*/contact: {normal: hertz-sphere, E_star: 8 MPa, mu: 0.5, k_t: 10 kN\/m, mu_r: 0.1, k_r: 10 kN\/m}/; s/160 kPa/300 N\/m/' test.yaml >spheres.yaml
check 'spheres, hertz-sphere: E_star' soft spheres.yaml E_star --set shape=sphere
check 'an impact holds with the k_n that is named' soft impact.yaml k_n
check 'hertz-line: E_star' soft impact.yaml E_star --set contact.normal=hertz-line --set contact.E_star='1 MPa' --set step.safety=0.02
check 'with a dashpot' soft impact.yaml k_n --set contact.damping_ratio=0.3
check 'a weight' soft weight.yaml k_n
check 'a given motion cannot be stopped: no value' run_gives 4 impact.yaml -o out --force --set disks.0.motion=prescribed --set disks.1.motion=prescribed
check 'but it says what presses' says stderr 'the prescribed motion presses it'
check 'nor what overlaps at the start' run_gives 4 impact.yaml -o out --force --set disks.1.x=0.5
check 'which is told' says stderr 'the scene starts so: place them further apart'
# below the floor, or the floor turned over: both are told as the same thing
for ny in -1 1; do
    check "a disk behind a wall, ny: $ny" run_gives 4 weight.yaml -o out --force --set walls.0.ny=$ny --set "disks.0.y=-($ny)*disks.0.radius"
    check 'is told, and what to write' says stderr "disk 0 is behind wall 0, whose normal points to the other side: write nx: 0, ny: $((-ny)), or place"
done
finish
