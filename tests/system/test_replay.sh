#!/bin/sh
# SPDX-License-Identifier: MIT
# trundle replay at the command line: its tables, what it refuses, Ctrl-C, and that a new run takes old tables away.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
cd "$work" || exit 1
write_small_case small.yaml
sed 's/k_n: 160 MPa/normal: hertz-line, E_star: 400 MPa, k_t: 180 MPa, k_r: 80 MPa/; s/rows: 20/&, path_rows: 60, curves: no/' small.yaml >case.yaml

# replay_gives CODE TEXT ARGUMENTS...: with that code, and the text in what it said
replay_gives() {
    wanted=$1 text=$2
    shift 2
    "$TRUNDLE" replay "$@" >stdout 2>stderr </dev/null
    code=$?
    cat stdout stderr >said-now
    equals "$code" "$wanted" && says said-now "$text"
}
tables='replay-errors.csv replay-stress.csv replay.csv'
has_tables() { equals "$(cd "$1" && echo replay*)" "$tables"; }
quiet_without_terminal() { equals "$(cat stderr)" "$(grep '^note: ' stderr)"; }

check 'a run with paths.csv' run_gives 0 case.yaml -o run
check 'its replay' replay_gives 0 'cattaneo-mindlin' run -n 10
check 'makes three tables beside it' has_tables run
check 'and says nothing else' quiet_without_terminal
check 'or elsewhere' replay_gives 0 'elsewhere' run -n 10 -j 1 -o elsewhere
check 'the same bytes' diff -q run/replay.csv elsewhere/replay.csv
no_stress() { replay_gives 0 'contacts, rows' run -n 10 --every 5 -o part && not test -e part/replay-stress.csv; }
check 'of each fifth contact there is no stress' no_stress

check 'no run: 3' replay_gives 3 case.yaml nowhere
check 'which run? 2' replay_gives 2 'which run?'
check 'two runs: 2' replay_gives 2 'one run at a time' run run
check 'no number: 2' replay_gives 2 '-j must be a whole number' run -j two
run small.yaml -o spring
check 'no paths.csv: 2' replay_gives 2 'output.path_rows' spring
run small.yaml -o spring --force --set output.path_rows=5
check 'laws without E_star: 2' replay_gives 2 'E_star' spring
check 'no table of a replay that failed' equals "$(listing spring | grep replay)" ''

# bad_paths CHANGE TEXT: a copy of the run, changed, is refused with that text and gets no table
bad_paths() {
    rm -rf bad && cp -r run bad && rm -f bad/replay*.csv && (cd bad && eval "$1") && replay_gives 2 "$2" bad &&
        equals "$(listing bad | grep replay)" ''
}
lines=$(grep -c '' run/paths.csv)
check 'an unfinished run: 2' bad_paths 'rm summary.json' 'bad has no summary.json: the run is not finished'
check 'paths.csv cut at the end of a line: 2, and where' \
    bad_paths 'sed -i "\$d" paths.csv' "bad/paths.csv:$((lines - 1)): error: the file ends here with "
check 'a row that occurs twice: 2, and where' bad_paths 'sed -i 5p paths.csv' 'bad/paths.csv:6: error: the contact of '
check 'a disk that touches itself: 2, and where' bad_paths \
    'awk -F, -v OFS=, "NR == 5 {\$3 = \$4} 1" paths.csv >p && mv p paths.csv' 'bad/paths.csv:5: error: disk '
check 'a disk that is not there: 2, and where' bad_paths \
    'awk -F, -v OFS=, "NR == 5 {\$4 = 4000} 1" paths.csv >p && mv p paths.csv' 'bad/paths.csv:5: error: impossible contact: '

stopped() {
    "$TRUNDLE" replay run -n 400 -j 2 -o stopped >stdout 2>stderr </dev/null &
    sleep 0.5
    kill -INT $!
    wait $!
    equals $? 130 && says stderr stopped && not test -e stopped
}
# a shell without job control starts children with SIGINT ignored, where trundle still sets its handler
check 'Ctrl-C: 130, and nothing is written' stopped

run_gives 0 case.yaml -o run --force --set seed=4 >/dev/null
check 'a new run takes the tables of the old one away' equals "$(listing run | grep replay)" ''
finish
