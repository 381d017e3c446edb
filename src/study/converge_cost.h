/* SPDX-License-Identifier: MIT */
/* What a level costs. */
#ifndef TR_STUDY_CONVERGE_COST_H
#define TR_STUDY_CONVERGE_COST_H

#include "study/converge_data.h"

/* A run of the case as it is, before one has been measured: good to a factor of three [s]. */
double tr_converge_guess(const tr_scene *scene);

/* Wall time of all seeds of a level, of so many runs at once, from the time of the nearest level that was run [s]. */
double tr_converge_cost(const tr_converge *c, const tr_converge_ladder *l, int level);

/* Of so many runs of `seconds` each. */
double tr_converge_wall(const tr_converge *c, double seconds, int runs);

#endif
