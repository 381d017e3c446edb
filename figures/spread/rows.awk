# SPDX-License-Identifier: MIT
# Standard deviation between the seeds of each case, from the points.csv of sweeps.
FNR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
{
    key = $column["n_disks"] FS $column["contact.mu_r"] FS $column["contact.friction"]
    key = key FS $column["shear.inertial_number"]
    if (!(key in n)) order[++cases] = key
    n[key]++
    peak[key, n[key]] = $column["sin_phi_peak"]; residual[key, n[key]] = $column["sin_phi_residual"]
}
function deviation(x, key,  i, sum, square) {
    for (i = 1; i <= n[key]; i++) sum += x[key, i]
    for (i = 1; i <= n[key]; i++) square += (x[key, i] - sum / n[key])^2
    return sqrt(square / (n[key] - 1))
}
END {
    print "N,mu_r,friction,I,seeds,s_peak,s_residual"
    for (c = 1; c <= cases; c++)
        printf "%s,%d,%.5f,%.5f\n", order[c], n[order[c]], deviation(peak, order[c]), deviation(residual, order[c])
}
