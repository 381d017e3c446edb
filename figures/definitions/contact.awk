# SPDX-License-Identifier: MIT
# From contact.csv of contact.yaml: force and moments of the contact by each definition, step by step, and a table of
# what is there at the end of each segment beside a spring that is worked out by hand. Variables: names (separated by
# blanks), rows and table (files to write). Conjugate moments: V_r = A w1 + B w2 + C Vt gives -A T, -B T and the force
# -C T on disk 2. The line of centres stands still.
BEGIN {
    FS = OFS = ","
    n = split(names, name, " ")
    R1 = 0.005; R2 = 0.010; R_eff = R1*R2/(R1 + R2); k_r = 1e6; bound = 10
    split("slide|roll like gears|spin disk 1|roll back|slide and roll", said, "|")
    print "step", "segment", "definition", "T", "paper_1", "paper_2", "conjugate_1", "conjugate_2" >rows
}
NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
{
    i = $at["law"]; step = $at["step"]; segment = $at["segment"] + 1
    if (!(i in slide)) slide[i] = roll[i] = hand[i] = 0
    # s1 + s2 = -2 roll, s1 - s2 = slide: arcs of this step over both rims
    s1 = ($at["u_slide_m"] - slide[i])/2 - ($at["u_roll_m"] - roll[i]); s2 = -($at["u_slide_m"] - slide[i])/2 - ($at["u_roll_m"] - roll[i])
    slide[i] = $at["u_slide_m"]; roll[i] = $at["u_roll_m"]
    if (s1*s1 < 1e-24) s1 = 0 # rounding: a rim that stands still (1e-12 m; a step is 1e-7 m)
    if (s2*s2 < 1e-24) s2 = 0
    coefficients(name[i + 1])
    T = -$at["moment_1_N"]/R_eff
    hand[i] += k_r*(A*s1/R1 - B*s2/R2) # dth1 = s1/R1, dth2 = -s2/R2
    if (hand[i] > bound) hand[i] = bound
    if (hand[i] < -bound) hand[i] = -bound
    if (!known) hand[i] = "" # not worked out here: only T
    if (known && (T - hand[i])^2 > (1e-9*bound)^2) bad = 1 # a sum of 200 steps, rounded
    print step, segment, name[i + 1], T, $at["moment_1_N"], $at["moment_2_N"], (known ? -A*T : ""), (known ? -B*T : "") >rows
    if (segment > segments) segments = segment
    end[segment, i] = T; by_hand[segment, i] = hand[i]; m1[segment, i] = known ? -A*T : ""; m2[segment, i] = known ? -B*T : ""
}
function coefficients(of) {
    A = B = 0; known = of ~ /^(wang|bagi-kuhn|alonso-min|alonso-mean)$/
    if (of == "wang") { A = R_eff; B = -R_eff }
    else if (of == "bagi-kuhn" || (of == "alonso-mean" && s1*s2 > 0)) { A = R1/2; B = -R2/2 }
    else if (of == "alonso-min" && s1*s2 > 0) { if (s1*s1 < s2*s2*(1 - 1e-9)) A = R1; else B = -R2 } # equal: disk 2
}
function number(x) { if (x == "") return "–"; x = x*x < 1e-18 ? 0 : sprintf("%.3g", x); sub(/^-/, "−", x); return x }
END {
    print "after", "definition", "T (N/m)", "by hand", "moments on 1 and 2: the paper's (mN)", "conjugate (mN)" >table
    for (k = 1; k <= segments; k++) for (i = 0; i < n; i++)
        print said[k], name[i + 1], number(end[k, i]), number(by_hand[k, i]), \
            number(-1000*R_eff*end[k, i]) "; " number(1000*R_eff*end[k, i]), number(1000*m1[k, i]) "; " number(1000*m2[k, i]) >table
    if (bad) print "T is not what the spring by hand gives: " table >"/dev/stderr"
    exit bad
}
