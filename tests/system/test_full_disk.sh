#!/bin/sh
# SPDX-License-Identifier: MIT
# A full disk: exit code 3, a message, and nothing half-written under a final name, wherever it strikes.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
contact=$PWD/cases/contact-reversal.yaml
patch=$PWD/cases/patch-cattaneo-to-carter.yaml
cd "$work" || exit 1
write_small_case small.yaml
write_bodies_case bodies.yaml
mkdir disk
if ! mount -t tmpfs -o size=1M tmpfs disk 2>/dev/null; then
    skip 'a full disk' 'cannot mount a small file system here'
    finish
fi
trap 'umount "$work/disk"; cleanup' EXIT

ends_with() { # FILE HEX: its last bytes
    [ "$(tail -c $((${#2} / 2)) "$1" | od -An -v -tx1 | tr -d ' \n')" = "$2" ] || { echo "$1 is cut short"; false; }
}
whole() { # every file under a final name is complete of its kind
    for file in $(find disk -type f); do
        case $file in
        *.part) echo "$file is left over" && return 1 ;;
        *.png) ends_with "$file" 49454e44ae426082 || return 1 ;;
        *.svg) ends_with "$file" 3c2f7376673e0a0a || return 1 ;;
        *.mp4) ffmpeg -v error -xerror -i "$file" -f null - || return 1 ;;
        *.gif) ends_with "$file" 3b || return 1 ;;
        *.json | *.yaml | *.gp) ends_with "$file" 0a || return 1 ;;
        *.csv) ends_with "$file" 0a && awk -F, 'NR == 1 { n = NF } NF != n { exit 1 }' "$file" || return 1 ;;
        esac
    done
}
# strikes SIZE ARGUMENTS...: the run either fails as it should or has room for all
finished=0
strikes() {
    rm -rf disk/* # first: a disk cannot shrink below what is on it
    mount -o "remount,size=$1" disk || return 1
    shift
    run "$@" -o disk/results
    whole || return 1
    if [ "$code" -eq 0 ]; then
        finished=$((finished + 1))
        test -e disk/results/summary.json
    else
        equals "$code" 3 && says stderr 'error: cannot' && not test -e disk/results/summary.json
    fi
}
for size in 4k 8k 16k 64k 256k 1M 4M; do check "$size, frames" strikes $size small.yaml --frames 8; done
check '4M is enough' equals "$finished" 1
for size in 300k 400k 1200k; do check "$size, the film among frames" strikes $size small.yaml --frames 8; done
for size in 8k 16k 32k 64k 128k; do check "$size, tables and curves" strikes $size small.yaml; done
for size in 8k 16k 64k 512k; do check "$size, bodies" strikes $size bodies.yaml --set output.rows=5000 --set time_end=2s; done
for size in 8k 64k 256k 400k 512k 2M; do check "$size, a contact" strikes $size "$contact"; done
for size in 8k 64k 256k; do check "$size, inside a contact" strikes $size "$patch" --set path.1.steps=50; done

# Rows that were written before a film failed are kept, and the message says so.
rm -rf disk/*
mount -o remount,size=600k disk
check 'frames fill the disk' run_gives 3 small.yaml --frames 8 -o disk/results
check 'the message says where' says stderr 'No space left on device'
check 'and what is kept' says stderr 'kept in disk/results:'
kept=$(sed -n 's/.*: \([0-9]*\) rows of history.*/\1/p' stderr)
check 'it has the rows' equals "$(($(wc -l <disk/results/history.csv) - 1))" "$kept"
finish
