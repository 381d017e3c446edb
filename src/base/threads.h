/* SPDX-License-Identifier: MIT */
/* Threads that chunk work. They are made once, and wait between runs.
 *
 * Work is cut into as many chunks as there are threads. Thread k takes chunk k, so that the data of a chunk stay near
 * one processor. A thread that is done takes any chunk that no thread has begun. So if another program holds a
 * processor, work does not wait for the blocked thread. Results must not depend on the thread that does a chunk.
 *
 * WAITING. A thread first polls for about 100 microseconds, and then sleeps. It sleeps at once if there are more
 * threads than processors. */
#ifndef TR_THREADS_H
#define TR_THREADS_H

#include "base/status.h"
#include <stdint.h>

enum { TR_MOST_THREADS = 1024 };

typedef struct tr_threads tr_threads;

/* n threads (1 to TR_MOST_THREADS), including the caller. Signals go to the caller: the others block them.
 * NULL and TR_FILE in st when memory or the threads of the system are short. */
tr_threads *tr_threads_new(int n, tr_status *st);

/* Ends the other threads before it returns. May be NULL. */
void tr_threads_free(tr_threads *threads);

/* How many; NULL: 1. */
int tr_threads_count(const tr_threads *threads);

/* work(context, k) once for each k from 0 to n - 1; all are done when it returns. NULL: the caller does the one chunk.
 * Call it from one thread at a time, and not from within work. */
void tr_threads_run(tr_threads *threads, void (*work)(void *context, int k), void *context);

/* The start of chunk k of n; it ends where chunk k + 1 starts. */
static inline int tr_threads_chunk(int all, int k, int n) {
    return (int)((int64_t)all * k / n);
}

/* Processors that this process may use. */
int tr_processors(void);

#endif
