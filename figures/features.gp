# SPDX-License-Identifier: MIT
# What a feature and what a law costs, per touching contact and step. Data: trundle bench --features (make features).
set datafile separator ','
stats csv skip 1 using 3 nooutput
n = STATS_records
stats csv skip 1 using (strcol(1) eq 'feature' ? $3 : NaN) nooutput
features = STATS_records
longest = STATS_max
stats csv skip 1 using ($0 == 2 ? $3 : NaN) nooutput # the scene in which the laws stand: the third
base = STATS_max
color(group) = group eq 'normal' ? 0x0072b2 : group eq 'friction' ? 0xcc3311 : group eq 'rolling' ? 0x009e73 : 0x5e3c99
cost(x) = sprintf(x < 99.5 ? '%.1f' : '%.0f', x)

set multiplot
set lmargin at screen 0.37
set rmargin at screen 0.975
set grid xtics linetype 1 linecolor '#d8d8d8'
set border 3
set tics nomirror
unset key
unset ytics
set style fill solid 1 noborder
set bars 0.6

# One at a time: the darker end of a bar is what its feature adds.
before = 0
added(x) = (from = before, before = x, from)
set tmargin at screen 0.945
set bmargin at screen 0.605
set xrange [0:1.25*longest]
set title 'features, one at a time' offset 0,-0.6
set yrange [features - 0.4:-0.6]
plot csv skip 1 every ::0::features - 1 using (0):0:(0):3:($0 - 0.36):($0 + 0.36) with boxxyerror fillcolor rgb '#c9bfdc', \
    '' skip 1 every ::0::features - 1 using (0):0:(added($3)):3:($0 - 0.36):($0 + 0.36) with boxxyerror fillcolor rgb '#5e3c99', \
    '' skip 1 every ::0::features - 1 using 3:0:4:5 with xerrorbars pointtype 0 linewidth 2 linecolor rgb '#000000', \
    '' skip 1 every ::0::features - 1 using 5:0:(' '.cost($3)) with labels left offset 0.5,0, \
    '' skip 1 every ::0::features - 1 using (0):0:2 with labels right offset -1,0

# Another law in its slot: a factor, so a logarithmic axis, from the scene that all of them differ from.
laws = n - features
set tmargin at screen 0.5
set bmargin at screen 0.1
set logscale x
set xrange [0.8*base:150*base]
set yrange [laws - 0.4:-0.6]
set xtics (10, 20, 50, 100, 200, 500, 1000, 2000)
set title 'another law in the scene of the third bar (grey line)'
set xlabel 'ns per touching contact and step (logarithmic)' offset 0,0.4
set arrow 1 from base, graph 0 to base, graph 1 nohead linewidth 2 linecolor '#808080' front
plot csv skip 1 every ::features using (base):0:(base):3:($0 - 0.36):($0 + 0.36):(color(strcol(1))) with boxxyerror fillcolor rgb variable, \
    '' skip 1 every ::features using 3:0:4:5 with xerrorbars pointtype 0 linewidth 2 linecolor rgb '#000000', \
    '' skip 1 every ::features using 5:0:(' '.cost($3)) with labels left offset 0.5,0, \
    '' skip 1 every ::features using (0.8*base):0:(strcol(1).':  '.strcol(2)) with labels right offset -1,0
unset multiplot
