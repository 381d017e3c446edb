#!/bin/sh
# SPDX-License-Identifier: MIT
# Faults: each allocation fails once, in a small run of every kind and command; and, in `run` and `sweep`, each system
# call that opens, writes, syncs, cuts, renames, closes or removes a file: ENOSPC, EIO, EINTR, or half a write.
#
# usage: faults.sh TRUNDLE PROGRAMS [STRIDE [SCENE...]]      every STRIDE-th fault (default: 1, all)
# PROGRAMS: directory of memory.so and calls. Prints each scene with its number of faults, and each that went wrong.
#
# What must hold: no signal (but inside Cairo, see in_cairo) and no hang; exit 0 with all files of an undisturbed run,
# or with a note of what is missing, or 3 and a message; files of the user are as they were; all that stands in a
# directory of results is listed; a finished run that was to be replaced is whole, or gone; and the same command,
# undisturbed, then gives the bytes of a run that never met a fault, and leaves no part.
set -u
mode=$1
if [ "$mode" = --one ]; then
    trundle=$2 programs=$3
else
    trundle=$(realpath "$1") programs=$(realpath "$2") self=$(realpath "$0") stride=${3:-1}
    [ $# -lt 3 ] && shift $# || shift 3
    work=$(mktemp -d)
    export work
    trap 'rm -rf "$work"' EXIT
    trap 'exit 130' INT TERM
fi

# ---- the scenes ----
# NAME FAULTS COMMAND: `out` is where results go. Faults: memory, calls, or both.
scenes='
biaxial|both|run biaxial.yaml -o out
tables|both|run tables.yaml -o out --checkpoint 0
resumed|both|run tables.yaml -o out --resume --checkpoint 0
frames|memory|run frames.yaml -o out
replaced|both|run biaxial.yaml -o out --force
sampling|both|run biaxial.yaml -o out --sample sample.bin
sampled|memory|run biaxial.yaml -o out --sample packing.bin
periodic|memory|run biaxial.yaml -o out --set boundary=periodic --set sample.disks=16 --set shear.strain_end=0.008
bodies|both|run bodies.yaml -o out
lanes|memory|run lanes.yaml -o out
contact|both|run contact.yaml -o out
patch|both|run patch.yaml -o out
sweep|both|sweep sweep.yaml -o out -j 1
replay|memory|replay run -n 3 -j 1 -o out
card|memory|measures -o out/card.csv
measures|memory|measures card.csv -o out/by-card.csv
verify|memory|verify pure-motions -o out
laws|memory|laws
law|memory|laws kuhn-creep
bench|memory|bench biaxial.yaml --set shear.strain_end=0.1
sizes|memory|bench --sizes 100 -o out/sizes.csv
'
field() { printf '%s' "$scenes" | grep "^$1|" | cut -d '|' -f "$2"; }

biaxial='kind: biaxial
seed: 3
sample: {disks: 9, r_min: 0.76 mm, r_max: 1.52 mm}
contact: {k_n: 160 MPa, mu: 0.5, mu_r: 0.5}
compaction: {pressure: 160 kPa, inertial_number: 0.2, unbalanced: 0.1}
shear: {inertial_number: 0.05, strain_end: 0.01}'
bodies='kind: bodies
time_end: 0.02 s
gravity: {y: -9.81 m/s^2}
contact: {k_n: 1 MPa, mu: 0.5, mu_r: 0.1}
disks:
  - {radius: 10 mm, x: 0, y: 9.99 mm, vx: 0.1 m/s}
walls:
  - {nx: 0, ny: 1}
checks:
  - {what: speed, disk: 0, exact: disks.0.vx, tolerance: 1 m/s}'
path='path:
  - {force: 10 kN/m, slide: 0.1 um, roll: a, steps: 3}
  - {force: 20 kN/m, slide: -0.3 um, roll: -2*a, steps: 3}'

bed='s/mu_r: 0.5/&, friction: dahlberg-alfredsson, k_t: 80 MPa, E_star: 200 MPa/'

# Stand-ins: quick, and the same bytes everywhere.
write_programs() {
    mkdir "$1" || exit 1
    cat >"$1/ffmpeg" <<'END'
#!/bin/sh
for last; do :; done
case "$*" in *pipe:0*) cksum ;; *) echo gif ;; esac >"${last#file:}"
END
    cat >"$1/gnuplot" <<'END'
