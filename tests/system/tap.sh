# SPDX-License-Identifier: MIT
# shellcheck shell=sh
# TAP for the shell tests of this directory: source it, call check and skip, end with finish.
# It gives a temporary directory $work that is removed at the end. The plan comes last: a script that dies half-way has
# none, and tests/run counts that as a failure.

tests=0 failures=0
work=$(mktemp -d)
cleanup() { rm -rf "$work"; }
trap cleanup EXIT
trap 'exit 130' INT TERM

# Under the address sanitizer: fontconfig keeps its cache to the end, which is no leak of ours.
echo leak:libfontconfig >"$work/.leaks"
export LSAN_OPTIONS="suppressions=$work/.leaks:print_suppressions=0"

# check NAME COMMAND...: passes if the command succeeds; what it printed is shown if it fails.
check() {
    name=$1
    shift
    tests=$((tests + 1))
    if "$@" >"$work/said" 2>&1; then
        echo "ok $tests - $name"
    else
        echo "not ok $tests - $name"
        failures=$((failures + 1))
        sed 's/^/# /' "$work/said"
    fi
}

skip() {
    tests=$((tests + 1))
    echo "ok $tests - $1 # SKIP $2"
}

finish() {
    echo "1..$tests"
    [ "$failures" -eq 0 ]
    exit
}

# ---- small predicates ----

not() { ! "$@"; }

# Nothing on standard output; what there is, is the complaint.
is_silent() {
    said=$("$@")
    [ -z "$said" ] || { echo "$said"; false; }
}

equals() { [ "$1" = "$2" ] || { echo "is: $1"; echo "not: $2"; false; }; }

# says FILE TEXT
says() { grep -qF -- "$2" "$1" || { echo "no \"$2\" in:"; cat "$1"; false; }; }

# A small biaxial test that takes a tenth of a second; frames and rows are few.
write_small_case() {
    cat >"$1" <<'CASE'
kind: biaxial
seed: 3
sample: {disks: 60, r_min: 0.76 mm, r_max: 1.52 mm}
contact: {k_n: 160 MPa, mu: 0.5, mu_r: 0.5}
compaction: {pressure: 160 kPa, inertial_number: 0.1, unbalanced: 1e-2}
shear: {inertial_number: 2e-3, strain_end: 0.01}
output: {frames: 0, rows: 20}
CASE
}

# A disk that falls and bounces on a floor: no compaction, a few milliseconds.
write_bodies_case() {
    cat >"$1" <<'CASE'
kind: bodies
time_end: 0.05 s
gravity: {y: -9.81 m/s^2}
contact: {k_n: 1 MPa, mu: 0.5, mu_r: 0.1}
disks:
  - {radius: 10 mm, x: 0, y: 11 mm, vx: 0.1 m/s}
walls:
  - {nx: 0, ny: 1}
output: {frames: 0, rows: 20, contacts: 3}
CASE
}

# run ARGUMENTS...: trundle run, silent; leaves $work/stdout, $work/stderr and the exit code in $code.
run() {
    "$TRUNDLE" run "$@" >"$work/stdout" 2>"$work/stderr" </dev/null
    code=$?
}

# run_gives CODE ARGUMENTS...
run_gives() {
    wanted=$1
    shift
    run "$@"
    [ "$code" -eq "$wanted" ] || { echo "exit code $code, not $wanted"; cat "$work/stdout" "$work/stderr"; false; }
}

# Files under a directory but the list of them, one a line, sorted.
listing() { (cd "$1" && find . -type f ! -name trundle-files.txt | sed 's|^\./||' | sort); }

no_parts() { is_silent find "$1" -name '*.part'; }
