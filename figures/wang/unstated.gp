# SPDX-License-Identifier: MIT
# The difference between the models while one thing that the paper does not give is changed: strength above, void ratio
# below.
csv = dir.'/unstated.csv'
array coefficient[2] = [0.5, 2]
array quantity[2] = ['sin_phi_residual', 'e_residual']
array words[2] = ['residual sin φ less that of Wang', 'residual e less that of Wang (% of it)']
array left[2] = [-0.29, -24]
array right[2] = [0.09, 8]
array tics[2] = [0.1, 5]
array scale[2] = [1, 100]
rows = int(system("sed 1d '".csv."' | cut -d, -f1 | uniq | wc -l"))
array label[rows]
do for [k = 1:rows] { label[k] = system(sprintf("sed 1d '%s' | cut -d, -f1 | uniq | sed -n %dp", csv, k)) }
row(text) = sum [k = 1:rows] (label[k] eq text ? k : 0)
lever = 'lever 2 R_{eff}' # twice the coefficient stands for it
# Wang's own value of a row, for percents: rows of wang come before their differences
own(q) = strcol('model') eq 'wang' && strcol('quantity') eq quantity[q] && strcol('minus') eq '' ? $7 : NaN
pick_row(m, c, q, x) = strcol('model') eq model[m] && strcol('quantity') eq quantity[q] && strcol('minus') eq wang && \
    (strcol('changed') eq lever ? $2/2 : $2) == coefficient[c] ? scale[q]*x/(q == 2 ? e_wang : 1) : NaN
stats csv using (own(2)) nooutput
e_wang = STATS_mean
set multiplot layout 2,2 title caption font ',16' margins 0.16,0.985,0.09,0.88 spacing 0.03,0.1
set yrange [rows + 0.7:0.3]
set tics font ',17'
do for [q = 1:2] {
    do for [c = 1:2] {
        set xrange [left[q]:right[q]]
        set xtics tics[q]
        set xlabel words[q] offset 0,0.5
        set ytics ()
        do for [k = 1:rows] { set ytics add ((c == 1 ? label[k] : '') k) }
        if (q == 1) { set title sprintf('μ_r = %g', coefficient[c]) offset 0,-0.5 } else { unset title }
        if (q == 1 && c == 1) { set key at graph 0.02, graph 0.45 left Left reverse samplen 1.5 font ",17" } else { unset key }
        set arrow 1 from 0, graph 0 to 0, graph 1 nohead linewidth 1.5 back
        plot for [m = 3:4] csv using (pick_row(m, c, q, $7)):(row(strcol(1)) + 0.12*(2*m - 7)):(pick_row(m, c, q, $9)):(pick_row(m, c, q, $10)) \
            with xerrorbars linewidth 2.5 pointtype mark[m] pointsize 1.4 linecolor rgb color[m] title name[m]
    }
}
unset multiplot
