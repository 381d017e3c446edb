#!/bin/sh
# SPDX-License-Identifier: MIT
# Every citation in the sources, like [Wang2015 eq. 11], has its entry in src/references.bib, and every entry is cited.
# usage: test_citations.sh [ROOT]   with a root: only the rules, on that tree
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
root=${1:-.}

# Keys are a name and a year. The bracket may hold more behind the key; several keys may share it: [A2001, B2002].
cited() {
    find "$root/src" \( -name '*.[ch]' -o -name '*.cpp' \) -exec cat {} + | tr '\n' ' ' | grep -oE '\[[A-Z][^][]*\]' |
        grep -oE '\<([A-Z][A-Za-z]+(1[89]|20)[0-9][0-9][a-z]?|STARCCM)\>' | sort -u # a page without a year
}
entries() { sed -n 's/^@[a-z]*{\([^,]*\),.*/\1/p' "$root/src/references.bib" | sort; }

only_in_first() {
    "$1" | sort -u >"$work/first"
    "$2" | sort -u | comm -23 "$work/first" -
}
twice() { entries | uniq -d; }

check 'every citation has an entry' is_silent only_in_first cited entries
check 'every entry is cited' is_silent only_in_first entries cited
check 'no entry occurs twice' is_silent twice
some() { [ "$(cited | wc -l)" -ge 3 ]; }
check 'there are citations' some
[ $# -eq 1 ] && finish

# broken RULE FILE LINE: with the line at the end of the file of a copy, the rule must fail, and no other
broken() {
    rm -rf "$work/copy"
    mkdir "$work/copy"
    cp -r src "$work/copy/"
    printf '%s\n' "$3" >>"$work/copy/src/$2"
    "$0" "$work/copy" >"$work/tap" 2>&1
    says "$work/tap" 1..4 || return 1
    failed=$(grep '^not ok' "$work/tap" | sed 's/^not ok [0-9]* - //')
    equals "$failed" "$1"
}
check 'noticed: a citation of nothing' broken 'every citation has an entry' core/step.c '/* [Nobody1999 eq. 3] */'
check 'noticed: the second of two' broken 'every citation has an entry' core/step.c '/* [Wang2015; Nobody1999] */'
check 'noticed: an entry that nobody cites' broken 'every entry is cited' references.bib '@book{Nobody1999, title = {x}}'
check 'noticed: an entry that occurs twice' broken 'no entry occurs twice' references.bib '@article{Wang2015, title = {x}}'
finish
