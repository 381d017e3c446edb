#!/bin/sh
# SPDX-License-Identifier: MIT
# Files of the user are never removed or written over: what a command reads, and what no run has made.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
cd "$work" || exit 1

write_small_case small.yaml
write_bodies_case bodies.yaml
cat >contact.yaml <<'CASE'
kind: contact
bodies: {R1: 10 mm, R2: 10 mm, E: 70 GPa, nu: 0.3}
laws:
  - {friction: dahlberg-alfredsson, mu: 0.3, k_t: 10 GPa}
path: paths.csv
output: {curves: no}
CASE
printf 'u_slide_m,u_roll_m,P_N_per_m\n1e-6,0,1000\n2e-6,1e-6,1000\n' >table.csv
sum() { find "$1" -type f -exec cksum {} + | sort; }
# keeps DIR COMMAND...: the command changes nothing in DIR
keeps() {
    kept=$1
    shift
    before=$(sum "$kept")
    "$@" || return 1
    equals "$(sum "$kept")" "$before"
}
refuses() { run_gives 3 "$@"; }

# ---- what a run reads ----
for file in paths.csv contact.csv case.yaml summary.json plot.gp contact.svg history.csv paths/1-2.csv \
    paths/wall0-3.csv; do
    rm -rf in && mkdir -p in/paths && cp table.csv "in/$file"
    check "a path called $file in the directory of the results" keeps in refuses contact.yaml --set path="in/$file" -o in
    check 'both names are in the message' says stderr "in/$file, which this command reads"
    check 'also with --force' keeps in refuses contact.yaml --set path="in/$file" -o in --force
done
rm -rf in && mkdir -p in/paths && cp table.csv in/mine.csv && ln in/mine.csv in/contact.csv
check 'a path under a second name' keeps in refuses contact.yaml --set path=in/mine.csv -o in
rm -f in/contact.csv && ln -s mine.csv in/contact.csv
check 'or behind a symbolic link' keeps in refuses contact.yaml --set path=in/mine.csv -o in
rm -f in/contact.csv
check 'any other name is fine' run_gives 0 contact.yaml --set path=in/mine.csv -o in
check 'it is there afterwards' cmp table.csv in/mine.csv
sed 's/contacts: 3/contacts: 3, paths: [wall0-0]/' bodies.yaml >recorded.yaml
check 'the results of a run, replayed into its own directory' run_gives 0 recorded.yaml -o own
check 'are refused' keeps own refuses contact.yaml --set path=own/paths/wall0-0.csv -o own --force
ln -s own alias
check 'also by another way' keeps own refuses contact.yaml --set path=own/paths/wall0-0.csv -o alias --force
mkdir self && cp bodies.yaml self/case.yaml
check 'a case file' keeps self refuses self/case.yaml -o self --force
check 'an existing sample' run_gives 0 small.yaml -o one --sample sample.bin
mkdir two && cp sample.bin two/checkpoint.bin
check 'and has the name of a result' keeps two refuses small.yaml -o two --sample two/checkpoint.bin --force
check 'a sample that the run would make, and write over' refuses small.yaml -o three --sample three/history.csv
check 'nothing is there' is_silent ls three
"$TRUNDLE" measures -o card.csv >stdout 2>stderr
cp card.csv card.before
measures() { ! "$TRUNDLE" measures card.csv -o "$1" >stdout 2>stderr; }
check 'a table that is read' measures ./card.csv
check 'is as it was' cmp card.before card.csv
check 'both names' says stderr './card.csv would replace card.csv'
measures_part_is_kept() {
    "$TRUNDLE" measures wanted.csv.part -o wanted.csv >stdout 2>stderr
    [ $? -eq 3 ] && cmp first.csv wanted.csv.part && says stderr 'wanted.csv.part has the name of a result'
}
bench() { ! "$TRUNDLE" bench --sizes 100 small.yaml -o small.yaml >stdout 2>stderr; }
cp small.yaml small.before
check 'a case of bench' bench
check 'it is as it was too' cmp small.before small.yaml

# ---- what no run has made ----
for file in history.csv contacts.csv case.yaml summary.json checkpoint.bin history.csv.part frames/12345.png \
    paths/1-2.csv; do
    rm -rf home && mkdir -p home/frames home/paths && echo mine >"home/$file"
    check "$file that no run has made" keeps home refuses small.yaml -o home
    check 'is named' says stderr "home/$file was not made by trundle"
done
rm -rf home && mkdir -p home/frames && echo mine >home/history.csv
check 'also with --force' keeps home refuses small.yaml -o home --force
rm home/history.csv && echo mine >home/frames/12345.png
check 'a picture that is not in the way stays with --force' keeps home/frames run_gives 0 bodies.yaml -o home --force
rm -rf home && mkdir -p home/frames && echo mine >home/frames/00001.png
check 'one in the way is kept' keeps home/frames refuses bodies.yaml -o home --force --frames 3
rm -rf other home && mkdir other home && echo mine >other/00000.png && ln -s ../other home/frames
check 'frames that is a symbolic link' keeps other refuses bodies.yaml -o home --frames 2 --force
check 'is named too' says stderr 'home/frames is a symbolic link'
rm -rf old && cp -r one old && rm old/trundle-files.txt
check 'a directory without a list, as older versions left them' keeps old refuses small.yaml -o old --force
check 'a list with names outside of the directory' run_gives 0 bodies.yaml -o listed
echo mine >precious
printf '../precious\n/%s/precious\nnotes.txt\n' "$work" >>listed/trundle-files.txt
echo mine >listed/notes.txt
check 'removes results alone' run_gives 0 bodies.yaml -o listed --force
check 'nothing else' equals "$(cat precious listed/notes.txt)" 'mine
mine'
check 'a file of the name of a former result' run_gives 0 bodies.yaml -o once --frames 2
check 'of which there is none now' run_gives 0 bodies.yaml -o once --force
echo mine >once/frames.txt
mkdir once/frames && echo mine >once/frames/00000.png
check 'is not taken for one' keeps once/frames refuses bodies.yaml -o once --force --frames 2
check 'a list cut short in a name' run_gives 0 bodies.yaml -o torn
printf 'contac' >>torn/trundle-files.txt
check 'continues' run_gives 0 bodies.yaml -o torn --force
check 'a name a line' is_silent grep -v -x -E '#.*|contac|-?[a-z./0-9]+\.(csv|yaml|json)' torn/trundle-files.txt

