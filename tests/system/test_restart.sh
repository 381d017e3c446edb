#!/bin/sh
# SPDX-License-Identifier: MIT
# Restart: a test that was stopped at any moment, in any way, ends with the bytes of one that was not; what is no
# checkpoint of it is refused with the reason. timing in summary.json alone may differ.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
cd "$work" || exit 1
write_small_case small.yaml
write_bodies_case bodies.yaml
periodic='--set boundary=periodic --set shear.hold=mean'
# All that a test can leave: frames with an inset, film, curves, lists of contacts, paths, for one of which it runs
# twice.
cat >full.yaml <<'CASE'
kind: biaxial
seed: 3
sample: {disks: 60, r_min: 0.76 mm, r_max: 1.52 mm}
contact: {k_n: 160 MPa, mu: 0.5, mu_r: 0.5, friction: dahlberg-alfredsson, k_t: 80 MPa, E_star: 200 MPa}
compaction: {pressure: 160 kPa, inertial_number: 0.1, unbalanced: 1e-2}
shear: {inertial_number: 2e-3, strain_end: 0.01, walls: rough}
output: {frames: 4, rows: 50, contacts: 4, increments: yes, paths: [most-mobilised, wall1-15]}
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
        rm "$dir.bytes/trundle-files.txt" # which tells of removed files too
    done
    diff -r "$1.bytes" "$2.bytes"
}
# A checkpoint at every opportunity, so that it is met in any state.
ends_as() { # REFERENCE CASE DIR ARGUMENTS...
    reference=$1 from=$2 to=$3
    shift 3
    run_gives 0 "$from" -o "$to" --resume --checkpoint 0 "$@" && same "$to" "$reference"
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
# shellcheck disable=SC2086 # a list of options
check 'a periodic cell' run_gives 0 small.yaml -o periodic $periodic
# shellcheck disable=SC2086
check 'checkpoints change no byte of it' ends_as periodic small.yaml periodic-checkpoints $periodic

# ---- stopped ----
# Half a second, of which the first rows take a fifth.
long='--set shear.strain_end=0.1 --set output.rows=500 --set shear.inertial_number=7e-4'
wait_for() { # up to 20 s or so
    for _ in $(seq 2000); do
        "$@" 2>/dev/null && return 0
        sleep 0.01
    done
    return 1
}
grown() { [ "$(wc -l <"$1/history.csv.part")" -gt "$2" ]; }
# shellcheck disable=SC2086 # a list of options
check 'a longer run' run_gives 0 small.yaml -o long $long
for signal in INT TERM HUP; do
    rm -rf stopped
    # shellcheck disable=SC2086
    start small.yaml -o stopped $long
    wait_for grown stopped 100
    kill -s $signal "$pid"
    wait "$pid"
    check "SIG$signal" equals $? 130
    check 'says how to go on' says stderr '--resume continues from there'
    check 'it has a checkpoint, though the first was not due' test -s stopped/checkpoint.bin
    echo cut >stopped/checkpoint.bin.part # as a kill in the middle of a checkpoint leaves it
    copy stopped "stopped$signal"
    # shellcheck disable=SC2086
    check 'and ends with the same bytes' ends_as long small.yaml stopped $long
    check 'no part of a checkpoint is left' no_parts stopped
done
# shellcheck disable=SC2086
start small.yaml -o early $long --set compaction.inertial_number=0.01
wait_for test -s early/case.yaml
kill -s INT "$pid"
wait "$pid"
check 'SIGINT in the compaction' says stderr 'stopped during compaction; --resume continues from there'
# shellcheck disable=SC2086
check 'the same without a stop' run_gives 0 small.yaml -o late $long --set compaction.inertial_number=0.01
# shellcheck disable=SC2086
check 'and ends with the same bytes' ends_as late small.yaml early $long --set compaction.inertial_number=0.01

# ---- refused ----
untouched() { # DIR: as it was in stoppedINT, and no case but its own runs there
    diff -r "$1" stoppedINT
}
refuses() { # WHY ARGUMENTS...
    why=$1
    shift
    # shellcheck disable=SC2086
    run_gives 3 "$@" -o refused --resume && says stderr "$why"
}
copy stoppedINT refused
# shellcheck disable=SC2086
check 'another case is refused' refuses 'is from another case: it has `seed: 3' small.yaml $long --set seed=4
check 'another kind too' refuses 'is from another case' bodies.yaml
check 'nothing was touched' untouched refused
poke() { printf "$1" | dd of=refused/checkpoint.bin bs=1 seek="$2" conv=notrunc 2>/dev/null; }
poke '\377\377\377' 5000
# shellcheck disable=SC2086
check 'a damaged one is refused' refuses 'damaged: its checksum is wrong' small.yaml $long
copy stoppedINT refused
truncate -s 5000 refused/checkpoint.bin
# shellcheck disable=SC2086
check 'a truncated one is refused' refuses 'cut short: 5000 bytes of' small.yaml $long
copy stoppedINT refused
poke '\2' 8
# shellcheck disable=SC2086
check 'a newer one is refused' refuses 'version 2, from a newer trundle' small.yaml $long
copy stoppedINT refused
truncate -s 200 refused/history.csv
# shellcheck disable=SC2086
check 'so is one whose tables are cut' refuses 'is shorter than the checkpoint says: 200 bytes of' small.yaml $long
check 'the checkpoint is still there' cmp refused/checkpoint.bin stoppedINT/checkpoint.bin
check 'an end that asks for both' run_gives 2 small.yaml -o refused --resume --force
check 'seconds that are none' run_gives 2 small.yaml -o refused --checkpoint soon

# The one before stands in for a damaged one.
start full.yaml -o two --checkpoint 0
wait_for grown two 20
kill -s KILL "$pid"
wait "$pid" 2>/dev/null
[ -s two/checkpoint.bin ] || cp two/checkpoint.bin.old two/checkpoint.bin # it was killed between the two renames
truncate -s 100 two/checkpoint.bin
check 'of two the older is whole' ends_as full full.yaml two
check 'and it says why' says stderr 'continued from the older checkpoint: error: two/checkpoint.bin is cut short'

# ---- full disk ----
full_disk() { # SIZE: whenever it is full, room is made, and the run goes on
    mount -o "remount,size=$1" disk || return 1
    # shellcheck disable=SC2086
    start small.yaml -o disk/results --resume --checkpoint 0 $long
    wait "$pid"
    code=$?
    [ "$code" -eq 0 ] || { [ "$code" -eq 3 ] && says stderr 'error: cannot'; }
}
mkdir disk
if mount -t tmpfs -o size=1M tmpfs disk 2>/dev/null; then
    trap 'umount "$work/disk"; cleanup' EXIT
    filled=0
    for size in 24k 48k 96k 112k 128k 144k 160k 192k 224k; do
        check "a disk of $size" full_disk $size
        [ "$code" -ne 3 ] || filled=$((filled + 1))
        [ "$code" -ne 3 ] || [ ! -e disk/results/checkpoint.bin ] || went_on=yes
    done
    check 'it was full several times, with a checkpoint behind it' equals "$((filled > 3)) ${went_on-}" '1 yes'
    mount -o remount,size=4M disk
    # shellcheck disable=SC2086
    check 'with room for all, the same bytes' ends_as long small.yaml disk/results $long
else
    skip 'a full disk' 'cannot mount a small file system here'
fi

# ---- other kinds ----
check 'bodies start over' run_gives 0 bodies.yaml -o bodies --resume
check 'and are left when they are finished' run_gives 0 bodies.yaml -o bodies --resume
check 'and say so' says stderr 'nothing to resume'
finish
