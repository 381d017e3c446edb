#!/bin/sh
# SPDX-License-Identifier: MIT
# Restart: a test that was stopped at any moment, in any way, ends with the bytes of one that was not; what is no checkpoint of
# it is refused with the reason. timing in summary.json alone may differ.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
cd "$work" || exit 1
write_small_case small.yaml
write_bodies_case bodies.yaml
# All that a test can leave: frames with an inset, film, curves, lists of contacts, paths, for one of which it runs twice.
cat >full.yaml <<'CASE'
kind: biaxial
seed: 3
sample: {disks: 60, r_min: 0.76 mm, r_max: 1.52 mm}
contact: {k_n: 160 MPa, mu: 0.5, mu_r: 0.5, friction: dahlberg-alfredsson, k_t: 80 MPa, E_star: 200 MPa}
compaction: {pressure: 160 kPa, inertial_number: 0.1, unbalanced: 1e-2}
shear: {inertial_number: 2e-3, strain_end: 0.01, walls: rough}
output: {frames: 4, rows: 50, contacts: 4, paths: [most-mobilised, wall1-15]}
CASE

start() {
    "$TRUNDLE" run "$@" >stdout 2>stderr </dev/null &
    pid=$!
}
same() { # DIR REFERENCE: the same files with the same bytes, and no other
    for dir in "$1" "$2"; do
        rm -rf "$dir.bytes"
        cp -r "$dir" "$dir.bytes"
        sed -i '/"timing"/,/}/d' "$dir.bytes/summary.json"
    done
    diff -r "$1.bytes" "$2.bytes"
}
# A checkpoint at every opportunity, so that it is met in any state.
ends_as() { # REFERENCE CASE DIR
    run_gives 0 "$2" -o "$3" --resume --checkpoint 0 && same "$3" "$1"
}
copy() { # FROM TO
    rm -rf "$2"
    cp -r "$1" "$2"
}

check 'a run without a stop' run_gives 0 full.yaml -o full --checkpoint 1000
check 'checkpoints change no byte' ends_as full full.yaml checkpoints
check '--resume of a finished run does nothing' run_gives 0 full.yaml -o full --resume
check 'and says so' says stderr 'nothing to resume: this run is finished'
check 'not of another case' run_gives 3 full.yaml -o full --resume --set seed=4
check 'and says so' says stderr 'holds a finished run of another case'

# ---- killed ----
# Moments of an unfinished run: one that came to its end meanwhile is compared, and another begun.
killed() { # CASE REFERENCE TIMES SEED LONGEST
    kills=0 tries=0
    rm -rf killed
    while [ "$kills" -lt "$3" ]; do
        tries=$((tries + 1))
        [ "$tries" -lt 200 ] || { echo "killed only $kills times"; return 1; }
        start "$1" -o killed --resume --checkpoint 0
        sleep "$(awk -v seed="$4$tries" -v most="$5" 'BEGIN { srand(seed); print 0.005 + most * rand() }')"
        kill -s KILL "$pid" 2>/dev/null
        wait "$pid" 2>/dev/null
        code=$?
        [ "$code" -eq 137 ] || [ "$code" -eq 0 ] || { echo "exit code $code"; cat stderr; return 1; }
        if [ -e killed/summary.json ]; then
            ends_as "$2" "$1" killed || return 1
            rm -rf killed
        else
            kills=$((kills + 1))
        fi
    done
    ends_as "$2" "$1" killed
}
check 'killed at 20 moments, the same bytes in the end' killed full.yaml full 20 1 0.4
check 'a run of tables alone' run_gives 0 small.yaml -o small
check 'killed at 20 moments too' killed small.yaml small 20 2 0.1
check 'bodies start afresh' run_gives 0 bodies.yaml -o bodies --resume
check 'and are left when they are finished' run_gives 0 bodies.yaml -o bodies --resume
check 'and say so' says stderr 'nothing to resume'
finish
