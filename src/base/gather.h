/* SPDX-License-Identifier: MIT */
/* A stream that gathers text in memory, as open_memstream does; but that says nothing when it has found none, and leaves text out. */
#ifndef TR_GATHER_H
#define TR_GATHER_H

#include "base/status.h"
#include <stdio.h>

typedef struct tr_gather {
    FILE *stream; /* write there */
    char *text;
    size_t n, room;
} tr_gather;

/* *g stays where it is until the end. */
bool tr_gather_begin(tr_gather *g, tr_status *st);

/* Closes the stream. All that was written; free(). NULL, and TR_FILE, if something was lost; also where begin has failed. */
char *tr_gather_end(tr_gather *g, tr_status *st);

#endif
