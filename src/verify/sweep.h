/* SPDX-License-Identifier: MIT */
/* A work-precision diagram: methods over steps that are halved, the error of each and its time.
 *
 * Each run is repeated; the repeats of all methods and steps are interleaved, so that other work of the machine affects
 * all of them alike. Points have the median and the quartiles of the times; errors do not change from repeat to repeat.
 *
 * Rows: of each method the order, the least-squares slope of ln(error) over ln(step) where floor < error < 0.05
 * (coarser: not asymptotic); of the first, which is the tool's own, the error at the default step. */
#ifndef TR_SWEEP_H
#define TR_SWEEP_H

#include "verify/verify.h"

typedef struct tr_sweep_result {
    double step, error, seconds;
} tr_sweep_result;

typedef struct tr_sweep_method {
    const char *name;
    double order, tolerance; /* of the order, in theory; NAN: no claim */
    const char *reason;      /* of the tolerance */
} tr_sweep_method;

enum { TR_SWEEP_METHODS = 8, TR_SWEEP_STEPS = 12 };

typedef struct tr_sweep {
    const char *step_name; /* "dt [s]" */
    const tr_sweep_method *method;
    int methods, steps, repeats;
    double floor;       /* errors below it do not count for an order; 0: 1e-7, of rounding */
    int usual;          /* which step is the default */
    double goal;        /* largest error at the default step; 1e-3, or the reason for another */
    const char *reason; /* of it */
    /* Runs a method with step k, 0 the coarsest. */
    bool (*run)(void *context, int method, int k, tr_sweep_result *result, tr_status *st);
    void *context;
} tr_sweep;

bool tr_sweep_add(tr_verify *v, const tr_sweep *sweep, tr_status *st);

double tr_sweep_now(void); /* [s] */

/* Sorts them. */
double tr_sweep_median(double *values, int n);

#endif
