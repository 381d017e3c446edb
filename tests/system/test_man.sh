#!/bin/sh
# SPDX-License-Identifier: MIT
# Man pages and the completion for bash: both must have every command and every option that --help has.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
commands=$("$TRUNDLE" --help | sed -n 's/^  \([a-z]*\)   *[a-z].*/\1/p' | grep -vx trundle)
options_of() { "$TRUNDLE" "$1" --help | grep -oE '^ {2,6}(-., )?--[a-z-]+=?' | grep -oE -- '--[a-z-]+=?'; }
check 'the help names seven commands or more' test "$(echo "$commands" | wc -l)" -ge 7

# ---- man pages ----
has_options() { # COMMAND: its page has each of its options in bold
    for option in $(options_of "$1"); do
        sed 's/\\-/-/g' "$work/man/trundle-$1.1" | grep -qF "\\fB${option%=}\\fR" || { echo "no $option"; return 1; }
    done
}
if command -v help2man >/dev/null 2>&1; then
    check 'pages are made' src/cli/man.sh "$TRUNDLE" "$work/man"
    named=$(sed -n 's/^\.BR trundle-\([a-z]*\) (1),*$/\1/p' "$work/man/trundle.1")
    check 'the first page names all others' equals "$named" "$commands"
    for command in $commands; do
        check "$command: its page has all its options" has_options "$command"
        check "$command: its page has the name that man looks for" \
            grep -q "^trundle-$command \\\\- [a-z]" "$work/man/trundle-$command.1"
        check "$command: its page has a synopsis" grep -q '^\.SH SYNOPSIS' "$work/man/trundle-$command.1"
    done
    made() {
        (unset MAKEFLAGS MAKELEVEL && make --no-print-directory TRUNDLE="$TRUNDLE" OUT="$work/out" "$@" >"$work/made")
    }
    check 'make install puts them there' made install-man DESTDIR="$work/root" PREFIX=/usr
    check 'all of them' diff -r "$work/man" "$work/root/usr/share/man/man1"
    check 'no page names this directory' not grep -r "$work" "$work/man"
    if command -v groff >/dev/null 2>&1; then
        warnings() { groff -man -Tutf8 -ww "$work"/man/*.1 2>&1 >"$work/read"; }
        check 'groff has no warnings' is_silent warnings
    else
        skip 'groff has no warnings' 'no groff'
    fi
else
    skip 'man pages' 'no help2man'
fi

# ---- completion ----
# complete WORD...: what is offered for the last word, one a line
complete_words() {
    bash -c '. src/cli/completion.bash; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _trundle
        printf "%s\n" "${COMPREPLY[@]}" | sort' bash "$TRUNDLE" "$@"
}
offers() { # WANTED WORD...
    wanted=$1
    shift
    equals "$(complete_words "$@")" "$wanted"
}
if command -v bash >/dev/null 2>&1; then
    check 'completion: all commands' offers "$(printf '%s\n' $commands --help --version | sort)" ''
    check 'completion: a command that was begun' offers replay re
    for command in $commands; do
        check "completion: options of $command" offers "$(options_of "$command" | sort)" "$command" --
    done
    check 'completion: an option that was begun' offers "$(printf '%s\n' --sample= --seed= --set=)" run --s
    check 'completion: kinds behind --keys' offers "$(printf '%s\n' biaxial bodies)" run --keys b
    check 'completion: a law' offers wang-spring laws wang
    check 'completion: a verification' offers slip-to-roll verify slip-to
    check 'completion: a case' offers cases/biaxial-creep.yaml run cases/biaxial-c
    check 'completion: the value of an option is a file' offers cases/biaxial-creep.yaml run --sample = cases/biaxial-c
else
    skip 'completion' 'no bash'
fi
finish
