# SPDX-License-Identifier: MIT
# What each of Kuhn's two kinds of rolling resistance does, from the points of creep.sh: differences of runs that share
# a sample, seed by seed. A seed counts if it has all its points. used: file that gets the seeds that count.
#
# Rule, written before the runs. Four numbers: peak and residual sin phi, dilatancy (residual void ratio less that at
# the start), share of rolling in the residual, Sum |V_r|/Sum (|V_r| + |V_s|). Six differences of each: contact moment
# (mu_r = 0.5 less 0) without and with creep, creep less spring without and with contact moment, and creep by Kuhn's
# rolling less by Wang's without and with contact moment: 24 verdicts.
#   raises, lowers    the interval leaves out 0
#   within M          it lies inside -M to M: M = 0.02 for sin phi and the share, 0.005 for the dilatancy, which is too
#                     little for a test
#                     with few samples to matter: half of what one sample differs from the next, or less
#   undecided         neither. It is not "no effect"
# Both of the first two may hold: `raises, within M`. The interval is Student's of the differences, of 99.79 % = 1 -
# 0.05/24: by Bonferroni, all 24 hold together with 95 %. The table also has the 95 % interval of each single
# difference, which decides nothing. The rows `together` (both less each one only) show how one changes the effect of
# the other; they have an interval and no verdict.
BEGIN {
    FS = OFS = ","
    tests = 24
    split("peak residual dilatancy rolling", quantity, " ")
    said["peak"] = "peak sin φ"; said["residual"] = "residual sin φ"; said["dilatancy"] = "dilatancy e − e0"; said["rolling"] = "rolling share"
    margin["peak"] = margin["residual"] = margin["rolling"] = 0.02; margin["dilatancy"] = 0.005
}
FNR == 1 { split("", at); for (i = 1; i <= NF; i++) at[$i] = i; next }
{
    f = "contact.friction" in at ? $at["contact.friction"] : $at["contact.creep_roll"]
    k = $at["contact.mu_r"] + 0 "," (f == "coulomb-spring" ? "spring" : f == "kuhn" ? "kuhn" : "creep")
    s = $at["seed"]
    x[k, s, "peak"] = $at["sin_phi_peak"]; x[k, s, "residual"] = $at["sin_phi_residual"]; x[k, s, "rolling"] = $at["rolling_share_residual"]
    x[k, s, "dilatancy"] = $at["e_residual"] - $at["e0"]
    if ($at["sin_phi_peak"] != "" && $at["sin_phi_residual"] != "" && $at["rolling_share_residual"] != "" && $at["e_residual"] != "") points[s]++
}
function number(v) { v = sprintf("%.4f", v); if (v + 0 == 0) sub(/^-/, "", v); return v }
function verdict(a, b, m,   sign, small) {
    sign = a > 0 ? "raises" : b < 0 ? "lowers" : ""
    small = a >= -m && b <= m ? "within " m : ""
    return sign != "" && small != "" ? sign "; " small : sign small != "" ? sign small : "undecided"
}
# TERMS: "+KEY -KEY ...": their sum of each seed
function judge(kind, other, terms, q, decide,   n, i, s, d, sum, squares, mean, error, half, all, term, parts) {
    parts = split(terms, term, " ")
    for (i = 1; i <= n_seeds; i++) {
        d[i] = 0
        for (n = 1; n <= parts; n++) d[i] += (substr(term[n], 1, 1) == "+" ? 1 : -1)*x[substr(term[n], 2), seed[i], q]
        sum += d[i]
    }
    mean = sum/n_seeds
    for (i = 1; i <= n_seeds; i++) squares += (d[i] - mean)^2
    error = sqrt(squares/(n_seeds - 1)/n_seeds)
    half = student(0.05, n_seeds - 1)*error; all = student(0.05/tests, n_seeds - 1)*error
    print said[q], kind, other, n_seeds, number(mean), number(half), number(all), margin[q], decide ? verdict(mean - all, mean + all, margin[q]) : ""
}
END {
    for (s in points) if (points[s] == 6) seed[++n_seeds] = s
    for (i = 1; used && i <= n_seeds; i++) print seed[i] >used
    if (n_seeds < 2) { print "error: at least two seeds are needed" >"/dev/stderr"; exit 1 }
    print "number", "of", "beside", "seeds", "mean", "half_95", "half_all", "margin", "verdict"
    for (i = 1; i <= 4; i++) {
        q = quantity[i]
        judge("contact moment", "no creep", "+0.5,spring -0,spring", q, 1)
        judge("contact moment", "creep", "+0.5,creep -0,creep", q, 1)
        judge("creep", "no contact moment", "+0,creep -0,spring", q, 1)
        judge("creep", "contact moment", "+0.5,creep -0.5,spring", q, 1)
        judge("together", "both less each alone", "+0.5,creep -0.5,spring -0,creep +0,spring", q, 0)
        judge("Kuhn's rolling less Wang's", "no contact moment", "+0,kuhn -0,creep", q, 1)
        judge("Kuhn's rolling less Wang's", "contact moment", "+0.5,kuhn -0.5,creep", q, 1)
    }
}
