#!/bin/sh
# SPDX-License-Identifier: MIT
# What other codes compute: runs the card in each of them that is installed (Debian: lammps, liggghts, yade; nothing is installed here) and
# says what each uses. usage: interop.sh TRUNDLE DIR
# Writes DIR/card.csv, DIR/CODE.csv (the card with the answers), DIR/CODE.txt (what trundle identify says), and DIR/codes.csv: a line
# for each answer of each code, with its release.
set -eu
trundle=$(realpath "$1") here=$(dirname "$(realpath "$0")")
mkdir -p "$2"
out=$(realpath "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM
"$trundle" measures --card "$out/card.csv"
found=
for pair in lammps:lmp liggghts:liggghts yade:yade yade-ratcheting:yade; do
    code=${pair%:*}
    if ! command -v "${pair#*:}" >/dev/null 2>&1; then
        echo "$code: not installed"
        continue
    fi
    mkdir "$work/$code"
    release=$(cd "$work/$code" && "$here/$code.sh" "$out/card.csv" "$out/$code.csv")
    "$trundle" identify "$out/$code.csv" -o "$work/$code.found" >"$out/$code.txt" || [ $? -eq 1 ]
    awk -v release="$release" 'NR == 1 {print "release," $0; next} {print release "," $0}' "$work/$code.found" >"$work/$code.rows"
    found="$found $work/$code.rows"
    printf '%s\n\n' "$release"
    sed 's/^/    /' "$out/$code.txt"
    echo
done
[ "$found" ] || { echo 'no other code is installed: apt-get install lammps liggghts yade'; exit 0; }
# shellcheck disable=SC2086 # a list of files
awk 'FNR > 1 || NR == 1' $found >"$out/codes.csv"
echo "tables in $2"
