# SPDX-License-Identifier: MIT
# The page of `make gallery`, from one object a demonstration: {name, yaml, summary, film, gif, still, first, expert}, the last five names
# of files beside the page, or null; $words: all words, of one language; $map: points of the map of slopes. It is written so
# that it is XML too (xmllint reads it). All text goes through @html.

# The order of the lecture. A case that is not named comes last in the group of its kind. A list in a list is one demonstration with a
# chooser.
def groups: [
    {title: "group_motions", kinds: [], cases: ["rigid-rotation", "pure-rolling", "rolling-over", "pure-sliding", "sliding-over",
        "radii-ten", "floor", "gear-train"]},
    {title: "group_dynamics", kinds: ["bodies"], cases: ["slip-to-roll", "incline-free", ["incline", "incline-bagi-kuhn",
        "incline-star-force", "incline-star-torque", "incline-star-damping"], "coasting", "rollers", "locomotive"]},
    {title: "group_machines", kinds: [], cases: ["ice-and-carpet", "conveyor", "ramp-jump", "race", "back-spin", "struck-row",
        "rack-and-pinion", "braked-wheel", "spool"]},
    {title: "group_rings", kinds: [], cases: ["bowl", "drum", "planets"]},
    {title: "group_inside", kinds: ["contact", "patch"], cases: ["contact-reversal", "patch-cattaneo-to-carter"]}
];

def given: . != null and . != "";
# As in the films: _ lowers the letters and digits behind it, or one character.
def lowered: @html | gsub("_(?<c>[A-Za-z0-9]+|&[^;]+;|[^ ])"; "<sub>\(.c)</sub>");
def say($key): $words[0][$key] // error("no word for " + $key);
def word($key): say($key) | lowered;
def filled($with): reduce $with[] as $w (.; (index("%s")) as $i | if $i == null then . else .[:$i] + $w + .[$i + 2:] end);
def lesson($key): .summary.lesson[$key] // "";
def title: if lesson("title") | given then lesson("title") else .name end;
def paragraph($class): if given then "<p class=\"\($class)\">\(lowered)</p>\n" else "" end;

# To so many digits, as a person writes them: 0.1133, 12346000, 8.7 · 10⁻¹⁹. Divided by a power of ten, not multiplied by a fraction, so that
# no 0.30000000000000004 comes out.
def power10: reduce range(.) as $_ (1; . * 10);
def raised: tostring | explode | map(if . == 45 then 8315 elif . == 49 then 185 elif . == 50 or . == 51 then . + 128 else . + 8256 end) | implode;
def number($digits):
    if type != "number" then say("page_none")
    elif . == 0 then "0"
    else (fabs | log10 | floor) as $e
        | if $e < -4 or $e > 8 then ((. / pow(10; $e)) | number(if $digits < 3 then $digits else 3 end)) + " · 10" + ($e | raised)
          else ($digits - 1 - $e) as $places
              | if $places < 0 then (-$places | power10) as $p | (. / $p | round) * $p
                else ($places | power10) as $p | (. * $p | round) / $p end
              | tostring | sub("^-"; "−") end end;
# A power is in W/m as it is in a picture; N/s is the same.
def in_person: . as $u | {"1": "", "N/s": "W/m", "J/s": "W", "m/s^2": "m/s²"} | .[$u] // $u;
def quantity($digits; $unit):
    ($unit | tostring | in_person) as $u
    | (number($digits) + if type == "number" and ($u | given) then " " + $u else "" end) | @html;

# wall0-3, 0-1, 2; laws.0, path.2: of which contact or disk, of which law, and where on its path
def of: "\(. // "")"
    | if test("^wall[0-9]+-[0-9]+$") then (capture("^wall(?<a>[0-9]+)-(?<b>[0-9]+)$") as $m | say("page_of_wall") | filled([$m.a, $m.b]))
      elif test("^[0-9]+-[0-9]+$") then (split("-") as $m | say("page_of_disks") | filled($m))
      elif test("^[0-9]+$") then (. as $m | say("page_of_disk") | filled([$m]))
      elif test("^laws") then (capture("^laws\\.(?<a>[0-9]+), path\\.(?<b>[0-9]+)$") as $m | say("page_of_law") | filled([$m.a, $m.b]))
      elif test("^path") then (ltrimstr("path.") as $m | say("page_of_segment") | filled([$m]))
      else . end;

