/* SPDX-License-Identifier: MIT */
/* What the error of a number may come from: one row for each setting that is no physics. */
#ifndef TR_STUDY_CONVERGE_CAUSES_H
#define TR_STUDY_CONVERGE_CAUSES_H

#include "scene/scene.h"

typedef struct tr_cause {
    const char *name;                               /* "step" */
    const char *words;                              /* "the time step" */
    unsigned kinds;                                 /* 1 << tr_kind, of each kind that has it */
    const char *key;                                /* to set; `*` stands for each item of a list */
    double finer;                                   /* a level finer: the setting times this */
    double cost;                                    /* and the run time about times this */
    int coarser_levels, finer_levels;               /* that may be tried */
    double order;                                   /* in theory, of a smooth motion; NaN: theory gives none */
    bool whole;                                     /* a whole number */
    bool paired;                                    /* levels have the same sample; false: each has its own */
    double least, most;                             /* the range of the setting */
    int (*items)(const tr_scene *scene);            /* of the list; NULL: no list */
    double (*own)(const tr_scene *scene, int item); /* the setting of the case; NaN: the case has none */
} tr_cause;

extern const tr_cause tr_causes[];
extern const int tr_n_causes;

/* Whether it applies: the case has the setting. */
bool tr_cause_applies(const tr_cause *cause, const tr_scene *scene);

/* Of item i, so many levels finer than the case. NaN: out of range, or no whole number. */
double tr_cause_setting(const tr_cause *cause, const tr_scene *scene, int item, int level);

/* How many keys it sets, and the name of each. */
int tr_cause_keys(const tr_cause *cause, const tr_scene *scene);
void tr_cause_key(const tr_cause *cause, int item, char *key, size_t size);

#endif
