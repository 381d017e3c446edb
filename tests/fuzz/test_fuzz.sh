#!/bin/sh
# SPDX-License-Identifier: MIT
# Every input that once broke a reader, and every seed of tests/fuzz/corpus, goes through its reader again. `make fuzz`
# makes new ones.
. "$(dirname "$0")/../system/tap.sh"
here=$(realpath "$(dirname "$0")")
build=$(realpath "${BUILD:-build/release}")

feed() {
    mkdir "$work/$1"
    cd "$work/$1" && "$build/tests/fuzz/replay_$1" "$here/corpus/$1"/*
}
for target in "$here"/fuzz_*.c; do
    target=$(basename "$target" .c)
    target=${target#fuzz_}
    check "known inputs of the target $target" feed "$target"
done
finish
