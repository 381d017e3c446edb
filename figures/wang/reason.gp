# SPDX-License-Identifier: MIT
# The paper's reason for the difference: contacts with s1 s2 < 0, where model 2 has no rolling resistance. And how much
# is rolled.
csv = dir.'/strength/collect.csv'
set multiplot layout 2,1 title caption font ',16' margins 0.1,0.985,0.1,0.93 spacing 0.05
set xrange [-0.05:2.05]
set format x ''
set ylabel 'contacts with s_1 s_2 < 0 (%)'
set yrange [0:100]
set key top right samplen 1.5 spacing 1.1 opaque
plot for [m = 1:4] csv using ($1 + aside(m)):(pick(m, 'opposed_fraction_residual', '', 100*$6)):(100*$8):(100*$9) \
    with yerrorlines linewidth 2 pointtype mark[m] pointsize 1.2 linecolor rgb color[m] title name[m]
set format x '%g'
set xlabel 'coefficient of rolling resistance μ_r' offset 0,0.4
set ylabel 'share of rolling, Σ|V_r| / Σ(|V_r| + |V_s|) (%)'
unset key
plot for [m = 1:4] csv using ($1 + aside(m)):(pick(m, 'rolling_share_residual', '', 100*$6)):(100*$8):(100*$9) \
    with yerrorlines linewidth 2 pointtype mark[m] pointsize 1.2 linecolor rgb color[m]
unset multiplot
