#!/bin/sh
# SPDX-License-Identifier: MIT
# A part of the faults of `make faults`, some 20 s of two processors: see tests/faults/faults.sh.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
programs=${FAULTS:-build/release/tests/faults}
if nm "$TRUNDLE" 2>/dev/null | grep -q __asan_; then
    skip 'faults' 'the address sanitizer has allocations of its own'
    finish
fi
tests/faults/faults.sh "$TRUNDLE" "$programs" 251 >"$work/faults"
while read -r line; do
    case $line in
    *', 0 wrong') check "$line" true ;;
    *wrong) check "$line" grep -A 8 "^not ok" "$work/faults" ;;
    'not ok '*': without a fault:') check "$line" false ;;
    skipped:*) skip "${line#skipped: }" 'no tracing here' ;;
    esac
done <"$work/faults"
check 'the campaign came to its end' grep -q '^[1-9][0-9]* faults, ' "$work/faults"
finish
