/* SPDX-License-Identifier: MIT */
/* A run along a path (run_path.c), and what the two kinds of case add to it. */
#ifndef TR_DRIVEN_H
#define TR_DRIVEN_H

#include "out/dir.h"
#include "out/summary.h"
#include "study/contact.h"
#include "study/report.h"

typedef struct tr_driven {
    const tr_scene *scene; /* with its path */
    const tr_run_options *options;
    tr_run_report *report;
    int64_t total, done;                 /* steps */
    int n;                               /* lines: the laws, or the one solver */
    tr_contact_state state[TR_MAX_LAWS];  /* of each line, after the last step */
    tr_contact_state before[TR_MAX_LAWS]; /* after the step before it; step 0: there is none */
    tr_path_result result[TR_MAX_LAWS];  /* so far */
    bool rolling;                        /* some line has moments */
    tr_file table;                       /* contact.csv */
    tr_check_result check[TR_MAX_CHECKS];
    void *own; /* of the kind */
} tr_driven;

/* Of a kind. False: *st tells why. */
typedef struct tr_driven_kind {
    /* Names and label of line i. */
    void (*name)(tr_driven *d, int i);
    /* To the start of the path. The first call allocates. */
    bool (*start)(tr_driven *d, tr_status *st);
    bool (*step)(tr_driven *d, tr_status *st);
    void (*free)(tr_driven *d);
    /* A run before the run, in which `watch` sees each step; NULL: none. */
    bool (*rehearses)(const tr_driven *d);
    void (*watch)(tr_driven *d);
    /* Its own files; NULL: none. keep: after each step. close: whatever ended the run; kept: room for what is kept. */
    bool (*open)(tr_driven *d, tr_status *st);
    bool (*keep)(tr_driven *d, tr_status *st);
    void (*close)(tr_driven *d, char kept[80], tr_status *st);
    /* Lines of the report. */
    void (*say)(tr_driven *d);
} tr_driven_kind;

#endif
