/* SPDX-License-Identifier: MIT */
/* What a command says while it runs, and when it fails. */
#ifndef TR_CLI_PROGRESS_H
#define TR_CLI_PROGRESS_H

#include "base/status.h"

/* Prints the message of a failure on stderr and returns its code. */
int tr_cli_fail(const tr_status *st);

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
