#!/bin/sh
# SPDX-License-Identifier: MIT
# What a case may not mean is said before the run, as notes on standard error: the run goes on, and exit codes stay.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
cd "$work" || exit 1

cat >gears.yaml <<'CASE'
kind: bodies
time_end: 10 ms
contact: {k_n: 1 MPa, mu: 0.5, k_t: 0.5*k_n, rolling: none}
disks:
  - {radius: 20 mm, x: 0, y: 0, spin: 1, motion: prescribed}
  - {radius: 10 mm, x: 30 mm, y: 0, motion: pinned}
output: {rows: 4, contacts: 0, frames: 0}
CASE
once() { equals "$(grep -c "$1" stderr)" 1; }

check 'tangent disks: the run is done' run_gives 0 gears.yaml -o gears
check 'tangent disks: said once, with the pair' once '^note: disks 0 and 1 only touch'
check 'with an overlap' says stderr 'An overlap of 1e-06 m presses them with 1 N/m; give disk 1 x: 0.029999, y: 0'
check '--check says it too' run_gives 0 gears.yaml --check
check 'and that the case is fine' says stdout 'gears.yaml: ok'
check 'in the same words' says stderr 'note: disks 0 and 1 only touch'
check 'a place from the note' run_gives 0 gears.yaml -o mended --set disks.1.x=0.029999
check 'has no note' test ! -s stderr
{ cat gears.yaml; printf -- '---\nlabel: second\ndisks:\n'; sed -n 's/, spin: 1//; /radius/p' gears.yaml; } >two.yaml
check 'several scenes' run_gives 0 two.yaml --check
check 'the label tells which one is meant' once '^note: second: disks 0 and 1 only touch'

cat >far.yaml <<'CASE'
kind: bodies
time_end: 1 us
contact: {k_n: 1 MPa, damping_ratio: 0, friction: none, rolling: none}
disks:
  - {radius: 1 um, x: 1e5, y: 0, vx: 0.2}
  - {radius: 1 um, x: 1e5 + 2.01e-6, y: 0}
output: {rows: 4, contacts: 0, frames: 0}
CASE
check 'small disks far out: the run is done' run_gives 0 far.yaml -o far
check 'told of' once '^note: disks 0 and 1: numbers near 1e+05 m are 1.5e-11 m apart'
check 'what they do in a step too' once '^note: disk 0 moves by 2.6e-09 m a step'
check 'near the origin: no note' run_gives 0 far.yaml -o near --set disks.0.x=0 --set disks.1.x=2.01e-6
check 'none' test ! -s stderr
check 'too far for any overlap: refused' run_gives 2 far.yaml -o refused --set disks.0.radius=1e-9
check 'before a directory is made' not test -e refused
write_small_case stiff.yaml
check 'a sample that is too stiff is told of' run_gives 0 stiff.yaml --check --set contact.k_n=1e15 \
    --set compaction.inertial_number=1
check 'with the reason' says stderr 'note: contacts are too stiff for the pressure'
finish
