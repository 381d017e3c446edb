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
nasty='<i>a & b</i> "c" '"'d' "'</h3><script>throw 1</script> $(x) `y` \1 ]]> ü V_s F_< _'
told='<i>a & b</i> "c" '"'d' "'</h3><script>throw 1</script> $(x) `y` \1 ]]> ü Vs F< _' # as read: _ lowers the next
printf '# %s\n' "$nasty" >cases/bare.yaml
echo '{"kind": "bodies", "left_out": []}' >demos/bare/summary.json
jq --arg t "$nasty" '. + {left_out: [$t], lesson: {title: $t, equation: $t, sentence: $t, question: $t, answer: $t}, checks: [
    {lane: $t, what: "slip-ends", of: "wall0-4", measured: 0.113099996, exact: 0.1133, error: -0.00019999, tolerance: 0.001, unit: "s", ok: true},
    {lane: "", what: "power", of: "2", measured: -1234567.8, exact: 1.25e-7, error: 0, tolerance: 0.3, unit: "1", ok: true},
    {lane: "", what: $t, of: $t, measured: null, exact: 10, error: null, tolerance: 1, unit: $t, ok: false}]}' \
    out/demos/pure-rolling/summary.json >demos/pure-rolling/summary.json
for name in slip-to-roll contact-reversal; do # two without a lesson
    jq 'del(.lesson, .checks)' "out/demos/$name/summary.json" >"demos/$name/summary.json"
done
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
    for part in h3 'p[@class="equation"]' 'p[@class="sentence"]' 'details[@class="question"]/summary' \
        'details[@class="question"]/p' '/tbody/tr[1]/th/b'; do
        check "$part as it is" tells "$rolling/$part" "$told"
    done
    check 'in the contents too' tells '//nav//a[@href="#pure-rolling"]/span' "$told"
    check 'in an attribute' tells "$rolling/video/@aria-label" "Film: $nasty"
    check 'nothing became a tag' counts '//i' 0
    check 'no script either' counts '//script' 1
    check 'the case as it is' tells '//pre[@id="yaml-bare"]' "$(cat cases/bare.yaml)"
    cells() { tells "normalize-space($rolling//tbody/tr[$1])" "$2"; }
    check 'a check, rounded' cells 1 "$told slip ends wall 0 and disk 4✓ agrees0.1131 s0.1133 s−0.0002 s0.001 s"
    check 'large and small numbers' cells 2 'power disk 2✓ agrees−12346001.25e−700.3'
    check 'an event that was not seen' cells 3 "$nasty $nasty✗ differsnone10 ${nasty}none1 $nasty"
    check 'the head counts them' tells '//header/p[@class="bad"]' '✗ 1 of 3 numbers measured in them out of the tolerance.'
    check 'groups' tells 'normalize-space(//nav)' "Motions $told Dynamics slip-to-roll bare Inside a contact contact-reversal"
    check 'a film for each of the bodies' counts '//video[@poster]' 2
    check 'curves for the contact' counts '//article[@id="contact-reversal"]/img[@alt]' 1
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

# ---- in a browser ----
if ! command -v chromium >/dev/null; then
    skip 'in a browser' 'no chromium'
    finish
