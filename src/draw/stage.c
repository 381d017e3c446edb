/* SPDX-License-Identifier: MIT */
#include "draw/stage.h"

#include <math.h>

tr_stage tr_stage_of(cairo_t *cr, const tr_show_lane *lane, tr_box box, tr_box room, double scale, double range) {
    double tilt = isfinite(lane->tilt) ? lane->tilt : 0;
    return (tr_stage){cr,        lane,     tr_frame_map(room, scale, lane->x0, lane->y0, lane->x1, lane->y1),
                      box,       range,    tilt,
                      cos(tilt), sin(tilt)};
}

tr_point tr_stage_turned(const tr_stage *s, double x, double y) {
    return (tr_point){x * s->cos - y * s->sin, x * s->sin + y * s->cos};
}

tr_point tr_stage_point(const tr_stage *s, double x, double y) {
    tr_point p = tr_stage_turned(s, x, y);
    return tr_frame_point(&s->map, p.x, p.y);
}
