# SPDX-License-Identifier: MIT
# Do rotations gather in bands? From the last instant of a disks.csv, for |rotation| and for the mean |V_r|: Gini
# coefficient and 90th over 50th percentile, of the values only, at any place; and the correlation length, of
# where they are.
#
# For rotations that are normal and independent: Gini sqrt(2) - 1 = 0.414, percentiles 1.645/0.674 = 2.44, length 0.
# Correlation C(r): of the ranks of the values of two disks r apart, in bins of a mean diameter, from every twentieth
# disk; ranks, so that a few runaways do not count. Length: sum of C over the bins up to the first with C < 0.05, in
# diameters. `null`: the largest |C| of any bin with the ranks shuffled, four times. Lines to standard output:
# name,value,rotation,rolling
# usage: awk -F, -f localisation.awk disks.csv
function shuffle(from, to,    i, j, keep) {
    for (i = 0; i < n; i++) to[i] = from[i]
    for (i = n - 1; i > 0; i--) {j = int((i + 1)*rand()); keep = to[i]; to[i] = to[j]; to[j] = keep}
}
# In place, ascending: the numbers of the disks by their value (Shell's sort).
function sort_by(value, order,    gap, i, j, k) {
    for (i = 0; i < n; i++) order[i] = i
    for (gap = int(n/2); gap > 0; gap = int(gap/2.2 + 0.5 - (gap == 1)))
        for (i = gap; i < n; i++) {
            k = order[i]
            for (j = i; j >= gap && value[order[j - gap]] > value[k]; j -= gap) order[j] = order[j - gap]
            order[j] = k
        }
}
# Gini, percentiles; rank from -1 to 1 in `rank`
function distribution(value, rank,    order, i, sum, weighted) {
    sort_by(value, order)
    sum = weighted = 0
    for (i = 0; i < n; i++) {
        sum += value[order[i]]; weighted += (i + 1)*value[order[i]]
        rank[order[i]] = 2*(i + 0.5)/n - 1
    }
    gini = 2*weighted/(n*sum) - (n + 1)/n
    median = value[order[int(n/2)]]
    ratio = value[order[int(0.9*n)]]/median
}
function correlate(rank,    i, j, k, cx, cy, b, c, s, shuffled, count, C, N, r, x, y, dx, dy) {
    for (s = 0; s < 4; s++) {shuffle(rank, shuffled); for (i = 0; i < n; i++) null_rank[s, i] = shuffled[i]}
    for (b = 0; b < bins; b++) count[b] = C[b] = N[0, b] = N[1, b] = N[2, b] = N[3, b] = 0
    for (i = 0; i < n; i += 20) {
        x = X[i]; y = Y[i]; cx = int(x/reach); cy = int(y/reach)
        for (c = 0; c < 9; c++) {
            cell = (cx + c%3 - 1) " " (cy + int(c/3) - 1)
            for (k = 0; k < cells[cell]; k++) {
                j = member[cell, k]
                dx = X[j] - x; dy = Y[j] - y; r = sqrt(dx*dx + dy*dy)/d
                if (j == i || r >= bins) continue
                b = int(r)
                count[b]++; C[b] += rank[i]*rank[j]
                for (s = 0; s < 4; s++) N[s, b] += null_rank[s, i]*null_rank[s, j]
            }
        }
    }
    span = largest = 0; open = 1
    for (b = 0; b < bins; b++) if (count[b] > 500) {
        at[b] = 3*C[b]/count[b] # ranks have the variance 1/3
        if (at[b] < 0.05) open = 0
        if (open) span += at[b]
        for (s = 0; s < 4; s++) {
            r = 3*N[s, b]/count[b]
            if (r < 0) r = -r
            if (r > largest) largest = r
        }
    }
}
FNR == 1 {for (i = 1; i <= NF; i++) column[$i] = i; next}
$column["time_s"] != time {time = $column["time_s"]; n = sum_r = 0}
{
    X[n] = $column["x_m"] + 1; Y[n] = $column["y_m"] + 1 # cells are counted from 0
    turned[n] = $column["angle_rad"] < 0 ? -$column["angle_rad"] : +$column["angle_rad"]
    rolls[n] = +$column["mean_v_r_m_per_s"]
    sum_r += $column["radius_m"]
    n++
}
END {
    srand(1)
    bins = 20; d = 2*sum_r/n; reach = bins*d
    for (i = 0; i < n; i++) {cell = int(X[i]/reach) " " int(Y[i]/reach); member[cell, cells[cell]++] = i}
    distribution(turned, rank)
    correlate(rank)
    degrees = 180/3.14159265358979
    printf "median,%.4g deg\ngini,%.3f\np90_over_p50,%.2f\ncorrelation_1,%.3f\ncorrelation_5,%.3f\ncorrelation_10,%.3f\nlength,%.2f\nnull,%.3f\n", \
        median*degrees, gini, ratio, at[1], at[5], at[10], span, largest
    distribution(rolls, rank)
    correlate(rank)
    printf "rolling_median,%.4g m/s\nrolling_gini,%.3f\nrolling_p90_over_p50,%.2f\nrolling_correlation_1,%.3f\nrolling_correlation_5,%.3f\nrolling_correlation_10,%.3f\nrolling_length,%.2f\nrolling_null,%.3f\n", \
        median, gini, ratio, at[1], at[5], at[10], span, largest
}
