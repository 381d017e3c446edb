# SPDX-License-Identifier: MIT
# From collect.csv of the sweep: a table of each definition, of its difference from wang, and of what so few seeds can
# tell. Rule, written before the runs: `differs` where the 95 % interval of the difference (Student, seed by seed)
# leaves out 0; `equal within` the margin where it lies inside of it; else `undecided`. Undecided is not equal.
# The detectable difference is the least that n seeds call `differs` in 80 of 100 trials, if differences scatter as
# those of 32 other samples of this test (seeds 101 to 132) do: standard deviations below. Three seeds know their
# scatter only to a factor of 0.5 to 6.
BEGIN {
    FS = OFS = ","
    split("sin_phi_peak sin_phi_residual e_residual", quantity, " ")
    said["sin_phi_peak"] = "peak sin φ"; said["sin_phi_residual"] = "residual sin φ"; said["e_residual"] = "residual void ratio"
    margin["sin_phi_peak"] = margin["sin_phi_residual"] = 0.02; margin["e_residual"] = 0.005 # the former as in ../wang/verdicts.awk
    scatter["sin_phi_peak"] = 0.0104; scatter["sin_phi_residual"] = 0.0527; scatter["e_residual"] = 0.0116
}
NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
{
    of = $at["contact.rolling_velocity"]; what = $at["quantity"]; less = $at["minus"] != ""
    if (!(of in known)) { known[of] = 1; name[++n_names] = of }
    mean[of, what, less] = $at["mean"]; low[of, what, less] = $at["low_95"]; high[of, what, less] = $at["high_95"]
    seeds = $at["seeds"]
    if ($at["standard_error"] > 0 && what in said) student = ($at["high_95"] - $at["mean"])/$at["standard_error"]
}
# Normal distribution, Abramowitz & Stegun 26.2.17, to 1e-7
function normal(x,   t, p) {
    t = 1/(1 + 0.2316419*(x < 0 ? -x : x))
    p = exp(-x*x/2)/sqrt(8*atan2(1, 1))*t*(0.319381530 + t*(-0.356563782 + t*(1.781477937 + t*(-1.821255978 + t*1.330274429))))
    return x < 0 ? p : 1 - p
}
# How often Student's test with f degrees of freedom and the quantile t finds a difference of d standard errors: the
# mean over the measured standard deviation s, s^2 f of chi-squared with f degrees of freedom
function power(d, t, f,   s, ds, w, sum, weights) {
    ds = 0.001
    for (s = ds/2; s < 6; s += ds) { w = exp((f - 1)*log(s) - f*s*s/2); sum += w*(normal(d - t*s) + normal(-d - t*s)); weights += w }
    return sum/weights
}
function detectable(t, f,   a, b, m) {
    a = 0; b = 40
    while (b - a > 1e-4) { m = (a + b)/2; if (power(m, t, f) < 0.8) a = m; else b = m }
    return (a + b)/2
}
function number(x, digits) { x = sprintf("%." digits "f", x); if (x + 0 == 0) sub(/^-/, "", x); sub(/^-/, "−", x); return x }
function interval(of, what, less) {
    return number(mean[of, what, less], 4) " ± " number((high[of, what, less] - low[of, what, less])/2, 4)
}
function verdict(of, what,   a, b, m) {
    a = low[of, what, 1]; b = high[of, what, 1]; m = margin[what]
    return a > 0 || b < 0 ? "differs" : a >= -m && b <= m ? "equal within " m : "undecided"
}
END {
    if (seeds < 2) { print "at least two seeds are needed" >"/dev/stderr"; exit 1 }
    d = detectable(student, seeds - 1)/sqrt(seeds)
    print "number", "definition", "mean ± 95 %", "less that of wang ± 95 %", "verdict", "detectable difference (80 %)"
    for (k = 1; k <= 3; k++) for (i = 1; i <= n_names; i++) {
        of = name[i]; what = quantity[k]
        if (of == "wang") print said[what], of, interval(of, what, 0), "", "", ""
        else print said[what], of, interval(of, what, 0), interval(of, what, 1), verdict(of, what), number(d*scatter[what], 3)
    }
    for (i = 1; i <= n_names; i++) {
        x = mean[name[i], "energy.rolling.made_over_work", 0]
        print "energy made by the rolling law over the work of the walls", name[i], x < 1e-9 ? "below 1e-9" : sprintf("%.3f", x), "", "", ""
    }
}
