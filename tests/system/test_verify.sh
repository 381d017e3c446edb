#!/bin/sh
# SPDX-License-Identifier: MIT
# trundle verify: all numbers of the default group are right, each verification has one, the table can be read back,
# exit codes. What makes a number wrong, and the table then, is tested in tests/verify/.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
cd "$work" || exit 1

# gives CODE ARGUMENTS...: leaves stdout and stderr
gives() {
    wanted=$1
    shift
    "$TRUNDLE" verify "$@" >stdout 2>stderr </dev/null
    code=$?
    [ "$code" -eq "$wanted" ] || { echo "exit code $code, not $wanted"; grep FAILED stdout; cat stderr; false; }
}

check '--list' gives 0 --list
cp stdout list
check 'a line for each: group, name, what' is_silent awk 'NF < 3' list
awk '$1 == "exact" { print $2 }' list | sort >names
some() { [ "$(wc -l <names)" -gt 20 ]; }
check 'there are many' some
check '--list of a group' gives 0 --list exact
exact_only() { is_silent awk '$1 != "exact"' stdout; }
check 'has that group alone' exact_only

check 'the default group: every number is right' gives 0 -o out
check 'says so' says stdout 'numbers are right'
check 'nothing is wrong' not grep -q FAILED stdout
check 'nothing on standard error' equals "$(cat stderr)" ''

# ---- the table ----
# plain AWK: without quotes, ; for a comma inside of them
plain() {
    awk '{ for (i = 1; i <= length; i++) {
               c = substr($0, i, 1)
               if (c == "\"") quoted = !quoted; else printf "%s", quoted && c == "," ? ";" : c
           }
           print "" }' out/verify.csv | awk -F, "$@"
}
check '14 cells in each line' is_silent plain 'NF != 14 { print NR ": " NF " cells" }'
check 'its columns' equals "$(head -1 out/verify.csv)" \
    group,case,quantity,unit,source,reference,computed,error,tolerance,order,seconds,verdict,outcome,reason
check 'every verdict is ok' is_silent plain 'NR > 1 && $12 != "ok"'
check 'a tolerance has its reason' is_silent plain 'NR > 1 && $9 != "" && $14 == ""'
check 'what has no number has words' is_silent plain 'NR > 1 && $7 == "" && $13 == ""'
check 'a number is within its tolerance' is_silent plain 'NR > 1 && $7 != "" && ($7 - $6)^2 > ($9 * 1.0001)^2 + 1e-16 * $6^2'
plain 'NR > 1 { print $2 }' | sort -u >found
check 'a row for each verification' cmp found names
check 'as many as were said' equals "$(($(wc -l <out/verify.csv) - 1))" "$(sed -n 's/^\([0-9]*\) of .*/\1/p' stdout)"
numbers() { cut -d, -f1-10 "$1"; } # all but the time
check 'again, into the same directory' gives 0 slip-to-roll -o out
numbers out/verify.csv >once
check 'one by its name alone' equals "$(wc -l <out/verify.csv)" 4
check 'and again' gives 0 slip-to-roll -o twice
numbers twice/verify.csv >again
check 'the same numbers' cmp once again
check 'no parts left' no_parts .

# ---- mistakes ----
check 'an unknown name: 2' gives 2 no-such-name
check 'is named' says stderr 'no-such-name'
check 'an unknown option: 2' gives 2 --frobnicate
check 'a directory that cannot be: 3' gives 3 slip-to-roll -o /dev/null/out
full() {
    "$TRUNDLE" verify slip-to-roll >/dev/full 2>stderr
    [ $? -ne 0 ]
}
check 'a full standard output is noticed' full
check '--help' gives 0 --help
check 'says what the groups are' says stdout 'precision (error against run time)'
finish
