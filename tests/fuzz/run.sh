#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs each fuzz target for some seconds, as many at once as there are processors; tells how many inputs each took, and
# keeps what was found. usage: tests/fuzz/run.sh BUILD SECONDS TARGET...
set -u
build=$(realpath "$1") seconds=$2
shift 2
case $seconds in
'' | 0* | *[!0-9]*) echo "SECONDS must be a whole number above 0, not $seconds" >&2 && exit 2 ;;
esac
tests=$(realpath "$(dirname "$0")")
memory=${TMPDIR:-/tmp}
[ -w /dev/shm ] && memory=/dev/shm
work=$(mktemp -d "$memory/trundle-fuzz-XXXXXX")
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM

# What is new in its corpus stays in build/ and is where the next run begins; what was found goes to found/.
one() {
    target=$1
    mkdir -p "$work/$target" "$build/corpus/$target" "$build/found/$target"
    cd "$work/$target" || exit 1
    seeds=$tests/corpus/$target
    [ "$target" = case ] && seeds="$seeds $tests/../../cases"
    # shellcheck disable=SC2086 # a list of folders
    "$build/fuzz_$target" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=2000 -max_len=4000 -print_final_stats=1 \
        -artifact_prefix="$build/found/$target/" "$build/corpus/$target" $seeds >"$build/$target.log" 2>&1
    code=$?
    inputs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$build/$target.log")
    if [ $code -eq 0 ]; then
        echo "$target: $inputs inputs, nothing found"
    else
        kept=$(sed -n 's/.*Test unit written to //p' "$build/$target.log" | head -1)
        echo "$target: found after ${inputs:-?} inputs, kept in ${kept:-nowhere}, told in $build/$target.log"
        touch "$work/found"
    fi
}

running=0
for target in "$@"; do
    one "$target" &
    running=$((running + 1))
    [ $((running % $(nproc))) -eq 0 ] && wait
done
wait
[ ! -e "$work/found" ]
