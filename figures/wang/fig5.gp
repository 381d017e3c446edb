# SPDX-License-Identifier: MIT
# Strength against mu_r: above as it is, below less that of wang on the same samples.
csv = dir.'/strength/collect.csv'
array quantity[2] = ['sin_phi_residual', 'sin_phi_peak']
array words[2] = ['residual, mean over 15–20 % strain', 'peak']
unset key
set multiplot layout 2,2 columnsfirst title caption font ',16' margins 0.115,0.985,0.1,0.9 spacing 0.13,0.05
set xrange [-0.05:2.05]
do for [k = 1:2] {
    unset xlabel
    set format x ''
    set ylabel 'sin φ' offset 0.3
    set yrange [0.15:0.85]
    set title words[k]
    if (k == 2) { set key bottom right samplen 1.5 spacing 1.1 opaque }
    plot for [m = 1:4] csv using ($1 + aside(m)):(pick(m, quantity[k], '', $6)):8:9 with yerrorlines linewidth 2 \
        pointtype mark[m] pointsize 1.2 linecolor rgb color[m] title name[m]
    unset title
    unset key
    set format x '%g'
    set xlabel 'coefficient of rolling resistance μ_r' offset 0,0.4
    set ylabel 'sin φ less that of Wang' offset 0.3
    set yrange [-0.05:0.05]
    plot 0 with lines linewidth 1.5 linecolor rgb '#000000', \
        for [m = 2:4] csv using ($1 + aside(m)):(pick(m, quantity[k], wang, $6)):8:9 with yerrorbars linewidth 2 \
        pointtype mark[m] pointsize 1.2 linecolor rgb color[m]
}
unset multiplot
