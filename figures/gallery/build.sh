#!/bin/sh
# SPDX-License-Identifier: MIT
# One page of demonstrations with its films and pictures beside it, and all of it as GALLERY.zip.
# usage: figures/gallery/build.sh DEMOS GALLERY NAME...
# Run NAME of cases/NAME.yaml is in DEMOS/NAME; one that has no summary.json is left out. GALLERY is replaced as a
# whole.
set -eu
here=$(dirname "$0")
demos=$1 gallery=$2
shift 2
part=$gallery.part
rm -rf "$part"
mkdir -p "$part/media"

# take FILE TYPE: the file becomes media/NAME.TYPE, and its name the result; null if there is none
take() {
    [ -e "$1" ] || { echo null; return; }
    cp "$1" "$part/media/$name.$2"
    printf '"media/%s.%s"\n' "$name" "$2"
}
still_of() { # of the run: else the last picture of its film, else its curves
    for file in "$1/still.png" "$(find "$1/frames" -name '*.png' 2>/dev/null | sort | tail -n 1)" "$1/contact.png"; do
        [ ! -e "$file" ] || break
    done
    echo "$file"
}
for name in "$@"; do
    run=$demos/$name
    [ -e "$run/summary.json" ] || continue
    kind=$(jq -r .kind "$run/summary.json")
    film=$(take "$run/$kind.mp4" mp4) gif=$(take "$run/$kind.gif" gif) still=$(take "$(still_of "$run")" png)
    jq -n --arg name "$name" --rawfile yaml "cases/$name.yaml" --slurpfile summary "$run/summary.json" \
        --argjson film "$film" --argjson gif "$gif" --argjson still "$still" \
        '{name: $name, yaml: $yaml, summary: $summary[0], film: $film, gif: $gif, still: $still}'
done >"$part/demos.json"
jq -rs --rawfile css "$here/page.css" --rawfile js "$here/page.js" -f "$here/page.jq" "$part/demos.json" >"$part/index.html"
rm "$part/demos.json"
rm -rf "$gallery" "$gallery.zip"
mv "$part" "$gallery"
if command -v zip >/dev/null; then
    cd "$(dirname "$gallery")"
    zip -qr "$(basename "$gallery").zip" "$(basename "$gallery")"
fi
