#!/bin/sh
# SPDX-License-Identifier: MIT
# One file from the parts of the page: styles, words, modules one behind the other, the library as base64. The modules
# share one scope there, so names at their top level differ; `import` and `export` are for tests that run them one by one.
# usage: build.sh LIVE.wasm OUT.html
set -eu
here=$(dirname "$0")
page=$here/page
# Each only needs those before it.
modules='engine draw words gauge rim wheels pair coin throw carpet who thief slope gears inside sample show sheet tasks app'
# Lines of page.html that are only @NAME@ are replaced.
{
    while IFS= read -r line; do
        case $line in
        @style@) cat "$page/page.css" ;;
        @words@) printf 'const WORDS = ' && cat "$page/words.en.json" ;;
        @wasm@) printf "const WASM = '" && base64 -w 0 "$1" && printf "';\n" ;;
        @modules@)
            for module in $modules; do
                grep -v '^import ' "$page/$module.mjs" | sed 's/^export //'
            done
            ;;
        *) printf '%s\n' "$line" ;;
        esac
    done <"$page/page.html"
} >"$2.part"
mv "$2.part" "$2"
