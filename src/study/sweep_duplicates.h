/* SPDX-License-Identifier: MIT */
/* Values of a sweep that mean the same. */
#ifndef TR_SWEEP_DUPLICATES_H
#define TR_SWEEP_DUPLICATES_H

#include "study/sweep.h"

/* Finds a value in two spellings, and a key whose values have no effect. tr_grid_read calls it. */
bool tr_grid_check_duplicates(const tr_grid *g, tr_status *st);

#endif
