# SPDX-License-Identifier: MIT
# Means over the seeds with the 95 % interval of the mean. Variables: dir, seeds.
set datafile separator ','
array color[3] = ['#7f4a90', '#00714f', '#7fbf9f']
array name[3] = ['spring (no creep)', "creep, Wang's rolling", "creep, Kuhn's rolling"]
array width[3] = [7, 4, 2]
block(m, k) = 2*(k - 1) + m - 1 # of curves.csv: by friction, then by mu_r
csv = dir.'/curves.csv'
set grid linecolor '#d0d0d0'
set multiplot layout 2,1 margins 0.1,0.985,0.1,0.95 spacing 0.03
set xrange [0:20]
set yrange [0:0.8]
set ylabel 'sin φ' offset 0.5
set format x ''
set key top right samplen 1.5 opaque
set label 1 'with contact moment, μ_r = 0.5' at first 3.2,0.73 left
set label 2 'no contact moment' at first 3.2,0.2 left
plot for [m = 1:2] for [k = 1:3] csv index block(m, k) using (100*$3):($4 - $5):($4 + $5) with filledcurves notitle \
        fillcolor rgb color[k] fillstyle transparent solid 0.2 noborder, \
    for [m = 1:2] for [k = 1:3] csv index block(m, k) using (100*$3):4 with lines linewidth width[k] linecolor rgb color[k] \
        title (m == 1 ? name[k] : '')
unset label
unset key
set format x '%g'
set xlabel 'axial strain [%]' offset 0,0.4
set ylabel 'void ratio e'
set yrange [0.19:*]
plot for [m = 1:2] for [k = 1:3] csv index block(m, k) using (100*$3):($6 - $7):($6 + $7) with filledcurves notitle \
        fillcolor rgb color[k] fillstyle transparent solid 0.2 noborder, \
    for [m = 1:2] for [k = 1:3] csv index block(m, k) using (100*$3):6 with lines linewidth width[k] linecolor rgb color[k]
unset multiplot
