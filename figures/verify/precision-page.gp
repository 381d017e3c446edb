# SPDX-License-Identifier: MIT
# Error against run time, all cases on one page: figures/precision.png. Data: points.csv of `trundle verify precision`.
# usage: gnuplot -e 'dir = "out/verify"' figures/verify/precision-page.gp
csv = dir.'/points.csv'
set datafile separator ','
names(n, where) = system("awk -F, 'NR > 1 && ".where." && !seen[$".n."]++ {gsub(/ /, \"~\", $".n."); print $".n."}' ".csv)
of(c, series, where) = sprintf("< awk -F, '$1 == \"%s\" && $2 == \"%s\" && $5 != \"\" && %s' %s", c, series, where, csv)
plain(name) = system("echo '".name."' | tr '~' ' '")
array color[8] = ['#000000', '#00714f', '#7f4a90', '#7fbf9f', '#d08aa8', '#a89a00', '#c9a0d0', '#999999']
array mark[8] = [7, 6, 8, 4, 12, 5, 10, 2]
cases = names("1", '$6 != "" && $1 != "biaxial"')
rows = (words(cases) + 1)/2
set terminal pngcairo size 1350,150 + 430*rows font "DejaVu Sans,15" enhanced rounded linewidth 1.5
set output dir.'/precision.png'
set multiplot layout rows,2 margins 0.08,0.98,0.3/(rows + 0.3),0.97 spacing 0.09,0.24/(rows + 0.3)
set logscale xy
set format '10^{%T}'
set grid linecolor '#d8d8d8'
set key bottom left reverse Left noenhanced samplen 1 font ',11' opaque box linecolor '#d8d8d8'
set xlabel 'wall time of a run (s)' offset 0,0.6
set arrow 1 from graph 0, first 1e-3 to graph 1, first 1e-3 nohead dashtype 3 linecolor '#606060'
do for [c in cases] {
    set ylabel (c.', error') offset 1
    all = names("2", '$1 == "'.c.'"')
    plot for [i = 1:words(all)] of(c, plain(word(all, i)), '1') using 6:5 \
             with linespoints pointtype mark[i] pointsize 1.1 linecolor rgb color[i] title plain(word(all, i)), \
         sprintf("< awk -F, '$1 == \"%s\" && $9' %s", c, csv) using 6:5 with points pointtype 6 pointsize 2.6 \
             linecolor rgb '#808080' title 'default step'
}
unset multiplot
