/* SPDX-License-Identifier: MIT */
/* The commands. argv[0] is the command's name; each returns the exit code. */
#ifndef TR_CLI_H
#define TR_CLI_H

#include "out/dir.h"
#include <signal.h>

int tr_cli_run(int argc, char **argv);
int tr_cli_laws(int argc, char **argv);
int tr_cli_bench(int argc, char **argv);
int tr_cli_measures(int argc, char **argv);
int tr_cli_verify(int argc, char **argv);
int tr_cli_sweep(int argc, char **argv);
int tr_cli_replay(int argc, char **argv);

/* Prints the message of a failure on stderr and returns its code. */
int tr_cli_fail(const tr_status *st);

/* "cases/slip-to-roll.yaml" -> "slip-to-roll" */
void tr_cli_name(const char *file, char *name, size_t size);

/* A file that the user has named by its path. It must not be the file `input`, which is read (NULL: none is). */
bool tr_cli_open(tr_file *file, const char *path, const char *input, tr_status *st);

/* Reads the arguments, or ends the program: with TR_BAD_CASE if they are wrong, with TR_FILE if memory runs out. */
struct argp;
void tr_cli_parse(const struct argp *argp, int argc, char **argv, void *arguments);

/* An argument that is a whole number from low to high; ends the program otherwise. what: names it. */
struct argp_state;
int tr_cli_whole(const char *text, int low, int high, const char *what, struct argp_state *state);

/* Ctrl-C, SIGTERM, SIGHUP (the terminal was closed): from here on the first one asks to stop by setting the flag. A second one
 * kills. */
const volatile sig_atomic_t *tr_cli_stop(void);

/* A progress bar on stderr, drawn at most ten times a second; silent unless stderr is a terminal. */
typedef struct tr_progress {
    bool terminal, color;
    double started, drawn; /* [s] of the stage, and of the last drawing */
    char stage[32];
} tr_progress;

tr_progress tr_progress_begin(void);
void tr_progress_show(void *progress, const char *stage, double fraction);
void tr_progress_end(tr_progress *progress);

#endif
