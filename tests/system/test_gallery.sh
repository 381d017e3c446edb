#!/bin/sh
# SPDX-License-Identifier: MIT
# The demonstrations and their page: what make runs again and what not, that all text arrives as it is and every link
# leads somewhere, and, where chromium is installed, that the page works in a browser: pictures, films, keys.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
repo=$PWD
cd "$work" || exit 1
if ! command -v jq >/dev/null; then
    skip 'the gallery' 'no jq'
    finish
fi
unset MAKEFLAGS MAKELEVEL

# ---- make ----
demos='contact-reversal pure-rolling slip-to-roll'
made() { make -C "$repo" --no-print-directory TRUNDLE="$TRUNDLE" OUT="$work/out" "$@"; }
fails_but_goes_on() {
    mkdir -p out/demos
    made -k run-demos DEMOS="$demos" DEMO_FLAGS='--frames 4' && return 1 # frames are not for a contact
    equals "$(cd out/demos && ls ./*.done | tr '\n' ' ')" './pure-rolling.done ./slip-to-roll.done '
}
check 'a case that fails keeps no other away, and is told' fails_but_goes_on
check 'it is tried again' made run-demos DEMOS="$demos"
check 'then there is nothing to do' made -q run-demos DEMOS="$demos"
runs() { made -n run-demos DEMOS="$demos" "$@" | grep -c ' run '; }
check 'a case that changed runs alone' equals "$(runs -W cases/slip-to-roll.yaml)" 1
check 'a new program runs all' equals "$(runs -W "$TRUNDLE")" 3
check 'the page of them' made "$work/out/gallery/index.html" DEMOS="$demos"
check 'is there' test -s out/gallery/index.html
check 'and made once' made -q "$work/out/gallery/index.html" DEMOS="$demos"

check 'each case of the page has numbers that it is checked by' equals \
    "$(grep -lE '^kind: (bodies|contact|patch)' "$repo"/cases/*.yaml | xargs grep -L '^checks:')" ''

# ---- a page of these runs with lessons that want to be taken for HTML, and of a run that left nothing ----
cp -r "$repo/cases" . && cp -r out/demos . && mkdir demos/bare
# shellcheck disable=SC2016 # not for the shell
nasty='<i>a & b</i> "c" '"'d' "'</h3><script>throw 1</script> $(x) `y` \1 ]]> ü V_s F_< R_eq _'
told='<i>a & b</i> "c" '"'d' "'</h3><script>throw 1</script> $(x) `y` \1 ]]> ü Vs F< Req _' # as read: _ lowers what follows
printf '# %s\n' "$nasty" >cases/bare.yaml
echo '{"kind": "bodies", "left_out": []}' >demos/bare/summary.json
jq --arg t "$nasty" '. + {left_out: [$t], lesson: {title: $t, equation: $t, sentence: $t, question: $t, answer: $t, choices: [$t, "b", "c"], right: 2}, checks: [
    {lane: $t, what: "slip-ends", of: "wall0-4", measured: 0.113099996, exact: 0.1133, error: -0.00019999, tolerance: 0.001, unit: "s", ok: true},
    {lane: "", what: "power", of: "2", measured: -1234567.8, exact: 1.25e-7, error: 0, tolerance: 0.3, unit: "1", ok: true},
    {lane: "", what: "sliding-velocity", of: "0-1", measured: 8.673600000000001e-19, exact: 0, error: 8.6736e-19, tolerance: 1e-12, unit: "m/s", ok: true},
    {lane: "", what: "power-lost", of: "0-1", measured: 3, exact: 3, error: 0, tolerance: 0.1, unit: "N/s", ok: true},
    {lane: "", what: $t, of: $t, measured: null, exact: 10, error: null, tolerance: 1, unit: $t, ok: false}]}' \
    out/demos/pure-rolling/summary.json >demos/pure-rolling/summary.json
for name in slip-to-roll contact-reversal; do # two without a lesson
    jq 'del(.lesson, .checks)' "out/demos/$name/summary.json" >"demos/$name/summary.json"
done
mkdir -p demos/expert/pure-rolling && cp demos/slip-to-roll/bodies.mp4 demos/expert/pure-rolling
# shellcheck disable=SC2086 # a list of names
check 'a page with texts like tags' "$repo/figures/gallery/build.sh" demos page bare $demos missing

