# SPDX-License-Identifier: MIT
# Kuhn's Fig. 2: the same contact pushed, and rolling steadily. Data: kuhn-fig2.sh.
set datafile separator ','
array state[2] = ['pushed', 'rolling']
array name[2] = ['Cattaneo–Mindlin', 'steady-state creep']
array from[2] = [0.09, 0.55]
array speed[2] = [-1, 0.7] # of p; q moves with 1
array frame[2] = ['the frame moves with the material', 'material runs through the frame']
width = 0.43
here(k, x) = strcol(1) eq state[k] ? x : NaN
gap(x) = abs(x) < 1 ? 0 : 0.6*(abs(x)*sqrt(x*x - 1) - log(abs(x) + sqrt(x*x - 1))) # of Hertz's contact, exaggerated
set samples 400
set xrange [-1.3:1.3]
unset key
set multiplot
do for [k = 1:2] {
    set lmargin at screen from[k]
    set rmargin at screen from[k] + width

    set bmargin at screen 0.62
    set tmargin at screen 0.9
    unset tics
    unset border
    unset xlabel
    unset ylabel
    unset grid
    unset arrow
    set yrange [-1:1]
    set title name[k] font ',24' offset 0,0.3
    set label 1 'q' at -0.62,0.62 center font ',24' front
    set label 2 'p' at -0.62,-0.62 center font ',24' front
    set arrow 1 from -0.45,0.62 rto 1,0 linewidth 4 linecolor rgb '#7fbf9f' front
    set arrow 2 from (speed[k] < 0 ? 0.55 : -0.45),-0.62 rto speed[k],0 linewidth 4 linecolor rgb '#7fbf9f' front
    set label 3 'v^q' at 0.62,0.62 left textcolor rgb '#7fbf9f' font ',22' front
    set label 4 'v^p' at 0.62,-0.62 left textcolor rgb '#7fbf9f' font ',22' front
    plot sample [-1.3:1.3] '+' using 1:(0.05 + gap($1)):(1) with filledcurves linecolor rgb '#e6eaed', \
        [-1.3:1.3] '+' using 1:(-0.05 - gap($1)):(-1) with filledcurves linecolor rgb '#e6eaed', \
        [-1.3:1.3] '+' using 1:(0.05 + gap($1)) with lines linewidth 3 linecolor rgb '#4d5560', \
        [-1.3:1.3] '+' using 1:(-0.05 - gap($1)) with lines linewidth 3 linecolor rgb '#4d5560', \
        csv using 2:(here(k, $6 == 0 ? 0 : NaN)):(0.006):(0.05) with boxxyerror fillstyle solid noborder linecolor rgb '#c75000', \
        csv using 2:(here(k, $6 == 1 ? 0 : NaN)):(0.006):(0.05) with boxxyerror fillstyle solid noborder linecolor rgb '#c9ced4'

    set bmargin at screen 0.2
    set tmargin at screen 0.56
    unset title
    unset label
    unset arrow
    set border 3
    set yrange [0:1.15]
    set xtics -1,0.5,1 nomirror
    set xlabel 'x / a'
    set label 1 frame[k] at 0,1.1 center font ',18'
    if (k == 1) {
        set ytics 0.5 nomirror
        set ylabel 'traction τ / μp_0' offset 1
    }
    if (k == 2) {
        set border 1
        set label 2 "material\nenters" at -1.02,0.32 right font ',16'
        set label 3 "material\nleaves" at 1.02,0.32 left font ',16'
    }
    plot csv using 2:(here(k, $6 == 1 ? $4/2 : NaN)):($2 - 0.005):($2 + 0.005):(0):4 with boxxyerror fillstyle pattern 4 noborder \
            linecolor rgb '#42505e', \
        csv using 2:(here(k, $6 == 0 ? $4/2 : NaN)):($2 - 0.006):($2 + 0.006):(0):4 with boxxyerror fillstyle solid noborder \
            linecolor rgb '#c75000', \
        csv using 2:(here(k, $3)) with lines linewidth 2 linecolor rgb '#888888', \
        csv using 2:(here(k, $4)) with lines linewidth 4 linecolor rgb '#222222'
}
set lmargin at screen 0.01
set rmargin at screen 0.99
set bmargin at screen 0.005
set tmargin at screen 0.1
unset label
unset arrow
unset tics
unset border
unset xlabel
unset ylabel
set key center center horizontal maxrows 2 reverse Left samplen 2 spacing 1.2
plot [0:1] [0:1] NaN with lines linewidth 4 linecolor rgb '#222222' title 'traction, the same Q = 0.6 μP', \
    NaN with lines linewidth 2 linecolor rgb '#888888' title 'bound μp', \
    NaN with boxes fillstyle pattern 4 noborder linecolor rgb '#42505e' title 'stick', \
    NaN with boxes fillstyle solid noborder linecolor rgb '#c75000' title 'slip'
unset multiplot
