/* SPDX-License-Identifier: MIT */
/* The tables of a sweep. */
#ifndef TR_SWEEP_COLLECT_H
#define TR_SWEEP_COLLECT_H

#include "study/sweep.h"

/* Writes, from the summaries of all finished points, dir/points.csv: a row of each with its numbers; and
 * dir/collect.csv: for each combination and number the mean over the seeds, its standard error and 95 % interval, and,
 * in separate rows with the subtracted value in `minus`, the same for the differences by seed of `compare`. missing:
 * points not finished. */
bool tr_grid_collect(const tr_grid *g, const char *dir, int *missing, tr_status *st);

#endif
