/* SPDX-License-Identifier: MIT */
/* What all frames share: the map from metres to pixels, the side panel, units, the scale bar. */
#ifndef TR_FRAME_H
#define TR_FRAME_H

#include "draw/draw.h"
#include "draw/pen.h"

/* Margins of a frame [px]. */
enum {
    TR_EDGE = 28,
    TR_PANEL_X = 852,
    TR_PANEL_W = TR_FRAME_WIDTH - TR_EDGE - TR_PANEL_X,
    TR_PICTURE_W = TR_PANEL_X - 40 - TR_EDGE
};

/* Pixel of a point: (x + scale X, y - scale Y). The rectangle is where the view box lies. */
typedef struct tr_map {
    double scale, x, y;
    double left, top, width, height;
} tr_map;

/* A rectangle of the picture, from its upper left corner [px]. */
typedef struct tr_box {
    double x, y, w, h;
} tr_box;

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

/* Next of ..., 0.5, 1, 2, 5, 10, ... for 1e-300 < x < 1e300. */
double tr_frame_round_down(double x);
double tr_frame_round_up(double x);

typedef struct tr_head {
    const char *title, *label, *value; /* label and value: how far the film is */
    const tr_view_line *line;
    int n_lines;
} tr_head;

/* White ground, title, side panel. Returns its first free line [px]. */
double tr_frame_head(cairo_t *cr, const tr_head *head);

/* What the colours of a bar are: a ramp from 0 to range, or the diverging palette from -range. */
typedef struct tr_scale {
    const char *name;
    double range;
    const tr_unit *unit;
    tr_ramp ramp;
    bool diverging, motion; /* motion: words at its ends, no numbers */
} tr_scale;

/* In the panel; y: base line of its label [px]. */
void tr_frame_color_bar(cairo_t *cr, const tr_scale *scale, double y);

/* Of a field of contacts. */
tr_ramp tr_frame_ramp(tr_color color);

/* The time, with one digit more than its end needs. */
void tr_frame_time(char *text, size_t size, double time, double time_end);

/* The largest scale at which a part of the plane fits into the rectangle [px/m]; 0: it is empty or not finite. */
double tr_frame_scale(tr_box box, double x0, double y0, double x1, double y1);

/* That part in the middle of the rectangle, at a scale > 0. */
tr_map tr_frame_map(tr_box box, double scale, double x0, double y0, double x1, double y1);

/* A round length, at the left; y: base line of its label. Returns where the label ends [px]. */
double tr_frame_scale_bar(cairo_t *cr, double scale, double y);

/* Starts a frame of a world: all of the above, with time, scale bar, and the largest view box that fits.
 * *panel_y: first free line of the panel [px]. scale 0: the box is empty or not finite, so nothing is drawn. */
tr_map tr_frame_start(cairo_t *cr, const tr_view *view, double *panel_y);

tr_point tr_frame_point(const tr_map *map, double x, double y);

/* Near the picture and finite: Cairo's fixed-point coordinates would wrap. */
bool tr_frame_seen(tr_point p, double radius);

/* Image 0 of a point is the point; in a periodic cell it has eight more. */
int tr_frame_images(const tr_view *view);
tr_point tr_frame_image(const tr_view *view, const tr_map *map, tr_point p, int image);

/* In the picture, and no further out of a cell than its diameter. */
bool tr_frame_shown(const tr_view *view, const tr_map *map, tr_point p, double radius);

#endif
