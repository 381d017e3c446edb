# SPDX-License-Identifier: MIT
# Of points.csv: a row for each method of each case: name, error at the default step, time to an error of 1e-3 [s] with
# its quartiles, between two points by a straight line in logarithms; where every step does better, the time of the
# coarsest. Without a default step a case is left out.
BEGIN {FS = ","; print "row,name,error,seconds,low,high,at_most"}
NR == 1 {next}
$1 "," $2 != now {flush(); now = $1 "," $2; name = $1 ": " $2; error = ""; n = 0}
$5 != "" {e[n] = $5; t[n] = $6; low[n] = $7; high[n] = $8; n++}
$9 == 1 {error = $5}
END {flush()}
function between(x, y, part) {return exp(log(x) + part*(log(y) - log(x)))}
function flush(k, part) {
    if (error == "") return
    for (k = n; k > 0 && e[k - 1] < 1e-3; k--) ;
    printf "%d,%s,%s,", row++, name, error
    if (k == n) {print "NaN,NaN,NaN,NaN"; return}
    if (k == 0) {print "NaN,NaN,NaN," t[0]; return}
    part = log(e[k - 1]/1e-3)/log(e[k - 1]/e[k])
    printf "%.3g,%.3g,%.3g,NaN\n", between(t[k - 1], t[k], part), between(low[k - 1], low[k], part), between(high[k - 1], high[k], part)
}
