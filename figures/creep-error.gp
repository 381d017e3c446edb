# SPDX-License-Identifier: MIT
# Largest error of a force law at constant creepage from rest. Data: creep-error.sh.
set datafile separator ','
set datafile missing NaN # rows of other curves do not break a line
row(l) = l < 2 ? 0 : l - 1
cell(value) = strcol(2) eq 'all' ? NaN : value
all(value) = strcol(2) eq 'all' ? value : NaN

set multiplot
set xrange [0:1.6]
set yrange [-0.5:5.5]
set xtics 0.1,0.2,1.5 scale 0
set ytics ('1.5' 0, '2' 1, '3' 2, '4' 3, '5' 4, '6' 5) scale 0
set cbrange [0:30]
set palette defined (0 '#ffffff', 1 '#e3d3e8', 3 '#b08bbb', 6 '#7f4a90', 10 '#3f1250')
unset colorbox
unset key
set xlabel 'creepage ξ / F_0' offset 0,0.6
set tmargin at screen 0.945
set bmargin at screen 0.545
set title offset 0,-0.6

set title 'Dahlberg-Alfredsson, k = k_0 (% of μP)'
set ylabel 'Λ = ln(2d/a)' offset 1.5
set lmargin at screen 0.075
set rmargin at screen 0.49
plot csv using 2:(row($1)):(0.1):(0.5):(cell(100*$3)) with boxxyerror fillstyle solid 1 noborder fillcolor palette, \
    csv using 2:(row($1)):(cell(1) == 1 ? sprintf('%.1f', 100*$3) : '') with labels font ',18'

set title 'brush (% of μP)'
unset ylabel
set lmargin at screen 0.57
set rmargin at screen 0.99
plot csv using 2:(row($1)):(0.1):(0.5):(cell(100*$4)) with boxxyerror fillstyle solid 1 noborder fillcolor palette, \
    csv using 2:(row($1)):(cell(1) == 1 ? sprintf('%.0f', 100*$4) : ''):(100*$4 > 15 ? 0xffffff : 0) with labels font ',18' \
    textcolor rgb variable

set grid linecolor '#d0d0d0'
set tmargin at screen 0.4
set bmargin at screen 0.1
set xlabel 'Λ = ln(2d/a)' offset 0,0.4
set xrange [1.4:6.1]
set xtics 1 scale default

set title 'worst of all creepages (% of μP)'
set lmargin at screen 0.075
set rmargin at screen 0.49
set yrange [0:8]
set ytics autofreq 2 scale default
set key top right samplen 2 spacing 1.2
plot csv using 1:(all(100*$3)) with linespoints linewidth 3.5 pointtype 7 linecolor rgb '#a3195b' title 'k = k_0', \
    csv using 1:(all(100*$5)) with linespoints linewidth 3.5 pointtype 7 linecolor rgb '#7f4a90' title 'k for least error'

set title 'k / k_0 for the least error'
set lmargin at screen 0.57
set rmargin at screen 0.99
set yrange [1:1.4]
set ytics autofreq 0.1
at(creepage) = strcol(2) eq creepage ? $6 : NaN
plot csv using 1:(at('0.1')) with linespoints linewidth 3.5 pointtype 7 linecolor rgb '#a89a00' title 'ξ = 0.1 F_0', \
    csv using 1:(at('0.5')) with linespoints linewidth 3.5 pointtype 7 linecolor rgb '#7fbf9f' title 'ξ = 0.5 F_0', \
    csv using 1:(at('all')) with linespoints linewidth 3.5 pointtype 7 linecolor rgb '#7f4a90' title 'all creepages'
unset multiplot
