#!/bin/sh
# SPDX-License-Identifier: MIT
# trundle sweep: every point is what trundle run gives; killed at any moment and started again it ends with the same
# bytes; a point that fails does not stop the others; one at a time, two at once, by number, and as the job array of a
# cluster give the same.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
batch=$PWD/cases/cluster/sweep.sbatch
cd "$work" || exit 1
write_small_case small.yaml
# All programs but gnuplot: curves would take most of the time; one point below has them.
everything=$PATH
mkdir bin
for folder in $(echo "$PATH" | tr : ' '); do ln -s "$folder"/* bin/ 2>/dev/null; done
rm -f bin/gnuplot*
PATH=$work/bin
cat >sweep.yaml <<'CASE'
kind: sweep
base: small.yaml
seeds: [3, 5, 8]
vary: {contact.mu_r: [0, 1/2], contact.rolling_velocity: [wang, bagi-kuhn]}
set: {sample.disks: 40, shear.strain_end: 0.03}
compare: {key: contact.mu_r, to: 0}
CASE

sweep() {
    "$TRUNDLE" sweep "$@" >stdout 2>stderr </dev/null
    code=$?
}
# sweep_gives CODE ARGUMENTS...
sweep_gives() {
    wanted=$1
    shift
    sweep "$@"
    [ "$code" -eq "$wanted" ] || { echo "exit code $code, not $wanted"; cat stdout stderr; false; }
}
# All files of a sweep but what is timing, and the lists of files, whose order is that of the runs.
contents() {
    (cd "$1" && find . -type f ! -name '*.out' ! -name trundle-files.txt | sort | while read -r file; do
        echo "== $file"
        sed '/^  "timing": {$/,/^  }/d' "$file"
    done)
}
same() { contents "$1" >"$work/a" && contents "$2" >"$work/b" && cmp "$work/a" "$work/b"; }
summaries() { find "$1" -name summary.json | wc -l; }

# ---- what it gives ----
check 'it runs' sweep_gives 0 sweep.yaml -o two -j 2
check 'and says what it did' says stdout '12: 0 finished before, 12 run now, 0 failed'
check 'a directory for each point' equals "$(summaries two)" 12
check 'one packing for each seed' equals "$(find two/samples -name '*.bin*' | wc -l)" 3
check 'one at a time: the same bytes' sweep_gives 0 sweep.yaml -o one -j 1
check 'indeed' same one two
by_hand() {
    run_gives 0 small.yaml -o hand --set sample.disks=40 --set shear.strain_end=0.03 --set contact.mu_r=1/2 --set contact.rolling_velocity=bagi-kuhn --seed 5 &&
        cmp hand/history.csv two/mu_r=1_2*bagi-kuhn,seed=5-*/history.csv && cmp hand/case.yaml two/mu_r=1_2*bagi-kuhn,seed=5-*/case.yaml
}
check 'a point is what trundle run gives' by_hand
# difference of the means by the numbers of the summaries
collected() {
    for seed in 3 5 8; do
        a=$(sed -n 's/.*"sin_phi_peak": \(.*\),/\1/p' two/mu_r=1_2,*wang,seed="$seed"-*/summary.json)
        b=$(sed -n 's/.*"sin_phi_peak": \(.*\),/\1/p' two/mu_r=0,*wang,seed="$seed"/summary.json)
        echo "$a $b"
    done | awk '{ n++; sum += $1 - $2 } END { printf "%.8f\n", sum/n }' >mean
    equals "$(awk -F, '$1 == "1/2" && $2 == "wang" && $3 == "sin_phi_peak" && $4 == "contact.mu_r=0" { printf "%.8f\n", $6 }' two/collect.csv)" "$(cat mean)"
}
check 'collect.csv has the mean of the differences' collected
check 'a second time nothing is done' sweep_gives 0 sweep.yaml -o two
check 'as it says' says stdout '12: 12 finished before, 0 run now, 0 failed'

