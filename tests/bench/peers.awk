# SPDX-License-Identifier: MIT
# From the CSV of peers.sh: is it the same work, and the ratio of the times. Exit code 1 if it is not the same work.
# Allowed: half the overlap over the radius, 5e-4; with the other damping of gran/hooke/history, 0.01. Spins
# are what friction leaves over, so the arms show in them more.
BEGIN {FS = ","; allowed["lammps-rolling"] = allowed["lammps-granular"] = 5e-4; allowed["lammps-gran"] = 0.01}
NR == 1 {next}
{
    key = $2 " " $3
    if (!(key in n)) order[++codes] = key
    us[key, ++n[key]] = $4
    touching[key] = ($5 + $10)/2
    for (i = 5; i <= 9; i++) state[key, i] = $i
}
# spread(WHAT, KEY, COUNT): median (quartiles)
function spread(v, key, count, form,    i, j, t, s) {
    for (i = 1; i <= count; i++) s[i] = v[key, i]
    for (i = 2; i <= count; i++) for (j = i; j > 1 && s[j - 1] > s[j]; j--) {t = s[j]; s[j] = s[j - 1]; s[j - 1] = t}
    middle = s[1 + int((count - 1)/2 + 0.5)]
    return sprintf(form " (" form " to " form ")", middle, s[1 + int((count - 1)/4 + 0.5)], s[1 + int(3*(count - 1)/4 + 0.5)])
}
END {
    for (c = 1; c <= codes; c++) {
        key = order[c]
        split(key, part, " ")
        printf "%-16s %-8s %26s us per step", part[1], part[2], spread(us, key, n[key], "%.1f")
        printf ", %.1f M contact updates/s", touching[key]/middle
        own = "trundle " part[2]
        if (key == own) {print ""; continue}
        for (i = 1; i <= n[key]; i++) ratio[key, i] = us[key, i]/us[own, i]
        printf ", %s times trundle's\n", spread(ratio, key, n[key], "%.2f")
        worst = 0
        for (i = 5; i <= 9; i++) {
            d = state[key, i]/state[own, i] - 1; if (d < 0) d = -d
            if (i == 7) spins = d; else if (d > worst) worst = d
        }
        same = worst <= allowed[part[1]] && spins <= 0.01
        printf "  %s: contacts, kinetic energy and stresses within %.2g, at most %g; energy of spins within %.2g, at most 0.01\n", \
            same ? "ok" : "FAILED", worst, allowed[part[1]], spins
        if (!same) failed = 1
    }
    exit failed
}
