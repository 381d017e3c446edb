# SPDX-License-Identifier: MIT
# What other codes compute: a rigid rotation, and YADE's factors. Data: other-codes.sh.
set datafile separator ','
set multiplot layout 2,1 margins 0.115,0.98,0.1,0.95 spacing 0.17
set grid linecolor '#d0d0d0'
set title offset 0,-0.3
set key top left reverse Left
row(kind, n) = strcol(1) eq kind ? column(n) : NaN

set title 'a rigid rotation ω slides, R_1 = R_2 = R'
set xlabel 'overlap / R (%)'
set ylabel 'sliding velocity / (R ω)' offset 0.5
set xrange [0:10]
set yrange [-0.01:0.14]
plot csv using (100*row('rotation', 2)):3 with lines linewidth 4 linecolor '#7f4a90' title 'LAMMPS 29Sep2021', \
    csv using (100*row('rotation', 2)):4 with lines linewidth 7 linecolor '#7fbf9f' title 'LIGGGHTS 3.8.0', \
    csv using (100*row('rotation', 2)):5 with lines linewidth 3 dashtype 2 linecolor '#000000' title 'YADE 2023.02a'

set title "YADE's coefficients here"
set xlabel 'R_1/R_2'
set ylabel 'factor' offset 0.5
set xrange [1:10]
set yrange [0:14]
plot csv using (row('factor', 2)):3 with linespoints linewidth 4 pointtype 7 pointsize 1.3 linecolor '#00714f' title 'k_r/(alphaKr k_s)', \
    csv using (row('factor', 2)):4 with linespoints linewidth 4 pointtype 5 pointsize 1.3 linecolor '#000000' title 'mu_r/etaRoll'
unset multiplot
