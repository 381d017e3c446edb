# SPDX-License-Identifier: MIT
# Kuhn's Fig. 6 for disks, left; right, rolling over sliding of the contacts and the effect of creep, medians over an
# interval.
set datafile separator ','
set grid linecolor '#d0d0d0'
file(m, law) = dir.'/disks-'.word('large small', m).'-'.law.'/history.csv'
cm = 'cattaneo-mindlin'
creep = 'kuhn-creep'
array name[2] = ['large contacts, a/R = 10 %', 'small contacts, 0.74 %']
array color[2] = ['#7f4a90', '#00714f']
set multiplot layout 2,2 columnsfirst title caption font ',16' margins 0.11,0.985,0.1,0.93 spacing 0.13,0.04
set xrange [0:50]
set key top right samplen 2 spacing 1.05 opaque font ',16'
both = "plot for [m = 1:2] file(m, cm) every ::1 using (100*column('strain')):(column(c)) with lines linewidth 2 \
    linecolor rgb color[m] title name[m], for [m = 1:2] file(m, creep) every ::1 using (100*column('strain')):(column(c)) with lines \
    linewidth 1 dashtype 2 linecolor rgb '#000000' title m == 1 ? 'with creep' : ''"
above = "unset xlabel; set format x ''"
below = "set xlabel 'axial strain, %' offset 0,0.4; set format x '%g'; unset key"
@above
set ylabel '(σ_1 − σ_2)/p' offset 0.3
c = 'q_over_p'
@both
@below
set ylabel 'void ratio' offset 0.3
c = 'void_ratio'
@both
@above
set logscale y
set format y '%g'
set yrange [0.3:100]
set ylabel '|du^{roll}|/|du^{disp}|, median' offset 0.3
c = 'roll_over_slide_median'
@both
@below
set yrange [0.01:0.3]
set ylabel 'effect of creep, median' offset 0.3
plot for [m = 1:2] file(m, creep) every ::1 using (100*column('strain')):(column('creep_over_slide_median')) with lines linewidth 2 \
    linecolor rgb color[m]
unset multiplot
