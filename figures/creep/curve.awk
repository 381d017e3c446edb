# SPDX-License-Identifier: MIT
# history.csv of the seeds of one case: mean over the seeds at each row, and the 95 % interval of that mean (Student).
# usage: awk -f curve.awk -v mu_r=.. -v friction=.. FILES   prints mu_r,friction,strain,sin_phi,half,void_ratio,half
BEGIN { FS = OFS = "," }
FNR == 1 { files++; split("", at); for (i = 1; i <= NF; i++) at[$i] = i; next }
{
    k = FNR - 1; if (k > rows) rows = k
    n[k]++; strain[k] += $at["strain"]
    p = $at["sin_phi"]; e = $at["void_ratio"]
    phi[k] += p; phi2[k] += p*p; void[k] += e; void2[k] += e*e
}
function half(sum, squares, m,   v) {
    v = (squares - sum*sum/m)/(m - 1)
    return student(0.05, m - 1)*sqrt((v > 0 ? v : 0)/m)
}
END {
    for (k = 1; k <= rows; k++)
        if (n[k] == files && files > 1)
            print mu_r, friction, strain[k]/n[k], phi[k]/n[k], half(phi[k], phi2[k], n[k]), void[k]/n[k], half(void[k], void2[k], n[k])
    print ""; print ""
}