#!/bin/sh
stem=$(sed -n "s/.*\['\(.*\)\.svg'.*/\1/p" plot.gp)
printf '</svg>\n\n' >"$stem.svg.part"
printf 'IEND\256\102\140\202' >"$stem.png.part"
END
    chmod +x "$1/ffmpeg" "$1/gnuplot"
}

# Every law.
write_contact() {
    echo 'kind: contact'
    echo 'bodies: {R1: 10 mm, R2: 10 mm, E: 70 GPa, nu: 0.3}'
    echo 'laws:'
    for law in coulomb-spring dahlberg-alfredsson cattaneo-mindlin kuhn-creep vu-quoc-zhang exact; do
        echo "  - {friction: $law, mu: 0.3, k_t: 0.35*E_star}"
    done | sed '/exact\|mindlin\|zhang/s/, k_t.*E_star//'
    spring='friction: coulomb-spring, mu: 0.3, k_t: 0.35*E_star'
    for law in wang-spring bagi-kuhn-conjugate star-force-proportional star-constant-torque star-displacement-damping
    do
        case $law in
        *-spring | *-conjugate) echo "  - {$spring, rolling: $law, mu_r: 0.1, k_r: 1 MPa}" ;;
        *-damping) echo "  - {$spring, rolling: $law, mu_r: 0.1, theta_max: 0.1}" ;;
        *) echo "  - {$spring, rolling: $law, mu_r: 0.1}" ;;
        esac
    done
    echo "$path"
}

# write_inputs SCENE: into the current directory
write_inputs() {
    printf '%s\noutput: {frames: 0, rows: 4}\n' "$biaxial" >biaxial.yaml
    case $1 in
    tables | resumed)
        printf '%s\noutput: {frames: 0, rows: 4, %s, %s}\n' "$biaxial" 'contacts: 2, increments: yes' \
            'paths: [most-mobilised, wall0-3], path_rows: 3' | sed "$bed" >tables.yaml ;;
    frames)
        printf '%s\noutput: {frames: 2, rows: 3, paths: [0-1], curves: no}\n' "$biaxial" | sed "$bed" >frames.yaml ;;
    bodies)
        printf '%s\noutput: {frames: 2, still: 0.01 s, rows: 3, contacts: 2, paths: [wall0-0]}\n' "$bodies" \
            >bodies.yaml ;;
    lanes)
        printf 'label: one\n%s\noutput: {frames: 2, still: 0.01 s, rows: 3}\n---\nlabel: two\n%s\n' "$bodies" \
            'contact: {mu: 0.1}' >lanes.yaml ;;
    contact) write_contact >contact.yaml ;;
    patch)
        printf 'kind: patch\nbodies: %s\nmu: 0.3\nelements: 16\nLambda: 4.5\n%s\n%s\n' \
            '{R1: 10 mm, R2: 10 mm, E: 70 GPa, nu: 0.3}' \
            "$(echo "$path" | sed 's/slide: 0.1 um/tangential: mu*P\/3/; s/slide: -0.3 um/tangential: -mu*P\/3/')" \
            'output: {frames: 2, snapshots: 2}' >patch.yaml ;;
    sweep)
        printf 'kind: sweep\nbase: biaxial.yaml\nseeds: [3]\nvary: {contact.mu_r: [0, 0.5]}\n%s\n' \
            'compare: {key: contact.mu_r, to: 0}' >sweep.yaml ;;
    replay)
        sed 's/k_n: 160 MPa/normal: hertz-line, E_star: 400 MPa, k_t: 180 MPa, k_r: 80 MPa/
            s/rows: 4/&, path_rows: 4, curves: no/' biaxial.yaml >hertz.yaml ;;
    measures | card | sizes) mkdir out ;;
    esac
}

