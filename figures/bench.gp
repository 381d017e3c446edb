# SPDX-License-Identifier: MIT
# Cost of a step against the number of disks. Data: trundle bench --sizes (make bench).
set datafile separator ','
from = 1000 # the fit
stats csv skip 1 using ($1 >= from ? log($1) : NaN):(log($2)) name 'fit' nooutput
largest = exp(fit_max_x)

set multiplot
set lmargin at screen 0.12
set samples 500
set rmargin at screen 0.98
set grid linecolor '#d0d0d0'
set logscale x
set xrange [70:1.5*largest]
set format x '10^{%L}'
set bars 0.6

set tmargin at screen 0.96
set bmargin at screen 0.56
set logscale y
set format y '10^{%L}'
set ylabel 'time of a step (µs)' offset 0
set key top left Left reverse samplen 2
plot (x >= 0.99*from && x <= 1.01*largest ? exp(fit_intercept)*x**fit_slope : NaN) with lines linewidth 3 linecolor rgb '#a3195b' \
        title sprintf('N^{%.2f}, fitted from N = %d to %.0f', fit_slope, from, largest), \
    csv skip 1 using 1:2:3:4 with yerrorbars pointtype 7 linewidth 2 linecolor rgb '#7f4a90' title 'medians and quartiles'

set tmargin at screen 0.48
set bmargin at screen 0.11
unset logscale y
set format y '%g'
set yrange [0:*]
set ylabel 'per touching contact (ns)' offset -1
set xlabel 'disks N' offset 0,0.4
plot csv skip 1 using 1:5:6:7 with yerrorlines pointtype 7 linewidth 2 linecolor rgb '#7f4a90' title 'whole step', \
    csv skip 1 using 1:($5*$12) with linespoints pointtype 6 linewidth 2 linecolor rgb '#a89a00' title 'of it making lists'
unset multiplot
