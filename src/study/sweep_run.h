/* SPDX-License-Identifier: MIT */
/* The runs of a sweep. */
#ifndef TR_SWEEP_RUN_H
#define TR_SWEEP_RUN_H

#include "study/sweep.h"
#include <signal.h>

typedef struct tr_grid_options {
    const char *dir;
    int jobs;                          /* runs at once */
    int first, end;                    /* points first ... end - 1 */
    const volatile sig_atomic_t *stop; /* set it to end the runs and stop */
    void (*progress)(void *context, const char *stage, double fraction);
    void (*say)(void *context, const char *line); /* what happens to a point */
    void *context;
} tr_grid_options;

typedef struct tr_grid_report {
    int before, ran, failed; /* points finished before, run now, failed now */
    tr_code code;            /* of those that failed, the lowest */
} tr_grid_report;

/* Runs the missing points, each as a child process of this program. All are read, and those of the first seed
 * checked, before the first one runs. Packings go to dir/samples, and points with the same packing use one file. `say`
 * reports failed points. They are counted, their lowest code is kept, and the others run on. */
bool tr_grid_run(const tr_grid *g, const tr_grid_options *options, tr_grid_report *report, tr_status *st);

#endif
