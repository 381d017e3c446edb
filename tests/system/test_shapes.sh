#!/bin/sh
# SPDX-License-Identifier: MIT
# Spheres, and Hertz contacts of disks, from the case to the tables: units of columns and keys, and results that make
# sense.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
cd "$work" || exit 1

sample() { # SHAPE CONTACT PRESSURE
    cat <<CASE
kind: biaxial
shape: $1
sample: {disks: 100, r_min: 0.76 mm, r_max: 1.52 mm}
contact: {$2, mu: 0.5, rolling: wang-spring, mu_r: 0.2}
compaction: {pressure: $3, inertial_number: 0.05, unbalanced: 1e-3}
shear: {inertial_number: 2e-3, strain_end: 0.03}
output: {frames: 1, rows: 50}
CASE
}
sample sphere 'normal: hertz-sphere, E_star: 1 GPa, k_t: 100 kN/m, k_r: k_t' '200 N/m' >sphere.yaml
sample disk 'normal: hertz-line, E_star: 500 MPa, k_t: 80 MPa, k_r: k_t' '160 kPa' >disk.yaml
cat >contact.yaml <<'CASE'
kind: contact
bodies: {R1: 10 mm, R2: 10 mm, E: 70 GPa, nu: 0.3, shape: sphere}
laws:
  - {normal: hertz-sphere, friction: coulomb-spring, mu: 0.3, k_t: 1 MN/m, rolling: wang-spring, mu_r: 0.01, k_r: 1 kN/m}
path:
  - {force: 10 N, slide: 2 um, roll: 3*a, steps: 40}
CASE

for shape in sphere disk; do check "a biaxial test of ${shape}s runs" run_gives 0 $shape.yaml -o $shape; done
check 'a contact of spheres runs' run_gives 0 contact.yaml -o contact
check 'its report has their units' says stdout 'Q = 2 N, moment_1 = 0.0005 N m' # 1 MN/m * 2 um; 0.01 * 10 N * 5 mm

# Of disks a column ends in _N_per_m (forces), _N (moments), _Pa (stresses), _J_per_m; of spheres in _N, _N_m, _N_per_m,
# _J.
names() { head -n 1 "$1" | tr , '\n'; }
of_spheres() { sed 's/^moment_\(.*\)_N$/moment_\1_N_m/; s/_N_per_m$/_N/; s/_Pa$/_N_per_m/; s/_\(J\|kg\)_per_m$/_\1/'; }
for table in history contacts; do
    check "units of $table.csv" equals "$(names disk/$table.csv | of_spheres)" "$(names sphere/$table.csv)"
done
check 'disks have theirs' sh -c "head -n 1 disk/history.csv | grep -q 'stress_1_Pa,.*mean_f_n_N_per_m,.*work_J_per_m'"
check 'contact.csv' says contact/contact.csv \
    'law,step,segment,u_slide_m,u_roll_m,P_N,Q_N,q,a_m,moment_1_N_m,moment_2_N_m,f_r_N'
keys() { sed -n 's/^ *"\([^"]*\)":.*/\1/p' "$1" | grep '_'; }
check 'keys of summary.json' equals "$(keys disk/summary.json | of_spheres)" "$(keys sphere/summary.json)"
for key in mean_stress_2_N_per_m mean_mass_kg servo_mass_kg energy_work_J; do
    check "summary.json has $key" says sphere/summary.json "\"$key\":"
done
for key in E_star_Pa Q_end_N Q_max_N moment_1_end_N_m moment_max_N_m; do
    check "summary.json of the contact has $key" says contact/summary.json "\"$key\":"
done
if command -v gnuplot >/dev/null; then
    check 'its curves have their units' says contact/plot.gp "force = 'N'"
    check 'and are drawn' test -s contact/contact.png
else
    for what in 'its curves have their units' 'and are drawn'; do skip "$what" 'no gnuplot'; done
fi

# Means over the rows of history.csv, energies and void ratio of the last: of so few disks one instant may have few
# contacts. 2.5 < coordination < 4.5: isostatic is 3 (friction) to 4; void ratio: loose to denser than 400 mono-sized
# disks; the lateral pressure is held; the energy residual is below 2e-3 of the work.
sensible() { # DIR PRESSURE
    awk -F, -v p="$2" 'NR == 1 { for (i = 1; i <= NF; i++) { sub(/_(Pa|N_per_m|J|J_per_m)$/, "", $i); at[$i] = i }; next }
        { s1 += $at["stress_1"]; s2 += $at["stress_2"]; n++; work = $at["work"]; residual = $at["residual"]
          z += $at["coordination"]; e = $at["void_ratio"] }
        END { z /= n; print z, e, s1/n, s2/n, residual/work
              exit !(z > 2.5 && z < 4.5 && e > 0.1 && e < 0.35 && s1 > 1.3*s2 && s2/n > 0.95*p && s2/n < 1.05*p &&
                     residual < 2e-3*work && residual > -2e-3*work) }' "$1/history.csv"
}
check 'spheres give sensible numbers' sensible sphere 200
check 'so do Hertz contacts of disks' sensible disk 160000
for shape in sphere disk; do
    check "the resolved case of ${shape}s" run_gives 0 $shape/case.yaml -o again --force
    check 'gives the same bytes' cmp $shape/history.csv again/history.csv
done
finish
