/* SPDX-License-Identifier: MIT */
/* A stream that gathers text in memory. (open_memstream leaves text out without an error if memory is short.) */
#ifndef TR_GATHER_H
#define TR_GATHER_H

#include "base/status.h"
#include <stdio.h>

typedef struct tr_gather {
    FILE *stream; /* write there */
    char *text;
    size_t n, room;
} tr_gather;

/* *g must not move until the end. */
bool tr_gather_begin(tr_gather *g, tr_status *st);

/* Closes the stream. Returns all that was written; free(). NULL, and TR_FILE, if something was lost or begin failed. */
char *tr_gather_end(tr_gather *g, tr_status *st);

#endif
