#!/bin/sh
# SPDX-License-Identifier: MIT
# trundle identify: exit codes, where the words and the table go, columns by other names. What it says is tested in
# tests/study/test_identify.c.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
kept=$PWD/tests/interop
cd "$work" || exit 1
gives() { # CODE ARGUMENTS...
    code=$1
    shift
    "$TRUNDLE" identify "$@" >stdout 2>stderr </dev/null
    equals $? "$code"
}

check 'a code that is good: 0' gives 0 "$kept/liggghts.csv" -o found.csv
check 'its first line says so' equals "$(head -1 stdout)" 'good: objective: yes, balanced: yes, conjugate: yes'
check 'the table has a line for each answer and verdict' equals "$(cut -d, -f1 found.csv | xargs)" \
    'answer M1 M2 cap 1 V_s arm 1 arm 2 objective balanced conjugate'
check 'all as wide as the head' is_silent awk -v FPAT='[^,]*|"[^"]*"' -F, 'NR == 1 {n = NF} NF < n' found.csv
check 'one that is not: 1' gives 1 "$kept/lammps.csv"
check 'the reason first' equals "$(head -1 stdout | cut -d: -f1)" 'not objective when disks overlap'
sed '1s/V_s/slide/; 1s/R1/r_one/' "$kept/yade-no-ratcheting.csv" >other.csv
check 'other names: 2' gives 2 other.csv
check 'the missing one is told' says stderr 'other.csv:1: error: no column R1'
check 'mapped: 0' gives 0 other.csv --map slide=V_s -m r_one=R1
check 'the answer is there' says stdout 'V_s            midpoint'
check 'mapped to what is not there: 2' gives 2 other.csv --map slide=Vs
check 'is told' says stderr 'there is no column Vs here'
check 'a map without =: 2' gives 2 other.csv --map slide
check 'no file: 2' gives 2
check 'a file that is not there: 3' gives 3 nowhere.csv
check 'not onto the input: 3' gives 3 "$kept/lammps.csv" -o "$kept/lammps.csv"
check 'the card, without answers: 2' sh -c '"$0" measures --card card.csv && ! "$0" identify card.csv 2>stderr' "$TRUNDLE"
check 'what to add is told' says stderr 'no row has an answer: add a column V_r'
check 'each row of a kept file has the release' is_silent sh -c 'tail -qn +2 "$0"/*.csv | grep -vE "^[^,]*,(LAMMPS 29Sep2021|LIGGGHTS-PUBLIC 3.8.0|YADE 2023.02a)"' "$kept"
check 'no parts left' no_parts .
finish
