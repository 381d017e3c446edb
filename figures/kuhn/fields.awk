# SPDX-License-Identifier: MIT
# What the fields of the film say, from the contacts.csv of its runs: of the contacts that touched all their interval,
# beyond 5 % strain. To `classes`, by mobilisation, the share of them and the median of each quantity; to the output,
# Spearman's rank correlations. The name of a run is that of its folder.
# usage: awk -F, -v classes=CLASSES.csv -f fields.awk RUN/contacts.csv ... >CORRELATIONS.csv
BEGIN {
    n = 0
    n_names = split("mobilisation slide_m roll_m creep_m roll_over_slide creep_over_slide f_n", name, " ")
    n_pairs = split("1 2 1 3 2 3 1 5 2 5 3 5 1 6 5 6 7 1 7 5", pair, " ")/2
    print "contacts,mobilisation_from,share,slide_median_m,roll_median_m,creep_median_m,roll_over_slide_median,creep_over_slide_median" >classes
    print "contacts,number,of,with,rank_correlation"
}
function size(x) { return x < 0 ? -x : +x }
# In place, ascending: the numbers of the contacts by quantity q (Shell's sort).
function sort_by(q, order,   gap, i, j, k) {
    for (i = 0; i < n; i++) order[i] = i
    for (gap = int(n/2); gap > 0; gap = int(gap/2.2 + 0.5 - (gap == 1)))
        for (i = gap; i < n; i++) {
            k = order[i]
            for (j = i; j >= gap && x[q, order[j - gap]] > x[q, k]; j -= gap) order[j] = order[j - gap]
            order[j] = k
        }
}
# Ranks of q about their mean, equal ones (contacts that slide have mobilisation 1) with the mean of theirs; medians of
# each class.
function look(q,   order, i, j, k, c, passed) {
    sort_by(q, order)
    for (i = 0; i < n; i = j) {
        for (j = i + 1; j < n && x[q, order[j]] == x[q, order[i]]; j++) continue
        for (k = i; k < j; k++) rank[q, order[k]] = (i + j - n)/2
    }
    for (i = 0; i < n; i++) {
        c = class[order[i]]
        if (++passed[c] == int((count[c] + 1)/2)) median[q, c] = x[q, order[i]]
    }
}
function correlation(p, q,   i, pq, pp, qq) {
    for (i = 0; i < n; i++) {
        pq += rank[p, i]*rank[q, i]; pp += rank[p, i]^2; qq += rank[q, i]^2
    }
    return pq/sqrt(pp*qq)
}
function tell(   q, c, i, line) {
    for (q = 1; q <= n_names; q++) look(q)
    for (c = 0; c <= 4; c++) {
        line = run "," c/4 "," sprintf("%.3f", count[c]/n)
        for (q = 2; q <= 6; q++) line = line "," sprintf("%.3g", median[q, c])
        print line >>classes
        count[c] = 0
    }
    for (i = 1; i <= n_pairs; i++) {
        q = pair[2*i - 1]; c = pair[2*i]
        printf "%s,%d,%s,%s,%.2f\n", run, n, name[q], name[c], correlation(q, c)
    }
    n = 0
}
FNR == 1 {
    if (n) tell()
    k = split(FILENAME, part, "/"); run = part[k - 1]
    for (i = 1; i <= NF; i++) {
        sub(/^f_n_.*/, "f_n", $i) # disks N/m, spheres N
        column[$i] = i
    }
    next
}
$column["strain"] > 0.0501 && $column["followed"] && $column["u_slide_m"] != 0 {
    x[1, n] = +$column["mobilisation"]
    class[n] = x[1, n] >= 1 - 1e-9 ? 4 : int(4*x[1, n]*(1 - 1e-9)); count[class[n]]++
    x[2, n] = size($column["u_slide_m"]); x[3, n] = size($column["u_roll_m"]); x[4, n] = size($column["u_creep_m"])
    x[5, n] = x[3, n]/x[2, n]; x[6, n] = x[4, n]/x[2, n]
    x[7, n] = +$column["f_n"]
    n++
}
END { tell() }