# ---- by number, and on a cluster ----
"$TRUNDLE" sweep sweep.yaml --list >list
check 'the list has all points' equals "$(wc -l <list)" 12
listed() { while read -r _ name; do [ -e "two/$name/summary.json" ] || return 1; done <list; }
check 'by number and directory' listed
check 'one point by its number' sweep_gives 0 sweep.yaml -o some --index 7
check 'that one alone' equals "$(listing some | grep summary)" "$(sed -n 's/^7 //p' list)/summary.json"
check 'a number that is none' sweep_gives 2 sweep.yaml -o some --index 12
check 'collecting what there is' sweep_gives 0 sweep.yaml -o some --collect
check 'it says what is missing' says stderr '11 of 12 points are not finished'
# A cluster that runs each task at once, in the wrong order, and one of them twice.
mkdir cluster # bin/ is links: what is written there would be written to the system
cat >cluster/sbatch <<'CASE'
#!/bin/sh
for word; do case $word in --array=*) last=${word#--array=0-} ;; --dependency=afterany:4711) dependent=yes ;; esac; done
while case $1 in -*) true ;; *) false ;; esac do shift; done
if [ -n "${last:-}" ]; then
    for k in $(seq "$last" -1 0) 3; do SLURM_ARRAY_TASK_ID=$k sh "$@" >/dev/null || exit; done
    echo '4711;here'
else
    [ -n "${dependent:-}" ] && sh "$@"
fi
CASE
chmod +x cluster/sbatch
on_cluster() { PATH=$work/cluster:$PATH sh "$batch" sweep.yaml array; }
check 'as a job array' on_cluster
check 'the same bytes' same array two

# ---- killed at any moment ----
wait_for() { # COMMAND...: up to 20 s
    for _ in $(seq 2000); do
        "$@" 2>/dev/null && return
        sleep 0.01
    done
    false
}
started() { [ -d killed ] && [ "$(summaries killed)" -ge "$1" ]; }
killed() { # N SIGNAL: when N points are finished
    "$TRUNDLE" sweep sweep.yaml -o killed -j 2 >stdout 2>stderr </dev/null &
    pid=$!
    wait_for started "$1"
    kill -s "$2" $pid
    wait $pid 2>/dev/null
    code=$?
}
for n in 0 1 3 6; do killed $n KILL; done # and started again at once
check 'killed: no collect.csv' not test -e killed/collect.csv
before=$(summaries killed)
check 'some points are finished, some are not' [ "$before" -gt 0 -a "$before" -lt 12 ]
check 'started again' sweep_gives 0 sweep.yaml -o killed -j 2
check 'it does what is missing' says stdout "$before finished before, $((12 - before)) run now, 0 failed"
check 'and ends with the same bytes' same killed two
rm -r killed
killed 2 TERM
check 'asked to stop: code 130' equals $code 130
check 'it says how far it is' says stderr 'of 12 points are finished; the same command continues'
check 'started again' sweep_gives 0 sweep.yaml -o killed
check 'it ends with the same bytes' same killed two
# Runs of minutes, which do not end by themselves while this waits.
sed 's/disks: 40/disks: 400, shear.inertial_number: 1e-6/' sweep.yaml >long.yaml
processes() { # PATTERN: those whose command line has it. A bare system has no pgrep.
    for process in /proc/[0-9]*; do
        tr '\0' ' ' <"$process/cmdline" | grep -q -- "$1" && echo "${process#/proc/}"
    done 2>/dev/null
}
kill_processes() { for process in $(processes "$1"); do kill -KILL "$process"; done; } # nor xargs a kill to call
runs() { [ -n "$(processes "run .*-o $work/long/")" ]; }
ended() { ! kill -0 $pid; }
for signal in TERM KILL; do
    "$TRUNDLE" sweep long.yaml -o "$work/long" -j 2 >stdout 2>stderr </dev/null &
    pid=$!
    wait_for test -e long/mu_r=0,rolling_velocity=wang,seed=3/case.yaml
    kill -s $signal $pid
    check "SIG$signal: it ends" wait_for ended
    check 'and its runs with it' wait_for not runs
    kill_processes "run .*-o $work/long/"
    wait $pid 2>/dev/null
