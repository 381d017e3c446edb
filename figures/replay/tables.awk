# SPDX-License-Identifier: MIT
# tables.csv from */replay.csv, */replay-errors.csv, */replay-stress.csv, in this order: of each run and law, errors of
# force over mu P (quantiles of all instants, and by rolled distance), of the energy of all contacts, over that of the
# exact contact, and of sin phi, means of the halves of the strain. The row `exact` has what they are errors of, and the
# shares of the instants.
FNR == 1 {
    n = split(FILENAME, part, "/")
    run = part[n - 1]
    table = part[n]
    for (i = 1; i <= NF; i++) {
        name[i] = $i
        column[$i] = i
    }
    runs[run]
    next
}
table == "replay.csv" {
    for (i = 1; i <= NF; i++)
        if (name[i] ~ /_J_per_m$/) work[run, name[i]] += $i
}
table == "replay-errors.csv" && $1 == "force" {
    law = $2
    if ($3 == "all") {
        if (!(law in seen)) { seen[law]; order[++laws] = law }
        at[run, law] = $9 "," $11 "," $12
        instants[run] = $6
    }
    if ($3 == "rolled_a") {
        class[run, law, $5] = $11
        count[run, $5] = $6
    }
}
table == "replay-stress.csv" {
    late = $column["strain"] > half
    for (i = 1; i <= NF; i++)
        if (name[i] ~ /^sin_phi_/ && $i != "") { # an empty cell has no number
            sum[run, substr(name[i], 9), late] += $i
            rows[run, substr(name[i], 9), late]++
        }
}
function energy(run, law) { return work[run, law "_J_per_m"] }
function strength(run, law, late) { return sum[run, law, late] / rows[run, law, late] }
function shift(run, law, late) { return strength(run, law, late) - (law == "exact" ? 0 : strength(run, "exact", late)) }
BEGIN { half = 0.1 }
END {
    print "run,law,median,q90,q99,q90_rolled_below_0.1,q90_rolled_0.3_to_1,q90_rolled_above_3,energy,sin_phi_early,sin_phi_late"
    for (run in runs) {
        printf "%s,exact,0,0,0,%.3f,%.3f,%.3f,%.6g,%.4f,%.4f\n", run, (count[run, "0.03"] + count[run, "0.1"])/instants[run],
            count[run, "1"]/instants[run], count[run, "inf"]/instants[run], energy(run, "exact"), shift(run, "exact", 0), shift(run, "exact", 1)
        for (k = 1; k <= laws; k++) {
            law = order[k]
            printf "%s,%s,%s,%s,%s,%s,%.5f,%.4f,%.4f\n", run, law, at[run, law], class[run, law, "0.1"], class[run, law, "1"],
                class[run, law, "inf"], energy(run, law)/energy(run, "exact") - 1, shift(run, law, 0), shift(run, law, 1)
        }
    }
}