fi
browser=''
trap '[ -z "$browser" ] || kill -KILL "$browser"; cleanup' EXIT
# A script beside the page's own presses keys and tells the console what happens.
cat >script <<'EOT'
<script>
const wait = (ms) => new Promise((done) => setTimeout(done, ms));
const soon = async (holds) => {
    for (let k = 0; k < 100 && !holds(); k++) await wait(50);
    return holds();
};
const note = (text) => console.log("seen: " + text);
const press = (key, target = document.activeElement) => {
    const event = new KeyboardEvent("keydown", {key, bubbles: true, cancelable: true});
    target.dispatchEvent(event);
    return event.defaultPrevented;
};
const at = () => document.activeElement.id + " " + Math.round(document.activeElement.getBoundingClientRect().top);
addEventListener("load", async () => {
    const films = [...document.querySelectorAll("video")], film = films[0];
    await soon(() => films.every((f) => f.readyState >= 1));
    note("pictures " + [...document.images].map((i) => i.naturalWidth > 0));
    note("films " + films.map((f) => f.readyState >= 1 && f.videoWidth === 1280 && f.muted && f.loop));
    note("wants no motion " + matchMedia("(prefers-reduced-motion: reduce)").matches);
    note("space above the first taken " + press(" "));
    for (const key of ["n", "ArrowRight", "p", "ArrowLeft", "ArrowLeft", "n", "n", "n", "n", "n"]) {
        press(key);
        note(key + " " + at());
    }
    note("space without a film taken " + press(" "));
    for (let k = 0; k < 9; k++) press("p");
    await wait(1000);
    note("runs when seen " + !film.paused);
    const before = film.paused;
    note("space taken " + press(" "));
    note("space turns it " + (await soon(() => film.paused !== before)));
    press(" ");
    note("and back " + (await soon(() => film.paused === before)));
    scrollBy(0, film.getBoundingClientRect().top + 0.7 * film.offsetHeight);
    note("stops when a third is seen " + (await soon(() => film.paused)));
    film.focus();
    note("film with the focus seeks itself " + !press("ArrowRight") + ", " + !press(" ") + ", n goes on " + press("n"));
    note("stops when gone " + (await soon(() => film.paused)));
    note("not by Tab " + [...document.querySelectorAll("a, button, summary, video, pre[id^=yaml], .scroll")].filter((e) => e.tabIndex < 0).length);
    const button = document.querySelector("button.copy"), text = document.getElementById(button.dataset.of);
    text.parentNode.open = true;
    button.click();
    const said = button.parentNode.querySelector("[role=status]"), same = () => getSelection().toString().trim() === text.textContent.trim();
    note("copy " + (await soon(() => said.textContent === "copied" || (/^selected/.test(said.textContent) && same()))));
    note("end");
});
</script>
EOT
sed -e '/<\/body>/{r script' -e 'd}' moved/index.html >moved/test.html && echo '</body></html>' >>moved/test.html
browse() { # FLAGS...: what it tells, into `seen`. The port, of which nothing is asked, keeps it open.
    chromium --headless --no-sandbox --disable-gpu --user-data-dir="$work/profile$#" --enable-logging=stderr \
        --remote-debugging-port=0 --window-size=1280,800 "$@" "file://$work/moved/test.html" >/dev/null 2>log &
    browser=$!
    for _ in $(seq 300); do
        grep -q '"seen: end"' log && break
        sleep 0.1
    done
    kill -KILL "$browser" # asked politely, it may take for ever
    wait "$browser"
    browser=''
    sed -n 's/.*CONSOLE.*"seen: \(.*\)", source: .*/\1/p' log >seen
    test -s seen || { cat log; false; }
}
check 'a browser opens it' browse --force-prefers-reduced-motion
complaints() { grep CONSOLE log | grep -v '"seen: '; }
check 'without a complaint' is_silent complaints
cat >wanted <<'EOT'
pictures true,true,true,true
films true,true
wants no motion true
space above the first taken false
n pure-rolling 0
ArrowRight slip-to-roll 0
p pure-rolling 0
ArrowLeft pure-rolling 0
ArrowLeft pure-rolling 0
n slip-to-roll 0
n bare 0
n contact-reversal 0
n contact-reversal 0
n contact-reversal 0
space without a film taken false
runs when seen false
space taken true
space turns it true
and back true
stops when a third is seen true
film with the focus seeks itself true, true, n goes on true
stops when gone true
not by Tab 0
copy true
end
EOT
check 'pictures, films, keys' diff wanted seen
check 'and for whom motion is welcome' browse
sed -i 's/^wants no motion true/wants no motion false/; s/^runs when seen false/runs when seen true/' wanted
check 'the film runs when it is seen' diff wanted seen
finish
