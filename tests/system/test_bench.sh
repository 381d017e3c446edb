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

# ---- what features cost
"$TRUNDLE" bench --features --set sample.disks=60 --set shear.strain_end=0.4 -o "$work/features.csv" >"$work/out" 2>"$work/err"
code=$?
# A machine may be slow: but the code says what the lines say. With a dear normal law what is left out is a small part, and fails.
claimed() { if grep -q '^FAILED: a bare scene takes' "$1"; then echo 1; else echo 0; fi; }
check 'the exit code is that of the claims' equals $code "$(claimed "$work/out")"
"$TRUNDLE" bench --features --set sample.disks=60 --set shear.strain_end=0.05 --set contact.normal=hertz-line >"$work/dear" 2>&1
check 'the exit code is that of the claims: a dear normal law' equals $? "$(claimed "$work/dear")"
check 'no array without a law that needs it' grep -q '^ok: no history array' "$work/out"
check 'a law for the other shape is named, with the reason' grep -qx 'without contact.normal=hertz-sphere: the law hertz-sphere is for spheres, .*' "$work/out"
# column N ROW: of the CSV
column() { awk -F, -v n="$1" -v row="$2" '$2 == row {print $n}' "$work/features.csv"; }
check 'features one at a time' equals "$(awk -F, '$1 == "feature" {printf "%s;", $2}' "$work/features.csv" | sed 's/every [0-9]* steps/every N steps/')" \
    'linear alone;+ coulomb-spring;+ wang-spring;+ energy ledger;+ a frame every N steps;'
check 'every law is a row' equals "$(awk -F, '$1 ~ /^(normal|friction|rolling)$/ {printf "%s ", $2}' "$work/features.csv")" \
    'hertz-line dahlberg-alfredsson cattaneo-mindlin kuhn-creep vu-quoc-zhang bagi-kuhn-conjugate star-force-proportional star-constant-torque star-displacement-damping '
check 'numbers in order: quartiles about the median, above zero' awk -F, \
    'NR > 1 && !($4 > 0 && $4 <= $3 && $3 <= $5 && $6 > 0 && $7 > 0 && $8 > 0 && $9 > 0 && $10 >= 0) {print; bad = 1} END {exit bad}' "$work/features.csv"
# A block of steps changes a packing little; without friction a shear of its own would have it 16 % above the full one's.
check 'the same packing: touching contacts within 5 %' awk -F, '
    FNR == NR {if ($2 == "+ energy ledger") full = $8; next}
    FNR > 1 && ($8 > 1.05*full || $8 < 0.95*full) {print; bad = 1}
    END {exit bad}' "$work/features.csv" "$work/features.csv"
# Smooth walls: Q, T of the disks; the ledger's 7 of them and 2 of the walls.
arrays() { column 10 "$1"; }
check 'history arrays' equals "$(arrays 'linear alone') $(arrays '+ coulomb-spring') $(arrays '+ wang-spring') $(arrays '+ energy ledger')" '0 1 2 11'
check 'what is there takes memory' sh -c "test \"\$1\" -lt \"\$2\" && test \"\$2\" -lt \"\$3\"" - \
    "$(column 9 'linear alone' | cut -d. -f1)" "$(column 9 '+ wang-spring' | cut -d. -f1)" "$(column 9 '+ energy ledger' | cut -d. -f1)"
check 'the full scene is the whole' equals "$(column 6 '+ energy ledger')" 1.0000
check 'without friction it is refused' equals "$("$TRUNDLE" bench --features --set contact.friction=none 2>&1)" \
    'error: --features needs a case with friction and rolling resistance'
check 'refused with code 2' sh -c '"$0" bench --features --set contact.rolling=none; test $? -eq 2' "$TRUNDLE"
check 'a table of nothing is refused' sh -c '"$0" bench -o "$1"; test $? -eq 2' "$TRUNDLE" "$work/none.csv"

# README shows a mistake in cases/biaxial.yaml and what the tool says of it.
mkdir "$work/cases"
sed 's/^  mu_r:/  mu_R:/' "$root/cases/biaxial.yaml" >"$work/cases/biaxial.yaml"
(cd "$work" && "$TRUNDLE" run cases/biaxial.yaml --check) >/dev/null 2>"$work/said"
while IFS= read -r line; do
    check "README shows: $line" grep -qF "    $line" "$root/README.md"
done <"$work/said"
finish
