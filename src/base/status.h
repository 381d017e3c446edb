/* SPDX-License-Identifier: MIT */
/* How a call says that it failed.
 *
 * Every call that can fail takes a tr_status last and returns true on success. The first failure writes code and text;
 * nobody prints or exits below cli/. The codes are the exit codes of the program: one table for both. */
#ifndef TR_STATUS_H
#define TR_STATUS_H

#include <stdbool.h>

typedef enum tr_code {
    TR_OK = 0,            /* done */
    TR_CHECK_FAILED = 1,  /* a check of the tool's own (bench, verify) failed */
    TR_BAD_CASE = 2,      /* command line or case file is wrong */
    TR_FILE = 3,          /* a file or the memory: cannot open, write, allocate */
    TR_NUMERICAL = 4,     /* the solution broke down: non-finite, overlap too large, step over the bound */
    TR_INTERRUPTED = 130, /* the user stopped it */
} tr_code;

typedef struct tr_status {
    tr_code code;
    char text[1024]; /* message without a trailing newline; may have several lines */
} tr_status;

/* Writes code and text unless a failure is already there (the first one is the cause). Returns false, always,
 * so that a caller can write `return tr_status_fail(...)`. */
bool tr_status_fail(tr_status *st, tr_code code, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Adds to the text of a failure, if there is one. Returns false. */
bool tr_status_more(tr_status *st, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
