# SPDX-License-Identifier: MIT
# A verdict on each claim of Wang et al. 2015 about Figs. 5 and 6, from points.csv of strength.yaml. Each number is
# first made of the points of one seed, which share a sample, and then averaged over the seeds; the interval is
# Student's, 95 %. A seed that lacks a point or a number is left out.
#
# A claim has a range of numbers in which it is true: `holds` if the interval lies in it, `fails` if it lies outside,
# else `undecided`, with the number of seeds whose interval, shrinking as one over the root of their number, would no
# longer reach over the edge. The paper gives no numbers for "almost the same" and "not very sensitive"; the ranges used
# are in the rows.
BEGIN {
    OFS = ","
    print "claim", "model", "number", "low_95", "high_95", "true_from", "true_to", "seeds", "verdict", "seeds_to_decide"
}
NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
{
    m = $column["contact.mu_r"] + 0; v = $column["contact.rolling_velocity"]; s = $column["seed"] + 0
    for (i = 1; i <= NF; i++) if ($i == "") lacks[s] = 1 # an empty cell has no number
    if (++points[s] > most) most = points[s]
    if (!(m in known)) { known[m] = 1; mu_r[++n_mu_r] = m }
    phi[v, m, s] = $column["sin_phi_residual"]; peak[v, m, s] = $column["sin_phi_peak"]
    e[v, m, s] = $column["e_residual"]; e0[s] = $column["e0"]
    opposed[v, m, s] = $column["opposed_fraction_residual"]
}
# d[1 ... n]: a number of each seed
function judge(claim, model, from, to,   i, n, sum, squares, mean, half, verdict, more, edge, low, high) {
    n = n_seeds
    for (i = 1; i <= n; i++) sum += d[i]
    mean = sum/n
    for (i = 1; i <= n; i++) squares += (d[i] - mean)^2
    half = n > 1 ? student(0.05, n - 1)*sqrt(squares/(n - 1)/n) : "" # of one seed there is no interval
    verdict = n < 2 ? "undecided" : mean - half >= from && mean + half <= to ? "holds" : mean + half < from || mean - half > to ? "fails" : "undecided"
    more = ""
    if (verdict == "undecided") { # distance to the edge that is next
        edge = mean - from < 0 ? from - mean : mean - from
        if ((to - mean < 0 ? mean - to : to - mean) < edge) edge = to - mean < 0 ? mean - to : to - mean
        more = n < 2 ? "2 or more" : edge > 0 ? sprintf("%.0f", int(n*(half/edge)^2 + 1)) : ""
    }
    low = n < 2 ? "" : sprintf("%.4f", mean - half); high = n < 2 ? "" : sprintf("%.4f", mean + half)
    printf "%s,%s,%.4f,%s,%s,%g,%g,%d,%s,%s\n", claim, model, mean, low, high, from, to, n, verdict, more
}
# the mean over mu_r between two bounds of a model less wang, of one seed
function less(x, v, s, low, high,   i, n, sum) {
    for (i = 1; i <= n_mu_r; i++)
        if (mu_r[i] >= low && mu_r[i] <= high) { sum += x[v, mu_r[i], s] - x["wang", mu_r[i], s]; n++ }
    return sum/n
}
function mean_of(x, v, s, low, high,   i, n, sum) {
    for (i = 1; i <= n_mu_r; i++)
        if (mu_r[i] >= low && mu_r[i] <= high) { sum += x[v, mu_r[i], s]; n++ }
    return sum/n
}
END {
    for (s in points) if (!(s in lacks) && points[s] == most) seed[++n_seeds] = s # a seed counts with all its points
    if (!n_seeds) exit
    many = split("bagi-kuhn alonso-min alonso-mean", model, " ")
    for (k = 1; k <= many; k++) {
        v = model[k]
        for (i = 1; i <= n_seeds; i++) d[i] = less(phi, v, seed[i], 0.05, 0.15)
        judge("residual sin phi less that of wang for mu_r below 0.2: almost the same", v, -0.02, 0.02)
    }
    for (k = 1; k <= many; k++) {
        v = model[k]
        for (i = 1; i <= n_seeds; i++) d[i] = -less(phi, v, seed[i], 0.3, 2)
        judge("residual sin phi of wang less that of the model for mu_r above 0.2: wang is higher", v, 0, 1)
    }
    for (k = 1; k <= many; k++) {
        v = model[k]
        for (i = 1; i <= n_seeds; i++) d[i] = -less(peak, v, seed[i], 0.3, 2)
        judge("peak sin phi of wang less that of the model for mu_r above 0.2: wang is higher", v, 0, 1)
    }
    model[0] = "wang"
    for (k = 0; k <= many; k++) {
        v = model[k]
        for (i = 1; i <= n_seeds; i++) d[i] = (phi[v, 2, seed[i]] - phi[v, 1, seed[i]])
        judge("residual sin phi at mu_r = 2 less that at 1: saturation", v, -0.03, 0.03)
    }
    for (k = 0; k <= many; k++) {
        v = model[k]
        for (i = 1; i <= n_seeds; i++) d[i] = (peak[v, 2, seed[i]] - peak[v, 1, seed[i]])
        judge("peak sin phi at mu_r = 2 less that at 1: saturation", v, -0.03, 0.03)
    }
    for (k = 0; k <= many; k++) {
        v = model[k]
        for (i = 1; i <= n_seeds; i++) {
            d[i] = 1
            for (j = 1; j <= n_mu_r; j++) { x = e[v, mu_r[j], seed[i]] - e0[seed[i]]; if (x < d[i]) d[i] = x }
        }
        judge("residual void ratio less the initial one; the least of all mu_r: all samples dilate", v, 0, 1)
    }
    for (i = 1; i <= n_seeds; i++) d[i] = e0[seed[i]]
    judge("initial void ratio: 0.2 as printed with one digit", "all", 0.15, 0.25)
    for (k = 2; k <= many; k++) {
        v = model[k]
        for (i = 1; i <= n_seeds; i++) d[i] = mean_of(e, v, seed[i], 0.3, 2)/mean_of(e, "wang", seed[i], 0.3, 2) - 1
        judge("void ratio over that of wang less 1 for mu_r above 0.2: about 4 % lower", v, -0.06, -0.02)
    }
    for (k = 2; k <= many; k++) {
        v = model[k]
        for (i = 1; i <= n_seeds; i++) d[i] = e[v, 2, seed[i]]/e["wang", 2, seed[i]] - 1
        judge("the same at mu_r = 2 alone", v, -0.06, -0.02)
    }
    for (i = 1; i <= n_seeds; i++) d[i] = mean_of(opposed, "wang", seed[i], 0.3, 2)
    judge("fraction of contacts with s1 s2 < 0 for mu_r above 0.2: there are such", "wang", 0.01, 1)
    for (i = 1; i <= n_seeds; i++) d[i] = mean_of(opposed, "wang", seed[i], 0.3, 2) - mean_of(opposed, "wang", seed[i], 0.05, 0.15)
    judge("the same less that for mu_r below 0.2: more of them where the models are to differ", "wang", 0, 1)
}
