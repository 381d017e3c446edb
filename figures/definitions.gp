# SPDX-License-Identifier: MIT
# Rolling velocities by author over the pure motions, and the energy of a spring on each. Data: definitions.sh.
set datafile separator ','
array name[7] = ['wang', 'bagi-kuhn', 'alonso-min', 'alonso-mean', 'tordesillas', 'kuhn', 'conjugate-spring of bagi-kuhn']
array color[7] = ['#7f4a90', '#00714f', '#7fbf9f', '#d08aa8', '#a89a00', '#c9a0d0', '#000000']
# Where curves coincide, each is narrower than the one below it.
array width[7] = [14, 9, 5.5, 2.5, 3, 3.5, 3.5]
array dash[7] = [1, 1, 1, 1, 1, 2, 3]
of(motion, i) = strcol(1) eq motion && strcol(2) eq name[i] ? column(4) : NaN

set multiplot layout 2,2 margins 0.095,0.985,0.175,0.95 spacing 0.125,0.105
set logscale x
set xrange [0.098:10.2]
set xtics ('1/10' 0.1, '1/5' 0.2, '1/2' 0.5, '1' 1, '2' 2, '5' 5, '10' 10)
set grid linecolor '#d0d0d0'
set title offset 0,-0.6

set title 'rolling like gears'
set ylabel 'V_r / rim speed' offset 1
set yrange [-1.5:1.5]
unset key
set label 1 '+ : with rigid rotation added' at 0.13,0.25
set label 2 '○ : rigid rotation alone' at 0.13,-0.27
plot for [i = 1:7] csv using 3:(of('PR', i)) with lines linewidth width[i] linecolor rgb color[i] dashtype dash[i], \
    for [i = 1:6] csv using 3:(of('PR + RBR', i)) with points pointtype 1 linecolor rgb '#404040' notitle, \
    for [i = 1:6] csv using 3:(of('RBR', i)) with points pointtype 6 linecolor rgb '#404040' notitle

set title 'sliding without relative spin'
set ylabel 'V_r / sliding speed' offset 1
set yrange [-0.6:0.6]
set label 1 'bagi-kuhn' at 0.13,0.48 textcolor rgb color[2]
set label 2 'kuhn' at 0.13,-0.48 textcolor rgb color[6]
set label 3 'all others' at 0.13,0.08
plot for [i = 1:6] csv using 3:(of('PS', i)) with lines linewidth width[i] linecolor rgb color[i] dashtype dash[i], \
    for [i = 1:6] csv using 3:(of('PS + RBR', i)) with points pointtype 1 linecolor rgb '#404040'
unset label

set xlabel 'R_2/R_1' offset 0,0.5
set title 'cycle: slide, spin 1, slide back, spin back'
set ylabel 'energy made / k_r R_{eff} Δu Δθ_1' offset 1,-0.3
set yrange [-0.6:1.1]
set label 1 '○ : (R_2 − R_1)/(2|X_{21}|)' at 0.13,0.8
set samples 21
plot for [i = 1:7] csv using 3:(of('slide and spin', i)) with lines linewidth width[i] linecolor rgb color[i] \
        dashtype dash[i], (x - 1)/(2*(x + 1)) with points pointtype 6 linecolor rgb '#404040'

set title 'cycle: spin 1, roll, spin back, roll back'
set ylabel 'energy made / k_r R_1 Δθ_1 u_{roll}' offset 1
set label 1 'alonso, both' at 0.13,0.8 textcolor rgb color[3]
plot for [i = 1:7] csv using 3:(of('spin and roll', i)) with lines linewidth width[i] linecolor rgb color[i] \
    dashtype dash[i]
unset label
unset title
unset xlabel
unset ylabel
unset tics
unset border
unset logscale
set lmargin at screen 0.01
set rmargin at screen 0.99
set bmargin at screen 0.005
set tmargin at screen 0.095
set key center center horizontal reverse Left samplen 2 spacing 1.1
plot [0:1] [0:1] for [i = 1:7] NaN with lines linewidth width[i] linecolor rgb color[i] dashtype dash[i] \
    title (i == 7 ? 'conjugate bagi-kuhn' : name[i]).(i == 5 ? " × R_{min}/2" : "")
unset multiplot
