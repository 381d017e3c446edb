#!/bin/sh
# SPDX-License-Identifier: MIT
# The card in LIGGGHTS, gran model hooke/stiffness with rolling_friction epsd2, whose rolling spring has the stiffness kt.
# usage: liggghts.sh CARD.csv ANSWERS.csv, in an empty directory. Prints the release.
here=$(dirname "$(realpath "$0")")
# shellcheck source=tests/interop/card.sh
. "$here/card.sh"

solve() {
    model='hooke/stiffness tangential history rolling_friction epsd2' settings='absolute_damping on tangential_damping off'
    stiffness=$k_roll friction=0.0
    [ "$2" = slide ] && model='hooke/stiffness tangential history' stiffness=$k_t friction=$mu
    cat >"in.$1" <<END
units si
dimension 2
atom_style granular
atom_modify map array
boundary f f p
newton off
communicate single vel yes
read_data $1.data
hard_particles yes
fix m1 all property/global kn peratomtypepair 1 $k_n
fix m2 all property/global kt peratomtypepair 1 $stiffness
fix m3 all property/global gamman_abs peratomtypepair 1 0.0
fix m4 all property/global gammat_abs peratomtypepair 1 0.0
fix m5 all property/global coefficientFriction peratomtypepair 1 $friction
fix m6 all property/global coefficientRollingFriction peratomtypepair 1 $mu_r
pair_style gran model $model $settings
pair_coeff * *
$([ "$3" = 0 ] || echo "fix floor all wall/gran model $model primitive type 1 yplane $floor $settings")
neighbor 0.001 bin
neigh_modify delay 0
timestep $dt
dump d all custom $steps $1.atoms id fx fy tqz
dump_modify d format "%d %.17g %.17g %.17g" sort id
run $steps
END
    liggghts -in "in.$1" -log "log.$1" -screen none
}
ask "$(liggghts -h 2>&1 | sed -n 's/.*Version \(LIGGGHTS-PUBLIC\) \([0-9.]*\),.*/\1 \2/p')"
