# SPDX-License-Identifier: MIT
# From history.csv of the runs of kuhn.sh, in directories by their names: tables.csv, the numbers of Kuhn's tables 2, 3
# and 4 as means over the rows of 20.5 to 25.5 % strain, and on the output a verdict on each of his trends and reasons.
#
# A verdict is about a number of each block of 5 % strain, from 10 % on, and its mean. Runs that differ in anything are
# other packings after some percent of strain, and 5 % is longer than their stresses remember: blocks stand for
# independent samples, and the interval is Student's, 95 %. `holds` if it lies in the range in which the claim is true,
# `fails` if outside, else `undecided`.
BEGIN { OFS = FS = "," }
FNR == 1 {
    n = split(FILENAME, part, "/"); run = part[n - 1]; known[run] = 1
    for (i = 1; i <= NF; i++) column[$i] = i
    next
}
function value(name) { return $column[name] }
FNR == 2 {
    e0[run] = value("void_ratio"); z0[run] = value("coordination"); a0[run] = value("a_over_R")
    next
}
{
    strain = value("strain"); b = int(strain/0.05 + 1e-9)
    near = strain > 0.205 && strain <= 0.255
    for (name in column) {
        if (value(name) == "") continue # an empty cell has no number
        sum[run, name, b] += value(name); count[run, name, b]++
        if (near) { mean_23[run, name] += value(name); at_23[run, name]++ }
    }
    stress = column["stress_1_Pa"] ? column["stress_1_Pa"] : column["stress_1_N_per_m"]
    if (b > 0) { held = ($stress + $(stress + 1))/2; s1[run] += held; s2[run] += held*held; sn[run]++ }
    if (b > blocks[run] + 0 && strain >= 0.05*(b + 1) - 0.0051) blocks[run] = b
}
function block(run, name, b) { return sum[run, name, b]/count[run, name, b] }
function of(run, name) { return at_23[run, name] ? mean_23[run, name]/at_23[run, name] : "" }
# how: "-" or "/" of two runs, "" only of p
function judge(claim, p, q, name, how, from, to,   b, n, last, d, total, squares, mean, half, verdict) {
    if (!(p in known) || (how != "" && !(q in known))) return
    last = blocks[p]
    if (how != "" && blocks[q] < last) last = blocks[q]
    for (b = 2; b <= last; b++) {
        d[++n] = block(p, name, b)
        if (how == "-") d[n] -= block(q, name, b)
        if (how == "/") d[n] /= block(q, name, b)
        total += d[n]
    }
    if (n < 2) return
    mean = total/n
    for (b = 1; b <= n; b++) squares += (d[b] - mean)^2
    half = student(0.05, n - 1)*sqrt(squares/(n - 1)/n)
    verdict = mean - half >= from && mean + half <= to ? "holds" : mean + half < from || mean - half > to ? "fails" : "undecided"
    printf "%s,%s%s,%s,%.4g,%.4g,%.4g,%g,%g,%d,%s\n", claim, p, how == "" ? "" : " " how " " q, name, mean, mean - half, mean + half,
        from, to, n, verdict
}
END {
    n_columns = split("void_ratio coordination a_over_R sin_phi friction_share_of_q roll_over_slide_q1 roll_over_slide_median " \
        "roll_over_slide_q3 roll_over_slide_mean creep_over_slide_q1 creep_over_slide_median creep_over_slide_q3 " \
        "creep_over_slide_mean run_over_a_median run_over_a_median_by_length rolled_in_runs_above_2a followed unbalanced", wanted, " ")
    table = "run,e0,contacts_per_particle_0,coordination_0,a_over_R_0,mean_stress_scatter"
    for (i = 1; i <= n_columns; i++) table = table "," wanted[i]
    print table >tables
    close(tables) # before sort continues with it
    for (run in known) {
        m = s1[run]/sn[run]
        table = run "," e0[run] "," z0[run]/2 "," z0[run] "," a0[run] "," sprintf("%.3f", sqrt(s2[run]/sn[run] - m*m)/m)
        for (i = 1; i <= n_columns; i++) table = table "," sprintf("%.4g", of(run, wanted[i]))
        print table | ("sort >>" tables)
    }
    close("sort >>" tables)
    print "claim,runs,quantity,mean,low_95,high_95,true_from,true_to,blocks,verdict"
    split("disks spheres", shapes, " "); split("large small", sizes, " ")
    for (i = 1; i <= 2; i++) {
        for (j = 1; j <= 2; j++) {
            s = shapes[i] "-" sizes[j]; cm = s "-cattaneo-mindlin"; creep = s "-kuhn-creep"
            judge("creep does not change the strength", creep, cm, "sin_phi", "-", -0.02, 0.02)
            judge("creep does not change the volume", creep, cm, "void_ratio", "-", -0.01, 0.01)
            judge("creep increases rolling slightly", creep, cm, "roll_over_slide_median", "/", 1, 1.3)
            judge("the effect of creep is modest", creep, "", "creep_over_slide_median", "", 0, 0.5)
            judge("reason 1: half of the contacts roll less than 10 times as fast as they slide", creep, "", "roll_over_slide_median", "", 0, 10)
            judge("reason 2: half of the runs end within 2 a", creep, "", "run_over_a_median", "", 0, 2)
            judge("reason 2: most of the way is in runs that end within 2 a", creep, "", "rolled_in_runs_above_2a", "", 0, 0.5)
            judge("reason 3: friction gives less than a quarter of the strength", creep, "", "friction_share_of_q", "", 0, 0.25)
        }
        s = shapes[i]
        judge("small contacts roll more", s "-small-cattaneo-mindlin", s "-large-cattaneo-mindlin", "roll_over_slide_median", "/", 1, 1e9)
        judge("small contacts roll more", s "-small-kuhn-creep", s "-large-kuhn-creep", "roll_over_slide_median", "/", 1, 1e9)
        judge("creep has a larger effect on large contacts", s "-large-kuhn-creep", s "-small-kuhn-creep", "creep_over_slide_median", "/", 1, 1e9)
    }
    cm = "disks-large-cattaneo-mindlin"
    judge("reason 3: strength does not follow mu; 0.3 against 0.5", "mu-0.3", cm, "sin_phi", "-", -0.05, 0.05)
    judge("reason 3: strength does not follow mu; 0.8 against 0.5", "mu-0.8", cm, "sin_phi", "-", -0.05, 0.05)
    judge("slow enough: strength at I = 1e-3", "slow-cattaneo-mindlin", cm, "sin_phi", "-", -0.02, 0.02)
    judge("slow enough: rolling at I = 1e-3", "slow-cattaneo-mindlin", cm, "roll_over_slide_median", "/", 0.8, 1.25)
    judge("strength at I = 1e-2", "fast-cattaneo-mindlin", cm, "sin_phi", "-", -0.02, 0.02)
    judge("rolling at I = 1e-2", "fast-cattaneo-mindlin", cm, "roll_over_slide_median", "/", 0.8, 1.25)
    judge("an interval five times as long", "interval-long", cm, "roll_over_slide_median", "/", 0.8, 1.25)
    judge("an interval a fifth as long", "interval-short", cm, "roll_over_slide_median", "/", 0.8, 1.25)
}
