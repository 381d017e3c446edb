/* SPDX-License-Identifier: MIT */
/* One case, from scene to a directory of results: scene -> core -> out and draw. Neither prints nor exits. */
#ifndef TR_RUN_H
#define TR_RUN_H

#include "base/status.h"
#include "scene/scene.h"
#include <signal.h>

typedef struct tr_run_options {
    const char *dir;                                                     /* where results go */
    const char *title;                                                   /* of the film of a bodies scene */
    bool force;                                                          /* replace a finished run */
    const volatile sig_atomic_t *stop;                                   /* set it to stop cleanly */
    void (*progress)(void *context, const char *stage, double fraction); /* called often; may be NULL */
    void *context;
} tr_run_options;

/* The short table of results, and what was not made. */
typedef struct tr_run_report {
    int n_lines, n_notes;
    struct tr_report_line {
        char label[40], value[80];
    } line[24];
    char note[4][200];
} tr_run_report;

/* Runs the case. Stopped: TR_INTERRUPTED, and a message that says what was kept. Numerical failure: TR_NUMERICAL, and
 * what there is up to then is kept as well. A file that cannot be written: TR_FILE, nothing half-written under a final
 * name. */
bool tr_run(const tr_scene *scene, const tr_run_options *options, tr_run_report *report, tr_status *st);

#endif
