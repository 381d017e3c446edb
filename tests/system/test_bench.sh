#!/bin/sh
# SPDX-License-Identifier: MIT
# trundle bench on a small sample: its form, never its speed. And README's example of an error is the real one.
set -u
here=$(dirname "$0")
# shellcheck source=tests/system/tap.sh
. "$here/tap.sh"
root=$(cd "$here/../.." && pwd)

"$TRUNDLE" bench --set sample.disks=60 --set shear.strain_end=0.01 >"$work/out" 2>"$work/err"
check 'it runs' equals $? 0
check 'exactly one line of the form NN.N M contact updates/s' equals "$(grep -cE '^[0-9]+\.[0-9] M contact updates/s$' "$work/out")" 1
check 'it is the last' sh -c "tail -n 1 '$work/out' | grep -q 'contact updates/s$'"
check 'with rolling, eight passes' equals "$(sed '/^without/,$d' "$work/out" | grep -c 'ns per contact')" 9
check 'without, two fewer' equals "$(sed '1,/^without/d' "$work/out" | grep -c 'ns per contact')" 7
bytes() { sed -n "s/^$1.* \([0-9]*\) bytes per disk$/\1/p" "$work/out"; }
check 'and less memory' test "$(bytes without)" -lt "$(bytes 'as given')"
check 'a case of bodies is refused' equals "$("$TRUNDLE" bench "$root/cases/pure-rolling.yaml" 2>&1)" 'error: bench needs a case of kind: biaxial'

# README shows a mistake in cases/biaxial.yaml and what the tool says of it.
mkdir "$work/cases"
sed 's/^  mu_r:/  mu_R:/' "$root/cases/biaxial.yaml" >"$work/cases/biaxial.yaml"
(cd "$work" && "$TRUNDLE" run cases/biaxial.yaml --check) >/dev/null 2>"$work/said"
while IFS= read -r line; do
    check "README shows: $line" grep -qF "    $line" "$root/README.md"
done <"$work/said"
finish
