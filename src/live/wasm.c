/* SPDX-License-Identifier: MIT */
/* What the library takes from a system, in a page: one thread, no files, pairs by brute force (Box2D is not to be had
 * for WebAssembly), and the functions of base/math.h from wasi-libc, whose sources are musl's. This file is compiled
 * with -fno-builtin, so that no compiler replaces a call by what its own machine computes. */
#include "base/math.h"
#include "base/threads.h"
#include "broad/choose.h"

#include <math.h>
#include <stddef.h>

#define ONE(f)                                                                                                         \
    double tr_##f(double x) {                                                                                          \
        return f(x);                                                                                                   \
    }
#define TWO(f)                                                                                                         \
    double tr_##f(double x, double y) {                                                                                \
        return f(x, y);                                                                                                \
    }
ONE(log)
ONE(log2)
ONE(log10)
ONE(log1p)
ONE(exp)
ONE(expm1)
ONE(sin)
ONE(cos)
ONE(tan)
ONE(asin)
ONE(atan)
ONE(cbrt)
TWO(atan2)
TWO(hypot)
TWO(pow)

const tr_broad_finder *tr_broad_choose(int n) {
    (void)n;
    return &tr_broad_brute;
}

tr_threads *tr_threads_new(int n, tr_status *st) {
    tr_status_fail(st, TR_FILE, "error: cannot make %d threads in a page", n);
    return NULL;
}

void tr_threads_free(tr_threads *threads) {
    (void)threads;
}

int tr_threads_count(const tr_threads *threads) {
    (void)threads;
    return 1;
}

void tr_threads_run(tr_threads *threads, void (*work)(void *context, int k), void *context) {
    (void)threads;
    work(context, 0);
}

int tr_processors(void) {
    return 1;
}

/* wasi-libc has none: there are no links to follow. */
char *realpath(const char *path, char *room) {
    (void)path, (void)room;
    return NULL;
}
