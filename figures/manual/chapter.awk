# SPDX-License-Identifier: MIT
# One page, as cmark-gfm makes it, to a chapter of the book: headings get an id and go one level down, links between
# pages become links inside the book, tables may be wider than the window.
# -v page= its name; pages= the names of all; contents= gets lines of the contents, files= the names of files to copy

function chapter_of(name) {
    if (name == "README.md") return "trundle"
    sub(/\/README\.md$/, "", name)
    return name
}

# The anchor that GitHub gives a heading: small letters, no signs, - for blanks, and a number if there was one before.
function anchor(text) {
    gsub(/<[^>]*>/, "", text)
    gsub(/&[a-z]*;/, "", text)
    text = tolower(text)
    gsub(/[][!"#$%&'()*+,.\/:;<=>?@\\^`{|}~]/, "", text)
    gsub(/ /, "-", text)
    return seen[text]++ ? text "-" seen[text] - 1 : text
}

# a/b/../c -> a/c
function plain(path) {
    while (match(path, /[^\/]+\/\.\.\//)) path = substr(path, 1, RSTART - 1) substr(path, RSTART + RLENGTH)
    return path
}

function target(link,    at, path, part) {
    if (link ~ /^[a-z]+:/) return link
    if (link ~ /^#/) return "#" chapter "-" substr(link, 2)
    at = index(link, "#")
    path = plain(folder (at ? substr(link, 1, at - 1) : link))
    part = at ? substr(link, at + 1) : ""
    if (path in is_page) return "#" chapter_of(path) (part != "" ? "-" part : "")
    print path >>files
    return path (part != "" ? "#" part : "")
}

function links(line,    done, start, name) {
    while (start = match(line, /(href|src)="[^"]*"/)) {
        name = substr(line, start, index(substr(line, start), "\""))
        done = done substr(line, 1, start - 1) name
        line = substr(line, start + length(name))
        start = index(line, "\"") # target() matches too
        done = done target(substr(line, 1, start - 1))
        line = substr(line, start)
    }
    return done line
}

function heading(line,    level, text, id) {
    level = substr(line, 3, 1)
    text = substr(line, 5, length(line) - 9)
    id = chapter "-" anchor(text)
    printf "<h%d id=\"%s\">%s</h%d>\n", level + 1, id, links(text), level + 1
    gsub(/<\/?a[^>]*>/, "", text)
    if (level == 1) printf "<li><a href=\"#%s\">%s</a>\n<ul>\n", chapter, text >>contents
    if (level == 2) printf "<li><a href=\"#%s\">%s</a></li>\n", id, text >>contents
}

BEGIN {
    n = split(pages, name, " ")
    for (i = 1; i <= n; i++) is_page[name[i]] = 1
    chapter = chapter_of(page)
    folder = page
    if (!sub(/[^\/]*$/, "", folder)) folder = ""
    printf "<section class=\"chapter\" id=\"%s\">\n", chapter
}
/^<pre/ { code = 1 }
code { print; if (/<\/pre>/) code = 0; next }
/^<!-- raw HTML omitted -->$/ { next }
/^<h[1-6]>.*<\/h[1-6]>$/ { heading($0); next }
/^<table>/ { print "<div class=\"scroll\" tabindex=\"0\">" }
{ print links($0) }
/^<\/table>/ { print "</div>" }
END {
    print "</section>"
    print "</ul></li>" >>contents
}
