#!/bin/sh
# SPDX-License-Identifier: MIT
# trundle convert: what a run has in its tables is in the files of other programs. VTK is read by meshio where it is
# installed (Debian: python3-meshio).
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
cases=$PWD/cases
cd "$work" || exit 1
cat >small.yaml <<'END'
kind: biaxial
seed: 3
sample: {disks: 40, r_min: 0.76 mm, r_max: 1.52 mm}
contact: {k_n: 160 MPa, mu: 0.5, mu_r: 0.5}
compaction: {pressure: 160 kPa, inertial_number: 0.1, unbalanced: 1e-2}
shear: {inertial_number: 0.01, strain_end: 0.01}
output: {frames: 0, curves: no, contacts: 3}
END
convert() { "$TRUNDLE" convert "$@" >stdout 2>stderr </dev/null; }
gives() { # CODE ARGUMENTS...
    code=$1
    shift
    convert "$@"
    equals $? "$code"
}
"$TRUNDLE" run small.yaml -o walls >/dev/null || echo 'not ok the run'
"$TRUNDLE" run small.yaml -o cell --set boundary=periodic --set sample.disks=60 >/dev/null || echo 'not ok the periodic run'
"$TRUNDLE" run "$cases/floor.yaml" -o bodies --frames 0 >/dev/null || echo 'not ok the bodies'

# ---- LAMMPS: line for line what the tables have ----
check 'to lammps' gives 0 walls --to lammps
check 'says where' equals "$(cat stdout)" '2 files in walls/lammps'
atoms() { awk '/^ITEM: ATOMS/ {on = 1; next} /^ITEM/ {on = 0} on {print $1 - 1, $3, $4, $6, $7, $8, $12}' walls/lammps/disks.dump; }
disks() { awk -F, 'NR > 1 {print $2, $3, $4, $10, $6, $7, $8}' walls/disks.csv; }
check 'all disks, in place, with radius, velocity and spin' equals "$(atoms | cksum)" "$(disks | cksum)"
entries() { awk '/^ITEM: ENTRIES/ {on = 1; next} /^ITEM/ {on = 0} on {print $2 - 1, $3 - 1, $9, $10, $11, $12}' walls/lammps/contacts.dump; }
contacts() { awk -F, 'NR > 1 {print $3, $4, $10, $11, $13, $14}' walls/contacts.csv; }
check 'all contacts, with forces and moments' equals "$(entries | cksum)" "$(contacts | cksum)"
check 'three instants' equals "$(grep -c '^ITEM: TIMESTEP' walls/lammps/disks.dump)" 3
inside() { awk '/^ITEM: BOX/ {getline; x0 = $1; x1 = $2; getline; y0 = $1; y1 = $2; next} /^ITEM: ATOMS/ {on = 1; next} /^ITEM/ {on = 0}
    on && (!(x1 > x0) || $3 < x0 || $3 > x1 || $4 < y0 || $4 > y1) {bad = 1} END {exit bad}' "$1"; }
check 'disks are in the box' inside walls/lammps/disks.dump
check 'of a periodic cell too' sh -c '"$0" convert cell --to lammps >/dev/null && grep -q "BOX BOUNDS pp pp pp" cell/lammps/disks.dump' "$TRUNDLE"
check 'and disks are in it' inside cell/lammps/disks.dump
check 'its sides are those of the history' awk -F '[ ,]' 'FNR == 1 {file++} file == 1 && FNR > 1 {last = $19} # width
    file == 2 && /^ITEM: BOX/ {getline; side = $2 - $1} END {exit !((side/last - 1)^2 < 1e-16)}' cell/history.csv cell/lammps/disks.dump

# ---- extended XYZ ----
check 'to extxyz' gives 0 bodies --to extxyz -o xyz
check 'an instant a row of the history' equals "$(grep -c Lattice= xyz/disks.xyz)" "$(tail -n +2 bodies/history.csv | cut -d, -f1 | uniq | wc -l)"
check 'radii are those of the case' equals "$(awk '/^D/ {print $5}' xyz/disks.xyz | sort -u)" 0.01

# ---- VTK ----
check 'to vtk' gives 0 walls --to vtk -o vtk
lines() { awk '/^CELLS/ {cells = 1} cells && /^2 / {n++} END {print n}' cell/vtk/000*.vtk; }
check 'of a cell too' gives 0 cell --to vtk
check 'a line for each contact' equals "$(lines)" "$(($(wc -l <cell/contacts.csv) - 1))"
check 'a file an instant' equals "$(cd vtk && echo *.vtk)" '0000.vtk 0001.vtk 0002.vtk'
python=
for p in python3 /usr/bin/python3; do $p -c 'import meshio' 2>/dev/null && python=$p && break; done
read_by_meshio() {
    "$python" - <<'END' >read && tail -n +2 walls/contacts.csv | awk -F, '{n[$1]++; f[$1] += $10} END {for (t in n) printf "%d %.6g\n", n[t], f[t]}' | sort >wanted &&
import meshio
for k in range(3):
    m = meshio.read("vtk/%04d.vtk" % k)
    cells = {c.type: len(c.data) for c in m.cells}
    assert cells["vertex"] == 40 and m.point_data["radius"][:40].min() > 0 and (m.point_data["radius"][40:] == 0).all()
    lines = [c.data for c in m.cells if c.type == "line"][0]
    f_n = [f for c, f in zip(m.cells, m.cell_data["f_n"]) if c.type == "line"][0]
    for a, b in lines:  # a line is no longer than both radii
        gap = ((m.points[a] - m.points[b]) ** 2).sum() ** 0.5 - m.point_data["radius"][a] - m.point_data["radius"][b]
        assert -1e-4 < gap < 1e-9
    print("%d %.6g" % (len(lines), f_n.sum()))
END
        equals "$(sort read)" "$(cat wanted)"
}
if [ "$python" ]; then
    check 'meshio reads disks, contacts and their forces' read_by_meshio
else
    skip 'meshio reads disks, contacts and their forces' 'no python3-meshio'
fi

# ---- what is refused ----
check 'a format that is not there: 2' gives 2 walls --to pdb
check 'those that are, are told' says stderr 'no format is called pdb'
check 'no format: 2' gives 2 walls
mkdir unfinished && cp walls/case.yaml walls/disks.csv unfinished
check 'a run that is not finished: 2' gives 2 unfinished --to vtk
check 'is told' says stderr 'unfinished is not the directory of a finished run'
"$TRUNDLE" run "$cases/contact-reversal.yaml" -o contact --set output.curves=no >/dev/null
check 'one contact: 2' gives 2 contact --to vtk
cp -r walls broken && sed -i '5s/^[^,]*,/1e9,/' broken/disks.csv
check 'disks that do not follow each other: 2' gives 2 broken --to vtk
mkdir mine && echo mine >mine/disks.xyz
check 'a file of the user is not written over: 3' gives 3 walls --to extxyz -o mine
check 'and stays' equals "$(cat mine/disks.xyz)" mine
finish
