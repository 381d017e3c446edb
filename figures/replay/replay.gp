# SPDX-License-Identifier: MIT
# Error distribution of the friction laws on the paths of a biaxial test, and its stress with their forces. dir: the
# tables of trundle replay.
set datafile separator ','
set datafile columnheaders
array name[5] = ['coulomb-spring', 'cattaneo-mindlin', 'vu-quoc-zhang', 'kuhn-creep', 'dahlberg-alfredsson']
array color[5] = ['#999999', '#a89a00', '#7fbf9f', '#7f4a90', '#a3195b']
errors = dir.'/replay-errors.csv'
stress = dir.'/replay-stress.csv'
is(what, by, i) = strcol(1) eq what && strcol(2) eq name[i] && strcol(3) eq by
at_m(s) = s eq '0.2' ? 1 : s eq '0.4' ? 2 : s eq '0.6' ? 3 : s eq '0.8' ? 4 : s eq '0.99' ? 5 : 6
at_r(s) = s eq '0.03' ? 1 : s eq '0.1' ? 2 : s eq '0.3' ? 3 : s eq '1' ? 4 : s eq '3' ? 5 : 6
x(n, i) = n + 0.16*(i - 3)
least = 1e-4 # what is below it is drawn there
up(v) = v > least ? v : least

set multiplot layout 2,2 margins 0.1,0.985,0.17,0.95 spacing 0.085,0.125
unset key
set grid ytics linecolor '#d0d0d0'
set xrange [0.5:6.5]
set logscale y
set yrange [least:2.5]
set format y '10^{%T}'
set tics scale 0.5
set boxwidth 0.13

count(what) = system("awk -F, '$1 == \"".what."\" && $3 == \"all\" {print $6; exit}' '".errors."'")
set title 'force, '.count('force').' instants of contacts'
set ylabel '|Q − Q_{exact}| / μP' offset 1
set xtics ("<0.2" 1, "–0.4" 2, "–0.6" 3, "–0.8" 4, "–0.99" 5, "full slip" 6)
set xlabel 'mobilisation |Q_{exact}| / μP' offset 0,0.5
plot for [i = 1:5] errors using (is('force', 'mobilisation', i) ? x(at_m(strcol(5)), i) : NaN):(up($9)):(up($9)):(up($12)):(up($11)) \
         with candlesticks fillstyle solid 0.75 noborder linecolor rgb color[i] linewidth 1.5, \
     for [i = 1:5] errors using (is('force', 'mobilisation', i) ? x(at_m(strcol(5)), i) : NaN):(up($9)) with points pointtype 5 pointsize 0.7 linecolor rgb '#000000'

set title 'the same by rolled distance'
unset ylabel
set xtics ("<0.03" 1, "–0.1" 2, "–0.3" 3, "–1" 4, "–3" 5, ">3" 6)
set xlabel 'rolled so far, ∫|du_{roll}| / a' offset 0,0.5
plot for [i = 1:5] errors using (is('force', 'rolled_a', i) ? x(at_r(strcol(5)), i) : NaN):(up($9)):(up($9)):(up($12)):(up($11)) \
         with candlesticks fillstyle solid 0.75 noborder linecolor rgb color[i] linewidth 1.5, \
     for [i = 1:5] errors using (is('force', 'rolled_a', i) ? x(at_r(strcol(5)), i) : NaN):(up($9)) with points pointtype 5 pointsize 0.7 linecolor rgb '#000000'

set title 'energy, '.count('energy').' contacts'
set ylabel '|W − W_{exact}| / ∫μP |du_{slide}|' offset 1
set xlabel 'rolled in all, ∫|du_{roll}| / a' offset 0,0.5
plot for [i = 1:5] errors using (is('energy', 'rolled_a', i) ? x(at_r(strcol(5)), i) : NaN):(up($9)):(up($9)):(up($12)):(up($11)) \
         with candlesticks fillstyle solid 0.75 noborder linecolor rgb color[i] linewidth 1.5, \
     for [i = 1:5] errors using (is('energy', 'rolled_a', i) ? x(at_r(strcol(5)), i) : NaN):(up($9)) with points pointtype 5 pointsize 0.7 linecolor rgb '#000000'

unset logscale y
set format y '%g'
set yrange [*:*]
set xrange [0:20]
set xtics 5
set title 'strength with the forces of each law'
set ylabel 'sin φ − sin φ_{exact}' offset 1
set grid xtics
set xlabel 'axial strain, %' offset 0,0.5
bin(s) = s < 0.2 ? floor(s/0.01) + 0.5 : 19.5 # means over 1 % of strain
plot for [i = 1:5] stress using (bin(column('strain'))):(column('sin_phi_'.name[i]) - column('sin_phi_exact')) smooth unique \
         with lines linewidth 3.5 linecolor rgb color[i]

unset title
unset xlabel
unset ylabel
unset tics
unset border
set lmargin at screen 0.01
set rmargin at screen 0.99
set bmargin at screen 0.005
set tmargin at screen 0.07
set key center center horizontal maxrows 2 reverse Left samplen 2 spacing 1.2
plot [0:1] [0:1] for [i = 1:5] NaN with lines linewidth 6 linecolor rgb color[i] title name[i]
unset multiplot
