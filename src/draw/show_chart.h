/* SPDX-License-Identifier: MIT */
/* Curves over time. */
#ifndef TR_DRAW_SHOW_CHART_H
#define TR_DRAW_SHOW_CHART_H

#include "draw/frame.h"

/* The shape that stands for a lane wherever it is named. */
void tr_lane_marker(cairo_t *cr, tr_point at, double size, int lane);

void tr_show_chart(cairo_t *cr, tr_box box, const tr_show *show);

#endif
