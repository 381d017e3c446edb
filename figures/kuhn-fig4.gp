# SPDX-License-Identifier: MIT
# Kuhn's Fig. 4 with the exact half-plane in place of finite elements, and the difference. Data: kuhn-fig4.sh.
set datafile separator ','
set datafile missing NaN # rows of other curves do not break a line
array mu[4] = [0.1, 0.1, 0.3, 0.3]
array creepage[4] = [0.004, 0.001, 0.004, 0.001]
array color[4] = ['#a3195b', '#d08aa8', '#7f4a90', '#c9a0d0']
of(i, value) = $1 == mu[i] && $2 == creepage[i] ? value : NaN

set multiplot layout 2,1 margins 0.105,0.985,0.215,0.985 spacing 0.04
set grid linecolor '#d0d0d0'
set xrange [0:8]
set xtics 1 format ''
unset key

set ylabel 'Q / μP' offset 1
set yrange [0:1.05]
set ytics 0.2
plot for [i = 1:4] csv using 3:(of(i, $5)) with lines linewidth 3.5 linecolor rgb color[i], \
    for [i = 1:4] csv using 3:(of(i, $4)) with lines linewidth 3.5 linecolor rgb color[i] dashtype (8, 4)

set ylabel '(Q − Q_{exact}) / μP' offset 1
set xlabel 'rolling L / a' offset 0,0.5
set format x
set yrange [-0.035:0.005]
set ytics 0.01
plot for [i = 1:4] csv using 3:(of(i, $4 - $5)) with lines linewidth 3.5 linecolor rgb color[i]

unset xlabel
unset ylabel
unset tics
unset border
set lmargin at screen 0.01
set rmargin at screen 0.99
set bmargin at screen 0.005
set tmargin at screen 0.12
set key center center horizontal maxrows 2 reverse Left samplen 2.5 spacing 1.2
plot [0:1] [0:1] for [i = 1:4] NaN with lines linewidth 3.5 linecolor rgb color[i] \
    title sprintf('μ = %.1f, ξ = %.1f %%', mu[i], 100*creepage[i]), \
    NaN with lines linewidth 3.5 linecolor rgb '#000000' title 'exact', \
    NaN with lines linewidth 3.5 linecolor rgb '#000000' dashtype (8, 4) title 'Dahlberg-Alfredsson'
unset multiplot