# prepare SCENE: all that stands before the command in $work/SCENE/start, and what an undisturbed one leaves in want.
prepare() {
    at=$work/$1
    mkdir -p "$at/start" && cd "$at/start" || exit 1
    write_inputs "$1"
    case $1 in
    resumed) # a full disk has stopped it
        "$programs/calls" 150 ENOSPC "$work/count" "$trundle" run tables.yaml -o out --checkpoint 0 >"$at/said" 2>&1
        [ -e out/checkpoint.bin ] || { echo "not ok $1: no checkpoint to begin with"; return 1; } ;;
    replaced) quietly run biaxial.yaml -o out --set seed=4 ;;
    sampled) quietly run biaxial.yaml -o first --sample packing.bin ;;
    replay) quietly run hertz.yaml -o run ;;
    measures) quietly measures -o card.csv ;;
    esac
    rm -f stdout stderr
    cp -r "$at/start" "$at/want" && cd "$at/want" || exit 1
    # shellcheck disable=SC2046 # a command line
    "$trundle" $(field "$1" 3) >stdout 2>stderr </dev/null && return
    echo "not ok $1: without a fault:"
    cat stderr
    return 1
}
quietly() { "$trundle" "$@" >"$at/said" 2>&1 || cat "$at/said"; }

# ---- one fault ----
bad() {
    echo "not ok $scene, $fault $number: $*"
    sed 's/^/# /' stderr 2>/dev/null | head -8
    exit 1
}
# What may differ from run to run: times.
plain() {
    case $1 in
    */summary.json) sed '/"timing"/,/}/d' "$1" ;;
    */trundle-files.txt) # what is listed in the end
        awk '/^-/ { delete listed[substr($0, 2)]; next } !/^#/ && NF { listed[$0] = 1 }
             END { for (name in listed) print name }' "$1" | sort ;;
    *.png) head -c 33 "$1" ;; # ISA-L now and then takes another match of the same length; the film has the pixels
    */stdout) sed '/^wall time/d' "$1" ;;
    */sizes.csv) sed 's/,.*//' "$1" ;;
    */verify.csv) sed 's/,[^,]*,ok,/,ok,/' "$1" ;;
    *) cat "$1" ;;
    esac | case $scene in bench | sizes) sed 's/[0-9.e+-]*//g; s/  *//g' ;; *) cat ;; esac
}
files() { (cd "$1" && find . -type f ! -name stdout ! -name stderr ! -name log | sort); }
# same FILE...: here as in want, all but times
same() {
    for file; do
        [ "$(plain "./$file" | cksum)" = "$(plain "$want/$file" | cksum)" ] || { odd=$file; return 1; }
    done
}
# The same files with the same bytes.
complete() {
    odd=$(files . | diff - "$work/$scene.files" | tr '\n' ' ')
    # shellcheck disable=SC2046 # names without spaces
    [ -z "$odd" ] && same $(cat "$work/$scene.files")
}
# execute FAULT
execute() {
    # shellcheck disable=SC2086 # a command line
    case $1 in
    memory) timeout -s KILL 20 env FAULT_AT="$number" FAULT_WHERE=where LD_PRELOAD="$programs/memory.so" "$trundle" $line ;;
    none) timeout -s KILL 20 "$trundle" $line ;;
    *) timeout -s KILL 20 "$programs/calls" "$number" "$1" count "$trundle" $line ;;
    esac >stdout 2>stderr </dev/null
    code=$?
    [ ! -e where ] || mv where "$here.where"
    rm -f count
}
# Cairo does not survive each of its own allocations: it may end a run by a signal, or leave something out of a picture.
in_cairo() { grep -qs 'libcairo\|libfreetype\|libpixman' "$here.where"; }
# What stands in a directory of results and is on no list of it, nor of the one above.
unlisted() {
    for file in $(cd out && find . -type f ! -name 'trundle-files.txt*' ! -path './samples/*' | sed 's|^\./||'); do
        name=${file%.part} name=${name%.old}
        grep -qxF "$name" out/trundle-files.txt && continue
        grep -qxF "${name#*/}" "out/${name%%/*}/trundle-files.txt" 2>/dev/null || echo "$file"
    done
}
# one SCENE FAULT NUMBER
one() {
    scene=$1 fault=$2 number=$3 want=$work/$1/want line=$(field "$1" 3)
    here=$work/$scene.$fault.$number
    cp -r "$work/$scene/start" "$here" && cd "$here" || exit 1
    execute "$fault"
    case $code in
    0 | 3) ;;
    1) grep -q '^libgomp: ' stderr || bad "exit code 1" ;; # which ends the program by itself
    134 | 139) in_cairo || bad "exit code $code" ;;
    137) bad 'hangs' ;;
    *) bad "exit code $code" ;;
    esac
    if [ "$code" -eq 0 ]; then
        complete || in_cairo || grep '^note: ' stderr | grep -qvxFf "$want/stderr" || bad "exit code 0, and no word of $odd"
        [ "$fault" = short ] || same stdout || bad 'exit code 0, and not all is said'
    else
        grep -q 'error: \|^libgomp: \|: .*memory\|cannot' stderr || in_cairo || bad 'no message'
        [ "$fault" != memory ] || in_cairo || [ -z "$(find . -name '*.part')" ] ||
            bad "a part is left: $(find . -name '*.part')"
    fi
    for file in $(cd "$work/$scene/start" && find . -type f ! -path './out/*'); do
        cmp -s "$file" "$work/$scene/start/$file" || bad "$file is not as it was"
    done
    case $line in run* | sweep*) [ ! -d out ] || [ -z "$(unlisted)" ] || bad "not on the list: $(unlisted)" ;; esac
    [ "$code" -eq 3 ] && [ ! -e out ] || again # nothing was begun
    rm -rf "$here" "$here.where"
}
# The same command, without a fault.
again() {
    if cmp -s out/summary.json "$work/$scene/start/out/summary.json"; then
        diff -r out "$work/$scene/start/out" >stdout || bad 'the run before is no longer whole'
        return # it was not touched, and the rest would be as without a fault
    fi
    case $line in
    run*) line="$(echo "$line" | sed 's/ --force//; s/ --resume//') --resume" ;;
    esac
    first=$(cat stderr)
    execute none
    printf '%s\n-- then:\n' "$first" | cat - stderr >both && mv both stderr
    [ "$code" -eq 0 ] || bad "afterwards: exit code $code"
    complete || bad "afterwards: not as without a fault: $odd"
}

