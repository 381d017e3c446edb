/* SPDX-License-Identifier: MIT */
/* Velocities as bars. */
#ifndef TR_DRAW_SHOW_BAR_H
#define TR_DRAW_SHOW_BAR_H

#include "draw/frame.h"

/* A velocity as a bar within +-range in the colour of its meaning; its direction is its sign. Its number, if there is a
 * unit, stands beside it where there is room, else above. */
typedef struct tr_bar {
    double value, range;
    unsigned hue;
    const tr_unit *unit; /* NULL: no number */
    bool bold, with_unit;
    bool size_only; /* the number has no sign */
    bool differs;   /* hatched: another definition says otherwise */
} tr_bar;

void tr_bar_draw(cairo_t *cr, tr_box box, const tr_bar *bar);

#endif
