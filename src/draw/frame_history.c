/* SPDX-License-Identifier: MIT */
/* sin φ and the share of rolling over strain, which grow with the film, both from 0 to 1 along the same axis; and where
 * disks have fallen into a new place, a mark. */
#include "draw/frame_history.h"

#include "draw/say.h"

#include <math.h>
#include <stdio.h>

enum { LEAST_ROWS = 8, ROW = 30 };

/* The middle of the first n values, by halving an interval that holds it: no copy, no order. */
static double median(const double *value, int n) {
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < n; i++) low = fmin(low, value[i]), high = fmax(high, value[i]);
    for (int k = 0; k < 60 && high > low; k++) {
        double middle = 0.5 * (low + high);
        int below = 0;
        for (int i = 0; i < n; i++) below += value[i] <= middle;
        *(2 * below >= n ? &high : &low) = middle;
    }
    return high;
}

static double limit_of(const tr_history *h) {
    return h->n >= LEAST_ROWS ? 4 * median(h->unbalanced, h->n) : INFINITY;
}

bool tr_history_event(const tr_history *h, int i) {
    return h->unbalanced[i] > limit_of(h);
}

static void draw_curve(cairo_t *cr, tr_box plot, const tr_history *h, const double *value, unsigned hue) {
    for (int i = 0; i < h->n; i++) {
        double x = plot.x + plot.w * h->strain[i] / h->strain_end,
               y = plot.y + plot.h * (1 - fmin(fmax(value[i], 0), 1));
        if (isfinite(x) && isfinite(y) && tr_frame_seen((tr_point){x, y}, 1))
            cairo_line_to(cr, x, y);
        else
            cairo_new_sub_path(cr);
    }
    tr_pen_hue(cr, hue);
    cairo_set_line_width(cr, 3);
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_BEVEL);
    cairo_stroke(cr);
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_MITER);
}

/* One mark for rows that follow each other. Returns how many there are. */
static int draw_events(cairo_t *cr, tr_box plot, const tr_history *h) {
    int events = 0;
    double limit = limit_of(h);
    tr_pen_hue(cr, TR_RIM);
    for (int i = 0; i < h->n; i++) {
        double x = plot.x + plot.w * h->strain[i] / h->strain_end;
        if (!(h->unbalanced[i] > limit) || !tr_frame_seen((tr_point){x, plot.y}, 1)) continue;
        events += i == 0 || !(h->unbalanced[i - 1] > limit);
        cairo_rectangle(cr, x - 1, plot.y, 2, plot.h);
        cairo_fill(cr);
    }
    return events;
}

/* "▬ name" at x; where it ends. */
static double draw_key(cairo_t *cr, double x, double y, unsigned hue, const char *name) {
    tr_pen_hue(cr, hue);
    tr_pen_line(cr, (tr_point){x, y - 8}, (tr_point){x + 26, y - 8}, 4);
    return x + 34 + tr_pen_text(cr, (tr_text){.x = x + 34, .y = y, .size = 22, .bold = true, .hue = hue}, name) + 20;
}

void tr_frame_history(cairo_t *cr, tr_box box, const tr_history *h) {
    tr_box plot = {box.x + 46, box.y + 2 * ROW, box.w - 56, box.h - 3 * ROW - 4};
    if (!(plot.h > 40) || !(h->strain_end > 0)) return;
    double x = draw_key(cr, box.x, box.y + 22, TR_INK, "sin φ");
    draw_key(cr, x, box.y + 22, TR_ROLLS, TR_SAY(cr, rolling_share));
    if (draw_events(cr, plot, h) > 0) draw_key(cr, box.x, box.y + 22 + ROW, TR_FAINT, TR_SAY(cr, event));
    tr_pen_hue(cr, TR_INK);
    tr_pen_line(cr, (tr_point){plot.x, plot.y}, (tr_point){plot.x, plot.y + plot.h}, 2);
    tr_pen_line(cr, (tr_point){plot.x, plot.y + plot.h}, (tr_point){plot.x + plot.w, plot.y + plot.h}, 2);
    tr_text at = {.x = plot.x - 8, .y = plot.y + plot.h + 4, .size = 20, .align = TR_RIGHT};
    tr_pen_text(cr, at, "0");
    at.y = plot.y + 14;
    tr_pen_text(cr, at, "1");
    char text[64];
    snprintf(text, sizeof text, "%.3g %%", 100 * h->strain_end);
    at.x = plot.x + plot.w, at.y = plot.y + plot.h + 26;
    tr_pen_text(cr, at, text);
    at.x = plot.x, at.align = TR_LEFT;
    tr_pen_text(cr, at, TR_SAY(cr, strain));
    draw_curve(cr, plot, h, h->sin_phi, TR_INK);
    draw_curve(cr, plot, h, h->rolling_share, TR_ROLLS);
}
