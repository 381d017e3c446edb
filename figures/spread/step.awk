# SPDX-License-Identifier: MIT
# What half the step changes: sin phi of the second points.csv, with half the step, less that of the first, seed by
# seed. A seed gives one number, the mean over the cases that both files have, for the cases share its packing; mean and
# standard error over the seeds.
FNR == 1 { file++; for (i = 1; i <= NF; i++) column[file, $i] = i; next }
{
    seed = $column[file, "seed"]
    key = seed FS $column[file, "contact.mu_r"] FS $column[file, "contact.friction"]
    key = key FS $column[file, "shear.inertial_number"]
    p = $column[file, "sin_phi_peak"]; r = $column[file, "sin_phi_residual"]
}
file == 1 { peak[key] = p; residual[key] = r; next }
key in peak { cases[seed]++; dp[seed] += p - peak[key]; dr[seed] += r - residual[key] }
function put(name, d,  seed, n, sum, square) {
    for (seed in d) { n++; d[seed] /= cases[seed]; sum += d[seed] }
    for (seed in d) square += (d[seed] - sum / n)^2
    printf "%s,%d,%.5f,%.5f\n", name, n, sum / n, sqrt(square / (n - 1) / n)
}
END { print "quantity,seeds,change,standard_error"; put("peak", dp); put("residual", dr) }
