#!/bin/sh
# SPDX-License-Identifier: MIT
# make interop: where LAMMPS, LIGGGHTS or YADE is installed, the card goes through it and is identified. The answers of the releases of
# Debian 12 are known (figures/README.md); of another release only that there are some.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
here=$PWD
cd "$work" || exit 1
check 'it runs, whatever is installed' sh -c '"$0" "$1" out >said 2>&1 || { cat said; false; }' "$here/tests/interop/interop.sh" "$TRUNDLE"
check 'the card is there' equals "$(wc -l <out/card.csv)" 769
known() { # RELEASE ANSWER EXPLANATION
    grep -qF "$1,$2,$3" out/codes.csv || { cat out/codes.csv; false; }
}
if command -v lmp >/dev/null 2>&1; then
    check 'LAMMPS has answered' grep -q '^LAMMPS [0-9A-Za-z]*,F_t,' out/codes.csv
    if grep -q '^LAMMPS 29Sep2021,' out/codes.csv; then
        check 'its rolling spring is that of wang' known 'LAMMPS 29Sep2021' M1 '"wang, lever R_eff'
        check 'it slides by full radii' known 'LAMMPS 29Sep2021' F_t full-radius
        check 'and turns by midpoint arms' known 'LAMMPS 29Sep2021' 'arm 2' midpoint
        check 'which is not conjugate' known 'LAMMPS 29Sep2021' conjugate no
    fi
else
    skip 'the card in LAMMPS' 'no lmp'
fi
if command -v liggghts >/dev/null 2>&1; then
    check 'LIGGGHTS has answered' grep -q '^LIGGGHTS-PUBLIC [0-9.]*,F_t,' out/codes.csv
    if grep -q '^LIGGGHTS-PUBLIC 3.8.0,' out/codes.csv; then
        check 'its rolling spring is that of wang' known 'LIGGGHTS-PUBLIC 3.8.0' M1 '"wang, lever R_eff'
        check 'it slides and turns by midpoint arms' known 'LIGGGHTS-PUBLIC 3.8.0' 'arm 2' midpoint
        check 'at a floor half of the overlap is off' known 'LIGGGHTS-PUBLIC 3.8.0' 'arm 2 at wall' 'half of the overlap'
        check 'which is conjugate' known 'LIGGGHTS-PUBLIC 3.8.0' conjugate yes
    fi
else
    skip 'the card in LIGGGHTS' 'no liggghts'
fi
if command -v yade >/dev/null 2>&1; then
    check 'YADE has answered' grep -q '^YADE [0-9a-z.]*,F_t,' out/codes.csv
    if grep -q '^YADE 2023.02a,' out/codes.csv; then
        check 'its rolling spring has R1R2' known 'YADE 2023.02a' M1 '"tordesillas (w1-w2), lever R1R2"'
        check 'its bound has the smaller radius' known 'YADE 2023.02a' 'cap 1' '"min(R1,R2)"'
        check 'it slides by s1 - s2' known 'YADE 2023.02a' F_t alonso
        check 'without ratcheting control by midpoint arms' known 'YADE 2023.02a avoidGranularRatcheting=False' F_t midpoint
    fi
else
    skip 'the card in YADE' 'no yade'
fi
finish
