/* SPDX-License-Identifier: MIT */
/* The steps of a run at which rows and frames are due: spread evenly. */
#ifndef TR_SCHEDULE_H
#define TR_SCHEDULE_H

#include <stdbool.h>
#include <stdint.h>

/* Item j of n, from 0 to the end; a single one at the end. n <= total + 1, so no two fall on one step. */
bool tr_run_is_due(int j, int n, int64_t k, int64_t total);
/* Before step k: j items have been due. */
bool tr_run_is_between(int j, int n, int64_t k, int64_t total);

#endif
