#!/bin/sh
# SPDX-License-Identifier: MIT
# Exit codes: 0 done, 2 usage or case, 3 files, 4 numerical failure. Each failure says what is wrong, and a run that
# cannot begin touches no directory.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
cd "$work" || exit 1
write_small_case small.yaml
write_bodies_case bodies.yaml

# fails CODE TEXT ARGUMENTS...: with that code and a message that has the text
fails() {
    wanted=$1 text=$2
    shift 2
    run_gives "$wanted" "$@" && says stderr "$text"
}
# refused CODE TEXT ARGUMENTS...: the same, and no results directory
refused() {
    fails "$@" -o refused && not test -e refused
}

# ---- usage ----
program_gives() {
    wanted=$1
    shift
    "$TRUNDLE" "$@" >stdout 2>stderr
    equals $? "$wanted"
}
check 'no command: 2' program_gives 2
check 'unknown command: 2' program_gives 2 fly
check '--help: 0' program_gives 0 --help
check '--version: 0' program_gives 0 --version
check 'run --help: 0' program_gives 0 run --help
check 'no case: 2' program_gives 2 run
check 'two cases: 2' program_gives 2 run small.yaml bodies.yaml
check 'which are named' says stderr 'one case file at a time, and these are two: small.yaml bodies.yaml'
# of --set
whole='--set takes KEY=VALUE in one word: --set contact.mu_r=VALUE'
check 'a value apart from its key: 2' fails 2 "$whole" small.yaml --set contact.mu_r 0.1
check 'before the case' fails 2 "$whole" --set contact.mu_r 0.1 small.yaml
check 'behind the =' fails 2 "$whole" small.yaml --set contact.mu_r= 0.1
check 'before the =' fails 2 "$whole" small.yaml --set contact.mu_r =0.1
check 'no --set: 2' fails 2 'to change a key of the case write --set contact.mu_r=0.1' small.yaml contact.mu_r=0.1
check 'of bench too: 2' program_gives 2 bench small.yaml --set contact.mu_r 0.1
check 'with the same words' says stderr "$whole"
# a file of another command
printf 'kind: sweep\nbase: small.yaml\nvary: {contact.mu: [0.1, 0.2]}\n' >sweep.yaml
check 'a sweep is no case: 2' fails 2 'sweep.yaml:1:7: error: this is a sweep over many cases: `trundle sweep` runs it' sweep.yaml
check 'a case is no sweep: 2' program_gives 2 sweep small.yaml
check 'which says what runs it' says stderr 'trundle run runs a single case'
check 'a file is no run to replay: 2' program_gives 2 replay small.yaml
check 'which says what is' says stderr 'small.yaml is a file; a replay is of the directory of a finished run'

check 'all keys: 0' program_gives 0 run --keys
check 'keys of a kind: 0' program_gives 0 run --keys patch
check 'keys of no kind: 2' program_gives 2 run --keys small.yaml
check 'with the kinds that there are' says stderr 'there are biaxial|bodies|contact|patch'
check 'unknown option: 2' program_gives 2 run small.yaml --frobnicate
check 'bench of too short a test: 2' program_gives 2 bench small.yaml --set shear.strain_end=1e-6
check 'bench of bodies: 2' program_gives 2 bench bodies.yaml

