#!/bin/sh
# SPDX-License-Identifier: MIT
# Which commit a program was built from: summary.json and --version say it, and the build needs no git for it.
set -u
# shellcheck source=tests/system/tap.sh
. "$(dirname "$0")/tap.sh"
unset MAKEFLAGS MAKELEVEL BUILD CC CXX CFLAGS GIT_DIR GIT_WORK_TREE

# ---- the program ----
write_bodies_case "$work/fall.yaml"
named=$("$TRUNDLE" --version | sed -n 's/^trundle [0-9.]*, commit //p')
is_a_commit() { echo "$named" | grep -qE '^([0-9a-f]{12,40}(-dirty)?|unknown)$' || { echo "is: $named"; false; }; }
check '--version names a commit, or unknown' is_a_commit
check 'a run' run_gives 0 "$work/fall.yaml" -o "$work/fall"
check 'summary.json names the same' says "$work/fall/summary.json" "\"commit\": \"$named\""

check 'README cites the version that this is' says README.md "note = {Version $("$TRUNDLE" --version | sed 's/^trundle \(.*\), .*/\1/'), MIT licence}"

# ---- the build, in a copy of two sources ----
mkdir -p "$work/outer/copy/src/base" && cp Makefile "$work/outer/copy" && cp src/base/commit.c src/base/version.h src/base/math.h src/base/student.[ch] \
    "$work/outer/copy/src/base"
echo 'extern const char tr_commit[]; int puts(const char *); int main(void) { return puts(tr_commit) < 0; }' >"$work/main.c"
cd "$work/outer/copy" || exit 1
objects='build/release/src/base/commit.c.o build/release/src/base/student.c.o'
# shellcheck disable=SC2086 # a list of names
made() { make --no-print-directory PKGS= "$@" $objects; }
says_of_itself() { # WANTED: built now
    made >/dev/null && ${CC:-cc} "$work/main.c" build/release/src/base/commit.c.o -o "$work/main" && equals "$("$work/main")" "$1"
}
compiled() { made -n | sed -n 's/.* -c .*src\/base\/\(.*\)/\1/p' | xargs; }
check 'without git, as from a tarball: unknown' says_of_itself unknown
check 'then there is nothing to do' made -q
if ! command -v git >/dev/null; then
    skip 'with git' 'no git'
    finish
fi
commit() { git "$@" add -A && git "$@" -c user.name=x -c user.email=x@example.org commit -qm x; }
printf '/build/\n' >.gitignore
git -C .. init -q && commit -C ..
check 'a tarball in the repository of something else: unknown' says_of_itself unknown
git init -q && commit
head=$(git rev-parse --short=12 HEAD)
check 'one object is made for it' equals "$(compiled)" commit.c
check 'in a repository: its commit' says_of_itself "$head"
check 'again nothing to do' made -q
touch new
check 'a file that git does not know changes nothing' made -q
echo >>src/base/student.h
check 'a file that differs: dirty' says_of_itself "$head-dirty"
commit
check 'another commit: that object alone' equals "$(compiled)" commit.c
check 'and its name' says_of_itself "$(git rev-parse --short=12 HEAD)"
git -c user.name=x -c user.email=x@example.org tag -a "it's\"1\"" -m x
check 'the name of a tag is not used' made -q
git worktree add -q "$work/tree" HEAD && cd "$work/tree" || exit 1
check 'in a worktree, whose .git is a file' says_of_itself "$(git rev-parse --short=12 HEAD)"
mkdir "$work/bin" && printf '#!/bin/sh\nexit 127\n' >"$work/bin/git" && chmod +x "$work/bin/git"
without_git() { (PATH=$work/bin:$PATH && says_of_itself unknown); }
check 'where git does not run: unknown' without_git
finish
