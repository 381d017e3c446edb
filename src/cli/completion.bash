# SPDX-License-Identifier: MIT
# Completion of trundle for bash. It asks the program itself: --help names commands and options, so nothing goes stale.
# To try it: source src/cli/completion.bash
# shellcheck shell=bash

# Lines on standard input that begin with the word so far. Words that end in = get no blank behind them.
_trundle_offer() {
    local line
    while IFS= read -r line; do
        [[ $line == "$1"* ]] && COMPREPLY+=("$line")
    done
    [[ ${#COMPREPLY[@]} -eq 1 && ${COMPREPLY[0]} == *= ]] && compopt -o nospace 2>/dev/null
}

# Files whose name matches a pattern, and directories.
_trundle_files() {
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -f -X "!$2" -- "$1"; compgen -d -- "$1")
}

_trundle() {
    local program=${COMP_WORDS[0]/#\~/$HOME} command=${COMP_WORDS[1]-} word=${COMP_WORDS[COMP_CWORD]}
    local before=${COMP_WORDS[COMP_CWORD - 1]}
    COMPREPLY=()
    if [[ $COMP_CWORD -eq 1 ]]; then
        _trundle_offer "$word" < <("$program" --help | sed -n 's/^  \([a-z]*\)  *[a-z].*/\1/p' | grep -vx trundle
            printf '%s\n' --help --version)
        return
    fi
    [[ $before == = || $word == = ]] && { # the value of an option: bash takes = for a word
        compopt -o filenames 2>/dev/null
        mapfile -t COMPREPLY < <(compgen -f -- "${word#=}")
        return
    }
    case $command:$word in
    *:-*)
        _trundle_offer "$word" < <("$program" "$command" --help |
            sed -n 's/^ \{2,6\}\(-.,\)\{0,1\} *\(--[a-z-]*=\{0,1\}\).*/\2/p')
        ;;
    run:*)
        if [[ " ${COMP_WORDS[*]} " == *' --keys '* ]]; then
            _trundle_offer "$word" < <("$program" run --keys | sed -n 's/^## `kind: \([a-z]*\)`$/\1/p')
        else
            _trundle_files "$word" '*.yaml'
        fi
        ;;
    sweep:* | bench:* | converge:*) _trundle_files "$word" '*.yaml' ;;
    measures:* | identify:*) _trundle_files "$word" '*.csv' ;;
    replay:* | convert:*) _trundle_files "$word" '*/' ;;
    laws:*) _trundle_offer "$word" < <("$program" laws | sed -n 's/^  \([^ ]*\) .*/\1/p' | sort -u) ;;
    verify:*) _trundle_offer "$word" < <("$program" verify --list | awk '{print $1; print $2}' | sort -u) ;;
    esac
}
complete -F _trundle trundle
