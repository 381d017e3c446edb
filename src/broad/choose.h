/* SPDX-License-Identifier: MIT */
/* The choice of a finder. */
#ifndef TR_CHOOSE_H
#define TR_CHOOSE_H

#include "broad/broad.h"

/* The finder for n disks: brute force up to 32, else Box2D. */
const tr_broad_finder *tr_broad_choose(int n);

#endif
