# SPDX-License-Identifier: MIT
# Residual void ratio against mu_r: above as it is, below less that of wang on the same samples, in percent of what wang
# has in the mean.
csv = dir.'/strength/collect.csv'
set multiplot layout 2,1 title caption font ',16' margins 0.1,0.985,0.1,0.93 spacing 0.05
set xrange [-0.05:2.05]
set format x ''
set ylabel 'residual void ratio e' offset 0.5
set yrange [0.2:0.33]
set key at graph 0.98,0.55 samplen 1.5 spacing 1.1 opaque
stats csv using (strcol(3) eq 'e0' ? $6 : NaN) nooutput
e0 = STATS_mean
plot e0 with lines dashtype 2 linewidth 2 linecolor rgb '#777777' title sprintf('at the start, %.3f', e0), \
    for [m = 1:4] csv using ($1 + aside(m)):(pick(m, 'e_residual', '', $6)):8:9 with yerrorlines linewidth 2 \
    pointtype mark[m] pointsize 1.2 linecolor rgb color[m] title name[m]
stats csv using (pick(1, 'e_residual', '', $6)) nooutput
e_wang = STATS_mean
set format x '%g'
set xlabel 'coefficient of rolling resistance μ_r' offset 0,0.4
set ylabel 'e less that of Wang (%)'
set yrange [-7:5]
set key default
set key bottom right samplen 1.5
plot 0 with lines linewidth 1.5 linecolor rgb '#000000' notitle, \
    -4 with lines dashtype 3 linewidth 3 linecolor rgb '#a3195b' title 'the paper: model 2 about 4 % lower', \
    for [m = 2:4] csv using ($1 + aside(m)):(pick(m, 'e_residual', wang, 100*$6/e_wang)):(100*$8/e_wang):(100*$9/e_wang) \
    with yerrorbars linewidth 2 pointtype mark[m] pointsize 1.2 linecolor rgb color[m] notitle
unset multiplot
