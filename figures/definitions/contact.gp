# SPDX-License-Identifier: MIT
# One contact on one path, by definition. Data: contact.awk. Variables: csv, names.
of(i, column) = strcol(3) eq word(names, i) ? column : NaN
set ylabel font ',17'
set multiplot layout 3,1 margins 0.125,0.98,0.16,0.915 spacing 0.035
set xrange [0:200]
set xtics 40
set format x ''
do for [k = 1:4] { set arrow k from 40*k, graph 0 to 40*k, graph 1 nohead linecolor '#808080' }
array part[5] = ['slide', 'roll like gears', 'spin disk 1', 'roll back', 'slide and roll']
do for [k = 1:5] { set label k part[k] at 40*k - 20, graph 1.12 center }
unset key
set ylabel "\nT (N/m)"
set yrange [-12:12]
plot for [i = 1:words(names)] csv using 1:(of(i, $4)) with lines linewidth width[(i - 1)%4 + 1] linecolor rgb colour(i)
do for [k = 1:5] { unset label k }
set yrange [-75:75]
set ylabel "moment on 1 (mN),\nthe paper's"
plot for [i = 1:words(names)] csv using 1:(of(i, 1000*$5)) with lines linewidth width[(i - 1)%4 + 1] linecolor rgb colour(i)
set ylabel "moment on 1 (mN),\nconjugate"
set format x '%g'
set xlabel 'step' offset 0,0.5
set key at screen 0.5,0.03 center horizontal reverse Left samplen 2
plot for [i = 1:words(names)] csv using 1:(of(i, 1000*$7)) with lines linewidth width[(i - 1)%4 + 1] linecolor rgb colour(i) \
    title word(names, i)
unset multiplot
