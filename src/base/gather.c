/* SPDX-License-Identifier: MIT */
#include "base/gather.h"

#include "base/alloc.h"
#include <stdlib.h>
#include <string.h>

/* Returns 0 if memory is short; the stream keeps this as its error. */
static ssize_t add(void *context, const char *bytes, size_t n) {
    tr_gather *g = context;
    tr_status no_memory = {0};
    if (g->n + n + 1 > g->room) {
        size_t room = 2 * (g->n + n + 1);
        if (!tr_alloc_grow(&g->text, g->n, room, 1, &no_memory)) return 0;
        g->room = room;
    }
    memcpy(g->text + g->n, bytes, n);
    g->n += n;
    g->text[g->n] = '\0';
    return (ssize_t)n;
}

bool tr_gather_begin(tr_gather *g, tr_status *st) {
    *g = (tr_gather){.text = tr_alloc(1, 1, st), .room = 1};
    if (g->text) g->stream = fopencookie(g, "w", (cookie_io_functions_t){.write = add});
    return g->stream || tr_status_fail(st, TR_FILE, "error: out of memory");
}

char *tr_gather_end(tr_gather *g, tr_status *st) {
    bool whole = g->stream && !ferror(g->stream);
    if (g->stream) whole = !fclose(g->stream) && whole;
    if (whole) return g->text;
    tr_status_fail(st, TR_FILE, "error: out of memory");
    free(g->text);
    return NULL;
}
