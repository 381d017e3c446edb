# SPDX-License-Identifier: MIT
# From the CSV of ../definitions.sh, over R2/R1 from 1/10 to 10: the closed form of each number, and how far the tool is
# from it. Variables: names (definitions, separated by blanks), kinematics and energy (files to write). Closed forms of
# touching disks, r = R2/R1: (R1 - R2)/(2(R1 + R2)) is what the mean flow differs by from R_eff (w1 - w2), in slidings.
BEGIN {
    FS = OFS = ","
    n = split(names, name, " ")
    split("RBR PR PS", motion, " ")
    said["RBR"] = "rigid rotation"; said["PR"] = "rolling like gears"; said["PS"] = "sliding without relative spin"
    split("slide and spin|spin and roll", cycle, "|")
    said["slide and spin"] = "slide; spin 1; slide back; spin back"; said["spin and roll"] = "spin 1; roll; spin back; roll back"
}
NR > 1 {
    want = closed($1, $2, $3)
    if ($3 == 10) at_ten[$1, $2] = $4
    count[$1, $2]++
    if (want == "") next # a definition that is not worked out here: only its numbers
    if (!(($1, $2) in worst) || (off = $4 > want ? $4 - want : want - $4) > worst[$1, $2]) worst[$1, $2] = off + 0
}
function closed(what, of, r,   mean) {
    mean = (1 - r)/(2*(1 + r))
    if (what ~ /conjugate$/ || of == "conjugate-spring of bagi-kuhn" || what == "RBR") return 0
    if (of != "wang" && of != "bagi-kuhn" && of !~ /^alonso-/) return ""
    if (what == "PR") return 1
    if (what == "PS") return of == "bagi-kuhn" ? mean : 0
    if (what == "slide and spin") return of == "bagi-kuhn" ? -mean : 0
    if (what == "spin and roll") return of == "bagi-kuhn" ? -mean : of ~ /^alonso/ ? r/(1 + r) : 0
    return ""
}
function words(what, of) {
    if (what == "PR") return "1"
    if (what == "PS" && of == "bagi-kuhn") return "(R1 − R2)/(2(R1 + R2))"
    if (what ~ /spin/ && what !~ /conjugate/ && of == "bagi-kuhn") return "(R2 − R1)/(2(R1 + R2))"
    if (what == "spin and roll" && of ~ /^alonso/) return "R2/(R1 + R2)"
    return "0"
}
function number(x) {
    if (x*x < 1e-24) return "0" # rounding
    return x < 0 ? "−" sprintf("%.4g", -x) : sprintf("%.4g", x)
}
function row(file, first, second, what, of) {
    if (!count[what, of]) return
    if (closed(what, of, 10) == "") { print first, second, "not worked out here", "", number(at_ten[what, of]), "" >file; return }
    print first, second, words(what, of), number(closed(what, of, 10)), number(at_ten[what, of]), sprintf("%.0e", worst[what, of]) >file
    if (worst[what, of] > 1e-9) bad = 1 # ten digits are printed
}
END {
    print "motion", "definition", "V_r over the speed of the motion", "at R2/R1 = 10", "the program", "largest difference" >kinematics
    for (k = 1; k <= 3; k++) for (i = 1; i <= n; i++) row(kinematics, said[motion[k]], name[i], motion[k], name[i])
    print "cycle", "definition and moments", "energy made", "at R2/R1 = 10", "the program", "largest difference" >energy
    for (k = 1; k <= 2; k++) for (i = 1; i <= n; i++) {
        row(energy, said[cycle[k]], name[i] " with the paper's moments", cycle[k], name[i])
        row(energy, said[cycle[k]], name[i] " with conjugate moments", cycle[k] " conjugate", name[i])
    }
    for (k = 1; k <= 2; k++) row(energy, said[cycle[k]], "the law conjugate-spring with bagi-kuhn", cycle[k], "conjugate-spring of bagi-kuhn")
    if (bad) print "a number is not its closed form: " kinematics ", " energy >"/dev/stderr"
    exit bad
}
