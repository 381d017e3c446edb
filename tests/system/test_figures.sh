#!/bin/sh
# SPDX-License-Identifier: MIT
# The data of figures/: against closed forms written out here, and the same bytes from run to run.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"

# The two that take longest run the same solver of the half-plane as exact-path and kuhn-fig2: once is enough.
for script in figures/*.sh; do
    figure=$(basename "$script" .sh)
    check "$figure: writes its data" sh -c '"$0" "$1" >"$2/$3.csv"' "$script" "$TRUNDLE" "$work" "$figure"
    case $figure in cattaneo-to-carter | creep-error) ;; *)
        "$script" "$TRUNDLE" >"$work/again.csv"
        check "$figure: the same bytes again" cmp "$work/$figure.csv" "$work/again.csv"
    esac
    check "$figure: has a script that draws it" test -s "figures/$figure.gp"
done

# Two colours have one meaning each, TR_SLIDES and TR_ROLLS of src/draw/palette.h; a figure has no other orange (hue 10 to 50 degrees) and no
# other blue (190 to 260), but greys of little colour, and the pale ends of the two ramps.
hues_of() { # FILES: oranges and blues that mean nothing
    awk '
        FNR == 1 {file = FILENAME}
        {
            for (line = tolower($0); match(line, /#[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]/); line = substr(line, RSTART + 7)) {
                hex = substr(line, RSTART, 7)
                for (k = 0; k < 3; k++) c[k] = (16*(index("0123456789abcdef", substr(hex, 2 + 2*k, 1)) - 1) + index("0123456789abcdef", substr(hex, 3 + 2*k, 1)) - 1)/255
                high = c[0] > c[1] ? c[0] : c[1]; if (c[2] > high) high = c[2]
                low = c[0] < c[1] ? c[0] : c[1]; if (c[2] < low) low = c[2]
                if (high - low < 0.15) continue
                if (high == c[0]) hue = (c[1] - c[2])/(high - low)
                else if (high == c[1]) hue = 2 + (c[2] - c[0])/(high - low)
                else hue = 4 + (c[0] - c[1])/(high - low)
                hue *= 60; if (hue < 0) hue += 360
                if (hue >= 10 && hue <= 50 || hue >= 190 && hue <= 260) print file ":" FNR ": " hex
            }
        }' "$@" | grep -viE '#(c75000|00457c|f3d3bc|e39a66|662900|c6d6e6|6d9ac4|00203a)$'
}
palette_is() { # the hues above are those of the palette
    for hue in C75000 00457C F3D3BC E39A66 662900 C6D6E6 6D9AC4 00203A; do
        grep -q "0x$hue" src/draw/palette.h src/draw/palette.c || { echo "$hue is not in the palette"; return 1; }
    done
}
# shellcheck disable=SC2046 # a list of names
check 'no orange and no blue but sliding and rolling' is_silent hues_of $(find figures src/out src/draw -name '*.gp' -o -name '*.css' -o -name plot.c)
check 'which are those of the palette' palette_is
echo "set style line 1 lc rgb '#d55e00'" >"$work/orange.gp"
echo "set style line 1 lc rgb '#0072B2'" >"$work/blue.gp"
check 'an orange is seen' test -n "$(hues_of "$work/orange.gp")"
check 'a blue is seen' test -n "$(hues_of "$work/blue.gp")"

# What make figures would run: a long study among it takes minutes to hours. Each is a target of its own.
long='figures/(wang|bands|kuhn|replay)/|trundle (bench|verify|sweep)'
would() { MAKEFLAGS='' MAKELEVEL='' make -n "$@" 2>&1; }
figures_alone() {
    would figures | grep -q 'definitions.sh' || { echo 'no figures'; return 1; }
    is_silent sh -c 'echo "$1" | grep -E "$2"' sh "$(would figures)" "$long"
}
check 'make figures runs no long study' figures_alone
for study in wang bands kuhn kuhn-film replay; do
    check "make $study runs its own" sh -c 'echo "$1" | grep -qE "$2"' sh "$(would $study)" "$long"
done

# closed_forms FILE ROWS AWK [TOLERANCE]: the program gives `is` and `want` of a row, which agree to 1e-9 (10 digits are
# printed) or that tolerance in all of that many rows
closed_forms() {
    awk -F, "NR > 1 {want = \"\"; $3; if (want == \"\") next; rows++
        if (is - want > ${4:-1e-9} || want - is > ${4:-1e-9}) {print \$0 \": expected \" want; bad = 1}}
        END {if (rows != $2) {print rows \" rows, not $2\"; bad = 1}; exit bad}" "$work/$1.csv"
}
definition='m = $1; d = $2; r = $3; is = $4; mean = (1 - r)/(2*(1 + r))' # r = R2/R1
check 'rigid rotation: nobody sees rolling' closed_forms definitions 147 "$definition; if (m == \"RBR\") want = 0"
check 'rolling: all agree but an angle and a sense' closed_forms definitions 294 "$definition
    if (m ~ /^PR/) want = d == \"kuhn\" ? -1 : d == \"tordesillas\" ? (1 + (r < 1 ? r : 1/r))/2 : 1"
check 'sliding: the mean flow sees rolling' closed_forms definitions 294 "$definition
    if (m ~ /^PS/) want = d == \"bagi-kuhn\" ? mean : d == \"kuhn\" ? -mean : 0"
check 'slide and spin: energy of the mean flow alone' closed_forms definitions 105 "$definition
    if (m == \"slide and spin\") want = d == \"bagi-kuhn\" ? -mean : 0"
check 'spin and roll: energy of model 2 also' closed_forms definitions 105 "$definition
    if (m == \"spin and roll\") want = d == \"bagi-kuhn\" ? -mean : d ~ /alonso/ ? r/(1 + r) : 0"
check 'conjugate moments make none' closed_forms definitions 168 "$definition
    if (m ~ /conjugate\$/) want = 0"
# Bounds: mu_r P R/2 for equal disks, mu_r P R of the law that takes the arm.
check 'rolling laws: at the bound at the end of each way forward' closed_forms rolling-laws 20 'is = -$5
    if ($2 !~ /dashpot/ && $3 > 0.0999999) want = ($2 ~ /prop/ ? 0.001 : 0.0005)*$4'

# Constant creepage x = xi/F0 from rest: z = sqrt(1 - q) of the law solves (1 - z) + al ln((z + al)/(1 + al)) = L/(a
# Lambda) with al = x - 1, to full slip in one of the four. Steady rolling of the half-plane is Carter's, to first order
# in the width of an element, a/100: it is 0.0016 off, and half of that for half the width.
creep='x = $2/(0.02*$1); al = x - 1; z = sqrt(1 - $4)'
check 'fig. 4: the law is its closed form' closed_forms kuhn-fig4 1626 "$creep
    if (\$3 <= (x > 1 ? 1.2274 : 5)) {want = \$3/4; is = 1 - z + al*log((z + al)/(1 + al))}"
check 'fig. 4: full slip from there on' closed_forms kuhn-fig4 1878 "$creep
    if (x > 1 && \$3 > 1.2275) {want = 1; is = \$4}"
check 'fig. 4: the exact contact ends as Carter says' closed_forms kuhn-fig4 4 "$creep; is = \$5
    if (\$3 == 20) want = x < 1 ? x*(2 - x) : 1" 0.0025
check 'fig. 4: the law is close to the exact contact' closed_forms kuhn-fig4 8004 'is = $4; want = $5' 0.035

# X = x/a, c = sqrt(1 - q). Less the elements beside the edges of stick, where the slope is infinite. What is left is
# the width of an element, most at the rim: at -a, Carter's slope is infinite too.
zones='X = $4; c = sqrt(0.4); is = $5; p = sqrt(1 - X*X)
    edge = X - 2*c + 1; u = (X + 1 - c)/c; carter = p - (edge < 0 ? c*sqrt(1 - u*u) : 0)
    rim = (X < 0 ? -X : X) - c; cattaneo = p - (rim < 0 ? c*sqrt(1 - X*X/(c*c)) : 0)'
check 'traction: the closed form is Carter' closed_forms cattaneo-to-carter 200 "$zones; if (\$1 == \"carter\") want = carter"
check 'traction: starts as Cattaneo' closed_forms cattaneo-to-carter 196 "$zones
    if (\$1 == \"traction\" && \$3 == 0 && (rim > 0.01 || rim < -0.01)) want = cattaneo" 0.01
check 'traction: ends as Carter' closed_forms cattaneo-to-carter 198 "$zones
    if (\$1 == \"traction\" && \$3 == 4 && (edge > 0.01 || edge < -0.01)) want = carter" 0.01
# Left at 2a: 6, 3 and less than 0.3 %, by an independent program, to its last digit; the width of an element adds 0.5
# %.
check 'distance to Carter at 2a' closed_forms cattaneo-to-carter 3 'is = $5
    if ($1 == "distance" && $3 == 2) want = $2 == 0.3 ? 0.06 : $2 == 0.6 ? 0.03 : 0.002' 0.005

# The worst of all creepages by an independent program; here steps and elements are coarse (a/30) and creepages few.
check 'error of the law with k0' closed_forms creep-error 4 'is = $3; L = $1
    if ($2 == "all") want = L == 1.5 ? 0.075 : L == 2 ? 0.059 : L == 4 ? 0.033 : L == 6 ? 0.023 : ""' 0.002

# Sliding alone, the first three segments, is Cattaneo's and Mindlin's problem. In the first: u over 2 mu P/(pi E*) is
# q (Lambda + 1/2) + (1 - q) ln(1 - q)/2. What differs is the last element that sticks.
check 'path: the exact contact slides as Cattaneo says' closed_forms exact-path 99 'q = $5
    if ($1 == "exact" && $2 < 100) {want = 4.5*$2/100; is = 4.5*q + (1 - q)*log(1 - q)/2}' 0.0002
check 'path: cattaneo-mindlin is exact until it rolls' closed_forms exact-path 310 'is = $6
    if ($1 == "cattaneo-mindlin" && $3 < 3) want = 0' 0.0001 # second order in 200 elements: (2/200)^2
# Stick of both is as wide, c = sqrt(1 - q), and where it slips the traction is the bound, to the last of the 10 digits.
check 'fig. 2: stick as wide as Cattaneo and Carter say' sh -c '
    awk -F, "NR > 1 && \$6 {n[\$1]++} END {exit !(n[\"pushed\"] >= 125 && n[\"pushed\"] <= 128 && n[\"rolling\"] >= 125 && n[\"rolling\"] <= 128)}" "$1"
' sh "$work/kuhn-fig2.csv"
# 2500 disks on a square grid. Rotations normal and independent: Gini sqrt(2) - 1, percentiles 1.645/0.674, no
# correlation. Rolling large on the right half: ranks are +-1/2 and as much at random, C(r) = 3/4 (1 - 2 p), where a
# pair of the square lies on either side with p = <|x| (L - |y|)>/<(L - |x|) (L - |y|)>, a mean over its directions, L =
# 50. Summed over the grid: 0.727, 0.512 and 9.44. Tolerances: three times the scatter of so few disks, of 125 of which
# the pairs are counted.
awk 'BEGIN {
    srand(2); print "time_s,x_m,y_m,angle_rad,radius_m,mean_v_r_m_per_s"
    for (i = 0; i < 2500; i++) {
        normal = sqrt(-2*log(1 - rand()))*cos(6.283185307179586*rand())
        print "1," i%50 "," int(i/50) "," 0.1*normal ",0.5," rand() + (i%50 >= 25)
    }
}' >"$work/disks.csv"
awk -F, -f figures/bands/localisation.awk "$work/disks.csv" >"$work/localisation.csv"
is_near() { awk -F, -v q="$1" -v want="$2" -v by="$3" '$1 == q {is = $2; n++} END {print is; exit !(n == 1 && (is - want)^2 <= by^2)}' "$work/localisation.csv"; }
check 'bands: Gini coefficient of normal rotations' is_near gini 0.4142 0.02
check 'bands: their percentiles' is_near p90_over_p50 2.44 0.2
check 'bands: the null of no correlation' is_near null 0 0.1
check 'bands: they have no length' is_near length 0 0.2
check 'bands: correlation of two halves, near' is_near rolling_correlation_1 0.727 0.06
check 'bands: and far' is_near rolling_correlation_10 0.512 0.08
check 'bands: their length' is_near rolling_length 9.44 1.2

# The film of Kuhn's assemblies. Of a small test in a cell: each contact in two halves that meet, or are a side of the
# cell apart, and some are.
write_small_case "$work/small.yaml"
run "$work/small.yaml" -o "$work/small" --set boundary=periodic --set output.rows=3 --set output.contacts=2 --set output.increments=yes \
    --set contact.friction=dahlberg-alfredsson --set 'contact.E_star=200 MPa' --set 'contact.k_t=80 MPa'
awk -F, -v out="$work/film" -f figures/kuhn/film.awk "$work/small/disks.csv" "$work/small/contacts.csv"
halves_meet() {
    sides=$(awk -F, '{for (i = 1; i <= NF; i++) if ($i ~ /^(width|height)_m$/) c[$i] = i} END {print $c["width_m"], $c["height_m"]}' "$work/small/history.csv")
    n=$(awk -F, 'NR > 1 {t[$1]++; last = $1} END {print t[last]}' "$work/small/contacts.csv")
    awk -v sides="$sides" -v contacts="$n" 'BEGIN {split(sides, L)}
        !NF {contact = 1}
        !contact {R[$1, $2] = $3; next}
        NF {d = sqrt($3*$3 + $4*$4); if (d > R[$1, $2] || d < 0.95*R[$1, $2]) {print "not in its disk: " $0; bad = 1}}
        NF && ++n%2 {x = $1 + $3; y = $2 + $4; fields = $5 " " $6 " " $7; next}
        NF {
            x = ($1 + $3 - x)/(1000*L[1]); y = ($2 + $4 - y)/(1000*L[2]); i = int(x + 2.5) - 2; j = int(y + 2.5) - 2
            if ((x - i)^2 + (y - j)^2 > 1e-8 || i*i > 1 || j*j > 1 || fields != $5 " " $6 " " $7) {print "apart: " $0; bad = 1}
            over += i != 0 || j != 0
        }
        END {print n/2 " contacts of " contacts ", " over " over an edge"; exit bad || n/2 != contacts || !(over > 3) || over > n/4}' "$work/film-002.dat"
}
check 'film: the halves of a contact meet, across edges too' halves_meet
# 400 contacts that slide by s = 1 ... 400, the later half at the bound of friction, roll by s^2, backwards, and creep
# by 1/s; and those that are left out. Ranks: +-1, but of mobilisation, two values, sqrt(3)/2; f_n goes up and down.
# Medians: the lower one of the two in the middle.
mkdir -p "$work/made-up"
awk 'BEGIN {
    print "strain,followed,mobilisation,u_slide_m,u_roll_m,u_creep_m,f_n_N_per_m"
    for (s = 1; s <= 400; s++) {
        print "0.06,1," (s > 200 ? 1 : 0.3) "," s "," (-s*s) "," 1/s "," (s > 200 ? 401 - s : s)
        print "0.04,1,0.9,7,7,7,7\n0.06,0,0.9,7,7,7,7\n0.06,1,0.9,0,7,7,7"
    }
}' >"$work/made-up/contacts.csv"
awk -F, -v classes="$work/classes.csv" -f figures/kuhn/fields.awk "$work/made-up/contacts.csv" >"$work/correlations.csv"
check 'film: rank correlations' equals "$(awk -F, 'NR > 1 {print $2, $5}' "$work/correlations.csv" | sed 's/^400 //' | xargs)" \
    '0.87 0.87 1.00 0.87 1.00 1.00 -0.87 -1.00 0.00 0.00'
check 'film: medians of the classes' equals "$(grep made-up "$work/classes.csv" | grep -v ,0.000, | xargs)" \
    'made-up,0.25,0.500,100,1e+04,0.0099,100,9.8e-05 made-up,1,0.500,300,9e+04,0.00332,300,1.1e-05'
check 'fig. 2: slip at the bound' sh -c 'awk -F, "NR > 1 && !\$6 && (\$3 - \$4)^2 > 1e-18 {print; bad = 1} END {exit bad}" "$1"' sh "$work/kuhn-fig2.csv"
finish
