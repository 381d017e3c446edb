/* SPDX-License-Identifier: MIT */
/* Velocities as bars. */
#ifndef TR_DRAW_SHOW_BAR_H
#define TR_DRAW_SHOW_BAR_H

#include "draw/frame.h"

/* A velocity as a bar within +-range, and its number: beside the bar if there is room, else above. */
typedef struct tr_bar {
    double value, expected, range; /* expected NaN: not said */
    const tr_unit *unit;
    bool bold, with_unit;
    bool told; /* keep room for a verdict */
} tr_bar;

/* The value differs from what the class is told, by more than 1 % of the range. */
bool tr_bar_wrong(const tr_bar *bar);
void tr_bar_draw(cairo_t *cr, tr_box box, const tr_bar *bar);

/* V_s or V_r of a contact as the class is told; NaN: not said. */
double tr_show_expected(const tr_show_lane *lane, const tr_record *record, bool rolling);

/* The two numbers of a lane among others, in a row or below each other. */
void tr_panel_pair(cairo_t *cr, tr_box box, const tr_show_lane *lane, double range);

#endif
