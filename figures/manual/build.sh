#!/bin/sh
# SPDX-License-Identifier: MIT
# One book of all pages, with pictures and a contents list: MANUAL/index.html. Needs cmark-gfm, and no network.
# usage: figures/manual/build.sh TRUNDLE MANUAL
# MANUAL is replaced as a whole. Pictures, and files that the pages link to, keep their places of the repository in it.
set -eu
here=$(dirname "$0")
trundle=$1 manual=$2
part=$manual.part
pages='README.md cases/README.md keys figures/README.md src/README.md tests/README.md'
rm -rf "$part"
mkdir -p "$part"

markdown() { # PAGE: its text; the keys come from the program
    if [ "$1" = keys ]; then "$trundle" run --keys; else cat "$1"; fi
}
for page in $pages; do
    markdown "$page" >"$part/page.md"
    cmark-gfm -t html -e table -e strikethrough "$part/page.md" >"$part/page.html"
    awk -v page="$page" -v pages="$pages" -v contents="$part/contents" -v files="$part/files" -f "$here/chapter.awk" \
        "$part/page.html" >>"$part/chapters"
done
sort -u "$part/files" | while IFS= read -r file; do
    mkdir -p "$part/$(dirname "$file")"
    cp -R "${file%/}" "$part/$(dirname "$file")/"
done
{
    cat <<'HEAD'
<!DOCTYPE html>
<html lang="en" xmlns="http://www.w3.org/1999/xhtml">
<head>
<meta charset="utf-8" />
<meta name="viewport" content="width=device-width, initial-scale=1" />
<meta name="color-scheme" content="light dark" />
<title>trundle: the manual</title>
<style>
HEAD
    cat "$here/../gallery/page.css" "$here/book.css"
    printf '</style>\n</head>\n<body>\n<header>\n<h1>trundle: the manual</h1>\n<p>%s</p>\n</header>\n' \
        "$("$trundle" --version | sed 's/^trundle/Version/')"
    printf '<div class="book">\n<div id="contents" role="navigation" aria-label="Contents">\n<p>Contents</p>\n<ol>\n'
    cat "$part/contents"
    printf '</ol>\n</div>\n<main>\n'
    cat "$part/chapters"
    printf '</main>\n</div>\n<a class="up" href="#contents">Contents</a>\n</body>\n</html>\n'
} >"$part/index.html"
rm "$part/page.md" "$part/page.html" "$part/contents" "$part/files" "$part/chapters"
rm -rf "$manual"
mv "$part" "$manual"
