# SPDX-License-Identifier: MIT
# shellcheck shell=sh
# The card (trundle measures --card) in a code that reads data files of LAMMPS. Sourced by CODE.sh with the arguments CARD.csv
# ANSWERS.csv, in an empty directory; CODE.sh then has
#
#   solve NAME EXPERIMENT WALL   writes and runs the input of NAME.data, and leaves the dump NAME.atoms: id fx fy tqz
#
# and ends with `ask "CODE RELEASE"`. All motions of an experiment stand side by side in one box. Places are frozen and velocities
# given: no integrator, ten updates of the history in the time of the card. Disks on a floor: those at rest, the floor does not move.
set -eu
card=$1 answers=$2
gap=1.0 steps=10

# rows EXPERIMENT WALL: lines of the card, with their number first
rows() { awk -F, -v e="$1" -v wall="$2" 'NR > 1 && $2 == e && (($3 == "inf") == wall) && (!wall || $1 ~ /resting/) {print NR "," $0}' "$card"; }

# data WALL: rows on standard input to a data file
data() {
    awk -F, -v wall="$1" -v gap=$gap '
        { n++; x = gap*(n - 0.5)
          for (b = 1 + wall; b <= 2; b++) {
              id++; r = b == 1 ? $4 : $5
              atom[id] = sprintf("%d 1 %.17g 2700 %.17g %.17g 0", id, 2*r, (b == 1 ? $6 : $8) + x, b == 1 ? $7 : $9)
              speed[id] = sprintf("%d %s %s 0 0 0 %s", id, b == 1 ? $10 : $12, b == 1 ? $11 : $13, b == 1 ? $14 : $15)
          } }
        END { printf "card\n\n%d atoms\n1 atom types\n0 %g xlo xhi\n-2 2 ylo yhi\n-0.5 0.5 zlo zhi\n\nAtoms\n\n", id, gap*(n + 1)
          for (i = 1; i <= id; i++) print atom[i]
          print "\nVelocities\n"
          for (i = 1; i <= id; i++) print speed[i] }'
}

# play EXPERIMENT WALL: answers, a line for each row: NUMBER F_n F_t M1 M2, M1 - where there is a wall. The springs are those of the
# first row: they are the same in all.
play() {
    name=$1-$2
    rows "$1" "$2" >"$name.rows"
    data "$2" <"$name.rows" >"$name.data"
    IFS=, read -r _ _ _ _ _ _ floor _ _ _ _ _ _ _ _ _ k_n k_t mu k_roll mu_r time <"$name.rows"
    dt=$(awk -v t="$time" -v n=$steps 'BEGIN {printf "%.17g", t/n}')
    export floor k_n k_t mu k_roll mu_r dt steps
    solve "$name" "$1" "$2" >"$name.said" 2>&1 || { cat "$name.said" >&2; tail -n 5 "log.$name" >&2; return 1; }
    awk -F, -v wall="$2" '
        FNR == NR { if (/^ITEM/) on = /ATOMS/; else if (on) {split($0, w, " "); fx[w[1]] = w[2]; fy[w[1]] = w[3]; q[w[1]] = w[4]}; next }
        { n++; two = wall ? n : 2*n; one = wall ? 0 : 2*n - 1
          dx = $8 - $6; dy = $9 - $7; L = sqrt(dx*dx + dy*dy); nx = dx/L; ny = dy/L
          printf "%d %.17g %.17g %s %.17g\n", $1, fx[two]*nx + fy[two]*ny, -(fx[two]*ny - fy[two]*nx),
              wall ? "-" : sprintf("%.17g", q[one]), q[two] }' "$name.atoms" "$name.rows"
}

ask() { # "CODE RELEASE"
    for experiment in roll cap slide; do
        play $experiment 0
        play $experiment 1
    done >forces
    awk -v code="$1" 'BEGIN {OFS = ","}
        FNR == NR { a[$1] = $2 "," $3 "," ($4 == "-" ? "" : $4) "," $5; next }
        FNR == 1 { print $0, "code,F_n,F_t,M1,M2"; next }
        FNR in a { print $0, code, a[FNR] }' forces "$card" >"$answers"
    echo "$1"
}
