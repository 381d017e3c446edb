#!/bin/sh
# SPDX-License-Identifier: MIT
# How much does the strength of one sample differ from the next, and is the interval that `trundle run` prints right?
#
#     figures/spread/spread.sh TRUNDLE DIR
#
# Measures the rows of src/study/spread.c again and prints them (DIR/rows.csv, DIR/step.csv, DIR/rows.c); then tests, by
# the rule of rule.awk, whether the interval about each of 200 fresh samples covers the mean (DIR/coverage.csv). Exit
# code 1: it does not. Started again it does what is missing. Some 25 minutes of a processor.
set -eu
export LC_ALL=C
trundle=$1 out=$2
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$out"

# sweep NAME SEEDS DISKS NUMBERS SAFETY: of cases/biaxial.yaml, and with creep of cases/biaxial-creep.yaml. Points of
# both: DIR/NAME.csv.
sweep() {
    for law in coulomb-spring dahlberg-alfredsson; do
        case $law in coulomb-spring) base=biaxial ;; *) base=biaxial-creep ;; esac
        cat >"$out/$1-$law.yaml" <<CASE
kind: sweep
base: $here/../../cases/$base.yaml
seeds: $2
vary: {contact.mu_r: [0, 0.5], contact.friction: [$law], shear.inertial_number: [$4]}
set: {sample.disks: $3, step.safety: $5, output.frames: 0, output.energy: no, output.curves: no}
collect: [sin_phi_peak, sin_phi_residual, n_disks]
CASE
        "$trundle" sweep "$out/$1-$law.yaml" -o "$out/$1-$law" --yes >"$out/$1-$law.said"
    done
    awk 'NR == 1 || FNR > 1' "$out/$1"-*/points.csv >"$out/$1.csv"
}

sweep n100 1-64 100 '1e-3, 3e-3' 0.4
sweep n400 1-32 400 '1e-3, 3e-3' 0.4
sweep half-step 1-32 400 3e-3 0.2
sweep fresh 1001-1200 100 3e-3 0.4
sweep n1600 1-8 1600 '1e-3, 3e-3' 0.4

awk -F, -f "$here/rows.awk" "$out/n100.csv" "$out/n400.csv" "$out/n1600.csv" >"$out/rows.csv"
awk -F, -f "$here/step.awk" "$out/n400.csv" "$out/half-step.csv" >"$out/step.csv"
awk -F, -f "$here/table.awk" "$out/step.csv" "$out/rows.csv" >"$out/rows.c"
cat "$out/rows.c"
awk -F, -f "$here/../student.awk" -f "$here/rule.awk" "$out/rows.csv" "$out/fresh.csv" >"$out/coverage.csv" || {
    cat "$out/coverage.csv"
    exit 1
}
cat "$out/coverage.csv"
