# SPDX-License-Identifier: MIT
# The time step of 1000 random networks: growth of their energy against dt over the exact limit, and where the bound of
# the tool is. Data: trundle verify stability -o out/verify.
#     gnuplot -e 'set output "out/verify/stability.png"; set terminal pngcairo size 1350,1080 font "DejaVu Sans,20" enhanced' \
#         figures/verify/stability.gp
if (!exists('csv')) csv = 'out/verify/points.csv'
set datafile separator ','
set datafile missing NaN # rows of other series do not break a curve
of(series, value) = strcol(1) eq 'time-step' && strcol(2) eq series ? value : NaN
worst(f) = f < 1 ? 1 : (f + sqrt(f**2 - 1))**4

set multiplot
set grid linecolor '#d0d0d0'
set lmargin at screen 0.11
set rmargin at screen 0.975
set xrange [0:2]
set xtics 0.25
set arrow 1 from 1, graph 0 to 1, graph 1 nohead linecolor rgb '#888888' linewidth 2 dashtype 2

set tmargin at screen 0.935
set bmargin at screen 0.40
set title 'Energy after a step / before, 1000 random networks of 2 to 12 disks' offset 0,-0.5
set logscale y
set yrange [0.5:400]
set format x ''
set ylabel 'growth of energy per step' offset 1
set key top left reverse Left samplen 2 spacing 1.2
set samples 801
plot worst(x) with lines linewidth 3 linecolor rgb '#000000' title '(f + √(f² − 1))⁴, f = dt/limit', \
    csv using 4:(of('undamped', $5)) with points pointtype 7 pointsize 0.9 linecolor rgb '#7f4a90' title 'no dashpots', \
    csv using 4:(of('damped', $5)) with points pointtype 6 pointsize 0.9 linewidth 1.5 linecolor rgb '#a3195b' title 'damping ratio 0 to 1'

unset logscale y
set tmargin at screen 0.33
set bmargin at screen 0.095
set title 'The limit that trundle takes, from single contacts'
set format x '%g'
set xlabel 'dt / exact limit of the network (eigenvalues)' offset 0,0.4
set ylabel 'networks' offset 1
set yrange [0:*]
unset key
width = 0.025
bin(x) = width*(floor(x/width - 1e-6) + 0.5)
set boxwidth width
plot csv using (bin(of('bound', $4))):(1.0) smooth frequency with boxes fillstyle solid 0.6 linecolor rgb '#7fbf9f'
unset multiplot
