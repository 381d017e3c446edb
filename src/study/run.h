/* SPDX-License-Identifier: MIT */
/* One case, from scene to a directory of results: scene -> core -> out and draw. Neither prints nor exits. */
#ifndef TR_RUN_H
#define TR_RUN_H

#include "base/status.h"
#include "scene/scene.h"
#include <signal.h>

typedef struct tr_run_report tr_run_report;

typedef struct tr_run_options {
    const char *dir;       /* where results go */
    const char *case_file; /* where the scene was read: the run refuses to write over it; may be NULL */
    const char *title;     /* of the film of a bodies scene */
    bool force;            /* replace a finished run */
    bool resume;           /* go on from the checkpoint, if there is one; a finished run is left as it is */
    double checkpoint;     /* seconds between two; kind: biaxial */
    const char *sample;    /* kind: biaxial: file of the packing to start from, made if it is not there; may be NULL */
    int threads;           /* that share the work of a large sample; 0: one */
    bool share_few;        /* threads share the work of few disks too: slower, so it is for tests */
    const volatile sig_atomic_t *stop;                                   /* set it to stop cleanly */
    void (*progress)(void *context, const char *stage, double fraction); /* called often; may be NULL */
    void *context;
    void (*foretold)(const tr_run_report *report); /* once, before the run: report->n_warnings; may be NULL */
} tr_run_options;

/* The short table of results, and what was not made or may not be meant. */
struct tr_run_report {
    int n_lines, n_notes;
    struct tr_report_line {
        char label[40], value[200];
    } line[24 + TR_MAX_LANES * 32];       /* 32: checks of a scene */
    int failed;                           /* checks; the run is complete all the same */
    int n_warnings;                       /* the first of the notes: known before the run */
    char note[8 + 3 * TR_MAX_LANES][400]; /* 3: warnings of a scene */
};

/* Finds what reading a case cannot: a step above the bound, bodies that overlap too much. *report gets notes of what may not be
 * meant (n_warnings). summary: if it is not NULL, the text of the summary.json that a run of this case leaves, with its names and
 * without its numbers (free()). */
bool tr_run_check(const tr_scene *scene, tr_run_report *report, char **summary, tr_status *st);

/* Runs the case. What tr_run_check finds is found before the directory is touched. Stopped: TR_INTERRUPTED, numerical
 * failure: TR_NUMERICAL, a file that cannot be written: TR_FILE; each keeps the rows, frames and film up to then and
 * says so, and nothing is half-written under a final name. A checkpoint that is resumed but not of this case, or damaged: TR_FILE,
 * and nothing is touched. */
bool tr_run(const tr_scene *scene, const tr_run_options *options, tr_run_report *report, tr_status *st);

#endif
