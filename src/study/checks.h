/* SPDX-License-Identifier: MIT */
/* The numbers that a scene of bodies measures and compares with closed forms: `checks:` of a case.
 *
 * TR_WHATS of scene/what.h lists them. A mean over a time is the mean of its steps; an event is found between two
 * steps by a straight line. The two thresholds are found by bisection: the scene runs on slopes of its own, from rest,
 * until a slope that holds and one that does not are less than 0.05 degrees apart. A run on a slope takes four times as
 * long as the scene: the springs are loaded at once, and their swing must have come to rest. */
#ifndef TR_CHECKS_H
#define TR_CHECKS_H

#include "core/bodies.h"
#include "core/record.h"
#include "out/summary.h"
#include "study/report.h"

typedef struct tr_checks {
    const tr_scene *scene;
    struct tr_checking *item; /* of each */
} tr_checks;

bool tr_checks_open(tr_checks *c, const tr_scene *scene, tr_status *st);
void tr_checks_free(tr_checks *c);

/* Whether a check that is due at this time looks at contacts. */
bool tr_checks_need_contacts(const tr_checks *c, double time, double dt);

/* After every tr_step_forces; records: the touching contacts, if they are needed. */
void tr_checks_step(tr_checks *c, const tr_bodies *b, const tr_record *records, int n);

/* Finds the thresholds, each in a few dozen short runs. TR_INTERRUPTED: stopped. */
bool tr_checks_thresholds(tr_checks *c, const tr_run_options *options, tr_status *st);

/* Takes over the thresholds that were found before: they do not depend on the run. */
void tr_checks_adopt(tr_checks *c, const tr_checks *found);

/* At the end: result has room for scene->n_checks. */
void tr_checks_results(const tr_checks *c, tr_check_result *result);

#endif
