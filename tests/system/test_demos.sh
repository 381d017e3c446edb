#!/bin/sh
# SPDX-License-Identifier: MIT
# The demonstrations: every number that a case of kind bodies measures is where its closed form says; a number that is
# not is noticed; scenes side by side do not touch each other.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
cases=$(realpath "$(dirname "$0")/../../cases")
cd "$work" || exit 1

slopes=$cases/../figures/gallery/slopes.sh
for law in $("$slopes" --list); do "$slopes" "$law" >"$work/$law.yaml"; done
for case in "$cases"/*.yaml "$work"/*.yaml; do
    grep -q '^kind: bodies' "$case" || continue
    demo=$(basename "$case" .yaml)
    check "$demo: its numbers are those of the closed forms" run_gives 0 "$case" --frames 0 -o "$demo"
    check "$demo: it has numbers" grep -q '"exact"' "$demo/summary.json"
    check "$demo: it has a lesson" grep -q '"question"' "$demo/summary.json"
    check "$demo: with answers to choose from" grep -q '"choices"' "$demo/summary.json"
    in_german() { run_gives 0 "$case" --lang de --frames 0 -o "$demo-de" && [ "$(title "$demo")" != "$(title "$demo-de")" ]; }
    title() { sed -n 's/^ *"title": //p' "$1/summary.json" | head -n 1; }
    check "$demo: in German too, with the same numbers" in_german
    check "$demo: what its film shows is told too" grep -q '"happens"' "$demo/summary.json"
    # of a lesson all but its texts: which there are, how many answers, which one is right
    lesson() { sed -nE '/"lesson"/,/}/{ s/^( {4}"[a-z]+": ").*/\1/; s/^ {6}".*/      answer/; p; }' "$1/summary.json"; }
    check "$demo: the German lesson has the same parts and the same right answer" \
        equals "$(lesson "$demo-de")" "$(lesson "$demo")"
done

# ---- the closed forms follow the case, and the motion follows them: other values, still within the tolerance ----
check 'slip to roll on ice' run_gives 0 "$cases/slip-to-roll.yaml" --frames 0 -o ice --set contact.mu=0.15 --set time_end=0.5
check 'slip to roll, faster' run_gives 0 "$cases/slip-to-roll.yaml" --frames 0 -o fast --set disks.0.vx=1.5 --set time_end=0.5
check 'a slope with other coefficients' run_gives 0 "$cases/incline.yaml" --frames 0 -o other \
    --set contact.mu=0.4 --set contact.mu_r=0.05
check 'coasting with half the resistance stops later' run_gives 0 "$cases/coasting.yaml" --frames 0 -o half \
    --set contact.mu_r=0.05 --set time_end=3.2

# ---- a wrong number is noticed, and the run is complete all the same ----
fails_check() {
    run_gives 1 "$@" && says stderr 'of the checks of' && says stdout FAILED && grep -q '"ok": false' wrong/summary.json
}
check 'a wrong time' fails_check "$cases/slip-to-roll.yaml" --frames 0 -o wrong --set checks.0.exact=0.12
check 'a wrong acceleration, for the slope is another' fails_check "$cases/incline-free.yaml" --frames 0 -o wrong --force --set 'contact.mu=0.2' --set gravity.x=3
check 'a wrong velocity' fails_check "$cases/floor.yaml" --frames 0 -o wrong --force --set 'checks.4.exact=1 um/s'
never() {
    fails_check "$cases/slip-to-roll.yaml" --frames 0 -o wrong --force --set contact.mu=0 --set checks.0.exact=0.1 &&
        says stdout 'never happened' && grep -q '"measured": null' wrong/summary.json
}
check 'what does not happen' never

# ---- scenes side by side: each gives the numbers that it gives alone ----
cat >both.yaml <<'CASE'
kind: bodies
time_end: 0.05 s
label: slow
gravity: {y: -9.81 m/s^2}
contact: {k_n: 1 MPa, mu: 0.5, mu_r: 0.1}
disks:
  - {radius: 10 mm, x: 0, y: 11 mm, vx: 0.1 m/s}
walls:
  - {nx: 0, ny: 1}
output: {frames: 0, rows: 11, contacts: 3}
---
label: stiff
contact: {k_n: 100 MPa}
CASE
sed '/^---/,$d' both.yaml >slow.yaml
sed '/^---/,$d; s/k_n: 1 MPa/k_n: 100 MPa/' both.yaml >stiff.yaml
alone() {
    for one in both slow stiff; do run_gives 0 $one.yaml -o "side/$one" || return 1; done
    # the stiff scene has more steps and gives the time, so its rows are the same; the slow one is within a step of it
    grep '^1,' side/both/history.csv | cut -d, -f2- >a
    tail -n +2 side/stiff/history.csv >b
    cmp a b && [ "$(grep -c '^0,' side/both/history.csv)" -eq 11 ] &&
        equals "$(grep '^0,' side/both/history.csv | tail -1 | cut -d, -f2-)" "$(tail -1 side/slow/history.csv)"
}
check 'scenes side by side do not touch each other' alone
together() { # the row of the slow scene is less than its step, 0.9 ms, before that of the stiff one
    awk -F, '$1 == "0" { t = $2 } $1 == "1" && !(t <= $2 && $2 - t < 1e-3) { print; bad = 1 } END { exit bad }' side/both/history.csv
}
check 'and go together' together

paths_go() {
    run_gives 0 both.yaml -o paths --set output.paths=wall0-0 && equals "$(listing paths/paths)" '0-wall0-0.csv
1-wall0-0.csv' && run_gives 0 stiff.yaml -o paths --force && not test -e paths/paths
}
check 'the paths of several scenes go with the old run' paths_go

# ---- an event is found between two steps: of a throw, whose speed is linear in time, to rounding ----
cat >throw.yaml <<'CASE'
kind: bodies
time_end: 1 s
gravity: {y: -9.81 m/s^2}
contact: {k_n: 1 MPa, friction: none, rolling: none}
step: {dt: 0.0137 s}
disks: [{radius: 1 m, x: 3 m, y: 0, vy: 4 m/s}]
checks:
  - {what: stop-time, exact: disks.0.vy/(9.81 m/s^2), tolerance: 1e-12 s}
  - {what: stop-distance, exact: disks.0.vy^2/(2*9.81 m/s^2), tolerance: 9.81 m/s^2*step.dt^2}
  - {what: acceleration, at: 0.3 s, over: 0.2 s, exact: -9.81 m/s^2, tolerance: 1e-12*9.81 m/s^2}
output: {frames: 0}
CASE
check 'a throw' run_gives 0 throw.yaml -o throw

finish