# ---- the list itself ----
mkdir listy && cp bodies.yaml listy/trundle-files.txt
check 'a case that is called like the list' keeps listy refuses listy/trundle-files.txt -o listy --force
check 'is told' says stderr 'listy/trundle-files.txt was not made by trundle'
mkdir linked && echo mine >outside.txt && ln -s ../outside.txt linked/trundle-files.txt
check 'a list that is a symbolic link' refuses bodies.yaml -o linked
check 'is not written through' equals "$(cat outside.txt)" mine
mkdir listed_link && cp listed/trundle-files.txt elsewhere.txt && ln -s ../elsewhere.txt listed_link/trundle-files.txt
check 'not even to a true list' refuses bodies.yaml -o listed_link
check 'which is as it was' cmp listed/trundle-files.txt elsewhere.txt
if command -v mkfifo >/dev/null; then
    mkdir pipes && mkfifo pipes/trundle-files.txt
    waits_not() { timeout 20 "$TRUNDLE" run "$@" >stdout 2>stderr; [ $? -eq 3 ]; }
    check 'a pipe in its place does not wait' waits_not bodies.yaml -o pipes
    cp -r once piped && rm piped/summary.json && mkfifo piped/summary.json
    check 'also not as a result' waits_not bodies.yaml -o piped --resume
    mkfifo sample.fifo
    check 'also not as a sample' waits_not small.yaml -o four --sample sample.fifo
fi

# ---- names of parts ----
"$TRUNDLE" measures -o first.csv >/dev/null 2>&1
cp first.csv wanted.csv.part
check 'an input that has the name of the part' measures_part_is_kept
echo mine >sm.bin.part
check 'a file in the way of the part of a sample' refuses small.yaml -o five --sample sm.bin
check 'is kept' equals "$(cat sm.bin.part)" mine

# ---- --resume ----
run contact.yaml --set path=table.csv -o done
echo mine >done/checkpoint.bin && echo mine >done/checkpoint.bin.part
check '--resume of a finished run' keeps done run_gives 0 contact.yaml --set path=table.csv -o done --resume
"$TRUNDLE" run small.yaml -o hard --checkpoint 0 --set shear.inertial_number=5e-4 >/dev/null 2>&1 &
child=$!
for _ in $(seq 200); do [ -s hard/checkpoint.bin ] && [ -s hard/history.csv.part ] && break; sleep 0.02; done
kill -INT $child
wait $child 2>/dev/null
cp -al hard backup
kept_by_links() { (cd backup && find . -type f ! -name trundle-files.txt -exec cksum {} + | sort); }
before=$(kept_by_links)
check 'a run that was copied by hard links continues' run_gives 0 small.yaml -o hard --resume --set shear.inertial_number=5e-4
check 'the copy is as it was' equals "$(kept_by_links)" "$before"

# ---- a name is on the list before its file exists ----
is_listed() { listing "$1" | grep -v -x -F -f "$1/trundle-files.txt"; }
check 'all that a run leaves is listed' is_silent is_listed one
"$TRUNDLE" run small.yaml -o killed --frames 40 --checkpoint 0 >/dev/null 2>&1 &
child=$!
sleep 0.3
kill -KILL $child
wait $child 2>/dev/null
are_listed() { listing killed | sed 's/\.part$//; s/\.old$//' | grep -v -x -F -f killed/trundle-files.txt; }
check 'and what a killed run leaves' is_silent are_listed
check 'which is replaced without --force' run_gives 0 small.yaml -o killed
if strace -f -o /dev/null true 2>/dev/null; then
    strace -f -e trace=fsync,openat,rename,renameat -o trace "$TRUNDLE" run bodies.yaml -o traced >/dev/null 2>&1
    synced() { # the first fsync comes before the first file of results
        awk '/trundle-files.txt/ { listed = 1 } /fsync/ { if (listed) synced = 1 }
             /history\.csv\.part/ { print listed && synced; exit }' trace
    }
    check 'the list is on the disk first' equals "$(synced)" 1
else
    skip 'the list is on the disk first' 'no strace'
fi

# ---- tables of other commands ----
mkdir tables && echo mine >tables/verify.csv
verify() { ! "$TRUNDLE" verify slip-to-roll -o tables >stdout 2>stderr; }
check 'a table of that name in the directory of verify' keeps tables verify
check 'is found before anything is computed' not grep -q '^exact' stdout
cat >sweep.yaml <<'CASE'
kind: sweep
base: small.yaml
seeds: [1]
vary: {contact.mu: [0.5]}
collect: [sin_phi_peak]
CASE
sweep() { "$TRUNDLE" sweep sweep.yaml -o swept >stdout 2>stderr; }
check 'a sweep' sweep
check 'again' sweep
rm -rf swept && mkdir swept && echo mine >swept/points.csv
not_swept() { ! sweep; }
check 'points.csv that no sweep has made' keeps swept not_swept
finish
