#!/bin/sh
# SPDX-License-Identifier: MIT
# The page of make live in a headless Chromium. SHOTS=DIR keeps screenshots to look at. Without the browser, node or the
# compiler for WebAssembly: a counted skip.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/../system/tap.sh"
BUILD=${BUILD:-build/release}
for tool in chromium node clang-14 wasm-ld-14 wasm-opt file:/usr/include/wasm32-wasi/stdio.h wasm-rt; do
    .ci/packages has "$tool" && continue
    skip 'the page in a browser' "no $tool"
    finish
done
check 'the page is made' make --no-print-directory -s "$work/out/live/index.html" OUT="$work/out" BUILD="$BUILD"
small() { [ "$(wc -c <"$work/out/live/index.html")" -lt 1000000 ]; }
check 'it is smaller than 1 MB' small
alone() { ! sed "s/^const WASM = .*//" "$work/out/live/index.html" | grep -nE '(src|href)="|https?://|import '; }
check 'it is one file that loads nothing' alone

# The modules share one scope in the page: a name twice would be a mistake that the modules one by one do not have.
parses() {
    sed -n '/^<script type="module">$/,/^<\/script>$/p' "$work/out/live/index.html" | sed '1d;$d' >"$work/all.mjs" &&
        node --check "$work/all.mjs"
}
check 'no name of the modules is there twice' parses

timeout 900 node tests/live/page.mjs chromium "$work/profile" "$work/out/live/index.html" ${SHOTS:+"$SHOTS"} \
    >"$work/page" 2>"$work/page.err"
passed() {
    grep -qxF "ok $1" "$work/page" && return
    grep -F "not ok $1" "$work/page" || cat "$work/page" "$work/page.err"
    false
}
for name in 'every scene by keyboard alone' 'arrows are dragged, values typed, limits told' \
    'a link with nonsense opens the first scene and says so' 'the energy thief: one leg, one loop, by hand' \
    '400 disks: laws change while it runs, a contact is followed, the curve of before stays' \
    '400 disks: two samples side by side, three seeds one after the other' \
    '400 disks: rolling moment and creep, two by two' \
    'the sheet to print: each scene with its question, the answers on the last page' \
    '400 disks: a picture is drawn in 5.5 ms' \
    '1920 by 1080: nothing sticks out, dark and light' '1024 by 768: nothing sticks out, dark and light' \
    '390 by 844: nothing sticks out, dark and light' 'the console stays silent'; do
    check "$name" passed "$name"
done
finish
