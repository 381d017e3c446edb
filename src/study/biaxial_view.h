/* SPDX-License-Identifier: MIT */
/* What stays the same in every frame of a biaxial test. */
#ifndef TR_BIAXIAL_VIEW_H
#define TR_BIAXIAL_VIEW_H

#include "core/biaxial.h"
#include "draw/draw.h"

enum { TR_RUN_TITLE = 96 };

/* One scale and one box for the whole film. */
tr_view tr_run_biaxial_view(const tr_biaxial *b, char title[TR_RUN_TITLE]);

#endif
