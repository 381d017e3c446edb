# SPDX-License-Identifier: MIT
# Differences from wang with their intervals, beside the difference that so few seeds can detect. Data: collect.csv.
# Variables: csv, names, table.
pick(i, q, column) = strcol('contact.rolling_velocity') eq word(names, i) && strcol('quantity') eq q && strcol('minus') ne '' ? column : NaN
array quantity[3] = ['sin_phi_peak', 'sin_phi_residual', 'e_residual']
array said[3] = ['peak sin φ', 'residual sin φ', 'residual void ratio']
# The detectable difference, from the table
detectable(k) = real(system(sprintf("awk -F, -v q='%s' 'index($1, q) && $6 != \"\" {print $6; exit}' '%s'", said[k], table)))
set multiplot layout 1,3 margins 0.1,0.985,0.2,0.9 spacing 0.095
set xrange [0.5:words(names) - 0.5]
set xtics () rotate by 20 right
do for [i = 2:words(names)] { set xtics add (word(names, i) i - 1) }
set xzeroaxis linecolor '#404040'
unset key
do for [k = 1:3] {
    d = detectable(k)
    set title said[k]
    if (k == 1) { set ylabel 'less that of wang, 95 %' offset 0.5 } else { unset ylabel }
    set object 1 rectangle from graph 0, first -d to graph 1, first d behind fillcolor rgb '#e4e8ec' fillstyle solid noborder
    plot d with lines linecolor '#a0a8b0' dashtype 2, -d with lines linecolor '#a0a8b0' dashtype 2, \
        for [i = 2:words(names)] csv using (i - 1):(pick(i, quantity[k], $5)):7:8 with yerrorbars linewidth 3 pointsize 2 \
        pointtype mark[(i - 1)%4 + 1] linecolor rgb colour(i)
}
unset multiplot
