/* SPDX-License-Identifier: MIT */
/* Curves over time. */
#ifndef TR_DRAW_SHOW_CHART_H
#define TR_DRAW_SHOW_CHART_H

#include "draw/frame.h"

/* Colour and shape of a lane, wherever it is named. A single lane has those of its first curve. */
unsigned tr_lane_hue(int n_lanes, int lane);
void tr_lane_marker(cairo_t *cr, tr_point at, double size, int n_lanes, int lane);

void tr_show_chart(cairo_t *cr, tr_box box, const tr_show *show);

#endif
