# SPDX-License-Identifier: MIT
# Moment against rotation of all rolling laws. Data: rolling-laws.sh.
set datafile separator ','
array name[6] = ['wang-spring', 'conjugate-spring of bagi-kuhn', 'star-displacement-damping', 'star-displacement-damping with dashpot', \
    'star-constant-torque', 'star-force-proportional']
array color[6] = ['#7f4a90', '#d08aa8', '#000000', '#7fbf9f', '#00714f', '#a89a00']
# Where curves coincide, each is narrower than the one below it.
array width[6] = [10, 5.5, 2.5, 2.5, 2.5, 2.5]
array dash[6] = [1, 1, 2, 1, 1, 1]
moment(force, i) = strcol(1) eq force && strcol(2) eq name[i] ? -column(5) : NaN

set multiplot layout 2,1 margins 0.095,0.985,0.215,0.945 spacing 0.11
set grid linecolor '#d0d0d0'
set title offset 0,-0.6
set xrange [-6.2:6.2]
set ylabel 'resisting moment (N)' offset 1
unset key

set title 'normal force 10 kN/m'
set yrange [-12:12]
plot for [i = 1:6] csv using ($3*180/pi):(moment('constant', i)) with lines linewidth width[i] \
    linecolor rgb color[i] dashtype dash[i]

set title 'normal force 10 kN/m, rising to 20 on the way back, then falling to 5'
set xlabel 'relative rotation θ_1 − θ_2 (degrees)' offset 0,0.5
set yrange [-22:22]
plot for [i = 1:6] csv using ($3*180/pi):(moment('changing', i)) with lines linewidth width[i] \
    linecolor rgb color[i] dashtype dash[i]

unset title
unset xlabel
unset ylabel
unset tics
unset border
set lmargin at screen 0.01
set rmargin at screen 0.99
set bmargin at screen 0.005
set tmargin at screen 0.125
set key center center horizontal reverse Left samplen 2 spacing 1.1
plot [0:1] [0:1] for [i = 1:6] NaN with lines linewidth width[i] linecolor rgb color[i] dashtype dash[i] title i == 4 ? 'the same with dashpot' : name[i]
unset multiplot
