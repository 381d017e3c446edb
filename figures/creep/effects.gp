# SPDX-License-Identifier: MIT
# What creep changes: four differences of each number, with both intervals and the margin. Variables: dir.
set datafile separator ','
csv = dir.'/effects.csv'
array quantity[4] = ['peak sin φ', 'residual sin φ', 'dilatancy e − e0', 'rolling share']
# From top to bottom.
at(q) = strcol(1) ne q ? NaN : strcol(2) eq 'creep' ? (strcol(3) eq 'no contact moment' ? 4 : 3) : \
    strcol(2) eq "Kuhn's rolling less Wang's" ? (strcol(3) eq 'no contact moment' ? 2 : 1) : NaN
margin(q) = real(system(sprintf("awk -F, -v q='%s' '$1 == q {print $8; exit}' '%s'", q, csv)))
set grid xtics linecolor '#d0d0d0'
set multiplot layout 2,2 margins 0.26,0.97,0.11,0.94 spacing 0.06,0.17
set yrange [0.4:4.6]
set xtics nomirror
unset key
do for [k = 1:4] {
    q = quantity[k]; m = margin(q)
    set title q
    set xrange [-2.5*m:2.5*m]
    set xtics m
    if (k%2) {
        set ytics ("creep − none,\nμ_r = 0" 4, "creep − none,\nμ_r = 0.5" 3, "Kuhn − Wang,\nμ_r = 0" 2, "Kuhn − Wang,\nμ_r = 0.5" 1)
    } else { set ytics ('' 1, '' 2, '' 3, '' 4) }
    if (k > 2) { set xlabel 'change' offset 0,0.4 } else { unset xlabel }
    set object 1 rectangle from first -m, graph 0 to first m, graph 1 behind fillcolor rgb '#e4e8ec' fillstyle solid noborder
    set arrow 1 from 0, graph 0 to 0, graph 1 nohead linecolor '#404040'
    plot csv using 5:(at(q)):($5 - $7):($5 + $7) with xerrorbars linewidth 1.5 pointtype 0 linecolor rgb '#7f4a90', \
        csv using 5:(at(q)):($5 - $6):($5 + $6) with xerrorbars linewidth 5 pointtype 7 pointsize 1.6 linecolor rgb '#7f4a90'
}
unset multiplot
