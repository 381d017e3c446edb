# SPDX-License-Identifier: MIT
# The six differences of each number, with both intervals and the margin. Variables: dir.
set datafile separator ','
csv = dir.'/effects.csv'
array quantity[4] = ['peak sin φ', 'residual sin φ', 'dilatancy e − e0', 'rolling share']
# The verdicts of one number stand in the table in this order, with `together` between.
at(q) = strcol(1) eq q && strcol(2) ne 'together' ? place(strcol(2)) - (strcol(3) eq 'contact moment' || strcol(3) eq 'creep') : NaN
place(of) = of eq 'contact moment' ? 6 : of eq 'creep' ? 4 : 2
margin(q) = real(system(sprintf("awk -F, -v q='%s' '$1 == q {print $8; exit}' '%s'", q, csv)))
set grid xtics linecolor '#d0d0d0'
set multiplot layout 2,2 margins 0.29,0.98,0.11,0.94 spacing 0.05,0.16
set yrange [0.4:6.6]
set xtics nomirror
set offsets graph 0.05, graph 0.05, 0, 0
set xzeroaxis
unset key
do for [k = 1:4] {
    q = quantity[k]; m = margin(q)
    set title q
    if (k%2) {
        set ytics ('moment, no creep' 6, 'moment, with creep' 5, 'creep, no moment' 4, \
            'creep, with moment' 3, "Kuhn less Wang, no moment" 2, "Kuhn less Wang, with moment" 1)
    } else { set ytics ('' 1, '' 2, '' 3, '' 4, '' 5, '' 6) }
    if (k > 2) { set xlabel 'change' offset 0,0.4 } else { unset xlabel }
    set object 1 rectangle from first -m, graph 0 to first m, graph 1 behind fillcolor rgb '#e4e8ec' fillstyle solid noborder
    set arrow 1 from 0, graph 0 to 0, graph 1 nohead linecolor '#404040'
    plot csv using 5:(at(q)):($5 - $7):($5 + $7) with xerrorbars linewidth 1.5 pointtype 0 linecolor rgb '#0072b2', \
        csv using 5:(at(q)):($5 - $6):($5 + $6) with xerrorbars linewidth 5 pointtype 7 pointsize 1.6 linecolor rgb '#0072b2'
}
unset multiplot
