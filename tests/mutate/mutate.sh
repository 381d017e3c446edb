#!/bin/sh
# SPDX-License-Identifier: MIT
# Does the code change unseen? Makes the changes of table.tsv one at a time, in a copy of the tree, and says which test
# or row of `trundle verify` fails for each. A change is seen by a test that is not golden, never by the compiler.
# usage: mutate.sh [TEXT]   only lines of the table with TEXT
#        mutate.sh --check  only looks whether each line of the table still fits the code
# Exit code: 0 all seen, 1 not all, 2 the table is wrong. Run it where the Makefile is; the copy takes over what is
# built.
set -u
table=$(dirname "$0")/table.tsv
tab=$(printf '\t')
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM

# change FILE TEXT BECOMES: prints the file with it; fails unless the text is there once
change() {
    text=$2 becomes=$3 awk '
        { line = $0
          while (at = index(line, ENVIRON["text"])) {
              n++
              printf "%s%s", substr(line, 1, at - 1), ENVIRON["becomes"]
              line = substr(line, at + length(ENVIRON["text"]))
          }
          print line }
        END { exit n != 1 }' "$1"
}

# The lines that are asked for, without comments.
lines() { grep -v '^#' "$table" | grep -F -e "${1:-}"; }

bad=0
wrong() {
    echo "table.tsv: $1"
    bad=1
}
fits() {
    lines "$1" >"$work/lines"
    [ -s "$work/lines" ] || wrong "no line has \"$1\""
    while IFS=$tab read -r file text becomes watchers; do
        change "$file" "$text" "$becomes" >"$work/changed" || wrong "$file: \"$text\" is not there once"
        [ "$text" != "$becomes" ] || wrong "$file: \"$text\" does not change"
        [ -n "$watchers" ] || wrong "$file: \"$text\": nothing is to see it"
        for w in $watchers; do
            case $w in
            =*) grep -qF "\"${w#=}\"" src/verify/*.c || wrong "no verification is called ${w#=}" ;;
            *) [ -e "tests/$w.c" ] || wrong "no tests/$w.c" ;;
            esac
        done
    done <"$work/lines"
    [ "$bad" -eq 0 ]
}

# watch NAME: what of it fails, one a line; nothing if all is well or it cannot be built
watch() {
    case $1 in
    =*) timeout 300 ./trundle verify "${1#=}" >"$work/out" 2>&1 ;;
    *) CMOCKA_MESSAGE_OUTPUT=TAP timeout 300 "build/release/tests/$1" >"$work/out" 2>&1 ;;
    esac
    code=$?
    sed -n -e 's/^not ok *[0-9]* *-* *//p' -e 's/^  FAILED \(.\{44\}\).*/\1/p' "$work/out" | sed 's/ *$//' >"$work/failed"
    # a program that takes too long tells nothing: the machine may be slow
    [ "$code" -eq 0 ] || [ "$code" -eq 124 ] || [ -s "$work/failed" ] || echo "ended with code $code" >"$work/failed"
    grep -vi golden "$work/failed"
}
build() {
    case $1 in =*) target=build-all ;; *) target=build/release/tests/$1 ;; esac
    make -j2 --no-print-directory "$target" >"$work/make" 2>&1
}
every_test() { (cd tests && ls -- */test_*.c) | sed 's/\.c$//' | grep -v -e test_groups -e '^draw/' | tr '\n' ' '; }

# look WATCHERS: the first that sees something, and what; 1: none does, 2: it cannot be built
look() {
    for w in $1; do
        build "$w" || return 2
        watch "$w" >"$work/seen"
        [ -s "$work/seen" ] && echo "${w#=}: $(tr '\n' ';' <"$work/seen" | sed 's/;$//; s/;/; /g')" && return 0
    done
    return 1
}

[ "${1:-}" != --check ] || { fits ''; exit $((bad * 2)); }
fits "${1:-}" || exit 2
mkdir "$work/tree"
cp -pR Makefile src tests cases figures "$work/tree/"
[ ! -d build/release ] || cp -pR --parents build/release "$work/tree/"
cd "$work/tree" || exit 2

all=$(cut -f 4 "$work/lines" | tr ' ' '\n' | sort -u | tr '\n' ' ')
look "$all"
[ $? -eq 1 ] || { echo "error: red before any change, or cannot be built"; exit 2; }

total=0 unseen=0
while IFS=$tab read -r file text becomes watchers; do
    total=$((total + 1))
    cp "$file" "$work/kept"
    change "$file" "$text" "$becomes" >"$work/changed"
    cp "$work/changed" "$file"
    what="$file: $text -> $becomes"
    by=$(look "$watchers")
    code=$?
    if [ "$code" -eq 1 ]; then
        by=$(look "=exact $(every_test)")
        code=$?
    fi
    case $code in
    0) echo "seen    $what" && echo "        by $by" | cut -c 1-200 ;;
    1) echo "UNSEEN  $what" && unseen=$((unseen + 1)) ;;
    *) echo "ERROR   $what" && grep -m 1 'error:' "$work/make" && bad=1 ;;
    esac
    cp "$work/kept" "$file" # its time is new: objects of the changed file are built again
done <"$work/lines"
echo "$((total - unseen)) of $total changes are seen"
[ "$bad" -eq 0 ] || exit 2
[ "$unseen" -eq 0 ]
