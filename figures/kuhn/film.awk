# SPDX-License-Identifier: MIT
# From disks.csv and contacts.csv of a run, in this order, for each instant out-NNN.dat: the disks (x, y, R), an empty
# pair of lines, and two lines a contact (x, y, along, mobilisation, log10 of rolling and of creep over sliding). Each
# line goes from the centre of a disk, at its place in the cell, to the contact: where a contact goes across an edge its
# halves are apart, each with its own disk. Lengths in mm. A contact that did not touch all the interval has no
# increments: its logarithms are "?".
# usage: awk -F, -v out=OUT -f film.awk disks.csv contacts.csv
function log10(part, whole) { return part != 0 && whole != 0 ? log(part*part/(whole*whole))/(2*log(10)) : "?" }
function value(name) { return $column[name] }
FNR == 1 {
    table++; k = 0; time = ""
    for (i = 1; i <= NF; i++) column[$i] = i
    next
}
value("time_s") != time {
    if (k) close(file)
    time = value("time_s"); file = sprintf("%s-%03d.dat", out, ++k)
    if (table == 2) print "\n" >>file
}
table == 1 {
    i = value("disk")
    x[k, i] = 1000*value("x_m"); y[k, i] = 1000*value("y_m"); R[k, i] = 1000*value("radius_m")
    print x[k, i], y[k, i], R[k, i] >file
    next
}
{
    a = k SUBSEP value("a"); b = k SUBSEP value("b"); half = 500*value("overlap_m")
    fields = value("mobilisation") " ? ?"
    if (value("followed")) fields = value("mobilisation") " " log10(value("u_roll_m"), value("u_slide_m")) " " \
        log10(value("u_creep_m"), value("u_slide_m"))
    print x[a], y[a], (R[a] - half)*value("nx"), (R[a] - half)*value("ny"), fields >>file
    print x[b], y[b], (half - R[b])*value("nx"), (half - R[b])*value("ny"), fields >>file
}
