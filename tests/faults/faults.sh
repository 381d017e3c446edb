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
trundle=$(realpath "$1") programs=$(realpath "$2") stride=${3:-1} here=$(realpath "$(dirname "$0")")
[ $# -lt 3 ] && shift $# || shift 3
work=$(mktemp -d -p /dev/shm 2>/dev/null || mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM

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
motions|memory|measures --card out/motions.csv
convert|memory|convert run --to vtk -o out
identify|memory|identify answers.csv -o out/found.csv
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
    for law in wang-spring conjugate-spring star-force-proportional star-constant-torque star-displacement-damping
    do
        case $law in
        *-spring) echo "  - {$spring, rolling: $law, mu_r: 0.1, k_r: 1 MPa}" ;;
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
    measures | card | motions | sizes) mkdir out ;;
    identify)
        mkdir out
        cp "$here/../interop/liggghts.csv" answers.csv ;;
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
    convert) quietly run biaxial.yaml -o run ;;
    measures) quietly measures -o card.csv ;;
    esac
    rm -f stdout stderr
    cp -r "$at/start" "$at/want" && cd "$at/want" && mkdir "$at/known" || exit 1
    # shellcheck disable=SC2046 # a command line
    "$trundle" $(field "$1" 3) >../want.stdout 2>../known.stderr </dev/null && return
    echo "not ok $1: without a fault:"
    cat ../known.stderr
    return 1
}
quietly() { "$trundle" "$@" >"$at/said" 2>&1 || cat "$at/said"; }

# ---- all of them ----
campaign() {
    scene=$1
    prepare "$scene" || { failed=$((failed + 1)); return; }
    line=$(field "$scene" 3)
    case $(field "$scene" 2)$traced in both0) faults='memory ENOSPC EIO EINTR short' ;; *) faults=memory ;; esac
    for fault in $faults; do
        rm -rf "$work/counted" && cp -r "$work/$scene/start" "$work/counted" && cd "$work/counted" || exit 1
        # shellcheck disable=SC2086 # a command line
        case $fault in
        memory) timeout -s KILL 60 env FAULT_COUNT="$work/count" LD_PRELOAD="$programs/memory.so" "$trundle" $line ;;
        *) timeout -s KILL 60 "$programs/calls" 0 "$fault" "$work/count" "$trundle" $line ;;
        esac >"$work/said" 2>&1 </dev/null
        n=$(cat "$work/count")
        begin=$(((n + $(echo "$scene $fault" | wc -c)) % stride + 1)) # not the same in each
        seq "$begin" "$stride" "$n" >"$work/numbers"
        xargs -r -P 2 -n 50 "$programs/one" "$programs" "$trundle" "$work" "$scene" "$fault" "$line" \
            <"$work/numbers" >"$work/said" || echo "not ok $scene, $fault: not judged" >>"$work/said"
        grep -v '^in Cairo' "$work/said"
        tested=$(wc -l <"$work/numbers") wrong=$(grep -c '^not ok' "$work/said")
        killed=$((killed + $(grep -c '^in Cairo, signal' "$work/said")))
        pixels=$((pixels + $(grep -c '^in Cairo, pixels' "$work/said")))
        echo "$scene, $fault: $tested of $n, $wrong wrong"
        total=$((total + tested)) failed=$((failed + wrong))
    done
    rm -rf "${work:?}/$scene"
}

write_programs "$work/bin"
PATH=$work/bin:$PATH
total=0 failed=0 killed=0 pixels=0
"$programs/calls" 0 EIO "$work/count" /bin/true
traced=$? # 77: not to be had here
[ $traced -eq 0 ] || echo 'skipped: system calls that fail, for one program may not trace another here'
for scene in ${*:-$(echo "$scenes" | cut -d '|' -f 1)}; do campaign "$scene"; done
echo "$total faults, $failed wrong; Cairo: $killed ended by a signal, $pixels with wrong pixels"
[ "$failed" -eq 0 ]
