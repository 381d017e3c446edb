#!/bin/sh
# SPDX-License-Identifier: MIT
# Twenty of the random scenes of `make random`, and those that once went wrong: see tests/random/random.c.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
random=${RANDOM_SCENES:-build/release/random}
check 'random scenes: numbers, walls, energy, threads, stops' "$random" "$work/new" 20 1
check 'those that once went wrong' "$random" "$work/found" tests/random/found/*.yaml
finish
