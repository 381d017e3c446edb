/* SPDX-License-Identifier: MIT */
/* The few strokes that all frames are made of. Only draw/ sees this header: it names Cairo. */
#ifndef TR_PEN_H
#define TR_PEN_H

#include "draw/palette.h"
#include <cairo.h>
#include <stdbool.h>
#include <stddef.h>

struct tr_canvas {
    cairo_surface_t *surface;
    cairo_t *cr;
    struct tr_png *png; /* of tr_canvas_encode */
};

typedef enum tr_align { TR_LEFT, TR_CENTRE, TR_RIGHT } tr_align;

typedef struct tr_text {
    double x, y; /* of the base line's start, middle or end [px] */
    double size; /* [px] */
    double room; /* longest allowed width, longer text is set smaller [px]; 0: any */
    tr_align align;
    bool bold;
    bool halo;    /* a white rim, readable on any ground */
    unsigned hue; /* 0 (black) means TR_INK */
} tr_text;

typedef struct tr_point {
    double x, y;
} tr_point;

void tr_pen_hue(cairo_t *cr, unsigned hue);
void tr_pen_rgb(cairo_t *cr, tr_rgb color);

/* Text in DejaVu Sans, UTF-8; `_` lowers what follows, as in draw.h. Returns its width [px]. */
double tr_pen_text(cairo_t *cr, tr_text at, const char *given);

/* Only the width; ignores room. */
double tr_pen_width(cairo_t *cr, tr_text at, const char *given);

/* Words of a text in at most n_lines lines, of at.room or narrower; at.size is the largest that is tried. Returns the
 * height [px], and draws when asked. */
double tr_pen_paragraph(cairo_t *cr, tr_text at, int n_lines, const char *text, bool draw);

/* A tick in green or a dark cross; size: of the letters beside it, at: on their base line. */
void tr_pen_verdict(cairo_t *cr, tr_point at, double size, bool right);

void tr_pen_line(cairo_t *cr, tr_point from, tr_point to, double width);
void tr_pen_dot(cairo_t *cr, tr_point at, double radius);

/* Adds a disk to the path, so that many can be filled at once. */
void tr_pen_add_disk(cairo_t *cr, tr_point at, double radius);

/* A straight arrow with its head at `to`; shorter than half a head, nothing. */
void tr_pen_arrow(cairo_t *cr, tr_point from, tr_point to, double width);

/* An arc about `centre`; angles as in the world, counter-clockwise from +x. With an arrow head at its end if asked. */
void tr_pen_arc(cairo_t *cr, tr_point centre, double radius, double from, double sweep, double width, bool head);

#endif
