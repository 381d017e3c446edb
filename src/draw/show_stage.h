/* SPDX-License-Identifier: MIT */
/* The bodies of a lane on their stage. */
#ifndef TR_DRAW_SHOW_STAGE_H
#define TR_DRAW_SHOW_STAGE_H

#include "draw/stage.h"

/* With the ground. */
void tr_stage_draw(const tr_stage *stage);

#endif
