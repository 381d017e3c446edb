/* SPDX-License-Identifier: MIT */
/* The parts of tr_draw_show: the stage on which the bodies of a lane move, and what stands beside it. Only frame_show.c
 * knows where a part goes: each draws into the rectangle that it is given. */
#ifndef TR_SHOW_H
#define TR_SHOW_H

#include "draw/frame.h"

enum { TR_SHOW_CONTACTS = 4 }; /* that have room, in the panel and on the rims */

/* ---- the stage ---- */

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
void tr_stage_draw(const tr_stage *stage);

tr_point tr_stage_point(const tr_stage *stage, double x, double y);  /* [px] */
tr_point tr_stage_turned(const tr_stage *stage, double x, double y); /* a vector; y still points up */

/* What the bodies stand on and leave behind. */
void tr_ground_walls(const tr_stage *stage);
void tr_ground_trace(const tr_stage *stage);
void tr_ground_slope(const tr_stage *stage);

/* ---- numbers ---- */

/* A velocity as a bar within +-range, and its number: beside it where there is room, else above. */
typedef struct tr_bar {
    double value, expected, range; /* expected NaN: not said */
    const tr_unit *unit;
    bool bold, with_unit;
    bool told; /* keep room for a verdict */
} tr_bar;

/* The class is told otherwise: off by more than 1 % of the range. */
bool tr_bar_wrong(const tr_bar *bar);
void tr_bar_draw(cairo_t *cr, tr_box box, const tr_bar *bar);

/* V_s or V_r of a contact as the class is told; NaN: not said. */
double tr_show_expected(const tr_show_lane *lane, const tr_record *record, bool rolling);

/* V_s and V_r by every definition, a column for each of the first contacts. Rows that do not fit at a readable size are
 * left out: the arcs, then the last definitions; then all, and it returns false. */
bool tr_panel_bars(cairo_t *cr, tr_box box, const tr_show_lane *lane, double range);

/* The two numbers of a lane among others, in a row or below each other. */
void tr_panel_pair(cairo_t *cr, tr_box box, const tr_show_lane *lane, double range);

/* Height that the table of checks wants [px]; those that do not fit are counted in its last line. */
double tr_panel_checks_height(const tr_show_check *check, int n);
void tr_panel_checks(cairo_t *cr, tr_box box, const tr_show_check *check, int n);

/* ---- the chart ---- */

/* Colour and shape that stand for a lane wherever it is named; of one lane alone those of its first curve. */
unsigned tr_lane_hue(int n_lanes, int lane);
void tr_lane_marker(cairo_t *cr, tr_point at, double size, int n_lanes, int lane);

void tr_show_chart(cairo_t *cr, tr_box box, const tr_show *show);

#endif
