#!/bin/sh
# SPDX-License-Identifier: MIT
# The table of `make mutate` fits the code: each text is there once, what is to see it exists. And mutate.sh says so if
# not.
set -u
# shellcheck source=tests/system/tap.sh
. tests/system/tap.sh

check 'every line of the table fits the code' tests/mutate/mutate.sh --check

# spoiled WHAT LINE: with that line at the end of a copy of the table, --check must complain of it
spoiled() {
    mkdir -p "$work/mutate"
    cp tests/mutate/mutate.sh tests/mutate/table.tsv "$work/mutate/"
    printf '%b\n' "$2" >>"$work/mutate/table.tsv"
    "$work/mutate/mutate.sh" --check >"$work/complaint" 2>&1
    equals $? 2 && says "$work/complaint" "$1"
}
check 'noticed: a text that is not there' spoiled 'is not there once' 'src/core/step.c\tno such text\tx\t=servo'
check 'noticed: a text that occurs twice' spoiled 'is not there once' 'src/core/step.c\treturn\tx\t=servo'
check 'noticed: a change that changes nothing' spoiled 'does not change' 'src/core/step.c\tvel[k] += \tvel[k] += \t=servo'
check 'noticed: an unknown verification' spoiled 'no verification' 'src/core/step.c\tvel[k] += \tx\t=nothing'
check 'noticed: an unknown test' spoiled 'no tests/' 'src/core/step.c\tvel[k] += \tx\tcore/test_nothing'
finish