page=page/index.html
resolves() { # every link of the page leads to a file beside it or to a part of it
    links=$(grep -oE '(src|href|poster)="[^"]*"' "$1/index.html" | sed 's/^[a-z]*="//; s/"$//' | sort -u)
    [ "$(echo "$links" | wc -l)" -ge 11 ] || { echo "few links: $links"; return 1; }
    for link in $links; do
        case $link in
        \#*) grep -q " id=\"${link#\#}\"" "$1/index.html" || { echo "no part $link"; return 1; } ;;
        *) test -s "$1/$link" || { echo "no file $link"; return 1; } ;;
        esac
    done
}
check 'every link leads somewhere' resolves page
check 'nothing comes from the network' is_silent grep -nE '(src|href|poster)="([a-z]+:|//)|url\(|@import|fetch\(|<link' $page
if command -v xmllint >/dev/null; then
    check 'it is well formed' xmllint --noout $page
    tells() { equals "$(xmllint --xpath "string($1)" $page)" "$2"; }
    counts() { equals "$(xmllint --xpath "count($1)" $page)" "$2"; }
    rolling='//article[@id="pure-rolling"]'
    for part in h3 '/p[@class="equation unseen"]' '/p[@class="sentence"]' 'p[@class="question"]' 'ol/li[1]/button' \
        'div[@class="revealed"]/p[@class="answer"]' '/tbody/tr[1]/th/b'; do
        check "$part as it is" tells "$rolling/$part" "$told"
    done
    check 'in the contents too' tells '//nav//a[@href="#pure-rolling"]/span' "$told"
    check 'in an attribute' tells "$rolling//video/@aria-label" "Film: $nasty"
    check 'nothing became a tag' counts '//i' 0
    check 'no script either' counts '//script' 1
    check 'the case as it is' tells '//pre[@id="yaml-bare"]' "$(cat cases/bare.yaml)"
    cells() { tells "normalize-space($rolling//tbody/tr[$1])" "$2"; }
    check 'a check, rounded' cells 1 "$told slip ends wall 0 and disk 4✓ agrees0.1131 s0.1133 s−0.0002 s0.001 s"
    check 'large and small numbers' cells 2 'power disk 2✓ agrees−12346001.25 · 10⁻⁷00.3'
    check 'what is rounding is 0' cells 3 'sliding velocity disks 0 and 1✓ agrees0 m/s0 m/s0 m/s1 · 10⁻¹² m/s'
    check 'a power is a power in all of its row' cells 4 'power lost disks 0 and 1✓ agrees3 W/m3 W/m0 W/m0.1 W/m'
    check 'an event that was not seen' cells 5 "$nasty $nasty✗ does not agreenone10 ${nasty}none1 $nasty"
    check 'the head counts them' tells '//header/p[@class="bad"]' '✗ 1 of 5 numbers measured in them are out of the tolerance.'
    check 'what happens is told to who cannot see it' tells "$rolling//p[@id=\"told-pure-rolling\"]" "What happens: $told"
    check 'and the film says where' tells "$rolling//video/@aria-describedby" told-pure-rolling
    check 'answers stand on a page of their own' tells 'normalize-space(//section[@class="answers"]/p[1])' "$told 2. $told"
    check 'groups' tells 'normalize-space(//nav)' "Motions $told Dynamics slip-to-roll bare Inside a contact contact-reversal"
    check 'a film for each of the bodies' counts '//video[@poster]' 2
    check 'curves for the contact' counts '//article[@id="contact-reversal"]//img[@class="picture"]' 1
else
    skip 'what the page tells' 'no xmllint'
fi
if command -v zip >/dev/null; then
    check 'the archive holds the same' equals "$(zip -sf page.zip | sed -n 's|^ *page/\(..*[^/]\)$|\1|p' | sort)" "$(listing page)"
else
    skip 'the archive holds the same' 'no zip'
fi
mkdir 'else where' && mv page 'else where/page'
check 'it can be moved' resolves 'else where/page'
check 'and made again, smaller' "$repo/figures/gallery/build.sh" demos page slip-to-roll
check 'without what is gone' is_silent find page -name 'pure*'
mv 'else where/page' moved

