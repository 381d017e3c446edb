/* SPDX-License-Identifier: MIT */
/* The file of a sweep. */
#ifndef TR_SWEEP_READ_H
#define TR_SWEEP_READ_H

#include "study/sweep.h"

/* many: more than TR_MANY_POINTS are allowed. Also after a failure the grid goes to tr_grid_free. */
enum { TR_MANY_POINTS = 10000 };
bool tr_grid_read(tr_grid *g, const char *path, bool many, tr_status *st);
void tr_grid_free(tr_grid *g);

#endif