# What is less than a hundredth of its tolerance is rounding: 0.
def unless_rounding($tolerance): if type == "number" and ($tolerance | type) == "number" and fabs < 0.01 * $tolerance then 0 else . end;
def check:
    .unit as $u | .tolerance as $t
    | "<tr><th scope=\"row\">"
    + (if .lane | given then "<b>\(.lane | lowered)</b> " else "" end)
    + "\("\(.what)" | . as $what | $words[0]["what_" + gsub("-"; "_")] // ($what | gsub("-"; " ")) | @html) <small>\(.of | of | @html)</small></th>"
    + (if .ok then "<td class=\"ok\">✓ \(word("page_agrees"))</td>" else "<td class=\"bad\">✗ \(word("page_not"))</td>" end)
    + "<td>\(.measured | unless_rounding($t) | quantity(5; $u))</td><td>\(.exact | quantity(5; $u))</td>"
    + "<td>\(.error | unless_rounding($t) | quantity(2; $u))</td><td>\(.tolerance | quantity(2; $u))</td></tr>\n";
def checks:
    if length == 0 then "" else
    "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"\(word("page_checks"))\"><table>\n"
    + "<caption>\(word("page_checks"))</caption>\n<thead><tr>"
    + (["page_quantity", "page_verdict", "measured", "exact", "page_error", "page_tolerance"]
        | map("<th scope=\"col\">\(word(.))</th>") | join(""))
    + "</tr></thead>\n<tbody>\n\(map(check) | join(""))</tbody></table></div>\n" end;

# What a film tells to who cannot see it.
def happens: if lesson("happens") | given then lesson("happens") else lesson("sentence") end;

def described($key): (title | @html) as $title | say($key) | @html | filled([$title]);
def picture:
    (.name | @html) as $name
    | if .film then
        "<div class=\"stage\"><video id=\"film-\($name)\" muted=\"\" loop=\"\" playsinline=\"\" preload=\"metadata\" src=\"\(.film | @html)\""
        + (if .first then " poster=\"\(.first | @html)\"" else "" end)
        + (if .expert then " data-class=\"\(.film | @html)\" data-expert=\"\(.expert | @html)\"" else "" end)
        + " aria-label=\"\(described("page_film"))\" aria-describedby=\"told-\($name)\"></video>\n"
        + "<div class=\"cover\" aria-hidden=\"true\"><span>?</span></div></div>\n"
        + "<p class=\"transport\"><button type=\"button\" class=\"play\" aria-label=\"\(word("page_play"))\">▶</button>"
        + "<input type=\"range\" min=\"0\" max=\"1000\" value=\"0\" aria-label=\"\(word("page_seek"))\"/></p>\n"
      elif .still then "<img class=\"picture\" src=\"\(.still | @html)\" alt=\"\(described("page_picture"))\"/>\n"
      else "<p class=\"picture\">\(word("page_no_picture"))</p>\n" end;
def printed: if .first then "<img class=\"printed\" src=\"\(.first | @html)\" alt=\"\"/>\n" else "" end;

def links:
    [if .film then "<a href=\"\(.film | @html)\">\(word("page_a_film"))</a>" else empty end,
     if .gif then "<a href=\"\(.gif | @html)\">GIF</a>" else empty end,
     if .still then "<a href=\"\(.still | @html)\">\(word("page_a_still"))</a>" else empty end]
    | if length == 0 then "" else "<p class=\"links\">\(word("page_for_slides")) \(join(", ")).</p>\n" end;

