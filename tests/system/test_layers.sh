#!/bin/sh
# SPDX-License-Identifier: MIT
# The rooms of the house: which folder may include which, that no files need each other in a circle, where a library may
# be used, who may print. Each rule is then broken in a copy of the tree, to prove that breaking it is noticed.
# usage: test_layers.sh [ROOT]   with a root: only the rules, on that tree
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
root=${1:-.}

# Allowed: FOLDER: what it may include besides itself. The drivers in study/ put a whole run together, frames included,
# so that cli/ is arguments and printing only. api/ is the public library, whose face is trundle.h. live/ is that library
# in a page, with what a page has not in place of scene/'s and broad/'s libraries, and with study/inside.
arrows='
base:
scene: base
laws: base
patch: base
broad: base
core: base scene laws broad
out: base scene laws broad core
draw: base scene laws patch core
study: base scene laws patch core out draw
verify: base scene laws patch broad core out draw study
cli: base scene laws patch broad core out draw study verify
api: base scene laws core trundle.h
live: base scene laws broad study trundle.h
'
sources() { find "$root/src" -name '*.[ch]' -o -name '*.cpp' -o -name '*.hpp' | sort; }

# Every #include "folder/file" against the table.
forbidden_includes() {
    sources | xargs grep -n '^[[:space:]]*#[[:space:]]*include[[:space:]]*"' | awk -v arrows="$arrows" '
        BEGIN {
            n = split(arrows, line, "\n")
            for (i = 1; i <= n; i++) {
                m = split(line[i], word, "[: ]+")
                if (word[1] != "") may[word[1], word[1]] = 1
                for (k = 2; k <= m; k++) may[word[1], word[k]] = 1
            }
        }
        {
            from = $0; sub(/.*\/src\//, "", from); sub(/\/.*/, "", from)
            to = $0; sub(/^[^"]*"/, "", to); sub(/".*/, "", to); sub(/\/.*/, "", to)
            if (!((from, to) in may)) print
        }'
}

# A unit is NAME.c and NAME.h. Of lines "UNIT UNIT", where the first needs the second, those that lie on a circle. A
# circle
# within a folder, that is: the arrows see the others.
on_circles() {
    awk '
        function reaches(from, to,    k, list, n) { # from needs to, at once or through others
            if (from == to) return 1
            if (from in seen) return 0
            seen[from] = 1
            n = split(needs[from], list, " ")
            for (k = 1; k <= n; k++) if (reaches(list[k], to)) return 1
            return 0
        }
        function folder(unit) { return substr(unit, 1, index(unit, "/") - 1) }
        folder($1) == folder($2) && $1 != $2 && !(($1, $2) in edge) { edge[$1, $2] = 1; needs[$1] = needs[$1] " " $2 }
        END {
            for (pair in edge) {
                split(pair, unit, SUBSEP)
                for (name in seen) delete seen[name]
                if (reaches(unit[2], unit[1])) print unit[1] " needs " unit[2]
            }
        }' | sort
}

# Which functions a header declares and which a .c file defines, as "declares|defines UNIT FUNCTION". Both begin at the
# left margin. A declaration ends with ; and may be a list "TYPE NAME, NAME;".
functions() {
    awk '
        {
            file = line = $0
            sub(/:.*/, "", file)
            sub(/.*\/src\//, "", file)
            sub(/^[^:]*:[^:]*:/, "", line)
            if (file != last || line ~ /^[A-Za-z#}]/) name = list = ""
            last = file
            if (line ~ /^(typedef|extern) |(^| )static /) next
            if (line ~ /^[A-Za-z][A-Za-z0-9_ *]*[ *][a-z][A-Za-z0-9_]*\(/) {
                name = line
                sub(/\(.*/, "", name)
                sub(/.*[ *]/, "", name)
            } else if (file ~ /\.h$/ && line ~ /^[a-z_]+ [a-z][a-z0-9_, ]*[,;] *$/)
                list = "open"
            if (list != "") {
                n = split(line, word, /[ ,;]+/)
                for (k = 1; k <= n; k++) if (word[k] != "") print "declares", file, word[k]
                if (line ~ /;/) list = ""
            }
            if (name == "" || !match(line, /[;{]/)) next
            if (substr(line, RSTART, 1) == ";" && file ~ /\.h$/) print "declares", file, name
            if (substr(line, RSTART, 1) == "{" && file !~ /\.h$/) print "defines", file, name
            name = ""
        }' "$work/code" | sed 's/\.[a-z]* / /'
}

# Lines "HEADER UNIT UNIT...": whose functions a header declares, where they are not those of the file of its name.
headers_of_others() {
    functions | sort -u | awk '
        $1 == "defines" { home[$3] = $2 }
        $1 == "declares" { header[++n] = $2; name[n] = $3 }
        END {
            for (k = 1; k <= n; k++) {
                if (!(name[k] in home) || (header[k], home[name[k]]) in known) continue
                known[header[k], home[name[k]]] = 1
                others[header[k]] = others[header[k]] " " home[name[k]]
            }
            for (unit in others) if (others[unit] != " " unit) print unit others[unit]
        }' | sort
}

# A header speaks for one .c file. One that declares functions of several ties all who include it to all of these. A
# registry names its entries itself. The face of the library is one header for its users.
shared_headers() { awk 'NF > 2 && $1 != "trundle"' "$work/others"; }

# Units that include each other in a circle. A header counts for the file of its functions, whatever its name.
include_circles() {
    awk 'NF == 2' "$work/others" >"$work/alias"
    sources | xargs grep '^[[:space:]]*#[[:space:]]*include[[:space:]]*"' |
        sed 's/:.*include *"/ /; s/".*//; s/.*\/src\///' |
        awk '
            NR == FNR { home[$1 ".h"] = $2; next }
            {
                for (k = 1; k <= 2; k++) if ($k in home) $k = home[$k]; else sub(/\.[a-z]*$/, "", $k)
                print
            }' "$work/alias" - | on_circles
}

# object_circles DIRECTORY: object files of src/ there that call each other in a circle; those without a source are old.
object_circles() {
    find "$1" -name '*.o' | sort | while read -r object; do
        source=src/${object#"$1"/}
        [ -e "${source%.o}" ] && echo "$object"
    done | xargs nm -A | awk -v root="$1/" '
        {
            unit = substr($1, length(root) + 1)
            sub(/\.[a-z]*\.o:.*/, "", unit)
            if ($(NF - 1) ~ /^[TDBRVWC]$/) home[$NF] = unit
            if ($(NF - 1) == "U") uses[unit, $NF] = 1
        }
        END {
            for (use in uses) {
                split(use, word, SUBSEP)
                if (word[2] in home) print word[1], home[word[2]]
            }
        }' | on_circles
}

# library PATTERN FOLDER: its headers elsewhere than in the folder
library() {
    sources | grep -v "/src/$2/" | xargs grep -nE "#[[:space:]]*include[[:space:]]*[<\"]($1)"
}

# Code without its comments, each line as FILE:LINE:TEXT.
code_of() {
    awk '
        FNR == 1 { inside = 0 }
        {
            text = $0; kept = ""
            while (text != "") {
                if (inside) {
                    at = index(text, "*/")
                    if (!at) break
                    text = substr(text, at + 2); inside = 0
                } else {
                    at = index(text, "/*")
                    if (!at) { kept = kept text; break }
                    kept = kept substr(text, 1, at - 1); text = substr(text, at + 2); inside = 1
                }
            }
            sub(/\/\/.*/, "", kept)
            print FILENAME ":" FNR ":" kept
        }' "$@"
}

# snprintf and a file of results are fine; the terminal and the end of the program belong to cli/.
printing() {
    grep -v '^[^:]*/src/cli/' "$work/code" |
        grep -E '(^|[^A-Za-z0-9_])((v?printf|puts|putchar|perror|psignal|warnx?|errx?|exit|_exit|_Exit|quick_exit|abort)[[:space:]]*\(|(stdout|stderr)([^A-Za-z0-9_]|$))'
}

without_licence() { sources | xargs awk 'FNR == 1 && !/SPDX-License-Identifier: MIT/ { print FILENAME }'; }
too_long() { sources | xargs wc -l | awk '$2 != "total" && $1 > 500'; }

# Symbols of an archive or object in sections that can be written: neither constants nor relocated constants.
mutable_globals() {
    nm --format=sysv "$1" | awk -F'|' '
        { gsub(/ /, "") }
        $4 ~ /OBJECT|TLS|COMMON/ && $7 ~ /^(\.data|\.bss|\.tdata|\.tbss|\.sdata|\.sbss|\*COM\*|COM)/ && $7 !~ /^\.data\.rel\.ro/ &&
        $1 !~ /^(DW\.ref\.|_ZN2mu|_ZStL8__ioinit)/' # the C++ runtime, and constant strings of a header of muParser
}

# libm_calls DIRECTORY: objects there, but for pictures and verifications, that call functions of libm which round
# differently from system to system, in any precision. base/math.h has them.
libm_calls() {
    find "$1" -name '*.c.o' -o -name '*.cpp.o' | grep -vE '/(draw|verify)/' | sort | xargs nm -A | awk '
        $(NF - 1) == "U" &&
        $NF ~ /^(a?(sin|cos|tan)h?|atan2|sincos|exp(2|10|m1)?|log(2|10|1p)?|pow|cbrt|hypot|erfc?|lgamma(_r)?|tgamma|[jy][01n])[fl]?$/'
}
# What several rules look at, made once.
# shellcheck disable=SC2046 # no path here has spaces in it
code_of $(sources) >"$work/code"
headers_of_others >"$work/others"

check 'folders include only what is below them' is_silent forbidden_includes
check 'no header declares functions of several files' is_silent shared_headers
check 'no files include each other in a circle' is_silent include_circles
check 'Cairo, libpng and ISA-L only in draw/' is_silent library 'cairo|png\.h|pango|isa-l' draw
check 'Box2D only in broad/' is_silent library 'box2d|b2_' broad
check 'YAML and muParser only in scene/' is_silent library 'yaml|muParser' '\(scene\|live\)'
check 'jansson only in out/' is_silent library 'jansson' out
check 'libcsv only in study/' is_silent library 'csv\.h' study
check 'printing and exit only in cli/' is_silent printing
check 'every source file names its licence' is_silent without_licence
check 'no source file is longer than 500 lines' is_silent too_long
[ $# -eq 1 ] && finish

library_file=$(dirname "$TRUNDLE")/libtrundle.a
[ -e "$library_file" ] || library_file=build/release/libtrundle.a
if ! command -v nm >/dev/null || [ ! -e "$library_file" ]; then
    skip 'no mutable globals outside cli/' 'no nm or no libtrundle.a'
elif nm "$library_file" 2>/dev/null | grep -q __asan_; then
    skip 'no mutable globals outside cli/' 'the address sanitizer adds its own'
else
    check 'no mutable globals outside cli/' is_silent mutable_globals "$library_file"
fi

if ! command -v nm >/dev/null || [ ! -e "$library_file" ]; then
    skip 'no object files call each other in a circle' 'no nm or no libtrundle.a'
else
    check 'no object files call each other in a circle' is_silent object_circles "$(dirname "$library_file")/src"
fi

if ! command -v nm >/dev/null || [ ! -e "$library_file" ]; then
    skip 'log, sin and their like only from base/math.h' 'no nm or no libtrundle.a'
else
    check 'log, sin and their like only from base/math.h' is_silent libm_calls "$(dirname "$library_file")/src"
fi

# ---- each rule broken ----

# broken RULE FILE LINE: with the line at the end of the file of a copy, the rule must fail, and no other
broken() {
    rm -rf "$work/copy"
    mkdir "$work/copy"
    cp -r src "$work/copy/"
    chmod -R u+w "$work/copy"
    printf '%s\n' "$3" >>"$work/copy/src/$2"
    "$0" "$work/copy" >"$work/tap" 2>&1
    says "$work/tap" 1..11 || return 1
    failed=$(grep '^not ok' "$work/tap" | sed 's/^not ok [0-9]* - //')
    equals "$failed" "$1"
}
check 'noticed: laws include core' broken 'folders include only what is below them' laws/laws.c '#include "core/world.h"'
check 'noticed: core includes out' broken 'folders include only what is below them' core/step.c '#include "out/table.h"'
check 'noticed: laws include patch' broken 'folders include only what is below them' laws/laws.c '#include "patch/carter.h"'
check 'noticed: patch includes laws' broken 'folders include only what is below them' patch/carter.c '#include "laws/law.h"'
check 'noticed: out includes draw' broken 'folders include only what is below them' out/table.h '  #  include "draw/draw.h"'
check 'noticed: a path that goes up' broken 'folders include only what is below them' base/alloc.c '#include "../core/world.h"'
circle='no files include each other in a circle'
check 'noticed: world includes pipeline' broken "$circle" core/world.c '#include "core/pipeline.h"'
check 'noticed: a circle of headers' broken "$circle" core/world.h '#include "core/step.h"'
check 'noticed: a circle of three' broken "$circle" core/cell.c '#include "core/contacts.h"'
check 'noticed: a circle through a header of another name' broken "$circle" verify/sweep.c \
    '#include "verify/precision.h"'
several='no header declares functions of several files'
check 'noticed: a function of another file in a header' broken "$several" core/step.h \
    'bool tr_cell_check(const tr_world *world, tr_status *st);'
check 'noticed: the same, by the name of its type' broken "$several" laws/law.h 'tr_pass_run tr_kinematics_pair,
    tr_kinematics_wall;'
check 'not taken for a circle: a comment' broken '' core/world.c '/* #include "core/pipeline.h" */'
check 'noticed: Cairo in out' broken 'Cairo, libpng and ISA-L only in draw/' out/dir.c '#include <cairo.h>'
check 'noticed: Box2D in core' broken 'Box2D only in broad/' core/step.c '#include <box2d/box2d.h>'
check 'noticed: YAML in study' broken 'YAML and muParser only in scene/' study/run.c '#include <yaml.h>'
check 'noticed: jansson in core' broken 'jansson only in out/' core/step.c '#include <jansson.h>'
check 'noticed: libcsv in out' broken 'libcsv only in study/' out/table.c '#include <csv.h>'
check 'noticed: printf in a law' broken 'printing and exit only in cli/' laws/laws.c 'void f(void) { printf("x"); }'
check 'noticed: a message to stderr' broken 'printing and exit only in cli/' core/step.c 'void f(void) { fprintf(stderr, "x"); }'
check 'noticed: exit in core' broken 'printing and exit only in cli/' core/step.c 'void f(void) { exit(1); }'
check 'not taken for printing: a comment' broken '' core/step.c '/* printf("x") and exit(1) */'
check 'not taken for printing: snprintf' broken '' core/step.c 'void f(char *s) { snprintf(s, 2, "x"); }'
check 'noticed: a file of 600 lines' broken 'no source file is longer than 500 lines' base/version.h \
    "$(awk 'BEGIN { for (i = 0; i < 600; i++) print "" } END { print "int x;" }' </dev/null)"

licence_gone() {
    rm -rf "$work/copy"
    mkdir "$work/copy"
    cp -r src "$work/copy/"
    sed -i 1d "$work/copy/src/core/step.c"
    "$0" "$work/copy" | grep '^not ok' | grep -q 'licence'
}
check 'noticed: a file without its licence' licence_gone

global_noticed() {
    printf 'int counter = 1; static int hidden[3]; const int fine = 2;\nstatic const char *const names[] = {"a", "b"};\n%s\n' \
        'int f(int k) { return counter + hidden[k]++ + fine + *names[k]; }' >"$work/globals.c"
    ${CC:-cc} -O1 -fPIE -c "$work/globals.c" -o "$work/globals.o" && equals "$(mutable_globals "$work/globals.o" | wc -l)" 2
}
check 'noticed: global and static variables' global_noticed

calls_noticed() {
    mkdir -p "$work/objects/core"
    for pair in 'cell step' 'step list' 'list cell' 'tile cell'; do # tile is on no circle
        echo "void ${pair#* }(void); void ${pair% *}(void) { ${pair#* }(); }" >"$work/call.c"
        ${CC:-cc} -c "$work/call.c" -o "$work/objects/core/${pair% *}.c.o" || return 1
    done
    equals "$(object_circles "$work/objects")" "core/cell needs core/step
core/list needs core/cell
core/step needs core/list"
}
check 'noticed: object files that call each other in a circle' calls_noticed

libm_noticed() {
    mkdir -p "$work/libm/laws" "$work/libm/draw"
    printf '#include <math.h>\ndouble f(double x) { return %s; }\n' 'log(x) + sqrt(x) + hypotf(x, 1) + floor(x)' >"$work/libm.c"
    ${CC:-cc} -O1 -c "$work/libm.c" -o "$work/libm/laws/law.c.o" && cp "$work/libm/laws/law.c.o" "$work/libm/draw/pen.c.o" &&
        equals "$(libm_calls "$work/libm" | sed 's/.* //' | tr '\n' ' ')" 'hypotf log '
}
check 'noticed: log of libm in a law' libm_noticed
finish
