/* SPDX-License-Identifier: MIT */
/* Verifications: numbers of the code beside numbers from other sources. `trundle verify`.
 *
 * A verification is a function that runs the library on a case whose answer is known from elsewhere (closed form,
 * independent solver, invariance, order of convergence) and adds rows. A tolerance follows from the discretisation or
 * the statistics, is fixed before the run, and says its reason. Each verification names a change of the code that makes
 * it fail.
 *
 * exact      answers against closed forms; quick
 * precision  error against run time: points, and a row for what the defaults rest on
 * stability  stiff and extreme cases: the right answer, or a numerical failure that says where; never anything else
 */
#ifndef TR_VERIFY_H
#define TR_VERIFY_H

#include "base/status.h"
#include "out/dir.h"
#include "out/summary.h"
#include <math.h>
#include <signal.h>

typedef struct tr_verify tr_verify;

typedef struct tr_verification {
    const char *group, *name; /* "exact", "slip-to-roll" */
    const char *what;         /* one line */
    const char *source;       /* of the reference: "[Wang2015 eq. 12]", "rigid disk, I = m R^2/2" */
    const char *mutation;     /* a change of the code that makes a row of it fail, tried */
    /* False only if it cannot continue (memory, files, stopped): a wrong number is a row that says so. */
    bool (*run)(tr_verify *v, tr_status *st);
} tr_verification;

typedef struct tr_verify_row {
    const char *quantity; /* "time when slipping ends", 79 characters at most */
    const char *unit;     /* SI; "1". Copied, 15 characters at most */
    double reference, computed;
    double tolerance;   /* largest |computed - reference| */
    const char *reason; /* of the tolerance; lives as long as the program */
    double order;       /* observed order of convergence; NAN: none */
    const char
        *outcome; /* in words, for a case that may end in a failure that says where; NULL: only the number. Copied */
} tr_verify_row;

/* A point of an error against run time. */
typedef struct tr_verify_point {
    const char *series;        /* method or law variant: "leapfrog". Copied */
    double step;               /* of time or of the discretisation, in what `step_name` says */
    const char *step_name;     /* "dt [s]" */
    double error;              /* relative to the size of the answer */
    double seconds, low, high; /* wall time of one run: median, quartiles of interleaved repeats */
    bool usual;                /* the step that the tool takes by default */
} tr_verify_point;

/* Adds a row or a point to the results of the running verification. ok overrides the comparison only if outcome is
 * given: a row without numbers has reference, computed and tolerance NAN, and ok as given. */
bool tr_verify_add(tr_verify *v, const tr_verify_row *row, tr_status *st);
bool tr_verify_outcome(tr_verify *v, const char *quantity, const char *outcome, bool ok, tr_status *st);
bool tr_verify_point_add(tr_verify *v, const tr_verify_point *point, tr_status *st);

/* TR_INTERRUPTED if the user wants to stop: call it between runs. */
bool tr_verify_go_on(const tr_verify *v, tr_status *st);

/* A scene of bodies from the text of a case, whose `checks:` become rows; n_sets overrides "key=value". Its steps are
 * divided by 1, 2, 4, ... 2^(halvings): rows have the results of the last and, where the error is above rounding, the
 * observed order. reason: of the tolerances. */
bool tr_verify_scene(tr_verify *v, const char *text, const char *const *sets, int n_sets, int halvings,
                     const char *reason, tr_status *st);

/* The results of the checks of a scene, its step divided by 2^halvings: result has room for scene->n_checks. */
bool tr_verify_play(const tr_verify *v, const tr_scene *scene, int halvings, tr_check_result *result, tr_status *st);

/* ---- for the command ---- */

typedef struct tr_verified {
    const tr_verification *of;
    char quantity[80], unit[16], outcome[160];
    tr_verify_row row; /* its own quantity, unit and outcome are NULL */
    double seconds;    /* of the verification up to this row */
    bool ok;
} tr_verified;

struct tr_verify {
    const tr_verification *now;
    double started; /* [s] of the one at work */
    const volatile sig_atomic_t *stop;
    /* For the tests: all rows, but each point is measured once, and samples have fewer seeds. */
    bool brief;
    tr_verified *row;
    int n, capacity, failed;
    struct tr_verify_pointed {
        const tr_verification *of;
        char series[48];
        tr_verify_point point;
    } * point;
    int n_points, points_capacity;
};

/* Runs one, adding to v. TR_NUMERICAL becomes a row that failed. */
bool tr_verify_run(tr_verify *v, const tr_verification *which, tr_status *st);
void tr_verify_free(tr_verify *v);

/* Makes DIR and lists the tables, before the first verification runs. TR_FILE: see out/manifest.h. */
bool tr_verify_claim(const char *dir, tr_status *st);

/* DIR/verify.csv and, if there are points, DIR/points.csv. */
bool tr_verify_write(const tr_verify *v, const char *dir, tr_status *st);

#endif
