#!/bin/sh
# SPDX-License-Identifier: MIT
# trundle measures: where the card and the tables go, exit codes, and that nothing half-done is left. The numbers are
# tested in tests/study/.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
cd "$work" || exit 1
columns=case,R1,R2,x1x,x1y,x2x,x2y,v1x,v1y,v2x,v2y,w1,w2
printf '%s\ngears,2,1,0,0,3,0,0,0,0,0.6,0.5,-0.4\n' $columns >good.csv
# The last of many rows is bad: those before it fill more than one buffer.
awk -v head=$columns 'BEGIN { print head; for (i = 0; i < 5000; i++) print "a,1,1,0,0,2,0,0,0,0,0,0,0"; print "b,1,1,0,0,2,0,0,0,0,0,0,nan" }' </dev/null >bad.csv

# gives CODE ARGUMENTS...: leaves stdout and stderr
gives() {
    wanted=$1
    shift
    "$TRUNDLE" measures "$@" >stdout 2>stderr </dev/null
    code=$?
    [ "$code" -eq "$wanted" ] || { echo "exit code $code, not $wanted"; cat stdout stderr; false; }
}

# ---- the card ----
check 'the card' gives 0
# Nine definitions, 93 columns; each further one takes eight more.
width() { awk '$1 == "PR" && $2 == 1 {n = NF - 2} length > w {w = length} END {exit !(n >= 9 && w <= 100 + 8*(n - 9))}' stdout; }
check 'fits 100 columns' width
check 'no minus before a zero, no nan' not grep -qE -- '-0 |nan' stdout
# cells "MOTION" RATIO "NAME...": what stands in the columns with these heads, whose two lines are read as one word
cells() {
    awk -v motion="$1" -v ratio="$2" -v names="$3" '
        /bagi-/ {above = $0}
        /^motion/ {
            for (k = 22; k <= length; k += 8) {
                head = substr(above, k, 8) substr($0, k, 8)
                gsub(/ /, "", head)
                at[head, ++seen[head]] = k
            }
        }
        substr($0, 1, 15) == sprintf("%-15s", motion) && substr($0, 16, 5) + 0 == ratio + 0 {
            n = split(names, name, " ")
            for (i = 1; i <= n; i++) {
                times[name[i]]++
                cell = (name[i], times[name[i]]) in at ? substr($0, at[name[i], times[name[i]]], 8) : "no-" name[i]
                gsub(/ /, "", cell)
                printf "%s%s", cell, i < n ? " " : "\n"
            }
        }' stdout
}
all='wang bagi-kuhn alonsomin alonsomean torde-sillas wang iwash.oda alonso fullradii' # the second wang slides
check 'gears roll for all' equals "$(cells PR 2 "$all")" '1.000 1.000 1.000 1.000 1.500 0 0 0 0'
check 'marked: bagi-kuhn rolls in pure sliding of unequal disks' \
    equals "$(cells PS 10 "$all")" '0 0.409* 0 0 0 1.000 0.500* 1.000 1.000'
check 'not of equal ones' equals "$(cells PS 1 "$all")" '0 0 0 0 0 1.000 0.500* 1.000 1.000'
check 'marked: full radii with overlap, for two observers' \
    equals "$(cells 'RBR overlap' 1 "$all")" '0 0 0 0 0 0 0 0 0.050*!'
check 'spinning in place' \
    equals "$(cells 'floor: spinning' inf "$all")" '-1.000 -0.500* 0* 0* -1.000 1.000 0.500* 1.000 1.000'
check 'the card as CSV' gives 0 -o card.csv
check '42 motions' equals "$(wc -l <card.csv)" 43
check 'each as wide as the head' is_silent awk -F, 'NR == 1 {n = NF} NF != n || n < 35' card.csv
check 'which can be read back' gives 0 card.csv
check 'byte for byte' cmp stdout card.csv

check 'and with the arms' gives 0 -o arms.csv --arms
check 'which are told' says stdout 'stretched-midpoint'
check 'have columns of their own' says arms.csv 'r1_shared,r2_shared,power_shared,r1_midpoint'
check 'none is lost' equals "$(cut -d, -f1-35 arms.csv | cksum)" "$(cut -d, -f1-35 card.csv | cksum)"
check 'a card for other codes' gives 0 --card motions.csv
check 'says nothing then' equals "$(cat stdout stderr)" ''
check 'three lines a motion' equals "$(wc -l <motions.csv)" 769
check 'which can be measured' gives 0 motions.csv --arms
check 'all as wide as the head' is_silent awk -F, 'NR == 1 {n = NF} NF != n' motions.csv
check 'a card and a table: 2' gives 2 --card motions.csv good.csv

# ---- tables ----
check 'a table on standard output' gives 0 good.csv
check 'a line for a line' equals "$(wc -l <stdout)" 2
cp stdout expected
check 'the same in a file' gives 0 good.csv -o out.csv
check 'says nothing then' equals "$(cat stdout stderr)" ''
check 'byte for byte' cmp out.csv expected
check 'in another directory' gives 0 good.csv -o "$work/out.csv"
pipe() { "$TRUNDLE" measures /dev/stdin <good.csv >stdout && cmp stdout expected; }
check 'from a pipe' pipe
check 'not onto the input itself' gives 3 out.csv -o out.csv
check 'both names are said' says stderr 'out.csv would replace out.csv'
check 'changes nothing' cmp out.csv expected

# ---- bad input: 2, and nothing written ----
check 'a bad row' gives 2 bad.csv
check 'is named' equals "$(cat stderr)" 'bad.csv:5002: error: w2 is "nan", which is not a number'
check 'no rows before it' equals "$(wc -c <stdout)" 0
check 'the same with -o' gives 2 bad.csv -o out.csv
check 'keeps the old file' cmp out.csv expected
check 'no new file' gives 2 bad.csv -o new.csv
check 'at all' not test -e new.csv
check 'no parts' no_parts .
check 'two files: 2' gives 2 good.csv bad.csv
check 'unknown option: 2' gives 2 --frobnicate
check '--help' gives 0 --help
check 'says what a wall is' says stdout 'R1 = inf'

# ---- files: 3 ----
check 'no such file' gives 3 nowhere.csv
check 'is named' says stderr 'cannot read nowhere.csv: No such file'
check 'a directory' gives 3 .
check 'no such directory' gives 3 good.csv -o nowhere/out.csv
check 'a directory for -o' gives 3 good.csv -o .
check 'no name for -o' gives 3 good.csv -o ''
ln -s /dev/full full
check 'a device for -o' gives 3 good.csv -o full
check 'is left alone' test -c /dev/full -a -L full
full() {
    "$TRUNDLE" measures good.csv >/dev/full 2>stderr
    equals $? 3 && says stderr 'No space left'
}
check 'a full standard output' full
check 'no parts left' no_parts .
finish
