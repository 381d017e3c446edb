#!/bin/sh
# SPDX-License-Identifier: MIT
# Largest error of q = Q/mu P along the path, of the law of Dahlberg and Alfredsson and of the brush, against the exact
# half-plane, at constant creepage from rest; over creepage and Lambda = ln(2d/a). Stiffness of the law: k0 of the
# elastic contact, and the one that makes the error smallest, for this creepage and for all creepages (row `all`). CSV.
# usage: creep-error.sh TRUNDLE
set -eu
export LC_ALL=C
trundle=$1
case=${0%.sh}.yaml
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# follow CASE CREEPAGE [--set KEY=VALUE]
follow() {
    followed=$1 creepage=$2
    shift 2
    "$trundle" run "$followed" -o "$work/run" --force --set output.curves=no --set "path.0.slide=$creepage*0.3*a/R_star*roll" "$@" \
        >"$work/said" 2>&1 || { cat "$work/said" >&2; exit 1; }
}
ratios=$(seq 1 0.02 1.4) # k/k0, from 1
creepages=$(seq 0.1 0.2 1.5) # over F0
{
    cat "$case"
    for ratio in $ratios; do
        echo "  - {friction: dahlberg-alfredsson, step: exact, mu: 0.3, k_t: $ratio*pi*E_star/(2*bodies.Lambda)}"
    done
} >"$work/laws.yaml"
sed -e 's/kind: contact/kind: patch/; s/bodies:/mu: 0.3\nsolver: brush\nelements: 60\noutput: {frames: 0, snapshots: 0}\n&/; s/, Lambda: 4//; /^laws/,$d' \
    "$case" >"$work/brush.yaml"
for creepage in $creepages; do
    follow "$work/brush.yaml" "$creepage" # whatever Lambda
    cp "$work/run/contact.csv" "$work/brush-$creepage.csv"
done
for Lambda in 1.5 2 3 4 5 6; do
    for creepage in $creepages; do
        follow "$work/laws.yaml" "$creepage" --set "bodies.Lambda=$Lambda"
        # errors of this cell: brush, then each stiffness
        awk -F, -v cell="$Lambda $creepage" '
            !/^[0-9]/ {next}
            NR == FNR {q[-1, $2] = $8; next}
            {q[$1, $2] = $8; last = $1}
            END {
                for (law = -1; law <= last; law++) {
                    worst = 0
                    for (step = 1; (0, step) in q; step++) {
                        error = q[law, step] - q[0, step]
                        if (error < 0) error = -error
                        if (error > worst) worst = error
                    }
                    if (law) cell = cell " " worst
                }
                print cell
            }' "$work/brush-$creepage.csv" "$work/run/contact.csv"
    done
done | awk -v ratios="$ratios" '
    function row(creepage, error, best, i) {
        for (i = best = 1; i <= n; i++) if (error[i] < error[best]) best = i
        printf "%s,%s,%.6f,%.6f,%.6f,%s\n", Lambda, creepage, error[1], error[0], error[best], k[best]
    }
    function row_of_all() {
        row("all", all)
        delete all
    }
    BEGIN {
        n = split(ratios, k, "\n")
        print "Lambda,creepage_over_F0,dahlberg_k0,brush,dahlberg_best,k_over_k0_best"
    }
    NR > 1 && $1 != Lambda {row_of_all()}
    {
        Lambda = $1
        for (i = 0; i <= n; i++) {
            error[i] = $(i + 3)
            if (error[i] > all[i]) all[i] = error[i]
        }
        row($2, error)
    }
    END {row_of_all()}'
