/* SPDX-License-Identifier: MIT */
/* The frame of a few bodies. */
#ifndef TR_DRAW_FRAME_SHOW_H
#define TR_DRAW_FRAME_SHOW_H

#include "draw/draw.h"

/* A few bodies, for teaching: rim ticks, the arcs da and db, velocities, contact points' traces, V_s and V_r by every
 * definition, curves. */
void tr_draw_show(tr_canvas *canvas, const tr_show *show);

#endif
