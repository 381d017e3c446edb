#!/bin/sh
# SPDX-License-Identifier: MIT
# The slopes from which a disk rolls and slips, as the tool finds them, for some coefficients of rolling resistance.
# usage: figures/gallery/map.sh TRUNDLE DIR >JSON    runs are in DIR
set -eu
trundle=$1 dir=$2
for mu_r in 0.02 0.05 0.1 0.15 0.2 0.25; do
    "$trundle" run "$(dirname "$0")/../../cases/incline.yaml" --frames 0 --set contact.mu_r=$mu_r -o "$dir/$mu_r" --force >/dev/null
    mu=$(sed -n 's/^  mu: \([0-9.]*\).*/\1/p' "$dir/$mu_r/case.yaml" | head -n 1)
    jq --argjson mu_r $mu_r --argjson mu "$mu" '(.checks | map(select(.what == "rolls-from"))[0].measured) as $rolls
        | (.checks | map(select(.what == "slips-from"))[0].measured) as $slips
        | {mu_r: $mu_r, mu: $mu, rolls: ($rolls | sin/cos), slips: ($slips | sin/cos)}' "$dir/$mu_r/summary.json"
done | jq -s .
