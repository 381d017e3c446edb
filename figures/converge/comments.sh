#!/bin/sh
# SPDX-License-Identifier: MIT
# Writes at the end of each case what its numbers are good to, by trundle converge. What it wrote before is replaced. A case
# that does not converge within its budget keeps what it had.
# usage: figures/converge/comments.sh TRUNDLE OUT BUDGET CASE...
set -eu
trundle=$1 out=$2 budget=$3
shift 3
failed=0
for case in "$@"; do
    name=$(basename "$case" .yaml)
    if ! "$trundle" converge "$case" -o "$out/$name" --budget "$budget" >"$out/$name.log" 2>&1; then
        echo "$case: $(tail -n 1 "$out/$name.log")"
        failed=1
        continue
    fi
    awk '
        /^# --- What the numbers are good to/ { inside = 1 }
        !inside { for (; blank > 0; blank--) print ""; if ($0 == "") blank++; else print }
        /^# --- end of trundle converge/ { inside = 0 }' "$case" >"$case.part"
    { echo; cat "$out/$name/comment.txt"; } >>"$case.part"
    mv "$case.part" "$case"
    echo "$case"
done
exit "$failed"
