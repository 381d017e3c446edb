/* SPDX-License-Identifier: MIT */
/* What the finders share. */
#ifndef TR_BROAD_INTERNAL_H
#define TR_BROAD_INTERNAL_H

#include "broad/broad.h"

/* Refuses non-finite positions, which Box2D would take silently. */
bool tr_broad_check(const tr_broad_input *input, tr_status *st);

/* gap(a, b) < skin, in double: every finder uses this definition of a pair. */
bool tr_broad_near(const tr_broad_input *input, int a, int b);

#endif
