# SPDX-License-Identifier: MIT
# Strength and void ratio of mu_r = 0.5 against inertial number, stiffness ratio and time step.
csv = dir.'/independence.csv'
array what[3] = ['I', 'kappa', 'dt']
array axis[3] = ['inertial number I', 'stiffness ratio κ = k_n/σ_2', 'step over its bound']
array low[3] = [5e-5, 200, 0.15]
array high[3] = [2e-2, 5000, 1.1]
array quantity[3] = ['sin_phi_peak', 'sin_phi_residual', 'e_residual']
array words[3] = ['sin φ, peak', 'sin φ, residual', 'void ratio, residual']
array bottom[3] = [0.6, 0.35, 0.24]
array top[3] = [0.85, 0.6, 0.36]
set multiplot layout 3,3 title caption font ',16' margins 0.105,0.985,0.09,0.93 spacing 0.02,0.03
set logscale x
do for [q = 1:3] {
    do for [w = 1:3] {
        set xrange [low[w]:high[w]]
        set yrange [bottom[q]:top[q]]
        if (q == 3) { set format x w == 1 ? '10^{%T}' : '%g'; set xlabel axis[w] } else { set format x ''; unset xlabel }
        if (w == 1) { set format y '%g'; set ylabel words[q] offset 0.2 } else { set format y ''; unset ylabel }
        if (q == 1 && w == 3) { set key top right samplen 1.5 opaque } else { unset key }
        if (w == 3) { set xtics (0.2, 0.4, 0.8) } else { if (w == 2) { set xtics (300, 1000, 3000) } else { set xtics 10 } }
        plot for [m = 1:3:2] csv using ($2*(1 + 2.5*aside(m))):(strcol(1) eq what[w] && strcol(4) eq model[m] && \
            strcol(5) eq quantity[q] && strcol(6) eq '' ? $8 : NaN):10:11 with yerrorlines linewidth 2 pointtype mark[m] \
            pointsize 1.2 linecolor rgb color[m] title name[m]
    }
}
unset multiplot