done

# ---- what is finished: a summary, and the case of this point ----
rm two/mu_r=0,*wang,seed=3/summary.json
check 'a summary is gone: that point' sweep_gives 0 sweep.yaml -o two
check 'is done again' says stdout '11 finished before, 1 run now, 0 failed'
: >"$(echo two/mu_r=0,*wang,seed=5)/summary.json"
check 'a summary is empty: that point' sweep_gives 0 sweep.yaml -o two
check 'is done again' says stdout '11 finished before, 1 run now, 0 failed'
check 'which is told' says stderr 'seed=5): note: its directory has an incomplete summary.json; it runs again'
sed -i 's/"version": "[^"]*"/"version": "0.0.1"/; s/"sin_phi_peak": .*,/"sin_phi_peak": 9,/' two/mu_r=0,*wang,seed=8/summary.json
check 'of another version: not collected' sweep_gives 0 sweep.yaml -o two --collect
check 'as it says' says stderr '1 of 12 points are not finished and left out'
check 'it is done again' sweep_gives 0 sweep.yaml -o two
check 'which is told' says stderr 'seed=8): note: its directory has a run of another version of trundle; it runs again'
check 'and all is as before' same two one
sed -i 's/mu: 0.5/mu: 0.4/' small.yaml
check 'another base case' sweep_gives 0 sweep.yaml -o two
check 'all are done again' says stdout '0 finished before, 12 run now, 0 failed'
check 'which is told' says stderr 'seed=3): note: its directory has another case; it runs again'
sed -i 's/mu: 0.4/mu: 0.5/' small.yaml
sed 's/\[3, 5, 8\]/[3, 5, 8, 9]/; s/bagi-kuhn\]/bagi-kuhn, alonso-min]/' sweep.yaml >wider.yaml
check 'more seeds and values' sweep_gives 0 wider.yaml -o one
check 'leave the others' says stdout '24: 12 finished before, 12 run now, 0 failed'

# ---- a point that fails ----
sed 's/^vary.*/vary: {contact.k_n: [160 MPa, 1.2 MPa, 100 MPa]}/; /compare/d' sweep.yaml >fails.yaml
check 'points that fail: code 4' sweep_gives 4 fails.yaml -o fails -j 2
check 'the others are done' says stdout '9: 0 finished before, 6 run now, 3 failed'
check 'which one, and why' grep -q '^point 4 (k_n=1.2_MPa,seed=5-.*): error: ' stderr
check 'its log has the same' grep -q '^error' fails/k_n=1.2_MPa,seed=5-*/log
check 'collected over those that are there' grep -q '^1.2 MPa,sin_phi_peak,,0,,,,$' fails/collect.csv
check 'and of the others' grep -q '^100 MPa,sin_phi_peak,,3,0' fails/collect.csv
mkdir -p "$(echo fails/k_n=1.2_MPa,seed=5-*)" && echo mine >"$(echo fails/k_n=1.2_MPa,seed=5-*)/history.csv"
check 'one of them for a file in the way: the lower code, 3' sweep_gives 3 fails.yaml -o fails -j 2
check 'the others as before' says stdout '9: 6 finished before, 0 run now, 3 failed'
held() { # another process has this point
    mkdir -p held/mu_r=0,rolling_velocity=wang,seed=3
    flock held/mu_r=0,rolling_velocity=wang,seed=3 "$TRUNDLE" sweep sweep.yaml -o held --index 0 2>stderr
    [ $? -eq 3 ] && says stderr 'another run writes into held/mu_r=0'
}
check 'a point that another process runs: code 3' held
slow_victim() { # one of three runs, which would take minutes, is killed from outside
    sed 's/^vary.*/vary: {shear.inertial_number: [1e-7, 2e-3, 3e-3]}/; s/seeds.*/seeds: [3]/; /compare/d' sweep.yaml >slow.yaml
    "$TRUNDLE" sweep slow.yaml -o victim -j 2 >stdout 2>stderr </dev/null &
    pid=$!
    wait_for test -e victim/inertial_number=3e-3,seed=3/summary.json
    kill_processes 'run .*-o victim/inertial_number=1e-7'
    wait "$pid"
    [ $? -eq 3 ] && says stderr 'point 0 (inertial_number=1e-7,seed=3): error: ended by signal 9' && equals "$(summaries victim)" 2
}
check 'a run that is killed fails alone: code 3' slow_victim
check 'a point with all its helpers' env PATH="$everything" timeout 60 "$TRUNDLE" sweep sweep.yaml -o curves --index 0

