/* SPDX-License-Identifier: MIT */
/* Bars of V_s and of V_r by every definition, one group for each contact, all to the same scale. */
#include "draw/bodies_panel.h"

#include <math.h>
#include <stdio.h>

enum { LABEL_W = 176, VALUE_W = 84 };

static const double bar_left = TR_PANEL_X + LABEL_W, bar_right = TR_PANEL_X + TR_PANEL_W - VALUE_W;

/* Rows are equal lines of a table. */
typedef struct tr_rows {
    cairo_t *cr;
    double y, height, range;
    tr_unit unit;
} tr_rows;

static void draw_bar(tr_rows *rows, const char *label, double value, bool bold) {
    cairo_t *cr = rows->cr;
    double size = fmin(0.78 * rows->height, 22), base = rows->y + 0.74 * rows->height;
    double zero = (bar_left + bar_right) / 2, half = (bar_right - bar_left) / 2, u = value / rows->range;
    double end = zero + half * fmin(fmax(isfinite(u) ? u : 0, -1), 1);
    tr_pen_text(cr, (tr_text){.x = TR_PANEL_X, .y = base, .size = size, .room = LABEL_W - 8, .bold = bold}, label);
    tr_pen_hue(cr, 0xF3F4F6);
    cairo_rectangle(cr, bar_left, rows->y + 2, 2 * half, rows->height - 4);
    cairo_fill(cr);
    tr_pen_rgb(cr, tr_palette_diverging(value < 0 ? -0.75 : 0.75));
    cairo_rectangle(cr, fmin(zero, end), rows->y + 4, fabs(end - zero), rows->height - 8);
    cairo_fill(cr);
    tr_pen_hue(cr, TR_INK);
    tr_pen_line(cr, (tr_point){zero, rows->y}, (tr_point){zero, rows->y + rows->height}, 2);
    char number[32];
    tr_frame_number(number, sizeof number, value, &rows->unit, true);
    tr_pen_text(cr,
                (tr_text){.x = TR_PANEL_X + TR_PANEL_W,
                          .y = base,
                          .size = size,
                          .align = TR_RIGHT,
                          .room = VALUE_W - 8,
                          .bold = bold},
                number);
    rows->y += rows->height;
}

/* Which bodies, and the arcs over their rims. */
static void draw_heading(tr_rows *rows, const tr_record *r) {
    char name[64], number[32], arc[80];
    tr_text at = {
        .x = TR_PANEL_X, .y = rows->y + 0.8 * rows->height, .size = fmin(0.85 * rows->height, 20), .bold = true};
    tr_unit unit = tr_frame_unit(fmax(fabs(r->da), fabs(r->db)), "m");
    snprintf(name, sizeof name, r->a < 0 ? "wall %d – disk %d" : "disk %d – disk %d", r->a < 0 ? -1 - r->a : r->a,
             r->b);
    tr_pen_text(rows->cr, at, name);
    at.bold = false, at.align = TR_RIGHT;
    for (int i = 0; i < 2; i++) {
        tr_frame_number(number, sizeof number, i ? r->db : r->da, &unit, true);
        snprintf(arc, sizeof arc, "Δ%c %s%s%s", "ab"[i], number, i ? " " : "", i ? unit.name : "");
        at.x = TR_PANEL_X + (i ? 1.0 : 0.65) * TR_PANEL_W;
        at.size = fmin(0.78 * rows->height, 18);
        at.hue = i ? TR_VERMILLION : TR_BLUE;
        tr_pen_text(rows->cr, at, arc);
    }
    rows->y += 1.1 * rows->height;
}

static void draw_bars(tr_rows *rows, const char *symbol, const tr_velocity_measure *measure, int n, const double *value,
                      int used) {
    for (int k = 0; k < n; k++) {
        char label[64];
        snprintf(label, sizeof label, "%s %s", symbol, measure[k].name);
        draw_bar(rows, label, value[k], k == used);
    }
}

static void draw_axis(const tr_rows *rows) {
    tr_unit whole = rows->unit; /* the range is a round number */
    whole.decimals = rows->range / whole.size < 1 ? 1 : 0;
    char number[32];
    tr_text at = {.y = rows->y + 8, .size = fmin(0.78 * rows->height, 22), .hue = TR_FAINT};
    for (int i = -1; i <= 1; i += 2) {
        at.align = (tr_align)(i + 1); /* the numbers end where the bars end */
        at.x = (bar_left + bar_right) / 2 + i * (bar_right - bar_left) / 2;
        tr_frame_number(number, sizeof number, i * rows->range, &whole, true);
        tr_pen_text(rows->cr, at, number);
    }
    at.x = TR_PANEL_X + TR_PANEL_W;
    at.align = TR_RIGHT;
    tr_pen_text(rows->cr, at, rows->unit.name);
}

void tr_bodies_panel(cairo_t *cr, const tr_view *view, double range, double y) {
    const int shown = view->n_records < TR_BODIES_CONTACTS ? view->n_records : TR_BODIES_CONTACTS;
    const double bottom = TR_FRAME_HEIGHT - TR_EDGE;
    if (shown == 0) {
        tr_pen_text(cr, (tr_text){.x = TR_PANEL_X, .y = y + 44, .size = 28, .hue = TR_FAINT}, "no contact");
        return;
    }
    /* a group: heading 1.1, bars, gap 0.4; below all the axis and a note, 40 px */
    double n_rows = shown * (1.1 + tr_n_sliding_velocities + tr_n_rolling_velocities + 0.4);
    tr_rows rows = {.cr = cr, .y = y, .range = range, .height = fmin((bottom - 40 - y) / n_rows, 36)};
    rows.unit = tr_frame_unit(range, "m/s");
    for (int i = 0; i < shown; i++) {
        const tr_record *r = &view->record[i];
        draw_heading(&rows, r);
        draw_bars(&rows, "V_s", tr_sliding_velocities, tr_n_sliding_velocities, r->v_s_by,
                  0); /* friction uses the first */
        draw_bars(&rows, "V_r", tr_rolling_velocities, tr_n_rolling_velocities, r->v_r_by,
                  view->world->rolling_velocity);
        rows.y += 0.4 * rows.height;
    }
    draw_axis(&rows);
    if (view->n_records > shown) {
        char text[64];
        snprintf(text, sizeof text, "the first %d of %d contacts", shown, view->n_records);
        tr_pen_text(cr, (tr_text){.x = TR_PANEL_X, .y = bottom, .size = 20, .hue = TR_FAINT}, text);
    }
}
