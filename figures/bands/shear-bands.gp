# SPDX-License-Identifier: MIT
# Where disks turn and roll: 10,000 disks without (above) and with rolling resistance. Data: out/bands, see
# shear-bands.sh, which gives dir, caption, and the words above the panels, rotation and rolling, for mu_r = 0 and 0.5.
set datafile separator ','
set multiplot layout 2,2 title caption font ',20' offset 0,-0.1
set size ratio -1
unset key
unset border
unset xtics
unset ytics
set style fill solid 1 noborder
set title offset 0,-0.6
stats dir.'/mu_r-0/disks.csv' skip 1 using 3 name 'x' nooutput # the wider
middle = 0.5*(x_min + x_max)
half = 0.51*(x_max - x_min)
set xrange [middle - half:middle + half]
set colorbox horizontal
set cbtics scale 0 offset 0,0.5
set cblabel offset 0,1.1
set label 1 '50 mm' at graph 0.01,graph -0.06 font ',16'
set arrow 1 from graph 0,graph -0.025 rto 0.05,0 nohead linewidth 4

# The palettes of the frames, src/draw/palette.c; ends near the 90th percentile.
do for [i = 1:2] {
    mu_r = word('0 0.5', i)
    high = 0.99 - 0.475*(i - 1)
    bar = high - 0.455
    set tmargin at screen high - 0.075
    set bmargin at screen high - 0.41
    set lmargin at screen 0.01
    set rmargin at screen 0.49
    set palette defined (-1 '#17603a', -0.5 '#6fa687', 0 '#d5d8dc', 0.5 '#a87bb4', 1 '#592769')
    set cbrange [-60/i:60/i]
    set cbtics (sprintf('−%d°', 60/i) -60/i, '0' 0, sprintf('+%d°', 60/i) 60/i)
    set cblabel 'rotation since the start'
    set colorbox user origin 0.15,bar size 0.30,0.012
    set title '{/Symbol m}_r = '.mu_r.':  '.word(rotation, i).' d'
    plot dir.'/mu_r-'.mu_r.'/disks.csv' skip 1 using 3:4:10:($5*180/pi) with circles linecolor palette
    set lmargin at screen 0.51
    set rmargin at screen 0.99
    set palette defined (0 '#c6d6e6', 1 '#6d9ac4', 2 '#00457c', 3 '#00203a')
    set cbrange [0:200/(4*i - 3)]
    set cbtics (0, 100/(4*i - 3), 200/(4*i - 3))
    set cblabel 'mean |V_r| of its contacts now [mm/s]'
    set colorbox user origin 0.65,bar size 0.30,0.012
    set title '{/Symbol m}_r = '.mu_r.':  '.word(rolling, i).' d'
    plot dir.'/mu_r-'.mu_r.'/disks.csv' skip 1 using 3:4:10:($11*1000) with circles linecolor palette
}
unset multiplot
