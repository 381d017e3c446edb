#!/bin/sh
# SPDX-License-Identifier: MIT
# The card in LAMMPS, pair_style granular. Debian 12 has the release of 29 Sep 2021, before its granular package was rewritten in
# 2023. usage: lammps.sh CARD.csv ANSWERS.csv, in an empty directory. Prints the release.
here=$(dirname "$(realpath "$0")")
# shellcheck source=tests/interop/card.sh
. "$here/card.sh"

solve() {
    law="hooke $k_n 0 tangential linear_nohistory 0 0 rolling sds $k_roll 0 $mu_r damping velocity"
    [ "$2" = slide ] && law="hooke $k_n 0 tangential linear_history $k_t 0 $mu damping velocity"
    cat >"in.$1" <<END
units si
dimension 2
atom_style sphere
boundary f f p
newton off
comm_modify vel yes
read_data $1.data
pair_style granular
pair_coeff * * $law
$([ "$3" = 0 ] || echo "fix floor all wall/gran granular $law yplane $floor NULL")
neighbor 0.001 bin
timestep $dt
run $steps
write_dump all custom $1.atoms id fx fy tqz modify format float %.17g sort id
END
    lmp -in "in.$1" -log "log.$1" -screen none
}
ask "LAMMPS $(lmp -h | sed -n 's/^Large-scale.*Simulator - \([0-9]*\) \([A-Z][a-z]*\) \([0-9]*\).*/\1\2\3/p')"
