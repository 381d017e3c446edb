/* SPDX-License-Identifier: MIT */
/* The stage on which the bodies of a lane move. */
#ifndef TR_DRAW_STAGE_H
#define TR_DRAW_STAGE_H

#include "draw/frame.h"

typedef struct tr_stage {
    cairo_t *cr;
    const tr_show_lane *lane;
    tr_map map; /* of the turned plane */
    tr_box box; /* nothing is drawn outside */
    double range;
    double tilt, cos, sin;
} tr_stage;

/* The lane in the middle of the room, which is part of the box. */
tr_stage tr_stage_of(cairo_t *cr, const tr_show_lane *lane, tr_box box, tr_box room, double scale, double range);

tr_point tr_stage_point(const tr_stage *stage, double x, double y);  /* [px] */
tr_point tr_stage_turned(const tr_stage *stage, double x, double y); /* a vector; y still points up */

#endif
