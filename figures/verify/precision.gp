# SPDX-License-Identifier: MIT
# Error against run time, a diagram for each case, and a summary. Data: points.csv of `trundle verify precision`.
# usage: gnuplot -e 'dir = "out/verify"' figures/verify/precision.gp
csv = dir.'/points.csv'
set datafile separator ','
names(n, where) = system("awk -F, 'NR > 1 && ".where." && !seen[$".n."]++ {gsub(/ /, \"~\", $".n."); print $".n."}' ".csv)
of(c, series, where) = sprintf("< awk -F, '$1 == \"%s\" && $2 == \"%s\" && $5 != \"\" && %s' %s", c, series, where, csv)
plain(name) = system("echo '".name."' | tr '~' ' '")
array color[8] = ['#000000', '#00714f', '#7f4a90', '#7fbf9f', '#d08aa8', '#a89a00', '#c9a0d0', '#999999']
array mark[8] = [7, 6, 8, 4, 12, 5, 10, 2]
color_of(i) = color[(i - 1)%8 + 1] # a ninth series has the first color again, with another mark
mark_of(i) = mark[(i - 1 + (i - 1)/8)%8 + 1]
cases = names("1", '$6 != ""') # the points of `stability` have no time

do for [k = 1:2] {
    if (k == 1) {set terminal svg size 900,620 font "DejaVu Sans,17" enhanced rounded background "#ffffff"} \
    else {set terminal pngcairo size 1350,930 font "DejaVu Sans,20" enhanced rounded linewidth 1.5}
    ending = k == 1 ? '.svg' : '.png'
    set logscale xy
    set format '10^{%T}'
    set grid linecolor '#d8d8d8'
    set key outside top center horizontal maxcols 3 noenhanced samplen 1.5
    set xlabel 'wall time of a run [s]: median and quartiles'
    set arrow 1 from graph 0, first 1e-3 to graph 1, first 1e-3 nohead dashtype 3 linecolor '#606060'
    do for [c in cases] {
        set output dir.'/precision-'.c.ending
        set ylabel (c eq 'biaxial' ? 'half-width of the 95 % interval / mean [1]' : c.': error [1]')
        all = names("2", '$1 == "'.c.'"')
        plot for [i = 1:words(all)] of(c, plain(word(all, i)), '1') using 6:5:7:8 \
                 with xerrorbars pointtype mark_of(i) pointsize 1.3 linecolor rgb color_of(i) notitle, \
             for [i = 1:words(all)] of(c, plain(word(all, i)), '1') using 6:5 \
                 with linespoints pointtype mark_of(i) pointsize 1.3 linecolor rgb color_of(i) title plain(word(all, i)), \
              sprintf("< awk -F, '$1 == \"%s\" && $9' %s", c, csv) using 6:5 with points pointtype 6 pointsize 3 linecolor rgb '#808080' \
                 title 'default step'
    }
    unset arrow 1
    unset key
    if (k == 1) {set terminal svg size 900,1000 font "DejaVu Sans,14" enhanced rounded background "#ffffff"} \
    else {set terminal pngcairo size 1350,1500 font "DejaVu Sans,17" enhanced rounded linewidth 1.5}
    set output dir.'/precision-summary'.ending
    table = '< awk -f figures/verify/precision.awk '.csv
    set multiplot layout 1,2 margins 0.33,0.97,0.075,0.985 spacing 0.06
    unset logscale y
    rows = int(system(sprintf("awk -f figures/verify/precision.awk %s | wc -l", csv))) - 1
    set yrange [rows - 0.3:-0.7]
    set ytics scale 0
    unset ylabel
    set xlabel "error at the default step [1]\n(dotted: 10^{-3})"
    set arrow 1 from 1e-3, graph 0 to 1e-3, graph 1 nohead dashtype 3 linecolor '#606060'
    set format y '%s'
    plot table using 3:1:ytic(2) with points pointtype 7 linecolor rgb '#7f4a90'
    unset arrow 1
    set format y ''
    set xlabel "wall time to an error of 10^{-3} [s]\n(open: at most; none: not reached)"
    plot table using 4:1:5:6 with xerrorbars pointtype 7 linecolor rgb '#00714f', \
         table using 7:1 with points pointtype 6 linecolor rgb '#00714f'
    unset multiplot
    set yrange [*:*]
    set ytics scale default autofreq
}
