#!/bin/sh
# SPDX-License-Identifier: MIT
# Machines without gnuplot or ffmpeg, or with broken ones; names and paths that want to be taken for something else.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
contact=$PWD/cases/contact-reversal.yaml
cd "$work" || exit 1
write_small_case small.yaml
write_bodies_case bodies.yaml

# ---- programs that are not there, or fail ----
mkdir none bad
with_path() {
    path=$1
    shift
    PATH=$path "$TRUNDLE" run "$@" >stdout 2>stderr </dev/null
    equals $? 0 || { cat stderr; false; }
}
check 'without gnuplot and ffmpeg it runs' with_path "$work/none" small.yaml -o alone --frames 2
check 'says that there are no curves' says stderr 'note: no curves: gnuplot is not installed'
check 'and no film' says stderr 'note: no film: ffmpeg is not installed'
check 'all else is there' equals "$(listing alone | tr '\n' ' ')" \
    'case.yaml contacts.csv disks.csv frames/00000.png frames/00001.png history.csv summary.json '
check 'with no PATH at all' env -u PATH "$TRUNDLE" run bodies.yaml -o no_path --frames 1
printf '#!/bin/sh\nexit 7\n' >bad/gnuplot
chmod +x bad/gnuplot
check 'a gnuplot that fails costs the curves only' with_path "$work/bad:/bin:/usr/bin" small.yaml -o no_curves
check 'is said' says stderr 'note: no curves: gnuplot failed (7)'
check 'the summary is there' test -s no_curves/summary.json
check 'so does a contact run' with_path "$work/bad:/bin:/usr/bin" "$contact" -o contact_no_curves
check 'and says so' says stderr 'note: no curves: gnuplot failed (7)'
check 'without gnuplot a contact runs too' with_path "$work/none" "$contact" -o contact_alone
check 'says that there are no curves' says stderr 'note: no curves: gnuplot is not installed'
check 'all else is there' equals "$(listing contact_alone | tr '\n' ' ')" 'case.yaml contact.csv summary.json '
check 'no part' no_parts no_curves
printf '#!/bin/sh\necho no such encoder >&2\nexit 1\n' >bad/ffmpeg
chmod +x bad/ffmpeg
PATH="$work/bad:/bin:/usr/bin" "$TRUNDLE" run bodies.yaml --frames 3 -o no_film >stdout 2>stderr
check 'an ffmpeg that fails: code 3' equals $? 3
check 'in its own words' says stderr 'no such encoder'
check 'what is there is kept' says stderr 'kept in no_film'
check 'no part' no_parts no_film
check 'no film' is_silent find no_film -name 'bodies.*'

# ---- frames: 0 draws nothing: a font cache would show it ----
mkdir home
check 'without frames' env HOME="$work/home" XDG_CACHE_HOME="$work/home" PATH=none "$TRUNDLE" run bodies.yaml -o undrawn
check 'no font cache is touched' equals "$(listing home)" ''
check 'no frames/ is made' not test -e undrawn/frames

# ---- names ----
# plotted DIRECTORY, filmed DIRECTORY: a run there, with curves or a film
plotted() {
    run_gives 0 small.yaml -o "$1" && test -s "$1/summary.json" && { ! command -v gnuplot >/dev/null || test -s "$1/biaxial.svg"; }
}
filmed() {
    run_gives 0 bodies.yaml --frames 1 -o "$1" --force && test -s "$1/frames/00000.png" &&
        { ! command -v ffmpeg >/dev/null || { test -s "$1/bodies.mp4" && test -s "$1/bodies.gif"; }; }
}
named() { plotted "$1" && filmed "$1"; }
for name in 'with space' "it's" 'say "x"' 'a:b' '-dash' 'back\slash' 'per%cent%s' 'dollar$(date)' 'a;b&c|d' 'new
line' 'µ_φ' 'slash/' 'a/b/c/d' './././e' "$work/absolute" "$(printf '%0200d' 0)"; do
    case $name in -*) directory="./$name" ;; *) directory=$name ;; esac
    check "results in $(printf %s "$name" | tr '\n' '?' | cut -c1-30)" named "$directory"
done
check 'a name that begins with a dash' run_gives 0 bodies.yaml -o -dash2
check 'is a directory' test -e ./-dash2/summary.json
deep=deep
while [ ${#deep} -lt 3500 ]; do deep=$deep/$(printf '%0100d' 0); done
check 'a path of 3500 characters' named "$deep"

# The name of the case becomes the title of the film.
titled() {
    cp bodies.yaml "$1.yaml" && run_gives 0 "$1.yaml" --frames 1 -o titled --force && test -s titled/frames/00000.png
}
for name in 'two words' "it's" 'say "x"' '_' 'a_' '__' 'per%cent%s' 'µ_φ' '..' "$(printf '%0250d' 0)" "$(printf 'b\377\376')" \
    "$(printf '\342\202')" "$(printf '\200%.0s' $(seq 200))"; do
    check "a case called $(printf %s "$name" | LC_ALL=C tr -c 'A-Za-z0-9_. %' '?' | cut -c1-30)" titled "$name"
done
finish
