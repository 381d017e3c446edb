# SPDX-License-Identifier: MIT
# Does value +- t s of one sample cover the mean of the population as often as it says? The rule, written before the
# runs.
#
#     awk -F, -f ../student.awk -f rule.awk rows.csv points.csv
#
# rows.csv: the table that is shipped (s of each case from `seeds` seeds); points.csv: fresh seeds of some of these
# cases. For each case and quantity: the mean m of all n fresh samples stands for that of the population, and K of them
# have |x - m| <= t s.
#
# s was measured too. With normal x and X = (s/sigma)^2 = chi^2_nu/nu the share covered is p(X) = 2 Phi(t sqrt(X)) - 1:
# its mean over X is 0.95, but one table has one X, so K is binomial of a p that is itself drawn. K must lie between the
# quantiles of that mixture that hold 1 - 0.05/cases of it (so all cases hold together with 95 %, whatever they share).
# Where K lies outside, the interval does not say what it claims, and the case is to be taken out of the table. (The
# mean of n fresh samples is not that of the population: |x - m| is smaller by sqrt(1 - 1/n), 0.25 % for 200; it is put
# back.)
function phi2(z) { # P(|Z| < z), by the series of the error function: all terms positive
    if (z > 8) return 1
    term = z; total = z
    for (k = 1; term > 1e-17 * total; k++) { term *= z * z / (2 * k + 1); total += term }
    return 2 * total * exp(-z * z / 2) / sqrt(2 * pi)
}
# P(K = j), j = 0 ... n, in chance[]: binomial over X, by the midpoint rule in y = sqrt(X), whose density is y^(nu-1)
# exp(-nu y^2/2)
function mixture(n, nu, t,  i, j, y, w, all, p, q) {
    all = 0
    for (j = 0; j <= n; j++) chance[j] = 0
    for (i = 0; i < 400; i++) {
        y = (i + 0.5) / 200
        w = exp((nu - 1) * log(y) - nu * (y * y - 1) / 2)
        p = phi2(t * y)
        all += w
        for (j = 0; j <= n; j++) {
            q = (p > 1 - 1e-15) ? (j == n ? 0 : -800) : choose[j] + j * log(p) + (n - j) * log(1 - p)
            chance[j] += w * (q < -700 ? 0 : exp(q))
        }
    }
    for (j = 0; j <= n; j++) chance[j] /= all
}
function limits(n, share,  j, sum) { # the least and greatest K that leave out at most share/2 on either side
    sum = 0
    for (j = 0; sum + chance[j] <= share / 2; j++) sum += chance[j]
    least = j; sum = 0
    for (j = n; sum + chance[j] <= share / 2; j--) sum += chance[j]
    most = j
}
BEGIN { pi = atan2(0, -1) }
FNR == 1 { file++; for (i = 1; i <= NF; i++) column[file, $i] = i; next }
file == 1 { key = $1 FS $2 FS $3 FS $4; s[key, "peak"] = $6; s[key, "residual"] = $7; freedom[key] = $5 - 1; next }
{
    key = $column[2, "n_disks"] FS $column[2, "contact.mu_r"] FS $column[2, "contact.friction"]
    key = key FS $column[2, "shear.inertial_number"]
    if (!(key in freedom)) { print "no row of the table for " key; bad = 1; exit 1 }
    if (!(key in fresh)) order[++cases] = key
    n = ++fresh[key]
    x[key, "peak", n] = $column[2, "sin_phi_peak"]; x[key, "residual", n] = $column[2, "sin_phi_residual"]
}
END {
    if (bad) exit 1
    split("peak residual", quantity, " ")
    print "N,mu_r,friction,I,quantity,s_of_table,s_of_fresh,covered,of,share,least,most,verdict"
    for (c = 1; c <= cases; c++) for (q = 1; q <= 2; q++) {
        key = order[c]; n = fresh[key]; t = student(0.05, freedom[key]); sum = square = covered = 0
        for (i = 1; i <= n; i++) sum += x[key, quantity[q], i]
        for (i = 1; i <= n; i++) {
            off = (x[key, quantity[q], i] - sum / n) / sqrt(1 - 1 / n)
            square += off * off
            covered += off <= t * s[key, quantity[q]] && -off <= t * s[key, quantity[q]]
        }
        choose[0] = 0
        for (j = 1; j <= n; j++) choose[j] = choose[j - 1] + log((n - j + 1) / j)
        if (freedom[key] != last) { mixture(n, freedom[key], t); limits(n, 0.05 / (2 * cases)); last = freedom[key] }
        ok = covered >= least && covered <= most
        printf "%s,%s,%.4f,%.4f,%d,%d,%.3f,%d,%d,%s\n", key, quantity[q], s[key, quantity[q]], sqrt(square / n),
            covered, n, covered / n, least, most, ok ? "holds" : "FAILS"
        failed += !ok
    }
    exit failed > 0
}
