# SPDX-License-Identifier: MIT
# Shell functions for the pages: sourced by them. They read from $out, the directory of the page, and write XML. $here:
# the page's script.

# table FILE CAPTION: a CSV as a table. A first cell that repeats is written once.
table() {
    awk -F, -v caption="$2" '
        { gsub(/&/, "\\&amp;"); gsub(/</, "\\&lt;"); $0 = $0 }
        NR == 1 {
            printf "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"%s\"><table>\n<caption>%s</caption>\n<thead><tr>", caption, caption
            for (i = 1; i <= NF; i++) printf "<th scope=\"col\">%s</th>", $i
            print "</tr></thead>\n<tbody>"; next
        }
        {
            printf "<tr><th scope=\"row\">%s</th>", $1 == last ? "" : $1; last = $1
            for (i = 2; i <= NF; i++) printf "<td>%s</td>", $i
            print "</tr>"
        }
        END { print "</tbody></table></div>" }' "$out/$1"
}
# picture FILE WORDS
picture() {
    if [ -s "$out/$1" ]; then echo "<img class=\"picture\" src=\"$1\" alt=\"$2\"/>"; else echo '<p>No picture: gnuplot is not installed.</p>'; fi
}
# begin TITLE RULES: the head of a page. RULES: styles of its own
begin() {
    cat <<HTML
<!DOCTYPE html>
<!-- SPDX-License-Identifier: MIT -->
<html lang="en">
<head>
<meta charset="utf-8"/>
<meta name="viewport" content="width=device-width, initial-scale=1"/>
<meta name="color-scheme" content="light dark"/>
<title>$1</title>
<style>
$(cat "$here/../gallery/page.css")
section { margin-bottom: 3rem; }
td, th { text-align: left; white-space: normal; }
$2
</style>
</head>
<body>
HTML
}
