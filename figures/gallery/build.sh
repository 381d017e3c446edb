#!/bin/sh
# SPDX-License-Identifier: MIT
# One page of demonstrations with its films and pictures beside it, and all of it as GALLERY.zip.
# usage: [GALLERY_LANG=de] figures/gallery/build.sh DEMOS GALLERY NAME...
# Run NAME of cases/NAME.yaml, or of DEMOS/cases/NAME.yaml, is in DEMOS/NAME; one that has no summary.json is left out. Its pictures for an expert are
# in DEMOS/expert/NAME, the map of slopes is DEMOS/map.json. GALLERY is replaced as a whole.
set -eu
here=$(dirname "$0")
root=$here/../..
demos=$1 gallery=$2
shift 2
part=$gallery.part
rm -rf "$part"
mkdir -p "$part/media"

# take FILE TYPE: the file becomes media/NAMETYPE, and its name the result; null if there is none
take() {
    [ -e "$1" ] || { echo null; return; }
    cp "$1" "$part/media/$name$2"
    printf '"media/%s%s"\n' "$name" "$2"
}
still_of() { # of the run: else the last picture of its film, else its curves
    for file in "$1/still.png" "$(find "$1/frames" -name '*.png' 2>/dev/null | sort | tail -n 1)" "$1/contact.png"; do
        [ ! -e "$file" ] || break
    done
    echo "$file"
}
case_of() {
    for file in "cases/$1.yaml" "$demos/cases/$1.yaml"; do
        [ ! -e "$file" ] || break
    done
    echo "$file"
}
for name in "$@"; do
    run=$demos/$name
    [ -e "$run/summary.json" ] || continue
    kind=$(jq -r .kind "$run/summary.json")
    film=$(take "$run/$kind.mp4" .mp4) gif=$(take "$run/$kind.gif" .gif) still=$(take "$(still_of "$run")" .png)
    first=$(take "$run/frames/00000.png" -first.png) expert=$(take "$demos/expert/$name/$kind.mp4" -expert.mp4)
    jq -n --arg name "$name" --rawfile yaml "$(case_of "$name")" --slurpfile summary "$run/summary.json" \
        --argjson film "$film" --argjson gif "$gif" --argjson still "$still" --argjson first "$first" --argjson expert "$expert" \
        '{name: $name, yaml: $yaml, summary: $summary[0], film: $film, gif: $gif, still: $still, first: $first, expert: $expert}'
done >"$part/demos.json"
# The words of the page are those of src/draw/words_LANG.h: W(key, "text") becomes "key": "text".
sed -n 's/^W(\([a-z_]*\), \(".*"\))$/\1 \2/p' "$root/src/draw/words_${GALLERY_LANG:-en}.h" |
    sed 's/^\([a-z_]*\) \(.*\)$/{"\1": \2}/' | jq -s add >"$part/words.json"
[ -e "$demos/map.json" ] && cp "$demos/map.json" "$part/map.json" || echo '[]' >"$part/map.json"
jq -rs --slurpfile words "$part/words.json" --slurpfile map "$part/map.json" --rawfile css "$here/page.css" --rawfile js "$here/page.js" \
    -f "$here/page.jq" "$part/demos.json" >"$part/index.html"
rm "$part/demos.json" "$part/words.json" "$part/map.json"
rm -rf "$gallery" "$gallery.zip"
mv "$part" "$gallery"
if command -v zip >/dev/null; then
    cd "$(dirname "$gallery")"
    zip -qr "$(basename "$gallery").zip" "$(basename "$gallery")"
fi
