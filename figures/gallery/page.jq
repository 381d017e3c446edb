# SPDX-License-Identifier: MIT
# The page of `make gallery`, from one object a demonstration: {name, yaml, summary, film, gif, still}, the last three
# names of files beside the page, or null. It is written so that it is XML too (xmllint reads it). All text goes through
# @html.

# The order of the lecture. A case that is not named comes last in the group of its kind.
def groups: [
    {title: "Motions", kinds: [], cases: ["rigid-rotation", "pure-rolling", "rolling-over", "pure-sliding", "sliding-over",
        "radii-ten", "floor", "gear-train"]},
    {title: "Dynamics", kinds: ["bodies"], cases: ["slip-to-roll", "incline-free", "incline-wang", "incline-bagi-kuhn",
        "incline-star-force", "incline-star-torque", "incline-star-damping", "coasting", "rollers", "locomotive"]},
    {title: "Floors and machines", kinds: [], cases: ["ice-and-carpet", "conveyor", "ramp-jump", "race", "back-spin", "struck-row",
        "rack-and-pinion", "braked-wheel", "spool"]},
    {title: "Rings", kinds: [], cases: ["bowl", "drum", "planets"]},
    {title: "Inside a contact", kinds: ["contact", "patch"], cases: ["contact-reversal", "patch-cattaneo-to-carter"]}
];

def given: . != null and . != "";
# As in the films: _ lowers the character behind it.
def lowered: @html | gsub("_(?<c>&[^;]+;|[^ ])"; "<sub>\(.c)</sub>");
def plural($word): "\(.) \($word)" + if . == 1 then "" else "s" end;
def lesson($key): .summary.lesson[$key] // "";
def title: if lesson("title") | given then lesson("title") else .name end;
def paragraph($class): if given then "<p class=\"\($class)\">\(lowered)</p>\n" else "" end;

# To so many digits. Divided by a power of ten, not multiplied by a fraction, so that no 0.30000000000000004 comes out.
def power10: reduce range(.) as $_ (1; . * 10);
def number($digits):
    if type != "number" then "none"
    elif . == 0 then "0"
    else ($digits - 1 - (fabs | log10 | floor)) as $places
        | if $places < 0 then (-$places | power10) as $p | (. / $p | round) * $p
          else ($places | power10) as $p | (. * $p | round) / $p end
        | tostring | sub("^-"; "−") | sub("e-0?"; "e−") end;
def quantity($digits; $unit):
    (number($digits) + if type == "number" and $unit != "1" and ($unit | given) then " " + $unit else "" end) | @html;

# wall0-3, 0-1, 2; laws.0, path.2: of which contact or disk, of which law, and where on its path
def of: "\(. // "")"
    | sub("^wall(?<a>[0-9]+)-(?<b>[0-9]+)$"; "wall \(.a) and disk \(.b)")
    | sub("^(?<a>[0-9]+)-(?<b>[0-9]+)$"; "disks \(.a) and \(.b)")
    | sub("^(?<a>[0-9]+)$"; "disk \(.a)")
    | sub("^laws\\.(?<a>[0-9]+), "; "law \(.a), ")
    | sub("path\\.(?<a>[0-9]+)$"; "end of segment \(.a)");

def check:
    "<tr><th scope=\"row\">"
    + (if .lane | given then "<b>\(.lane | lowered)</b> " else "" end)
    + "\("\(.what)" | gsub("-"; " ") | @html) <small>\(.of | of | @html)</small></th>"
    + (if .ok then "<td class=\"ok\">✓ agrees</td>" else "<td class=\"bad\">✗ differs</td>" end)
    + "<td>\(.unit as $u | .measured | quantity(5; $u))</td><td>\(.unit as $u | .exact | quantity(5; $u))</td>"
    + "<td>\(.unit as $u | .error | quantity(2; $u))</td><td>\(.unit as $u | .tolerance | quantity(2; $u))</td></tr>\n";
def checks:
    if length == 0 then "" else
    "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Checks\"><table>\n"
    + "<caption>What the run measures, and the closed form</caption>\n<thead><tr>"
    + (["Quantity", "Verdict", "Measured", "Exact", "Error", "Tolerance"] | map("<th scope=\"col\">\(.)</th>") | join(""))
    + "</tr></thead>\n<tbody>\n\(map(check) | join(""))</tbody></table></div>\n" end;