# ---- a bad case: 2, and no directory ----
printf 'kind: biaxial\nseed: [\n' >broken.yaml
: >empty.yaml
check 'bad YAML' refused 2 'broken.yaml:' broken.yaml
check 'an empty file' refused 2 'empty.yaml:' empty.yaml
check 'a misspelt key' refused 2 'did you mean' small.yaml --set shear.strain_ent=0.1
check 'out of range' refused 2 'allowed is' small.yaml --set compaction.pressure=1e-9
check 'out of reach' refused 2 'compaction.pressure = 1e+09 is out of reach' small.yaml --set compaction.pressure=1e9
check 'a cell too thin' refused 2 'cell would be too thin' small.yaml --set boundary=periodic --set sample.disks=8
check 'wrong dimension' refused 2 'error:' small.yaml --set 'contact.k_n=3 m'
check '--seed that is no number' refused 2 'seed' small.yaml --seed x
check 'fewer than no frames' refused 2 'frames' small.yaml --frames -1
check 'a step above the bound (biaxial)' refused 2 'above the stability bound' small.yaml --set step.dt=1e-3
check 'a step above the bound (bodies)' refused 2 'above the stability bound' bodies.yaml --set step.dt=1
check '--check finds it too' fails 2 'above the stability bound' small.yaml --check --set step.dt=1e-3
check 'a finished run' run_gives 0 bodies.yaml -o kept
before=$(cat kept/* | cksum)
check 'survives --force with a bad case' run_gives 2 bodies.yaml -o kept --force --set step.dt=1
check 'byte for byte' equals "$(cat kept/* | cksum)" "$before"

# ---- a check that fails: 1 ----
{
    cat bodies.yaml
    echo 'checks: [{what: speed, disk: 0, exact: 100 m/s, tolerance: 1 m/s}]'
} >checked.yaml
check 'a check that fails' fails 1 'checks of checked.yaml failed' checked.yaml -o checked
check 'the run is finished' test -e checked/summary.json
check '--resume tells of the check again' fails 1 'checks of checked.yaml failed' checked.yaml -o checked --resume

# ---- files: 3 ----
touch file
ln -s loop loop
check 'a case that is not there' refused 3 'nothing.yaml' nothing.yaml
check 'a case that is a directory' refused 3 'kept' kept
check 'a file where the directory should be' fails 3 'not a directory' small.yaml -o file
check 'the file is as it was' not test -s file
check 'a file on the way to it' fails 3 'Not a directory' small.yaml -o file/results
check 'a loop of links' fails 3 'error:' small.yaml -o loop
check 'an empty name' fails 3 'directory' small.yaml -o ''
check 'a name that is too long' fails 3 'too long' small.yaml -o "$(printf '%0300d' 0)"
check 'a path that is too long' fails 3 'error:' small.yaml -o "$(printf '%05000d' 0)"
[ -d /proc/self ] && check 'where no directory can be made' fails 3 '/proc/' small.yaml -o /proc/trundle
mkdir -p taken/history.csv
check 'a directory in the place of a result' fails 3 'history.csv' small.yaml -o taken
mkdir taken2 && touch taken2/frames
check 'a file in the place of frames/' fails 3 'frames' bodies.yaml -o taken2 --frames 2
check 'leaves no part' no_parts taken2
if [ "$(id -u)" -ne 0 ]; then
    mkdir locked && chmod 500 locked
    check 'a directory without permission' fails 3 'Permission denied' small.yaml -o locked/results
else
    skip 'a directory without permission' 'root may write everywhere'
fi

# ---- numerical failure: 4, what there is, and where ----
check 'overlap at the start' refused 4 'contact of wall 0 with disk 0' bodies.yaml --set 'disks.0.y=5 mm'
check 'says what, step and time' says stderr 'overlap 0.005 m is above 0.3 of the radius 0.01 m, at step 0, time 0 s'
check '--check finds it too' fails 4 'overlap' bodies.yaml --check --set 'disks.0.y=5 mm'
thrown='--set step.safety=0.5 --set time_end=0.2s --set disks.0.y=100mm --set disks.0.vy=-4.9 --set gravity.y=0'
# shellcheck disable=SC2086 # a list of options
check 'overlap on the way' fails 4 'contact of wall 0 with disk 0' bodies.yaml -o thrown --frames 3 $thrown --set output.rows=1000
check 'says what is kept' says stderr 'kept in thrown:'
check 'rows up to then' test "$(wc -l <thrown/history.csv)" -gt 3
check 'the first frame' test -e thrown/frames/00000.png
check 'no summary' not test -e thrown/summary.json
check 'no part' no_parts thrown
check 'too large a step, forced' fails 4 'at step' small.yaml -o forced --set step.dt=1e-4 --set step.allow_unstable=yes
check 'names a disk or a contact' grep -qE 'disk [0-9]+|disks [0-9]+ and [0-9]+' stderr
check 'no row is not a number' not grep -qsi nan forced/history.csv
check 'too large a pressure' fails 4 'overlap' small.yaml -o crushed --set compaction.pressure=22e6
check 'a cell that gets too thin' fails 4 'the periodic cell is too thin: its width is' small.yaml -o thin \
    --set boundary=periodic --set sample.disks=11 --set compaction.pressure=8e6
finish
