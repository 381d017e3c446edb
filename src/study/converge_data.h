/* SPDX-License-Identifier: MIT */
/* What the files of a converge share: the ladders of a case and the numbers along them. */
#ifndef TR_STUDY_CONVERGE_DATA_H
#define TR_STUDY_CONVERGE_DATA_H

#include "out/dir.h"
#include "out/summary_read.h"
#include "scene/scene.h"
#include "study/converge_causes.h"
#include "study/converge_ladder.h"
#include <signal.h>

enum {
    TR_CONVERGE_NUMBERS = 32,
    TR_CONVERGE_CAUSES = 8, /* that apply to one case */
    TR_CONVERGE_SEEDS = 16,
    TR_CONVERGE_NOTE = 600,
    TR_CONVERGE_NOTES = 64
};

typedef struct tr_converge_options {
    const char *case_file, *dir;
    const char *of;                    /* names, commas between them; NULL: those that are usual for the kind */
    double to;                         /* asked: error over value [1] */
    double budget;                     /* wall time that this command may take [s] */
    int jobs;                          /* runs at once */
    bool plan;                         /* only tell what would run, and what it costs */
    const volatile sig_atomic_t *stop; /* set it to stop */
    void (*progress)(void *context, const char *stage, double fraction);
    void (*say)(void *context, const char *line); /* what happens to a run */
    void *context;
} tr_converge_options;

/* A number of summary.json, or a cell of a table: history.COLUMN@STRAIN, history.DISK.COLUMN@TIME,
 * contact.LAW.COLUMN@SEGMENT. */
typedef struct tr_converge_number {
    char name[TR_SUMMARY_NAME];
    char shown[TR_SUMMARY_NAME + 32]; /* "checks.0.measured (slip-ends)" */
    bool usual;                       /* not asked for by name */
} tr_converge_number;

typedef enum tr_level_state { TR_LEVEL_OPEN, TR_LEVEL_DONE, TR_LEVEL_FAILED } tr_level_state;

/* A case with one setting changed, of each seed. */
typedef struct tr_converge_level {
    double setting; /* of the first key of the cause; the case's own setting is level own of the ladder */
    tr_level_state state;
    double seconds; /* of one run: the median [s]. NaN: not run */
    double value[TR_CONVERGE_NUMBERS][TR_CONVERGE_SEEDS];
} tr_converge_level;

/* The ladder of a cause, from coarse to fine. */
typedef struct tr_converge_ladder {
    const tr_cause *cause;
    int n, own;
    tr_converge_level level[TR_LADDER_LEVELS];
    bool dear; /* the next level did not fit into the budget */
    tr_ladder of[TR_CONVERGE_NUMBERS];
} tr_converge_ladder;

typedef struct tr_converge {
    const tr_converge_options *options;
    tr_scene scene;
    char *base; /* absolute path of the case */
    int n_numbers, n_ladders, n_seeds, n_notes;
    tr_converge_number number[TR_CONVERGE_NUMBERS];
    tr_converge_level own; /* the case as it is, of all seeds; of kinds without a sample there is one */
    tr_converge_ladder ladder[TR_CONVERGE_CAUSES];
    tr_sample_error sample[TR_CONVERGE_NUMBERS];
    char note[TR_CONVERGE_NOTES][TR_CONVERGE_NOTE];
    double until; /* when the budget ends, tr_run_clock */
    volatile sig_atomic_t halt;
    bool late; /* halted by the budget */
} tr_converge;

/* Whether the case has a sample, which a seed chooses. */
static inline bool tr_converge_sampled(const tr_converge *c) {
    return c->scene.kind == TR_KIND_BIAXIAL;
}

#endif