def picture:
    (title | @html) as $title
    | if .film then
        "<video id=\"film-\(.name | @html)\" controls=\"\" muted=\"\" loop=\"\" playsinline=\"\" preload=\"metadata\" src=\"\(.film | @html)\""
        + (if .still then " poster=\"\(.still | @html)\"" else "" end) + " aria-label=\"Film: \($title)\"></video>\n"
      elif .still then "<img class=\"picture\" src=\"\(.still | @html)\" alt=\"Picture: \($title)\"/>\n"
      else "<p class=\"picture\">This run left no picture: ffmpeg or gnuplot was missing.</p>\n" end;

def links:
    [if .film then "<a href=\"\(.film | @html)\">film</a>" else empty end,
     if .gif then "<a href=\"\(.gif | @html)\">GIF</a>" else empty end,
     if .still then "<a href=\"\(.still | @html)\">still</a>" else empty end]
    | if length == 0 then "" else "<p class=\"links\">For slides: \(join(", ")).</p>\n" end;

def left_out:
    (.summary.left_out // []) | if length == 0 then "" else "<p class=\"links\">This scene did not need: \(join(", ") | @html).</p>\n" end;

def source:
    (.name | @html) as $name
    | "<details><summary>The case: cases/\($name).yaml</summary>\n"
    + "<p><button type=\"button\" class=\"copy\" data-of=\"yaml-\($name)\">Copy</button> <span role=\"status\"></span></p>\n"
    + "<pre id=\"yaml-\($name)\" tabindex=\"0\">\(.yaml | @html)</pre></details>\n";

def question:
    if lesson("question") | given then
        "<details class=\"question\"><summary>\(lesson("question") | lowered)</summary>\(lesson("answer") | paragraph("answer"))</details>\n"
    else "" end;

def demonstration:
    (.name | @html) as $name
    | "<article id=\"\($name)\" tabindex=\"-1\" aria-labelledby=\"title-\($name)\">\n<h3 id=\"title-\($name)\">\(title | lowered)</h3>\n"
    + (lesson("equation") | paragraph("equation"))
    + picture
    + (lesson("sentence") | paragraph("sentence"))
    + question
    + (.summary.checks // [] | checks)
    + left_out + links
    + "<p class=\"links\">Run it: <code>./trundle run cases/\($name).yaml</code></p>\n"
    + source
    + "</article>\n";

def entry:
    "<li><a href=\"#\(.name | @html)\">"
    + (if .still then "<img src=\"\(.still | @html)\" alt=\"\"/>" else "" end) + "<span>\(title | lowered)</span></a></li>\n";

def verdict:
    map(.summary.checks // [] | .[]) | map(select(.ok | not)) as $bad
    | if length == 0 then "" elif ($bad | length) == 0 then "<p class=\"ok\">✓ \(length | plural("number")) measured in them, each within its tolerance of the closed form.</p>"
      else "<p class=\"bad\">✗ \($bad | length) of \(length | plural("number")) measured in them out of the tolerance.</p>" end;

# Demonstrations of a group: those named in their order, then the rest of its kinds.
def members($group; $all; $named):
    [$group.cases[] as $name | $all[] | select(.name == $name)]
    + [$all[] | select((.name as $n | $named | index($n) | not) and (.summary.kind as $k | $group.kinds | index($k)))];

. as $all
| [groups[].cases[]] as $named
| [groups[] | . + {demos: members(.; $all; $named)} | select(.demos | length > 0)] as $groups
| "<!DOCTYPE html>
<!-- SPDX-License-Identifier: MIT -->
<html lang=\"en\">
<head>
<meta charset=\"utf-8\"/>
<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>
<meta name=\"color-scheme\" content=\"light dark\"/>
<title>Rolling or sliding? Demonstrations of trundle</title>
<style>
\($css)</style>
</head>
<body>
<header>
<h1>Rolling or sliding?</h1>
<p>\($all | length | plural("demonstration")) computed by trundle \($all[0].summary.version // "" | @html).</p>
\($all | verdict)
<p class=\"keys\">Keys: <kbd>n</kbd> or <kbd>→</kbd> next, <kbd>p</kbd> or <kbd>←</kbd> previous demonstration, <kbd>Space</kbd> plays or stops the film in view, <kbd>Tab</kbd> goes everywhere.</p>
</header>
<nav aria-label=\"Demonstrations\">
\([$groups[] | "<h2>\(.title)</h2>\n<ol>\n\(.demos | map(entry) | join(""))</ol>\n"] | join(""))</nav>
<main>
\([$groups[] | "<section>\n<h2>\(.title)</h2>\n\(.demos | map(demonstration) | join(""))</section>\n"] | join(""))</main>
<script>
\($js)</script>
</body>
</html>"
