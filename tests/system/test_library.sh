#!/bin/sh
# SPDX-License-Identifier: MIT
# The installed library: what it shows, and that the programs of tests/library/ are built against it and give the right
# numbers.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
root=$PWD there=$work/usr
unset MAKEFLAGS MAKELEVEL
case $BUILD in
*asan*)
    skip 'the library' 'a sanitizer belongs to the program, not to a library'
    finish ;;
esac
check 'make install' make --no-print-directory -s run-install TRUNDLE="$TRUNDLE" BUILD="$BUILD" PREFIX="$there" DESTDIR=
for file in bin/trundle include/trundle.h lib/libtrundle.a lib/libtrundle.so lib/libtrundle.so.0 lib/pkgconfig/trundle.pc share/trundle/cases/biaxial.yaml; do
    check "$file is there" test -s "$there/$file"
done
declared=$(grep -o 'trundle_[a-z_]*(' "$there/include/trundle.h" | tr -d '(' | sort -u)
check 'the header declares functions' test "$(echo "$declared" | wc -l)" -gt 20
check 'the shared library shows these names and no others' \
    equals "$(nm -D --defined-only "$there/lib/libtrundle.so" | awk '{print $3}' | sort)" "$declared"
# u: a constant of the C++ library, one for a whole program
check 'so does the archive' \
    equals "$(nm -g --defined-only "$there/lib/libtrundle.a" | awk 'NF == 3 && $2 != "u" {print $3}' | sort)" "$declared"
check 'the header stands alone, in C' \
    sh -c 'echo "#include <trundle.h>" | cc -std=c99 -Wall -Wextra -Wpedantic -Werror -fsyntax-only -I"$0/include" -x c -' "$there"
check 'and in C++' \
    sh -c 'echo "#include <trundle.h>" | c++ -Wall -Wextra -Werror -fsyntax-only -I"$0/include" -x c++ -' "$there"

PKG_CONFIG_PATH=$there/lib/pkgconfig
export PKG_CONFIG_PATH
# built PROGRAM FLAGS...
built() {
    program=$1
    shift
    cc -std=c17 -Wall -Wextra -Wpedantic -Werror -o "$work/$program" "$root/tests/library/$program.c" "$@" -lm
}
ran() { LD_LIBRARY_PATH=$there/lib "$work/$1" >"$work/$1.out"; }
for program in two_disks my_dem_loop; do
    # shellcheck disable=SC2046 # a command line
    check "$program is built with pkg-config" built $program $(pkg-config --cflags --libs trundle)
    check "$program runs" ran $program
    cp "$work/$program.out" "$work/$program.shared"
    # shellcheck disable=SC2046
    check "$program is built with the archive" \
        built $program -I"$there/include" "$there/lib/libtrundle.a" $(pkg-config --static --libs-only-l trundle | sed 's/-ltrundle//')
    check "$program runs with it" ran $program
    check "$program gives the same" cmp "$work/$program.out" "$work/$program.shared"
done
# The step is 1/100 of the bound; the end of an impact with a dashpot is of first order in it.
check 'two disks: the ratio of speeds is the closed form' \
    awk '{d = $1 - $2; exit !(d*d < 1e-8 && $2 > 0.7 && $2 < 0.8)}' "$work/two_disks.out"
# Its own loop and the library's world: sums in the same order, but for a factor 1/m.
check 'my loop: as the world of the library' \
    awk 'NR == 1 {split($0, a)} NR == 2 {for (i = 1; i <= 3; i++) {d = a[i] - $i; if (d*d > 4e-18) bad = 1}} END {exit bad || NR != 2}' "$work/my_dem_loop.out"
# Thrown without spin: friction takes a third of the speed until it rolls, and here rolling resistance a little more.
check 'and it rolls' \
    awk 'NR == 1 {v = $2; w = -0.1*$3; d = v - w; exit !(v > 0.55 && v < 2/3 && d*d < 1e-6)}' "$work/my_dem_loop.out"
finish