# ---- kinds without a sample ----
write_bodies_case bodies.yaml
printf 'kind: sweep\nbase: bodies.yaml\nvary: {output.rows: [10, 20]}\ncollect: [steps]\n' >bodies-sweep.yaml
check 'a sweep of bodies' sweep_gives 0 bodies-sweep.yaml -o bodies
check 'has no packings' not test -e bodies/samples

# ---- bad input: nothing is run, nothing made ----
no_sample() { run_gives 2 bodies.yaml -o none --sample x.bin && says stderr '--sample needs a case of kind: biaxial'; }
check '--sample of a kind that has none' no_sample
sed 's/mu_r:/mu_R:/; /compare/d' sweep.yaml >bad.yaml
check 'an unknown key' sweep_gives 2 bad.yaml -o bad
check 'its line' says stderr 'bad.yaml:4:8: error: point 0 (mu_R=0'
check 'nothing is made' not test -e bad
check 'the list of its points is none' sweep_gives 2 bad.yaml --list
check 'it is told in the same words' says stderr 'bad.yaml:4:8: error: point 0 (mu_R=0'
check 'and nothing else' test ! -s stdout
sed 's/1\/2/half/; /compare/d' sweep.yaml >bad.yaml
check 'a value that is none, in a list of points' sweep_gives 2 bad.yaml --list
check 'its place' says stderr 'bad.yaml:4:26: error: point 2 (mu_r=half'
sed 's/disks: 40/diskz: 40/; /compare/d' sweep.yaml >bad.yaml
check 'an unknown key that is set, in a list of points' sweep_gives 2 bad.yaml --list
check 'with what was meant' says stderr '(did you mean `disks`?)'
sed 's/\[0, 1.2\]/[]/' sweep.yaml >bad.yaml
check 'an empty list' sweep_gives 2 bad.yaml -o bad
sed 's/seeds.*/seeds: 1-250000/' sweep.yaml >bad.yaml
check 'a million points' sweep_gives 2 bad.yaml -o bad --list
check 'unless they are meant' says stderr '1000000 points; --yes allows more than 10000'
sed 's/^compare.*/collect: [sin_phi]/' sweep.yaml >bad.yaml
check 'a number that no summary has' sweep_gives 2 bad.yaml -o killed
check 'its line' says stderr 'bad.yaml:6:11: error: no number `sin_phi` will be in the summary.json of point 0'
check 'the same before any point runs' sweep_gives 2 bad.yaml -o never
check 'nothing is made' not test -e never
sed 's/1\/2/1\/2, 50e-2/' sweep.yaml >bad.yaml
check 'one value under two spellings' sweep_gives 2 bad.yaml -o never
check 'both are named' says stderr 'bad.yaml:4:31: error: `1/2` and `50e-2` of `contact.mu_r` make the same case'
check 'nothing is made' not test -e never
rm -r killed/mu_r=0,*seed=3 # a point that cannot run is found before
sed 's/disks: 40/disks: 40, step.dt: 1 s/' sweep.yaml >bad.yaml
check 'a step above the bound' sweep_gives 2 bad.yaml -o killed
check 'its point' says stderr 'bad.yaml:4:23: error: point 0 (mu_r=0'
check 'no such file' sweep_gives 3 nowhere.yaml
check 'a sweep is no case' run_gives 2 sweep.yaml
check 'options that exclude each other' sweep_gives 2 sweep.yaml --list --collect
check 'no jobs' sweep_gives 2 sweep.yaml -j 0
finish
