# SPDX-License-Identifier: MIT
# Friction force of all friction laws along one path. Data: friction-laws.sh.
set datafile separator ','
array name[5] = ['coulomb-spring', 'dahlberg-alfredsson', 'cattaneo-mindlin', 'kuhn-creep', 'vu-quoc-zhang']
array color[5] = ['#999999', '#00714f', '#000000', '#7f4a90', '#7fbf9f']
array width[5] = [7, 3.5, 3.5, 3.5, 2.5]
array dash[5] = [1, 1, 2, 1, 1]
Q(shape, i, P) = strcol(1) eq shape && strcol(2) eq name[i] ? $6/P : NaN
bound(shape, P) = strcol(1) eq shape && strcol(2) eq 'coulomb-spring' ? $5/P : NaN
array end[9] = [0, 100, 230, 310, 460, 610, 760, 860, 960]
array what[8] = ['slide', 'back', 'slide', 'roll', "slide\nand roll", "both\nback", "slide,\nP to 2 P_0", "P to\nP_0/2"]

set multiplot layout 2,1 margins 0.095,0.985,0.155,0.985 spacing 0.07
set grid ytics linecolor '#d0d0d0'
set xrange [0:960]
set yrange [-1.25:2.6]
set ytics 1
set xtics format ''
do for [k = 2:8] {set arrow k from end[k], graph 0 to end[k], graph 1 nohead linecolor '#bbbbbb' back}
do for [k = 1:8] {set label k what[k] at (end[k] + end[k + 1])/2, 2.3 center font ',17'}
set for [k = 2:9] xtics (end[k] - 1)
unset xtics
set ylabel 'disks: Q / μP_0' offset 1
unset key
plot csv using 3:(bound('disk', 1e4)) with filledcurves y1=0 fillcolor '#f2f2f2', \
    csv using 3:(-bound('disk', 1e4)) with filledcurves y1=0 fillcolor '#f2f2f2', \
    for [i = 1:5] csv using 3:(Q('disk', i, 1e4)) with lines linewidth width[i] linecolor rgb color[i] dashtype dash[i]
set ylabel 'spheres: Q / μP_0' offset 1
set xlabel 'along the path'
plot csv using 3:(bound('sphere', 100)) with filledcurves y1=0 fillcolor '#f2f2f2', \
    csv using 3:(-bound('sphere', 100)) with filledcurves y1=0 fillcolor '#f2f2f2', \
    for [i = 1:5] csv using 3:(Q('sphere', i, 100)) with lines linewidth width[i] linecolor rgb color[i] dashtype dash[i]

unset label
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
plot [0:1] [0:1] for [i = 1:5] NaN with lines linewidth width[i] linecolor rgb color[i] dashtype dash[i] title name[i], \
    NaN with filledcurves fillcolor '#e0e0e0' title 'within ±μP'
unset multiplot
