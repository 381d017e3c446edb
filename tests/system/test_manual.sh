#!/bin/sh
# SPDX-License-Identifier: MIT
# The manual: nothing of the pages is lost, every link and every picture is there, and it fits a small window.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
pages='README.md cases/README.md figures/README.md src/README.md tests/README.md'
if ! command -v cmark-gfm >/dev/null 2>&1; then
    skip 'the manual' 'no cmark-gfm'
    finish
fi
book=$work/manual page=$work/manual/index.html
check 'it is made' figures/manual/build.sh "$TRUNDLE" "$book"
cp -R "$book" "$work/first"
check 'it is made again over the first one' figures/manual/build.sh "$TRUNDLE" "$book"
check 'with the same bytes' diff -r "$work/first" "$book"

# ---- it is whole ----
# Pages without code blocks: there # and ! mean something else.
text() { awk '/^ *```/ {code = !code; next} !code && !/^    /' "$@"; }
"$TRUNDLE" run --keys >"$work/keys.md"
# shellcheck disable=SC2086 # a list of files
text $pages "$work/keys.md" >"$work/all.md"
count() { grep -oE -- "$1" "$2" | wc -l; }
check 'as many pictures as the pages have' equals "$(count '<img ' "$page")" "$(count '!\[' "$work/all.md")"
check 'as many headings (and its own title)' \
    equals "$(count '<h[1-6][ >]' "$page")" $(($(count '^#+ ' "$work/all.md") + 1))
check 'the contents name every chapter and every part of it' \
    equals "$(count '^<li><a href="#' "$page")" "$(count '^##? ' "$work/all.md")"
check 'as many rows in tables' equals "$(count '<tr>' "$page")" \
    "$(grep '^|' "$work/all.md" | grep -cvE '^[|: -]+$')"
sed '1,/<\/style>/d' "$page" >"$work/body.html"
check 'no mark of Markdown is left' not grep -nE '^\| |\]\(|^#' "$work/body.html"

# ---- it leads somewhere ----
links() { grep -oE '(src|href)="[^"]*"' "$1" | sed 's/^[a-z]*="//; s/"$//' | sort -u; }
resolve() { # each link leads to a part of the book, or to a file beside it
    [ "$(links "$1/index.html" | wc -l)" -ge 100 ] || { echo 'few links'; return 1; }
    links "$1/index.html" | while read -r link; do
        case $link in
        \#*) grep -q " id=\"${link#\#}\"" "$1/index.html" || { echo "no part $link"; exit 1; } ;;
        *..*) echo "outside of the book: $link"; exit 1 ;;
        http:* | https:*) ;;
        *) test -s "$1/${link%%#*}" || { echo "no file $link"; exit 1; } ;;
        esac
    done
}
check 'every link' resolve "$book"
check 'links between pages stay in the book' not grep -q 'href="[^"]*README.md' "$page"
check 'no two parts have one name' is_silent sh -c "grep -oE ' id=\"[^\"]*\"' '$page' | sort | uniq -d"
breaks() { # FILE SCRIPT: after this change of a copy of the book the links must fail
    cp -R "$book" "$work/broken" && sed -i "$2" "$work/broken/$1"
    resolve "$work/broken"
    broken=$?
    rm -r "$work/broken"
    [ "$broken" -ne 0 ]
}
check 'a part without its name is noticed' breaks index.html 's/ id="tests-errata-of-the-sources"//'
check 'an empty picture is noticed' breaks figures/bench.png '1,$d'

# ---- it can be read ----
if command -v xmllint >/dev/null 2>&1; then
    check 'it is well-formed' xmllint --noout "$page"
else
    skip 'it is well-formed' 'no xmllint'
fi
# width SIZE: how wide the book is in a window of this size. (Chromium makes windows this small for screenshots alone.)
width() {
    sed 's|</body>|<script>const tell = () => console.log("width", document.documentElement.scrollWidth); tell();\
        addEventListener("resize", tell); addEventListener("load", tell)</script></body>|' \
        "$page" >"$work/measured.html"
    mv "$work/measured.html" "$book"
    timeout 60 chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --user-data-dir="$work/browser" \
        --window-size="$1" --enable-logging=stderr --screenshot="$work/shot.png" "file://$book/measured.html" 2>&1 |
        sed -n 's|.*CONSOLE.*"width \([0-9]*\)".*|\1|p' | tail -n 1
}
fits() { equals "$(width "$1,900")" "$1"; }
if command -v chromium >/dev/null 2>&1; then
    check 'it fits a window of 390 pixels' fits 390
    check 'it fits a window of 1440 pixels' fits 1440
else
    skip 'it fits a window of 390 pixels' 'no chromium'
fi
finish
