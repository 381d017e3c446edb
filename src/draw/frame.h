/* SPDX-License-Identifier: MIT */
/* What all frames share: the map from metres to pixels, the side panel, units, the scale bar. */
#ifndef TR_FRAME_H
#define TR_FRAME_H

#include "draw/draw.h"
#include "draw/pen.h"

/* Margins of a frame [px]. */
enum { TR_EDGE = 28, TR_PANEL_X = 852, TR_PANEL_W = TR_FRAME_WIDTH - TR_EDGE - TR_PANEL_X };

/* Pixel of a point: (x + scale X, y - scale Y). The rectangle is where the view box lies. */
typedef struct tr_map {
    double scale, x, y;
    double left, top, width, height;
} tr_map;

/* An SI prefix for a kind of values: print value/size with that many decimals. */
typedef struct tr_unit {
    double size;
    char name[12];
    int decimals;
} tr_unit;

/* Puts `largest` between 1 and 1000; three digits after rounding. */
tr_unit tr_frame_unit(double largest, const char *si_unit);

/* "%.{decimals}f" with a true minus; sign: plus is shown too. */
void tr_frame_number(char *text, size_t size, double value, const tr_unit *unit, bool sign);

/* Starts a frame: white ground, title, side panel with time and lines, scale bar, view box as large as fits.
 * *panel_y: first free line of the panel [px]. scale 0: the box is empty or not finite, there is nothing to draw. */
tr_map tr_frame_start(cairo_t *cr, const tr_view *view, double *panel_y);

tr_point tr_frame_point(const tr_map *map, double x, double y);

/* Near the picture and finite: Cairo's fixed-point coordinates would wrap. */
bool tr_frame_seen(tr_point p, double radius);

#endif