# ---- all of them ----
campaign() {
    scene=$1
    prepare "$scene" || { failed=1; return; }
    files "$work/$scene/want" >"$work/$scene.files"
    case $(field "$scene" 2)$traced in both0) faults='memory ENOSPC EIO EINTR short' ;; *) faults=memory ;; esac
    for fault in $faults; do
        rm -rf "$work/counted" && cp -r "$work/$scene/start" "$work/counted" && cd "$work/counted" || exit 1
        line=$(field "$scene" 3) number=0
        # shellcheck disable=SC2086 # a command line
        case $fault in
        memory) timeout -s KILL 60 env FAULT_COUNT="$work/count" LD_PRELOAD="$programs/memory.so" "$trundle" $line ;;
        *) timeout -s KILL 60 "$programs/calls" 0 "$fault" "$work/count" "$trundle" $line ;;
        esac >"$work/said" 2>&1 </dev/null
        n=$(cat "$work/count")
        begin=$(((n + $(echo "$scene $fault" | wc -c)) % stride + 1)) # not the same in each
        seq "$begin" "$stride" "$n" >"$work/numbers"
        xargs -r -P 2 -n 1 sh "$self" --one "$trundle" "$programs" "$scene" "$fault" <"$work/numbers" >"$work/bad"
        cat "$work/bad"
        tested=$(wc -l <"$work/numbers") wrong=$(grep -c '^not ok' "$work/bad")
        echo "$scene, $fault: $tested of $n, $wrong wrong"
        total=$((total + tested)) failed=$((failed + wrong))
    done
    rm -rf "$work/$scene" "$work/$scene".*
}

if [ "$mode" = --one ]; then
    one "$4" "$5" "$6"
    exit
fi
write_programs "$work/bin"
PATH=$work/bin:$PATH
total=0 failed=0
"$programs/calls" 0 EIO "$work/count" /bin/true
traced=$? # 77: not to be had here
[ $traced -eq 0 ] || echo 'skipped: system calls that fail, for one program may not trace another here'
for scene in ${*:-$(echo "$scenes" | cut -d '|' -f 1)}; do campaign "$scene"; done
echo "$total faults, $failed wrong"
[ "$failed" -eq 0 ]
