/* SPDX-License-Identifier: MIT */
/* Options of a run, and its report. */
#ifndef TR_REPORT_H
#define TR_REPORT_H

#include "base/status.h"
#include "scene/scene.h"
#include <signal.h>

typedef struct tr_run_report tr_run_report;

typedef struct tr_run_options {
    const char *dir;       /* where results go */
    const char *case_file; /* file of the scene: the run refuses to write over it; may be NULL */
    const char *title;     /* of the film of a bodies scene */
    bool force;            /* replace a finished run */
    bool resume;           /* continue from the checkpoint, if there is one; a finished run stays as it is */
    double checkpoint;     /* seconds between two; kind: biaxial */
    const char *sample;    /* kind: biaxial: file of the packing to start from; made if it does not exist; may be
                            * NULL */
    int threads;           /* number of threads for a large sample; 0: one */
    bool share_few;        /* use threads also for few disks: slower, so only for tests */
    const volatile sig_atomic_t *stop;                                   /* set it to stop cleanly */
    void (*progress)(void *context, const char *stage, double fraction); /* called often; may be NULL */
    void *context;
    void (*foretold)(const tr_run_report *report); /* once, before the run: report->n_warnings; may be NULL */
} tr_run_options;

/* The short table of results, and notes about missing outputs and likely mistakes. */
struct tr_run_report {
    int n_lines, n_notes;
    struct tr_report_line {
        char label[40], value[200];
    } line[24 + TR_MAX_LANES * 32];       /* 32: checks of a scene */
    int failed;                           /* checks; the run is complete */
    int n_warnings;                       /* the first of the notes: known before the run */
    char note[8 + 5 * TR_MAX_LANES][400]; /* 5: warnings of a scene */
};

/* A line or a note, like printf. */
void tr_run_say(tr_run_report *report, const char *label, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
void tr_run_note(tr_run_report *report, const char *format, ...) __attribute__((format(printf, 2, 3)));

bool tr_run_stopped(const tr_run_options *options);
void tr_run_progress(const tr_run_options *options, const char *stage, double fraction);

#endif
