#!/bin/sh
# SPDX-License-Identifier: MIT
# Kuhn's assemblies [Kuhn2014 sec. 3.2] in the plane: small and large contacts, with and without creep, on disks and on
# spheres that move in the plane; his tables, a verdict on each trend and reason, and the picture.
#
#     figures/kuhn/kuhn.sh TRUNDLE DIR [DISKS [SPHERES]]
#
# 4096, Kuhn's number, and 1000 by default; spheres, whose contacts are harder, go to 30 % strain. Started again it does
# what is missing.
set -eu
export LC_ALL=C
trundle=$1 out=$2 disks=${3:-4096} spheres=${4:-1000}
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$out"

# run NAME SHAPE SIZE [SETTING ...]: SHAPE-SIZE.bin is the packing. E* of the small contacts is that of the case.
run() {
    name=$1 case=$here/../../cases/kuhn-$2.yaml sample=$out/$2-$3.bin
    n=$disks
    case $2 in spheres) n=$spheres ;; esac
    case $2-$3 in
    disks-large) set -- "$@" "contact.E_star=95*compaction.pressure" ;;
    spheres-small) set -- "$@" contact.nu=0.15 shear.strain_end=0.3 output.rows=300 ;;
    spheres-large) set -- "$@" 'contact.E_star=540*compaction.pressure/(1 mm)' contact.nu=0.34 step.safety=0.6 shear.strain_end=0.3 output.rows=300 ;;
    esac
    case $3 in small) set -- "$@" compaction.inertial_number=3e-2 ;; esac
    shift 3
    for setting; do set -- "$@" --set "$setting" && shift; done
    "$trundle" run "$case" -o "$out/$name" --resume --sample "$sample" --set sample.disks="$n" "$@" >"$out/$name.said" ||
        { [ $? -eq 4 ] && [ -s "$out/$name/history.csv" ]; } # one that breaks down has come so far
}

# Two at a time, one on each of two processors: both NAME ... -- NAME ...
both() {
    first=
    while [ "$1" != -- ]; do first="$first '$1'" && shift; done
    shift
    eval "run $first" &
    job=$!
    failed=
    run "$@" || failed=$?
    wait "$job" || failed=$?
    return ${failed:-0}
}

# Each size has its packing from its first run.
for shape in disks spheres; do
    for law in cattaneo-mindlin kuhn-creep; do
        both $shape-large-$law $shape large contact.friction=$law -- $shape-small-$law $shape small contact.friction=$law
    done
done
without=contact.friction=cattaneo-mindlin
# The third reason: strength against the coefficient of friction; the large contacts, which are quick.
both mu-0.1 disks large $without contact.mu=0.1 -- mu-0.2 disks large $without contact.mu=0.2
both mu-0.3 disks large $without contact.mu=0.3 -- mu-0.8 disks large $without contact.mu=0.8
# Is the answer that of slow tests, and of which interval?
both slow-cattaneo-mindlin disks large $without shear.inertial_number=1e-3 -- \
    fast-cattaneo-mindlin disks large $without shear.inertial_number=1e-2
both interval-long disks large $without output.rows=101 -- interval-short disks large $without output.rows=2501

"$here/tables.sh" "$out"
