#!/bin/sh
# SPDX-License-Identifier: MIT
# cases/cluster/sweep.sbatch on a Slurm of one node, brought up here and without systemd: the job array gives the same
# bytes as the sweep by itself; a task that is killed and put back into the queue does its point again; the job that
# depends on the array collects. Not one of the tests of `make test`: it needs root and three daemons. usage:
# tests/cluster/slurm.sh, or make test-slurm
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/../system/tap.sh"
batch=$PWD/cases/cluster/sweep.sbatch
cd "$work" || exit 1
chmod 755 .
mkdir state spool

# Munge, by which the daemons know each other, then the controller, then the node. They end with this script.
daemons=''
stop_daemons() {
    # shellcheck disable=SC2086 # a list of process numbers
    kill $daemons 2>/dev/null
    # shellcheck disable=SC2086
    wait $daemons 2>/dev/null
    cleanup
}
trap stop_daemons EXIT
start() { # LOG COMMAND...
    log=$1
    shift
    "$@" >"$log" 2>&1 &
    daemons="$! $daemons"
}
wait_for() { # COMMAND...: up to a minute
    for _ in $(seq 600); do
        "$@" >/dev/null 2>&1 && return
        sleep 0.1
    done
    false
}
host=$(hostname -s)
export SLURM_CONF="$work/slurm.conf"
cat >slurm.conf <<CONF
ClusterName=one
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=16817
SlurmdPort=16818
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge.socket,cred_expire=5
CredType=cred/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=batch_sched_delay=0,sched_interval=1,bf_interval=1
ReturnToService=2
KillWait=1
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
printf 'CgroupAutomount=no\n' >cgroup.conf
head -c 128 /dev/urandom >munge.key
chmod 400 munge.key
start munge.log munged --force --foreground --key-file "$work/munge.key" --socket "$work/munge.socket" \
    --pid-file "$work/munge.pid" --seed-file "$work/munge.seed" --log-file "$work/munged.log"
wait_for test -S munge.socket
start slurmctld.log slurmctld -D -c
start slurmd.log slurmd -D -N "$host"
idle() { sinfo -h -o %T | grep -q idle; }
check 'a Slurm of one node is up' wait_for idle
if [ "$failures" -gt 0 ]; then
    tail -n 20 munge*.log slurmctld.log slurmd.log | sed 's/^/# /'
    finish
fi

write_small_case small.yaml
cat >sweep.yaml <<'CASE'
kind: sweep
base: small.yaml
seeds: 1-3
vary: {contact.mu_r: [0, 0.5]}
set: {sample.disks: 200, shear.strain_end: 0.1, shear.inertial_number: 1e-3} # a second or two each
compare: {key: contact.mu_r, to: 0}
CASE
contents() {
    (cd "$1" && find . -type f ! -name '*.out' | sort | while read -r file; do
        echo "== $file"
        sed '/^  "timing": {$/,/^  }/d' "$file"
    done)
}
check 'the sweep by itself' "$TRUNDLE" sweep sweep.yaml -o alone
check 'it is submitted' sh "$batch" sweep.yaml queued
running() { ls queued/*/history.csv.part; }
wait_for running
task=$(squeue -h -r -t running -o %i | head -1)
check "task $task is put back into the queue while it runs" scontrol requeue "$task"
# Slurm lets it wait until its old credentials have expired.
empty() { [ -z "$(squeue -h)" ]; }
check 'the queue empties' wait_for empty
restarted() { scontrol show job "$task" | grep -q Restarts=1; }
check 'the task was started again' restarted
check 'the dependent job has collected' test -s queued/collect.csv
same() { contents alone >a && contents queued >b && cmp a b; }
check 'the same bytes' same
finish
