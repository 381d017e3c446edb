# SPDX-License-Identifier: MIT
# What the contacts of two assemblies do: large contacts above, small ones below; a column a field. film.sh gives the
# folders of the runs and of the tables of film.awk, the numbers of the instants from first to last, and picture, the
# format of their names.
#
# Columns are the factors of [Kuhn2014 eq. 17], effect of creep = F(|Q|/(mu P)) rolling/sliding with F as a/R; the last
# is their product.
n = last + 1 # rows of history.csv: the first is of the start
array size[2] = ['large', 'small']
array strain[2*n]; array sin_phi[2*n]; array W[2*n]; array H[2*n]; array a_over_R[2*n]; array used[2*n]; array roll[2*n]; array creep[2*n]
at(m, k) = (m - 1)*n + k + 1
set datafile separator ','
set table $none
do for [m = 1:2] {
    i(row) = at(m, int(row))
    history = runs.'/'.size[m].'/history.csv'
    plot history every ::::last using (strain[i($0)] = column('strain')):(sin_phi[i($0)] = column('sin_phi')), \
        '' every ::::last using (W[i($0)] = 1000*column('width_m')):(H[i($0)] = 1000*column('height_m')), \
        '' every ::::last using (a_over_R[i($0)] = column('a_over_R')):(used[i($0)] = column('mobilisation')), \
        '' every ::::last using (roll[i($0)] = column('roll_over_slide_median')):(creep[i($0)] = column('creep_over_slide_median'))
}
unset table
set datafile separator whitespace
set datafile missing '?'
unset key
unset border
unset xtics
unset ytics
set style fill solid 1 noborder
set palette defined (0 '#d9cbdd', 1 '#b08bbb', 2 '#7f4a90', 3 '#3f1250') # that of the frames
set size ratio -1
half = 0.5*(H[at(1, 0)] > H[at(2, 0)] ? H[at(1, 0)] : H[at(2, 0)]) + 1 # one scale: that of the highest cell
set yrange [-half:half]
set xrange [-1.24*half:1.24*half] # a panel is as wide
set cbtics scale 0 offset 0,0.6
array head[3] = ['friction  |Q| / μP', 'rolling / sliding', 'creep / sliding']
array lowest[3] = [0, -1, -2] # of the logarithms: those of quartiles, and a factor of 10
array highest[3] = [1, 3, 0]
array tics[3] = ["'0' 0, '0.5' 0.5, '1' 1", "'0.1' -1, '1' 0, '10' 1, '100' 2, '1000' 3", "'0.01' -2, '0.1' -1, '1' 0"]
below(c, h) = c == 1 ? sprintf('mean %.2f', used[h]) : sprintf('median %.2g', c == 2 ? roll[h] : creep[h])

do for [k = first:last] {
    set output sprintf(picture, k)
    set multiplot
    do for [m = 1:2] {
        h = at(m, k)
        low = m == 1 ? 0.47 : 0.045
        set tmargin at screen low + 0.39
        set bmargin at screen low
        set object 1 rectangle from -W[h]/2,-H[h]/2 to W[h]/2,H[h]/2 fillstyle empty border linecolor rgb '#909090' behind
        do for [c = 1:3] {
            left = 0.175 + 0.276*(c - 1)
            middle = left + 0.135
            set lmargin at screen left
            set rmargin at screen left + 0.27
            unset label
            if (c == 1) {
                if (m == 1) {set label sprintf('strain %.1f %%', 100*strain[h]) at screen 0.012,0.95 font ',20'}
                set label size[m].' contacts' at screen 0.012,low + 0.27 font ',20'
                set label sprintf('a/R = %.2g %%', 100*a_over_R[at(m, 0)]) at screen 0.012,low + 0.205 font ',20'
                set label sprintf('sin φ = %.2f', sin_phi[h]) at screen 0.012,low + 0.14 font ',20'
            }
            set label below(c, h) at screen middle,low - 0.018 center font ',17'
            unset colorbox
            if (m == 1) {
                set label head[c] at screen middle,0.965 center font ',20'
                set colorbox horizontal user origin left + 0.02,0.913 size 0.23,0.02
            }
            set cbrange [lowest[c]:highest[c]]
            eval 'set cbtics ('.tics[c].')'
            data = sprintf('%s/%s-%03d.dat', fields, size[m], k)
            plot data index 0 using 1:2:3 with circles linecolor rgb '#e6e6ea', \
                data index 1 using 1:2:3:4 with vectors nohead linewidth 1 linecolor rgb '#b0b0b4', \
                data index 1 using 1:2:3:4:(column(4 + c)) with vectors nohead linewidth 4 linecolor palette
        }
    }
    unset multiplot
}
