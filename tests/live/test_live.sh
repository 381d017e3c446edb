#!/bin/sh
# SPDX-License-Identifier: MIT
# The library in WebAssembly, run by node: the same bits as here, and the same messages. Without node or the compiler
# for WebAssembly: a counted skip.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/../system/tap.sh"
BUILD=${BUILD:-build/release}
wasm=$BUILD/wasm/live.wasm native=$BUILD/tests/live/native page=$PWD/src/live/page

for tool in node clang-14 wasm-ld-14 wasm-opt file:/usr/include/wasm32-wasi/stdio.h wasm-rt; do
    .ci/packages has "$tool" && continue
    skip 'the page computes what the command computes' "no $tool"
    finish
done
check 'the library builds for WebAssembly' make --no-print-directory -s "$wasm" BUILD="$BUILD"
# make test has built this one, with its own flags.
[ -x "$native" ] || make --no-print-directory -s "$native" BUILD="$BUILD" >/dev/null
in_wasm() { node tests/live/bits.mjs "$page/engine.mjs" "$wasm" "$@"; }

card() {
    "$TRUNDLE" measures -o "$work/card.csv" >/dev/null && in_wasm card "$work/card.csv" >"$work/card" || return 1
    cat "$work/card" # 42 motions by 7 definitions of rolling and 6 of sliding
    [ "$(cat "$work/card")" = '546 values of 42 motions are the same' ]
}
check 'the card of `trundle measures` has the same bits' card

# same STEPS CASE...: both ways end with the same positions, or say the same
same() {
    in_wasm "$@" >"$work/wasm" && "$native" "$@" >"$work/native" && diff "$work/wasm" "$work/native"
}
# shellcheck disable=SC2046 # no blanks in these names
check 'the cases of a few disks: the same positions after 2000 steps' same 2000 $(grep -l '^kind: bodies' cases/*.yaml)
# The others have several documents: the same message.
moved() { [ "$(grep -c '^cases.* [0-9a-f]*$' "$work/wasm")" -ge 8 ]; }
check 'and eight cases at least have moved' moved
check 'the biaxial test: the same positions after 10,000 steps' same 10000 cases/biaxial.yaml
check 'and with creep: the same positions after 2000 steps' same 2000 cases/biaxial-creep.yaml

# What "copy case.yaml" gives, run by the command's library.
copied() { mkdir -p "$work/copied/path" && node tests/live/cases.mjs "$page" "$work/copied"; }
check 'the scenes give their cases, and their addresses hold all values' copied
check 'the cases of the scenes: the same positions after 300 steps' same 300 "$work"/copied/*.yaml
none_refused() { ! grep -A3 error "$work/native"; }
check 'and none of them is refused' none_refused

cycles() {
    set --
    for rolling in wang conjugate passive; do
        for by in wang bagi-kuhn alonso-min alonso-mean; do
            laws="k_n: 1 GPa, friction: none, rolling: $rolling-spring, rolling_velocity: $by, mu_r: 1, k_r: 0.1 MPa"
            set -- "$@" "0.1,0.25,1e-4,0.03,-0.4,1234,$laws"
        done
    done
    same cycle "$@" "0.1,0.2,1e-4,0.03,0.3,10,k_n: 1 GPa, rolling: nonsense" &&
        [ "$(grep -c "^[0-9a-f]*$" "$work/wasm")" -eq 12 ]
}
check 'the closed cycle of one contact does the same work by all laws, and says the same of a wrong one' cycles
path_cases() {
    for case in "$work"/copied/path/*.yaml; do
        out=$work/out-$(basename "$case" .yaml)
        sed 's/frames: [0-9]*/frames: 0/' "$case" >"$work/case.yaml"
        "$TRUNDLE" run "$work/case.yaml" -o "$out" >/dev/null || return 1
        [ -f "$out/patch.csv" ] || continue
        in_wasm patch "$case" "$out/patch.csv" | tee -a "$work/patches"
    done
    [ "$(grep -c '^100 of 100 elements are the same$' "$work/patches")" -eq 12 ]
}
check 'the cases of one contact run, and the inside has the bits of the page' path_cases

check 'the scenes tell what closed forms say' node tests/live/scenes.mjs "$page" "$wasm"

# Messages of the reader of cases name line and column: the page's own reader of YAML must count as libyaml does.
cat >"$work/head" <<'END'
kind: bodies
time_end: 1
contact: {k_n: 1e6, mu: 0.3, rolling: none}
END
bad() {
    n=$((n + 1))
    { cat "$work/head" && printf '%b\n' "$1"; } >"$work/bad-$n.yaml"
}
n=0
bad 'disks: [{radius: 1 mm, x: 0, y: 0, colour: red}]'
bad 'disks:\n  - {radius: 1 mm, x: 0, y: 0}\n  - radius: 1 mm\n    x: 1 kg\n    y: 0'
bad 'disks:\n- radius: 1 mm\n  x: 0\n  y: 0\n  x: 1'
bad 'disks: [{radius: "1 mm + 2 s", x: 0, y: 0}]'
bad "disks: [{radius: 'x + 1', x: 'y', y: 'x'}]"
bad 'disks: [{radius: &r 1 mm, x: 0, y: 0}]'
bad 'disks: [{radius: 1 mm, x: 0, y: *r}]'
bad 'lesson:\n  title: Größe und Drall\n  question: >\n    one\n    two\n  sentnce: x\ndisks: [{radius: 1, x: 0, y: 0}]'
bad 'disks: [{radius: 1 mm, x: 0, y: 0, spin: 1/(2-2)}]'
bad 'disks: []'
bad 'disks: {radius: 1}'
bad 'gravity:\n  x: 1 m/s^2*sin(\n  y: 0\ndisks: [{radius: 1, x: 0, y: 0}]'
check 'wrong cases: the same message at the same place' same 1 "$work"/bad-*.yaml
refused() { [ "$(grep -c 'yaml:[0-9]*:[0-9]*: error: ' "$work/native")" -eq "$n" ] || { cat "$work/native"; false; }; }
check 'and each of them is refused with a place' refused

imports() {
    node -e 'const module = new WebAssembly.Module(require("fs").readFileSync(process.argv[1]));
        for (const i of WebAssembly.Module.imports(module)) console.log(i.module)' "$wasm" | sort -u >"$work/imports"
    [ "$(cat "$work/imports")" = wasi_snapshot_preview1 ]
}
check 'it imports nothing but a few functions of WASI' imports
finish
