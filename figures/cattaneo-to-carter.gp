# SPDX-License-Identifier: MIT
# From Cattaneo to Carter: traction inside the contact, and the distance left. Data: cattaneo-to-carter.sh.
set datafile separator ','
array roll[6] = ['0', '0.25', '0.5', '1', '2', '4']
array color[6] = ['#000000', '#5e3c99', '#00714f', '#7fbf9f', '#a89a00', '#a3195b']
array push[3] = [0.3, 0.6, 0.9]
array shade[3] = ['#a89a00', '#000000', '#5e3c99']
traction(i) = strcol(1) eq 'traction' && strcol(3) eq roll[i] ? $5 : NaN

set multiplot
set lmargin at screen 0.105
set rmargin at screen 0.985
set tmargin at screen 0.915
set bmargin at screen 0.525
set grid linecolor '#d0d0d0'
set xrange [-1:1]
set yrange [0:1.05]
set xtics 0.5
set ytics 0.2
set ylabel 'traction τ / μp_0' offset 1
set xlabel 'x / a' offset 0,0.5
set key at screen 0.545,0.963 center center horizontal maxrows 1 Left reverse samplen 1.3 width -1
set samples 400
plot sqrt(1 - x*x) with filledcurves y1=0 fillcolor '#f2f2f2' notitle, \
    for [i = 1:6] csv using 4:(traction(i)) with lines linewidth (i == 6 ? 7 : 3.5) linecolor rgb color[i] title (i == 1 ? 'L / a = 0' : roll[i]), \
    csv using 4:(strcol(1) eq 'carter' ? $5 : NaN) with lines linewidth 3 linecolor rgb '#000000' dashtype (8, 6) title 'Carter'

set tmargin at screen 0.41
set bmargin at screen 0.105
set xrange [0:4]
set xtics 0.5
set logscale y
set yrange [0.002:1.2]
set ytics ('100 %%' 1, '30 %%' 0.3, '10 %%' 0.1, '3 %%' 0.03, '1 %%' 0.01, '0.3 %%' 0.003)
set ylabel 'distance left to Carter' offset 1
set xlabel 'rolled L / a' offset 0,0.5
set key at graph 0.985,0.95 right top vertical maxrows auto Right noreverse width 0 samplen 2 title 'Q / μP' right
plot for [i = 1:3] csv using 3:(strcol(1) eq 'distance' && $2 == push[i] ? $5 : NaN) with lines linewidth 3.5 \
    linecolor rgb shade[i] title sprintf('%.1f', push[i])
unset multiplot
