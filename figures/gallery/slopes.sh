#!/bin/sh
# SPDX-License-Identifier: MIT
# The slope of cases/incline.yaml with another law of rolling resistance: its case, with the thresholds of that law.
# usage: figures/gallery/slopes.sh NAME >CASE    figures/gallery/slopes.sh --list
# A law holds up to tan(alpha) = HOLDS mu_r and rolls up to 3 mu - SLIPS mu_r; FORCE: the part of mu_r that is a force along the floor.
set -eu
here=$(dirname "$0")
list='incline-bagi-kuhn incline-star-force incline-star-torque incline-star-damping'
extra='' force='' title_en='' title_de='' equation=''
case ${1:-} in
--list) echo "$list"; exit ;;
incline-bagi-kuhn)
    law=conjugate-spring holds='' slips=/2 force=/2 extra=', rolling_velocity: bagi-kuhn'
    title_en='A slope: resistance to the flow of material' title_de='Ein Hang: Widerstand gegen den Fluss des Materials'
    equation='V_r = (s_1 + s_2)\/2   [Wang eqs. 16, 19a]' ;;
incline-star-force)
    law=star-force-proportional holds='' slips=2
    title_en='A slope: moment proportional to the force' title_de='Ein Hang: Moment proportional zur Kraft'
    equation='M = −μ_r f_n |r_c| sgn ω   [STAR-CCM+ eq. 3275]' ;;
incline-star-torque)
    law=star-constant-torque holds=2 slips=4
    title_en='A slope: constant torque' title_de='Ein Hang: konstantes Moment'
    equation='M_1 = −μ_r R_eq f_n sgn(ω_1 − ω_2), R_eq = 2R   [STAR-CCM+ eq. 3276]' ;;
incline-star-damping)
    law=star-displacement-damping holds=2 slips=4 extra=', theta_max: 0.001 deg, damping: yes, damping_multiplier: 0'
    title_en='A slope: displacement damping' title_de='Ein Hang: Dämpfung des Wegs'
    equation='M_k = −k_r ∫(ω_1 − ω_2) dt, |M_k| ≤ μ_r R_eq f_n   [STAR-CCM+ eq. 3277]' ;;
*) echo "which law? $list" >&2; exit 2 ;;
esac
case $slips in
/2) key='contact.mu_r\/2' word='μ_r\/2' ;;
*) key="$slips*contact.mu_r" word="${slips}μ_r" ;;
esac
[ -z "$force" ] || force='s/contact\.mu\*gravity\.y/(contact.mu + contact.mu_r\/2)*gravity.y/'
sed -e "s/rolling: wang-spring, mu_r: 0.1/rolling: $law$extra, mu_r: 0.1/" \
    -e "s/- 2\\*contact\\.mu_r/- $key/g" -e "s/3μ − 2μ_r/3μ − $word/g" \
    -e "s/atan(contact\\.mu_r)/atan(${holds:+$holds*}contact.mu_r)/g" -e "s/tan α = μ_r/tan α = ${holds}μ_r/g" \
    -e "s/+ contact\\.mu_r\\*gravity/+ ${holds:+$holds*}contact.mu_r*gravity/g" -e "$force" \
    -e "s/title: \"A disk on a slope.*/title: \"$title_en\"/" -e "s/title: \"Eine Scheibe am Hang.*/title: \"$title_de\"/" \
    -e "s/equation: .*/equation: \"$equation\"/" -e '/^# /d; /^#$/d' "$here/../../cases/incline.yaml" | cat -s
