#!/bin/sh
# SPDX-License-Identifier: MIT
# sample.file: Wang's test on a packing from a file. The disks of the run are those of the file; a case that was written runs
# again with the same bits, or tells that the file is another one; what does not fit is refused with its line.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
cd "$work" || exit 1
cat >thrown.yaml <<'END'
kind: biaxial
seed: 3
sample: {disks: 40, r_min: 0.76 mm, r_max: 1.52 mm}
contact: {k_n: 160 MPa, mu: 0.5, mu_r: 0.5}
compaction: {pressure: 160 kPa, inertial_number: 0.1, unbalanced: 1e-2}
shear: {inertial_number: 0.01, strain_end: 0.01}
output: {frames: 0, curves: no}
END
sed 's/^sample: .*/sample: {file: pack.csv}/' thrown.yaml >file.yaml
run() { "$TRUNDLE" run "$@" >stdout 2>stderr </dev/null; }
gives() { # CODE ARGUMENTS...
    code=$1
    shift
    run "$@"
    equals $? "$code"
}
"$TRUNDLE" run thrown.yaml -o thrown >/dev/null
awk -F, 'NR == 1 {print "x,y,r"; next} {print $3 "," $4 "," $10}' thrown/disks.csv >pack.csv
radii() { cut -d, -f10 "$1/disks.csv" | tail -n +2 | xargs; }

check 'a case that was written without a file runs again' gives 0 thrown/case.yaml -o again
check 'with the same bits' cmp thrown/history.csv again/history.csv
check 'a packing from CSV' gives 0 file.yaml -o csv
check 'has its radii, in their order' equals "$(radii csv)" "$(cut -d, -f3 pack.csv | tail -n +2 | xargs)"
# It was dense: compacted again it has the void ratio of a packing, and what it weighs did not change.
check 'and is as dense' awk -F, 'NR == 2 && FNR == 2 {e = $5} FNR == 2 && NR > 2 {exit !($5 > 0.1 && ($5 - e)^2 < 0.05^2)}' thrown/history.csv csv/history.csv
check 'the case that it wrote' gives 0 csv/case.yaml -o csv2
check 'gives the same bits' cmp csv/history.csv csv2/history.csv
"$TRUNDLE" convert thrown --to lammps -o dump >/dev/null
check 'the same from a dump' gives 0 file.yaml -o dumped --set sample.file=dump/disks.dump
check 'of the same disks' equals "$(radii dumped)" "$(radii csv)"
check 'and the same bits, for its box is around the disks' cmp csv/history.csv dumped/history.csv
check 'two threads and a stop change nothing' sh -c '"$0" run file.yaml -o stopped --checkpoint 0 >/dev/null && cmp csv/history.csv stopped/history.csv' "$TRUNDLE"
check 'in a periodic cell' gives 0 file.yaml -o cell --set boundary=periodic --set sample.width=30\ mm --set sample.height=30\ mm
check 'bench does not take it: 2' sh -c '! "$0" bench file.yaml 2>stderr' "$TRUNDLE"

# ---- refused ----
check 'file and radii: 2' gives 2 file.yaml -o no --set sample.r_min=1\ mm
check 'are told' says stderr '`r_min` and `file` mean the same: give one of them'
check 'neither: 2' gives 2 file.yaml -o no --set 'sample.file='
check 'is told' says stderr '`sample.r_min` is missing: smallest radius; radii are uniform from r_min to r_max [m]; or give file'
check 'no such file: 3' gives 3 file.yaml -o no --set sample.file=none.csv
refuses() { # ROWS MESSAGE
    printf "$1" >bad.csv
    gives 2 file.yaml -o no --set sample.file=bad.csv && says stderr "$2" && not test -e no
}
check 'disks that overlap too much, with the line' refuses 'x,y,r\n0,0,0.001\n0.0016,0,0.002\n0.01,0,0.002\n' \
    'bad.csv:3: error: this disk and that of line 2 overlap by 0.0014 m, more than 0.3 of the smaller radius, 0.001 m'
check 'a disk outside of the box' sh -c 'printf "x,y,r\n0.005,0.005,0.001\n0.0095,0.005,0.001\n" >bad.csv
    "$0" run file.yaml -o no --set sample.file=bad.csv --set sample.width="10 mm" --set sample.height="10 mm" 2>stderr; test $? = 2' "$TRUNDLE"
check 'with its line' says stderr 'bad.csv:3: error: this disk leaves the box: x = 0.0095 m, r = 0.001 m, and the box is 0 m to 0.01 m'
check 'over the edge of a cell' sh -c 'printf "x,y,r\n0.0001,0.005,0.001\n0.0299,0.005,0.001\n" >bad.csv
    "$0" run file.yaml -o no --set sample.file=bad.csv --set boundary=periodic --set sample.width="30 mm" --set sample.height="30 mm" 2>stderr; test $? = 2' "$TRUNDLE"
check 'too' says stderr 'bad.csv:3: error: this disk and that of line 2 overlap by 0.0018 m'
check 'a radius of 0' refuses 'x,y,r\n0,0,0.001\n1,0,0\n' 'bad.csv:3: error: the radius is 0: it must be above 0'
check 'no column of radii' refuses 'x,y\n0,0\n' 'bad.csv:1: error: no column r'
check 'one disk' refuses 'x,y,r\n0,0,1\n' '1 disk: a sample has two or more'
check 'a number that is none' refuses 'x,y,r\n0,zero,1\n' 'bad.csv:2: error: y is "zero", which is not a number'
check 'a dump without radii' refuses 'ITEM: TIMESTEP\n0\nITEM: ATOMS id x y\n1 0 0\n' 'bad.csv:3: error: the atoms have no column radius'
check 'a dump that is cut' refuses 'ITEM: TIMESTEP\n0\nITEM: ATOMS id x y radius\n1 0 0\n' 'bad.csv:4: error: fewer cells'
check 'a box that is none' refuses 'ITEM: BOX BOUNDS ff ff pp\n1 0\n' 'bad.csv:2: error: this must be the low and the high end'
echo '1,1,0.001' >>pack.csv
check 'a file that has changed since: 2' gives 2 csv/case.yaml -o no
check 'is told' says stderr 'pack.csv is not the file that it was'
finish
