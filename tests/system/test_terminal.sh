#!/bin/sh
# SPDX-License-Identifier: MIT
# What is printed where: a progress bar only on a terminal, colours only where they are wanted, and no trouble when a
# stream is closed or full.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
cd "$work" || exit 1
write_small_case small.yaml
write_bodies_case bodies.yaml
longer='--set sample.disks=150 --set shear.inertial_number=4e-4'
escape=$(printf '\033')
unset NO_COLOR
TERM=xterm
export TERM

# ---- not a terminal ----
check 'piped: it runs' run_gives 0 small.yaml -o piped
check 'stderr is empty' not test -s stderr
check 'no escape codes on stdout' not grep -q "$escape" stdout
check 'a table of results' says stdout 'sin phi, peak'
check 'that names the directory' grep -q '^results  *piped$' stdout
check 'nothing is not a number' not grep -qiE '(^|[^a-z])(nan|inf)([^a-z]|$)' stdout

# ---- streams that are closed or full ----
closed() { # the results must not land in a stream's place, nor a message in a file of results
    "$TRUNDLE" run small.yaml --frames 1 -o closed --force
    equals $? 0 && cmp piped/history.csv closed/history.csv
}
stdout_closed() { closed >&-; } # not `check ... >&-`: that would close check's own voice
stderr_closed() { closed 2>&-; }
stdin_closed() { closed <&-; }
check 'stdout closed' stdout_closed
check 'stderr closed' stderr_closed
check 'stdin closed' stdin_closed
all_closed() { closed <&- >&- 2>&-; }
check 'all three closed' all_closed
check 'stdout closed: a failure is told by the code' sh -c '"$TRUNDLE" run small.yaml -o closed >&- 2>&-; [ $? -eq 3 ]'
if [ -e /dev/full ]; then
    "$TRUNDLE" run small.yaml -o full >/dev/full 2>stderr
    code=$?
    check 'stdout full: code 3' equals "$code" 3
    check 'is said' says stderr 'standard output'
    check 'the results are there' cmp piped/history.csv full/history.csv
    check 'stderr full' sh -c '"$TRUNDLE" run nothing.yaml 2>/dev/full; [ $? -eq 3 ]'
else
    skip 'stdout full' 'no /dev/full'
fi
check 'a pipe that nobody reads' sh -c '"$TRUNDLE" run bodies.yaml -o unread | true; [ -e unread/summary.json ]'

# ---- a terminal ----
# on_terminal COLUMNS COMMAND: runs it with a terminal of that width; what it shows is in $work/shown
on_terminal() {
    script -qec "stty cols $1 rows 24; $2" /dev/null </dev/null >shown 2>&1
}
# The longest line that was ever on the screen, as wide as it looked.
widest() {
    tr '\r' '\n' <"$1" | sed "s/$escape\[[0-9;]*[A-Za-z]//g" | awk '{ if (length($0) > n) n = length($0) } END { print n + 0 }'
}
if command -v script >/dev/null && command -v stty >/dev/null && on_terminal 80 'test -t 2'; then
    check 'on a terminal it runs' on_terminal 80 "'$TRUNDLE' run small.yaml $longer -o t80 2>&1 >/dev/null"
    check 'a bar' grep -q '\.\.\.\.' shown
    check 'for the compaction' grep -q 'compaction' shown
    check 'and the shear' grep -q 'shear' shown
    check 'with percents' grep -q ' %' shown
    check 'in colour' grep -q "$escape\[34m" shown
    check 'no line is wider than the terminal' test "$(widest shown)" -lt 80
    wiped() { tail -c 4 shown | od -An -tx1 | tr -d ' \n' | grep -q '0d1b5b4b$'; }
    check 'it is wiped at the end' wiped
    check 'with NO_COLOR it runs' on_terminal 80 "NO_COLOR=1 '$TRUNDLE' run small.yaml $longer -o no_color 2>&1 >/dev/null"
    check 'a bar' grep -q '\.\.\.\.' shown
    check 'without colour' not grep -q "$escape\[[0-9;]*m" shown
    for columns in 20 12 3; do
        check "on $columns columns it runs" on_terminal $columns "'$TRUNDLE' run small.yaml $longer -o narrow --force 2>&1 >/dev/null"
        check 'something is shown' grep -q co shown
        check 'no line wraps' test "$(widest shown)" -lt $columns
    done
    check 'on a dumb terminal it runs' on_terminal 80 "TERM=dumb '$TRUNDLE' run small.yaml $longer -o dumb 2>&1 >/dev/null"
    check 'in silence' not test -s shown
    check 'a failure on a terminal' not on_terminal 80 "'$TRUNDLE' run small.yaml -o crushed --set compaction.pressure=1e9"
    last_line_clean() { tail -n 1 shown | tr '\r' '\n' | grep -q '^error:' || tail -n 1 shown | grep -q "K.*error:"; }
    check 'its message has a line of its own' last_line_clean
else
    skip 'a progress bar on a terminal' 'no script(1) or stty(1) to make a terminal'
fi
finish
