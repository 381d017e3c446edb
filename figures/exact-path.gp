# SPDX-License-Identifier: MIT
# Friction laws and the exact contact along one path, and their errors. Data: exact-path.sh.
set datafile separator ','
array name[6] = ['exact', 'coulomb-spring', 'cattaneo-mindlin', 'vu-quoc-zhang', 'kuhn-creep', 'dahlberg-alfredsson']
array color[6] = ['#000000', '#999999', '#a89a00', '#7fbf9f', '#7f4a90', '#a3195b']
array width[6] = [7, 3.5, 3.5, 3.5, 3.5, 3.5]
of(i, value) = strcol(1) eq name[i] ? value : NaN
array end[9] = [0, 100, 230, 310, 460, 610, 760, 860, 960]
array what[8] = ['slide', 'back', 'slide', 'roll', "slide\nand roll", "both\nback", "slide,\nP to 2 P_0", "P to\nP_0/2"]

set multiplot layout 2,1 margins 0.105,0.985,0.155,0.985 spacing 0.04
set grid ytics linecolor '#d0d0d0'
set xrange [0:960]
do for [k = 2:8] {set arrow k from end[k], graph 0 to end[k], graph 1 nohead linecolor '#bbbbbb' back}
unset key
unset xtics

do for [k = 1:8] {set label k what[k] at (end[k] + end[k + 1])/2, 2.3 center font ',17'}
set yrange [-1.25:2.6]
set ytics 1
set ylabel 'Q / μP_0' offset 1
plot csv using 2:(of(2, $4)) with filledcurves y1=0 fillcolor '#f2f2f2', \
    csv using 2:(of(2, -$4)) with filledcurves y1=0 fillcolor '#f2f2f2', \
    for [i = 1:6] csv using 2:(of(i, $5)) with lines linewidth width[i] linecolor rgb color[i]

unset label
set yrange [-0.42:0.28]
set ytics 0.1
set ylabel '(Q − Q_{exact}) / μP_0' offset 1
set xlabel 'along the path'
plot for [i = 1:6] csv using 2:(of(i, $6)) with lines linewidth (i == 1 ? 4 : 3.5) linecolor rgb color[i]

unset arrow
unset xlabel
unset ylabel
unset tics
unset border
set lmargin at screen 0.01
set rmargin at screen 0.99
set bmargin at screen 0.005
set tmargin at screen 0.1
set key center center horizontal maxrows 2 reverse Left samplen 2 spacing 1.2
plot [0:1] [0:1] for [i = 1:6] NaN with lines linewidth width[i] linecolor rgb color[i] title name[i]
unset multiplot
