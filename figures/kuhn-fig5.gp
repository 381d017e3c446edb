# SPDX-License-Identifier: MIT
# Kuhn's Fig. 5a and 5b. Data: kuhn-fig5.sh.
set datafile separator ','
array ratio[8] = ['0', '1', '10', '30', '100', '300', '1000', 'inf']
array color[8] = ['#000000', '#882255', '#a3195b', '#a89a00', '#a89a00', '#00714f', '#7f4a90', '#999999']
array dash[8] = [1, 2, 1, 1, 1, 1, 1, 1]
q(panel, i) = strcol(1) eq panel && strcol(2) eq ratio[i] ? column(5) : NaN

set multiplot layout 2,1 margins 0.095,0.985,0.225,0.985 spacing 0.125
set grid linecolor '#d0d0d0'
set yrange [0:1.05]
set ylabel 'Q / μP' offset 1
unset key

set label 1 'a' at graph 0.97,0.12 font ',28'
set xrange [0:3]
set xlabel 'sliding u_{disp} / ζ' offset 0,0.5
plot for [i = 1:8] csv using 3:(q('a', i)) with lines linewidth 3.5 linecolor rgb color[i] dashtype dash[i]

set label 1 'b'
set xrange [0:12]
set xlabel 'rolling u_{roll} / a' offset 0,0.5
plot for [i = 1:8] csv using 4:(q('b', i)) with lines linewidth 3.5 linecolor rgb color[i] dashtype dash[i]

unset label
unset xlabel
unset ylabel
unset tics
unset border
set lmargin at screen 0.01
set rmargin at screen 0.99
set bmargin at screen 0.005
set tmargin at screen 0.12
set key center center horizontal maxrows 2 reverse Left samplen 2 spacing 1.2
plot [0:1] [0:1] for [i = 1:8] NaN with lines linewidth 3.5 linecolor rgb color[i] dashtype dash[i] \
    title '1/ξ = '.(ratio[i] eq 'inf' ? '∞' : ratio[i])
unset multiplot