def left_out:
    (.summary.left_out // []) | if length == 0 then ""
    else "<p class=\"links\">\(join(", ") as $list | say("page_not_needed") | @html | filled([$list | @html]))</p>\n" end;

def source:
    (.name | @html) as $name
    | "<details><summary>\(say("page_case") | @html | filled(["cases/\($name).yaml"]))</summary>\n"
    + "<p><button type=\"button\" class=\"copy\" data-of=\"yaml-\($name)\">\(word("page_copy"))</button> <span role=\"status\"></span></p>\n"
    + "<pre id=\"yaml-\($name)\" tabindex=\"0\">\(.yaml | @html)</pre></details>\n";

# The question and the answers to choose from stand above the film.
def question:
    (lesson("choices") | if type == "array" then . else [] end) as $choices
    | (lesson("question") | paragraph("question"))
    + if ($choices | length) == 0 then "" else
        "<ol class=\"choices\" aria-label=\"\(word("page_predict"))\">"
        + ([range($choices | length) as $i
            | "<li><button type=\"button\" data-n=\"\($i + 1)\">\($choices[$i] | lowered)</button></li>"] | join("")) + "</ol>\n" end;

# What is covered until the class has answered.
def answer:
    (lesson("choices") | if type == "array" then . else [] end) as $choices
    | "<p class=\"verdict\" role=\"status\"></p>\n"
    + "<div class=\"revealed\" hidden=\"\">\n"
    + (if lesson("answer") | given then "<h4>\(word("page_answer"))</h4>\n\(lesson("answer") | paragraph("answer"))" else "" end)
    + "</div>\n";

# A run of its own: the film and what it tells.
def variant($hidden):
    (.name | @html) as $name | (.film != null) as $film # whose picture has the equation
    | "<div class=\"variant\" data-name=\"\($name)\"\(if $hidden then " hidden=\"\"" else "" end)>\n"
    + (lesson("equation") | paragraph(if $film then "equation unseen" else "equation" end))
    + picture + printed
    + "<p class=\"told unseen\" id=\"told-\($name)\">\(word("page_happens")): \(happens | lowered)</p>\n"
    + "<div class=\"revealed\" hidden=\"\">\n\(lesson("sentence") | paragraph("sentence"))"
    + (.summary.checks // [] | checks) + "</div>\n"
    + left_out + links
    + "<p class=\"links\">\(word("page_run_it")) <code>./trundle run cases/\($name).yaml</code></p>\n"
    + source
    + "</div>\n";

# Thresholds over mu_r, as lines of the closed form, and the points that were measured. 0 to mu along, tan alpha from 0 to 1 up.
def map_of($points):
    if ($points | length) == 0 then "" else
    $points[0].mu as $mu
    | def x: 60 + . / $mu * 520 | round; def y: 330 - . * 300 | round;
      "<figure class=\"map\"><svg viewBox=\"0 0 620 380\" role=\"img\" aria-label=\"\(word("page_map"))\">"
    + "<path class=\"axis\" d=\"M60 30V330H600\"/>"
    + "<path class=\"rolls\" d=\"M\(0 | x) \(0 | y)L\($mu | x) \($mu | y)\"/>"
    + "<path class=\"slips\" d=\"M\(0 | x) \(3 * $mu | y)L\($mu | x) \($mu | y)\"/>"
    + "<text x=\"330\" y=\"318\" class=\"area\">\(word("page_map_rests"))</text>"
    + "<text x=\"110\" y=\"210\" class=\"area rolls\">\(word("rolls"))</text>"
    + "<text x=\"390\" y=\"90\" class=\"area slips\">\(word("slips"))</text>"
    + "<text x=\"590\" y=\"365\" text-anchor=\"end\">μ<tspan dy=\"5\">r</tspan></text><text x=\"8\" y=\"45\">tan α</text>"
    + ([0.1, 0.2, 0.3] | map(select(. <= $mu)) | map("<text x=\"\(x)\" y=\"360\" text-anchor=\"middle\">\(.)</text>") | join(""))
    + ([0, 0.5] | map("<text x=\"50\" y=\"\(y + 7)\" text-anchor=\"end\">\(.)</text>") | join(""))
    + ($points | map("<circle class=\"rolls\" cx=\"\(.mu_r | x)\" cy=\"\(.rolls | y)\" r=\"6\"/><circle class=\"slips\" cx=\"\(.mu_r | x)\" cy=\"\(.slips | y)\" r=\"6\"/>") | join(""))
    + "</svg><figcaption>\(word("page_map")). \(say("page_map_about") | filled(["\($mu)"]) | lowered)</figcaption></figure>\n" end;

def chooser:
    if length == 1 then "" else
    "<p class=\"chooser\"><label>\(word("page_law")) <select>"
    + (map("<option value=\"\(.name | @html)\">\(title | gsub("_"; "") | @html)</option>") | join("")) + "</select></label></p>\n" end;

# Of one run or several, of which the first gives title, question and answer.
def demonstration:
    . as $runs | .[0] | (.name | @html) as $name
    | "<article id=\"\($name)\" tabindex=\"-1\" aria-labelledby=\"title-\($name)\" data-right=\"\(lesson("right") | if . == "" then 0 else . end)\">\n"
    + "<h3 id=\"title-\($name)\">\(title | lowered)</h3>\n"
    + question
    + ($runs | chooser)
    + ([range($runs | length) as $i | $runs[$i] | variant($i > 0)] | join(""))
    + "<p class=\"act\"><button type=\"button\" class=\"reveal\">\(word("page_reveal")) (R)</button></p>\n"
    + answer
    + (if ($runs | length) > 1 then "<div class=\"revealed\" hidden=\"\">\n\(map_of($map[0]))</div>\n" else "" end)
    + "<p class=\"notes\">\(word("page_notes"))</p>\n"
    + "</article>\n";

def entry:
    .[0] | "<li><a href=\"#\(.name | @html)\">"
    + ((.first // .still) as $picture | if $picture then "<img src=\"\($picture | @html)\" alt=\"\"/>" else "" end)
    + "<span>\(title | lowered)</span></a></li>\n";

def verdict:
    map(.summary.checks // [] | .[]) | map(select(.ok | not)) as $bad
    | if length == 0 then "" elif ($bad | length) == 0
      then "<p class=\"ok\">✓ \(length as $n | say("page_all_agree") | filled(["\($n)"]) | lowered)</p>"
      else "<p class=\"bad\">✗ \(length as $n | say("page_some_not") | filled(["\($bad | length)", "\($n)"]) | lowered)</p>" end;

# One line each.
def definitions:
    def rows($of; $sign): map("<tr><th scope=\"row\"><b class=\"\($of)\">V<sub>\($sign)</sub></b> \(. | gsub("_"; "-"))</th><td>\("def_v\($sign)_" + . | . as $k | word($k))</td></tr>") | join("\n");
    "<section class=\"definitions\">\n<h2 id=\"definitions\">\(word("page_definitions"))</h2>\n<p>\(word("page_definitions_about"))</p>\n"
    + "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-labelledby=\"definitions\"><table>\n"
    + (["wang", "iwashita_oda", "alonso", "full_radius"] | rows("slides"; "s")) + "\n"
    + (["wang", "bagi_kuhn", "alonso_min", "alonso_mean"] | rows("rolls"; "r")) + "\n</table></div>\n</section>\n";

# Of all runs the answers, for the last page of the print.
def answers:
    "<section class=\"answers\">\n<h2>\(word("page_answers"))</h2>\n"
    + (map(.[0] | select(lesson("answer") | given)
        | (lesson("choices") | if type == "array" then . else [] end) as $choices
        | "<p><b>\(title | lowered)</b> \(if ($choices | length) > 0 then "\(lesson("right")). " else "" end)\(lesson("answer") | lowered)</p>\n") | join(""))
    + "</section>\n";

# Demonstrations of a group, each a list of runs: those named in their order, then the rest of its kinds.
def members($group; $all; $named):
    [$group.cases[] | [.] | flatten | [.[] as $name | $all[] | select(.name == $name)] | select(length > 0)]
    + [$all[] | select((.name as $n | $named | index($n) | not) and (.summary.kind as $k | $group.kinds | index($k))) | [.]];

def keys_card:
    [["PageDown", "PageUp", "key_next"], ["Space", "", "key_play"], ["1", "4", "key_choose"], ["R", "", "key_reveal"],
     ["E", "", "key_expert"], ["F", "", "key_full"], ["?", "", "key_help"]]
    | map("<dt><kbd>\(.[0])</kbd>\(if .[1] != "" then " <kbd>\(.[1])</kbd>" else "" end)</dt><dd>\(.[2] as $k | word($k))</dd>") | join("\n");

. as $all
| [groups[].cases[] | [.] | flatten | .[]] as $named
| [groups[] | . + {demos: members(.; $all; $named)} | select(.demos | length > 0)] as $groups
| [$groups[].demos[]] as $demos
| "<!DOCTYPE html>
<!-- SPDX-License-Identifier: MIT -->
<html lang=\"\(word("language"))\">
<head>
<meta charset=\"utf-8\"/>
<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>
<meta name=\"color-scheme\" content=\"light dark\"/>
<title>\(word("page_title")) trundle</title>
<style>
\($css)</style>
</head>
<body class=\"gallery\" data-right=\"\(word("page_right"))\" data-wrong=\"\(say("page_wrong") | @html)\" data-copied=\"\(word("page_copied"))\" data-selected=\"\(word("page_selected"))\">
<header>
<h1>\(word("page_title"))</h1>
<p>\(say("page_about") | @html | filled(["\($demos | length)", ($all[0].summary.version // "" | @html)]))</p>
\($all | verdict)
</header>
<dialog id=\"keys\" aria-labelledby=\"keys-title\">
<h2 id=\"keys-title\">\(word("page_keys"))</h2>
<dl>
\(keys_card)
</dl>
<form method=\"dialog\"><button>\(word("page_close"))</button></form>
</dialog>
<nav aria-label=\"\(word("page_contents"))\">
\([$groups[] | "<h2>\(.title as $t | word($t))</h2>\n<ol>\n\(.demos | map(entry) | join(""))</ol>\n"] | join(""))</nav>
<main>
\([$groups[] | "<section>\n<h2>\(.title as $t | word($t))</h2>\n\(.demos | map(demonstration) | join(""))</section>\n"] | join(""))\(definitions)\($demos | answers)</main>
<button type=\"button\" class=\"help\" aria-label=\"\(word("page_keys"))\">?</button>
<script>
\($js)</script>
</body>
</html>"
