/* SPDX-License-Identifier: MIT */
/* Errors that the ladders of a converge give: of a number, by cause, at each level, and in all. */
#ifndef TR_STUDY_CONVERGE_ERRORS_H
#define TR_STUDY_CONVERGE_ERRORS_H

#include "study/converge_data.h"

/* Of number q at a level: of the first seed, or the mean of all. NaN: it was not run. */
double tr_converge_value(const tr_converge *c, const tr_converge_ladder *l, int q, int level);

/* The error that the cause makes at this level; NaN: not known. */
double tr_converge_error(const tr_converge *c, const tr_converge_ladder *l, int q, int level);

/* All causes at the case's own settings, those that are known; *unknown: how many are not. Errors of settings add
 * up; what is noise of samples adds up as squares. */
double tr_converge_total(const tr_converge *c, int q, int *unknown);

/* The coarsest setting whose error is within the share that each cause gets of what is asked, over all numbers: one
 * that was tried, or, where an order is seen, beyond. As a factor of the own setting. NaN: none is known. */
double tr_converge_wanted(const tr_converge *c, const tr_converge_ladder *l);

/* Seeds that it takes to have the mean within its share, over all numbers; 0: none is known. */
int tr_converge_wanted_seeds(const tr_converge *c);

/* No faster level that was tried has a smaller error. */
bool tr_converge_front(const tr_converge *c, const tr_converge_ladder *l, int q, int level);

/* A number that is 0 and stays 0, and was not asked for. */
bool tr_converge_idle(const tr_converge *c, int q);

#endif
