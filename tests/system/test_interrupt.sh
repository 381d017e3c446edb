#!/bin/sh
# SPDX-License-Identifier: MIT
# Ctrl-C: the first stops cleanly, keeps what there is and says so (130); a second one kills. SIGTERM and SIGHUP do the
# same.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
contact=$PWD/cases/contact-reversal.yaml
patch=$PWD/cases/patch-cattaneo-to-carter.yaml
cd "$work" || exit 1
write_small_case small.yaml
write_bodies_case bodies.yaml
slow='--set sample.disks=400 --set shear.strain_end=0.2 --set shear.inertial_number=1e-5 --set output.rows=2000 --frames 200'
compacting='--set sample.disks=3000 --set compaction.inertial_number=1e-4'

start() {
    "$TRUNDLE" run "$@" >stdout 2>stderr </dev/null &
    pid=$!
}
# wait_for COMMAND...: up to 20 s
wait_for() {
    for _ in $(seq 200); do
        "$@" 2>/dev/null && return 0
        sleep 0.1
    done
    return 1
}
gone() { ! kill -0 "$pid"; }
stop() { # SIGNAL: sends it and takes the exit code
    kill -s "$1" "$pid"
    wait "$pid"
    code=$?
}
has_rows() { [ "$(wc -l <"$1/history.csv.part")" -gt 4 ] && [ -s "$1/frames/00000.png" ]; }
whole_lines() { # the last character is a line break, every line has as many cells as the header
    [ "$(tail -c 1 "$1" | od -An -tx1 | tr -d ' ')" = 0a ] && awk -F, 'NR == 1 { n = NF } NF != n { bad = 1 } END { exit bad || NR < 3 }' "$1"
}

for signal in INT TERM HUP; do
    # shellcheck disable=SC2086 # a list of options
    start small.yaml -o "shear$signal" $slow
    check "SIG$signal during the shear: rows are growing" wait_for has_rows "shear$signal"
    stop $signal
    check 'code 130' equals "$code" 130
    check 'says where it stopped' says stderr 'stopped at strain'
    check 'says what it kept' says stderr "kept in shear$signal:"
    kept=$(sed -n 's/.*: \([0-9]*\) rows of history.*/\1/p' stderr)
    check 'history.csv has whole lines' whole_lines "shear$signal/history.csv"
    check 'as many rows as it said' equals "$(($(wc -l <"shear$signal/history.csv") - 1))" "$kept"
    check 'no summary' not test -e "shear$signal/summary.json"
    check 'no part' no_parts "shear$signal"
    if command -v ffmpeg >/dev/null; then
        check 'the film so far plays' ffmpeg -v error -xerror -i "shear$signal/biaxial.mp4" -f null -
        check 'so does its GIF' ffmpeg -v error -xerror -i "shear$signal/biaxial.gif" -f null -
    else
        skip 'the film so far plays' 'no ffmpeg'
    fi
done

start "$contact" -o contact --set path.0.steps=1000000
has_contact_rows() { [ "$(wc -l <contact/contact.csv.part)" -gt 4 ]; }
check 'a contact on its path: rows are growing' wait_for has_contact_rows
stop INT
check 'code 130' equals "$code" 130
check 'says where it stopped' says stderr 'stopped at step'
check 'contact.csv has whole lines' whole_lines contact/contact.csv
kept=$(sed -n 's/.*: \([0-9]*\) steps of contact.*/\1/p' stderr)
check 'two rows for each step that it said' equals "$(($(wc -l <contact/contact.csv) - 1))" $((2 * kept))
check 'no summary' not test -e contact/summary.json
check 'no part' no_parts contact

start "$patch" -o patch --set path.1.steps=1000000 --set output.frames=0
has_patch_rows() { [ "$(wc -l <patch/contact.csv.part)" -gt 4 ]; }
check 'inside a contact: rows are growing' wait_for has_patch_rows
stop INT
check 'code 130' equals "$code" 130
check 'contact.csv has whole lines' whole_lines patch/contact.csv
kept=$(sed -n 's/.*: \([0-9]*\) steps of contact.*/\1/p' stderr)
check 'as many rows as it said' equals "$(($(wc -l <patch/contact.csv) - 1))" "$kept"
check 'no summary' not test -e patch/summary.json
check 'no part' no_parts patch

# shellcheck disable=SC2086 # a list of options
start small.yaml -o compact $compacting
check 'during the compaction: it has begun' wait_for test -s compact/case.yaml
stop INT
check 'code 130' equals "$code" 130
check 'says so' says stderr 'stopped during compaction'
check 'only the case and the checkpoint are there' equals "$(listing compact | tr '\n' ' ')" 'case.yaml checkpoint.bin '

start bodies.yaml -o bodies --set time_end=1000s --frames 2
check 'in the rehearsal for a film: it has begun' wait_for test -s bodies/case.yaml
stop INT
check 'code 130' equals "$code" 130
check 'only the case is there' equals "$(listing bodies)" case.yaml

start bodies.yaml -o bodies --set time_end=1000s --set output.rows=1000000
has_lines() { [ -s bodies/history.csv.part ]; }
check 'bodies: rows are growing' wait_for has_lines
stop INT
check 'code 130' equals "$code" 130
check 'history.csv has whole lines' whole_lines bodies/history.csv
check 'an interrupted run is replaced without --force' run_gives 0 bodies.yaml -o bodies

# The first is heeded after 200 steps of the compaction, which take 300000 disks about a second; the second must not
# wait.
# shellcheck disable=SC2086 # a list of options
start small.yaml -o twice $compacting --set sample.disks=300000
wait_for test -s twice/case.yaml
kill -s INT "$pid"
sleep 0.1 # two that come at once are one
kill -s INT "$pid"
check 'a second Ctrl-C ends it at once' wait_for gone
wait "$pid"
check 'it was killed' equals $? 130
check 'without a word' not test -s stderr
finish