# ---- in German, with a chooser of laws and a map ----
german() {
    cp -r demos/pure-rolling demos/incline && cp -r demos/pure-rolling demos/incline-star-torque &&
        echo '[{"mu_r": 0.1, "mu": 0.3, "rolls": 0.1, "slips": 0.7}]' >demos/map.json && cp cases/bare.yaml cases/incline-star-torque.yaml &&
        GALLERY_LANG=de "$repo/figures/gallery/build.sh" demos german incline incline-star-torque slip-to-roll contact-reversal
}
check 'a page in German' german
check 'is in German' says german/index.html '<html lang="de">'
check 'with its words' says german/index.html 'Vorführungen'
words_of() { sed -n 's/^W(\([a-z_]*\), \(".*"\))$/\1/p' "$1" | sort; }
words_of "$repo/src/draw/words_en.h" >en
words_of "$repo/src/draw/words_de.h" >de
check 'no language lacks a word' diff en de
check 'nor has a line that the page cannot read' equals "$(grep -c '^W(' "$repo/src/draw/words_de.h")" "$(wc -l <de)"
mkdir words && cp -r "$repo/figures" "$repo/src" words && sed -i '/page_reveal/d' words/src/draw/words_de.h
missing_word() { GALLERY_LANG=de words/figures/gallery/build.sh demos lacking slip-to-roll && return 1; says "$work/said" 'no word for page_reveal'; }
check 'a missing word is an error' missing_word
if command -v xmllint >/dev/null; then
    check 'the laws of slopes are one demonstration' equals "$(xmllint --xpath 'count(//article)' german/index.html)" 3
    check 'with a chooser' equals "$(xmllint --xpath 'count(//article[@id="incline"]//option)' german/index.html)" 2
    # tan alpha = 0.7 at mu_r = 0.1 of mu = 0.3: 300 px are 1 up from 330, 520 px are mu along from 60
    check 'and a map with the points where they are' equals \
        "$(xmllint --xpath 'concat(//circle[@class="slips"]/@cx, " ", //circle[@class="slips"]/@cy, " ", //circle[@class="rolls"]/@cy)' german/index.html)" '233 120 300'
fi

# ---- in a browser, with the keys of a presenter's clicker and of a keyboard ----
if ! command -v chromium >/dev/null || ! command -v node >/dev/null; then
    skip 'in a browser' 'no chromium, or no node'
    finish
