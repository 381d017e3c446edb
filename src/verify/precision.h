/* SPDX-License-Identifier: MIT */
/* Group `precision`: what its files share. */
#ifndef TR_PRECISION_H
#define TR_PRECISION_H

#include "core/bodies.h"
#include "verify/integrate.h"
#include "verify/sweep.h"

/* A scene of bodies whose state at time_end is known. */
typedef struct tr_precise {
    const char *text; /* the case */
    const char *vary; /* a key that differs between runs, so that no error is small by chance; the number of runs */
    double from, to;  /* in equal steps from `from` on; `to` is not reached */
    int variants;     /* 1: vary is not read */
    double (*error)(const tr_bodies *b,
                    const void *reference); /* of the state at time_end, relative; velocities are those of time_end */
    void *(*reference)(const tr_scene *scene,
                       tr_status *st); /* data that do not depend on the step; freed with free; may be NULL */
    double coarsest;                   /* step over the default */
    int levels;                        /* halvings of it */
    int repeats;
} tr_precise;

/* Sweeps methods, named in the order of tr_integrator, over levels of the step. Error: the root mean square over the
 * variants; time: their median, which one interrupted run does not change. */
bool tr_precise_add(tr_verify *v, const tr_precise *c, const tr_sweep_method *method, int methods, double goal,
                    const char *reason, tr_status *st);

/* Whether *st is a numerical failure; clears it: a missing answer, not a reason to stop. */
bool tr_precise_failed(tr_status *st);

#endif
