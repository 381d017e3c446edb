/* SPDX-License-Identifier: MIT */
/* Threads of the solver, by OpenMP. A program without it does the same work in order. */
#ifndef TR_THREADS_H
#define TR_THREADS_H

#include <sched.h>
#include <stdint.h>

#ifdef _OPENMP
#include <omp.h>
#endif

enum { TR_MOST_THREADS = 1024 };

/* That this process may use. */
static inline int tr_processors(void) {
    cpu_set_t set;
    return sched_getaffinity(0, sizeof set, &set) ? 1 : CPU_COUNT(&set);
}

static inline int tr_threads(void) {
#ifdef _OPENMP
    return omp_get_max_threads();
#else
    return 1;
#endif
}

static inline void tr_threads_set(int n) {
#ifdef _OPENMP
    omp_set_num_threads(n);
#else
    (void)n;
#endif
}

/* Where share k of n begins; where it ends share k + 1 does. */
static inline int tr_threads_share(int all, int k, int n) {
    return (int)((int64_t)all * k / n);
}

/* work(context, k) for k from 0 to n - 1, by n threads. One alone is called like any function: OpenMP makes and frees a team
 * even for one. */
static inline void tr_threads_run(int n, void (*work)(void *context, int k), void *context) {
    if (n == 1) {
        work(context, 0);
        return;
    }
#ifdef _OPENMP
#pragma omp parallel for schedule(static, 1)
#endif
    for (int k = 0; k < n; k++) work(context, k);
}

#endif