fi
drive() { # WIDTH HEIGHT PAGE [FLAGS...] <COMMANDS: what it tells, into `seen`
    width=$1 height=$2 url=$3
    shift 3
    timeout 120 node "$repo/tests/system/browser.js" "$work/profile" "$width" "$height" "file://$work/$url" "$@" >seen 2>log || { cat log seen; false; }
}
at='document.activeElement.id + " " + Math.round(document.activeElement.getBoundingClientRect().top)'
film='document.querySelector("#pure-rolling video")'
covered='getComputedStyle(document.querySelector("#pure-rolling .cover")).display'
hidden='[...document.querySelectorAll("#pure-rolling .revealed")].every(e => e.hidden)'
cat >commands <<EOT
eval [...document.images].map(i => i.complete && i.naturalWidth > 0).every(Boolean)
until [...document.querySelectorAll("video")].every(f => f.readyState >= 1 && f.videoWidth === 1280 && f.muted && f.loop)
eval [...document.querySelectorAll("video")].every(f => f.paused && f.currentTime === 0)
key PageDown
eval $at
eval $film.paused + " " + $covered + " " + $hidden
key Space
until !$film.paused
eval $covered
key Space
until $film.paused
key 3
until !$film.paused
eval $covered + " " + $hidden
eval document.querySelector("#pure-rolling .verdict").textContent
eval [...document.querySelectorAll("#pure-rolling .choices button")].map(b => b.className)
key 2
eval document.querySelector("#pure-rolling .verdict").textContent
eval $film.src.split("/").pop()
key e
eval $film.src.split("/").pop()
until !$film.paused
key E
eval $film.src.split("/").pop()
key PageDown
eval $at
until $film.paused
key PageUp
eval $at
key PageUp
eval $at
key n
key n
key n
eval $at
key n
key n
eval $at
key ?
eval document.getElementById("keys").open
key ?
eval document.getElementById("keys").open
key p
key p
eval $at
key f
until document.fullscreenElement !== null
eval getComputedStyle(document.querySelector("nav")).display + " " + [...document.querySelectorAll("article")].filter(a => a.offsetHeight > 0).map(a => a.id)
key PageUp
eval [...document.querySelectorAll("article")].filter(a => a.offsetHeight > 0).map(a => a.id)
key f
until document.fullscreenElement === null
eval getComputedStyle(document.querySelector("nav")).display
eval [...document.querySelectorAll("a, button, summary, pre[id^=yaml], .scroll, input")].filter(e => e.tabIndex < 0).length
EOT
cat >wanted <<'EOT'
true
true
true
pure-rolling 0
true flex true
true
flex
true
true
none false
Not this one; the right one is: b
,right,wrong
Right.
pure-rolling.mp4
pure-rolling-expert.mp4
true
pure-rolling.mp4
slip-to-roll 0
true
pure-rolling 0
pure-rolling 0
contact-reversal 0
contact-reversal 0
true
false
slip-to-roll 0
true
none slip-to-roll
pure-rolling
true
block
0
EOT
check 'a browser opens it and takes the keys' drive 1280 800 moved/index.html <commands
check 'films wait under their question, covered; pages turn; answers reveal; full screen' diff wanted seen
cat >commands <<'EOT'
key n
eval [...document.querySelectorAll("#incline .variant")].map(v => v.hidden)
eval document.querySelector("#incline select").focus()
key ArrowDown
until document.querySelectorAll("#incline .variant")[0].hidden
eval [...document.querySelectorAll("#incline .variant")].map(v => v.hidden) + " " + document.activeElement.tagName
eval document.querySelector("#incline .map").offsetHeight
eval document.activeElement.blur()
key r
eval document.querySelector("#incline .map").offsetHeight > 200
EOT
laws() { drive 1280 800 german/index.html <commands && equals "$(cat seen)" 'false,true
undefined
true
true,false SELECT
0
undefined
true'; }
check 'the chooser shows one law at a time, and the map is there when all is revealed' laws
key_runs() { # MOTION FLAGS: whether R makes the film run
    printf 'key n\nkey r\neval new Promise(done => setTimeout(() => done(%s.paused), 1000))\n' "$film" | drive 1280 800 moved/index.html ${1:+"$1"} && says seen "$2"
}
check 'R reveals and runs' key_runs '' false
check 'but not for whom wants no motion' key_runs --force-prefers-reduced-motion true
narrow() { # no wider than the window, at projector and phone
    for size in '1920 1080' '1024 768' '390 844'; do
        # shellcheck disable=SC2086 # two numbers
        printf 'key n\neval document.documentElement.scrollWidth <= innerWidth\nkey 2\neval document.documentElement.scrollWidth <= innerWidth\n' | drive $size moved/index.html &&
            equals "$(cat seen)" 'true
true' || return 1
    done
}
check 'nothing is wider than the window' narrow
# WCAG: 4.5 between text and ground, light and dark
cat >contrast <<'EOT'
eval (() => { const lum = c => { const [r, g, b] = c.match(/[\d.]+/g).map(v => v / 255).map(v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4); return 0.2126 * r + 0.7152 * g + 0.0722 * b; }; const ground = e => { for (; e; e = e.parentElement) { const c = getComputedStyle(e).backgroundColor; if (!/, 0\)$/.test(c)) return c; } return getComputedStyle(document.documentElement).backgroundColor; }; return [...document.querySelectorAll("h1, h2, h3, p, a, button, td, th, caption, code, summary, span, kbd, dd")].filter(e => e.offsetHeight > 0 && e.textContent.trim()).filter(e => { const p = lum(getComputedStyle(e).color), q = lum(ground(e)); return (Math.max(p, q) + 0.05) / (Math.min(p, q) + 0.05) < 4.5; }).map(e => e.tagName + " " + e.className + " " + e.textContent.slice(0, 20)).join("; "); })()
EOT
readable() { drive 1280 800 moved/index.html "$@" <contrast && equals "$(cat seen)" ''; }
check 'text is read on its ground' readable
check 'in the dark too' readable --force-dark-mode
sheets() {
    printf 'pdf %s\n' "$work/page.pdf" | drive 1280 800 moved/index.html && equals "$(grep -ac '/Type */Page\>' page.pdf)" 5
}
check 'prints a sheet for each of four demonstrations, and one with the answers' sheets
finish
