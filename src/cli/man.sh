#!/bin/sh
# SPDX-License-Identifier: MIT
# Man pages of trundle and of each of its commands, from their --help, by help2man.
# usage: src/cli/man.sh TRUNDLE DIR
set -eu
trundle=$(realpath "$1") dir=$2
version=$("$trundle" --version | sed 's/^trundle \([^,]*\),.*/\1/')
title=$("$trundle" --help | sed -n 's/^trundle [^:]*: //p')
# Lines "  COMMAND  what it does" of the help.
commands=$("$trundle" --help | sed -n 's/^  \([a-z][a-z]*\)  *[a-z].*/\1/p' | grep -v '^trundle$')
# The date of the pages is that of the commit, so that one commit has one set of pages.
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || date +%s)}
export SOURCE_DATE_EPOCH
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$dir"
rm -f "$dir"/*.1
ln -s "$trundle" "$work/trundle" # the pages say `trundle`, not its path
PATH=$work:$PATH

# see_also WORDS...: a section with these pages
see_also() {
    echo '[SEE ALSO]'
    printf '.BR %s (1)\n' "$@" | sed '$!s/$/,/'
}

# page NAME PROGRAM DOC: help2man cannot name a program of two words, so sed mends the name.
page() {
    upper=$(echo "$1" | tr '[:lower:]' '[:upper:]')
    help2man --no-info --include "$work/more" --version-string "$version" --name "$3" "$2" |
        sed -e "s/^\.TH TRUNDLE /.TH $upper /" -e "s/^$2 \\\\- /$1 \\\\- /" >"$work/page"
    mv "$work/page" "$dir/$1.1"
}

# shellcheck disable=SC2046,SC2086 # lists of words
see_also $(printf 'trundle-%s ' $commands) >"$work/more"
page trundle trundle "$title"
for command in $commands; do
    see_also trundle >"$work/more"
    doc=$(trundle --help | sed -n "s/^  $command  *//p")
    page "trundle-$command" "trundle $command" "$doc"
done
