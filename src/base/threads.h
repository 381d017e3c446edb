/* SPDX-License-Identifier: MIT */
/* Threads of the solver, by OpenMP. A program without it, or that asks for one thread, runs the same loops in order. */
#ifndef TR_THREADS_H
#define TR_THREADS_H

#include <sched.h>

#ifdef _OPENMP
#include <omp.h>
#define TR_OMP(directive) _Pragma(#directive)
#else
#define TR_OMP(directive)
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

#endif
