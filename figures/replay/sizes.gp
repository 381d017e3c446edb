# SPDX-License-Identifier: MIT
# Does the ranking of the friction laws depend on the size of the contact? Errors on the paths of three runs. dir: of
# replay.sh.
set datafile separator ','
array name[5] = ['coulomb-spring', 'cattaneo-mindlin', 'vu-quoc-zhang', 'kuhn-creep', 'dahlberg-alfredsson']
array color[5] = ['#999999', '#a89a00', '#7fbf9f', '#7f4a90', '#a3195b']
array run[3] = ['small', 'walled', 'large']
x(n, i) = n + 0.16*(i - 3)
least = 1e-4 # what is below it is drawn there
up(v) = v > least ? v : least
file(n) = dir.'/'.run[n].'/replay-errors.csv'
is(what, by, end, i) = strcol(1) eq what && strcol(2) eq name[i] && strcol(3) eq by && strcol(5) eq end

set multiplot layout 2,2 margins 0.1,0.985,0.14,0.95 spacing 0.085,0.13
unset key
set grid ytics linecolor '#d0d0d0'
set xrange [0.5:3.5]
set xtics ("a/R = 0.7 %%" 1, "2 %%, walls" 2, "10 %%" 3)
set tics scale 0.5
set boxwidth 0.13
set logscale y
set yrange [least:2.5]
set format y '10^{%T}'

do for [panel = 1:3] {
    what = panel < 3 ? 'force' : 'energy'
    by = panel == 2 ? 'rolled_a' : 'all'
    set title panel == 1 ? 'force, all instants' : panel == 2 ? 'force, contacts that have rolled more than 3 a' : 'energy, all contacts'
    set ylabel panel == 1 ? '|Q − Q_{exact}| / μP' : panel == 3 ? '|W − W_{exact}| / ∫μP |du_{slide}|' : '' offset 1
    plot for [n = 1:3] for [i = 1:5] file(n) using (is(what, by, 'inf', i) ? x(n, i) : NaN):(up($9)):(up($9)):(up($12)):(up($11)) \
             with candlesticks fillstyle solid 0.75 noborder linecolor rgb color[i] linewidth 1.5, \
         for [n = 1:3] for [i = 1:5] file(n) using (is(what, by, 'inf', i) ? x(n, i) : NaN):(up($9)) with points pointtype 5 pointsize 0.7 linecolor rgb '#000000'
}

# Means of the two halves of the strain: a bar from one to the other.
unset logscale y
set format y '%g'
set yrange [*:*]
set title 'strength: 0 to 10 % strain (dot), 10 to 20 % (bar)'
set ylabel 'sin φ − sin φ_{exact}' offset 1
set xzeroaxis linetype -1
of(n, i) = strcol(1) eq run[n] && strcol(2) eq name[i]
plot for [n = 1:3] for [i = 1:5] dir.'/tables.csv' using (of(n, i) ? x(n, i) : NaN):11 with boxes fillstyle solid 0.75 noborder linecolor rgb color[i], \
     for [n = 1:3] for [i = 1:5] dir.'/tables.csv' using (of(n, i) ? x(n, i) : NaN):10 with points pointtype 7 pointsize 1 linecolor rgb '#000000'

unset title
unset xlabel
unset ylabel
unset tics
unset border
unset xzeroaxis
set lmargin at screen 0.01
set rmargin at screen 0.99
set bmargin at screen 0.005
set tmargin at screen 0.07
set key center center horizontal maxrows 2 reverse Left samplen 2 spacing 1.2
plot [0:1] [0:1] for [i = 1:5] NaN with lines linewidth 6 linecolor rgb color[i] title name[i]
unset multiplot
