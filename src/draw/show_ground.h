/* SPDX-License-Identifier: MIT */
/* Floors and walls, and the traces of contact points. */
#ifndef TR_DRAW_SHOW_GROUND_H
#define TR_DRAW_SHOW_GROUND_H

#include "draw/stage.h"

void tr_ground_walls(const tr_stage *stage);
void tr_ground_trace(const tr_stage *stage);
void tr_ground_slope(const tr_stage *stage);

#endif
