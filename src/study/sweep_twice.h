/* SPDX-License-Identifier: MIT */
/* Values of a sweep that say nothing new. */
#ifndef TR_SWEEP_TWICE_H
#define TR_SWEEP_TWICE_H

#include "study/sweep.h"

/* A value that is given twice under two spellings, and a key whose values have no effect. tr_grid_read looks for
 * them. */
bool tr_grid_check_twice(const tr_grid *g, tr_status *st);

#endif
