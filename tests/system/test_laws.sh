#!/bin/sh
# SPDX-License-Identifier: MIT
# What is written of laws and definitions outside of the registries: the tables in src/README.md name those that there
# are. A file
# of a law that the registry lacks is told.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"

only_in_first() {
    "$1" | sort -u >"$work/first"
    "$2" | sort -u | comm -23 "$work/first" -
}
laws() { "$TRUNDLE" laws | sed -n 's/^  \([a-z-]*\) .*/\1/p'; }
laws_in_readme() { sed -n 's/^| \(normal\|friction\|rolling\|friction, rolling\) | `\([a-z-]*\)`[ (].*/\2/p' src/README.md; }
definitions() {
    "$TRUNDLE" run figures/definitions.yaml --check --set laws.0.rolling_velocity=no-such 2>&1 |
        sed -n 's/.*allowed is //p' | tr '|' '\n' | tr -d ' '
}
definitions_in_readme() { sed -n '/^| `rolling_velocity` |/,/^$/s/^| \(`[a-z].*`\) | [^V].*/\1/p' src/README.md | grep -oE '[a-z-]{2,}'; }

check 'there are laws' test "$(laws | wc -l)" -gt 10
check 'and rows of them' test "$(laws_in_readme | wc -l)" -gt 10
check 'src/README.md has no row of a law that is gone' is_silent only_in_first laws_in_readme laws
check 'there are definitions' test "$(definitions | wc -l)" -ge 4
check 'and rows of them' test "$(definitions_in_readme | wc -l)" -ge 4
check 'src/README.md has no row of a definition that is gone' is_silent only_in_first definitions_in_readme definitions
for law in $(laws | sort -u); do
    check "trundle laws $law tells its claims" \
        sh -c '"$0" laws "$1" | grep -q "claims, at the default options"' "$TRUNDLE" "$law"
done

told() { "$TRUNDLE" laws "$@" >"$work/told" 2>"$work/stderr"; }
check 'the same law in another code' told wang-spring --in yade --radii 0.02,0.01
check 'its coefficients' grep -qx '    k_r = 4.5 alphaKr k_s' "$work/told"
check 'its bound' grep -qx '    mu_r = 1.5 etaRoll' "$work/told"
check 'its release' grep -q 'YADE 2023.02a' "$work/told"
check 'without radii: of three ratios' told wang-spring --in yade
check 'are told' grep -qx '    k_r = c alphaKr k_s, c = 4, 4.5, 12.1 at R1/R2 = 1, 2, 10' "$work/told"
check 'a law that was not measured there' not told kuhn-creep --in lammps
check 'says which were' grep -q 'kuhn-creep was not measured in lammps; measured are wang-spring in lammps,' "$work/stderr"
check 'a code that is not known' not told wang-spring --in esys
check 'radii that are none' not told wang-spring --in yade --radii 1
check 'radii without a code' not told wang-spring --radii 1,2

# Every file of a law is in the registry; law_template.c is not called after a slot.
forgotten() {
    for file in src/laws/normal_*.c src/laws/friction_*.c src/laws/rolling_*.c; do
        name=$(basename "$file" .c)
        grep -q "^const tr_law tr_$name = " "$file" || continue
        grep -q "X($name)" src/laws/laws.c || echo "$file: laws.c has no row X($name)"
    done
}
check 'no file of a law is forgotten' is_silent forgotten
finish
