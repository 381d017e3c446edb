/* SPDX-License-Identifier: MIT */
#include "draw/patch_plot.h"
#include "draw/frame.h"
#include "draw/say.h"

#include <math.h>
#include <stdio.h>

double tr_patch_limited(double u) {
    return isfinite(u) ? fmin(fmax(u, -1), 1) : 0;
}

double tr_patch_slip_range(const tr_patch_state *s) {
    double most = 0;
    for (int i = 0; i < s->n; i++) most = fmax(most, fabs(s->slip[i]));
    return most > 1e-100 && most < 1e100 ? tr_frame_round_up(0.98 * most) : 0;
}

/* The element under a pixel, -1 outside of the contact. */
static int element_at(const tr_patch_plot *p, double x) {
    double u = 0.5 * (1 + (x - p->x0) / p->a) * p->state->n;
    return u >= 0 && u < p->state->n ? (int)u : -1;
}

static double height_of(const tr_patch_plot *p, double stress) {
    return p->half * tr_patch_limited(stress * p->scale / p->half);
}

/* On a lattice of the whole picture. */
static void hatch_clipped(cairo_t *cr) {
    double x0, y0, x1, y1;
    cairo_clip_extents(cr, &x0, &y0, &x1, &y1);
    const int step = 9;
    for (int k = (int)floor((x0 + y0) / step); step * k < x1 + y1; k++) { /* lines x + y = step k */
        cairo_move_to(cr, step * k - y0, y0);
        cairo_line_to(cr, step * k - y1, y1);
    }
    tr_pen_hue(cr, TR_STICKS);
    cairo_set_line_width(cr, 2.2);
    cairo_stroke(cr);
}

void tr_patch_plot_hatch(cairo_t *cr, double x, double y, double width, double height) {
    cairo_save(cr);
    cairo_rectangle(cr, x, y, width, height);
    cairo_clip(cr);
    hatch_clipped(cr);
    cairo_restore(cr);
}

/* From the axis to tau, or from top to bottom. Whole pixels: neighbours leave no seam. */
static void fill_zones(const tr_patch_plot *p, bool band, double top, double bottom) {
    cairo_t *cr = p->cr;
    cairo_save(cr);
    for (int stick = 0; stick <= 1; stick++) {
        for (int x = (int)(p->x0 - p->a) - 1; x < p->x0 + p->a + 1; x++) {
            int i = element_at(p, x + 0.5);
            if (i < 0 || (p->state->side[i] == 0) != stick) continue;
            double from = band ? top : p->y0, to = band ? bottom : nearbyint(p->y0 - height_of(p, p->state->tau[i]));
            cairo_rectangle(cr, x, fmin(from, to), 1, fabs(to - from));
            if (stick) continue;
            double slip = fabs(p->state->slip[i]);
            tr_pen_rgb(cr, tr_palette_ramp(TR_RAMP_SLIDING, p->slip_range > 0 ? slip / p->slip_range : 0));
            cairo_fill(cr);
        }
    }
    tr_pen_hue(cr, TR_WHITE);
    cairo_fill_preserve(cr);
    cairo_clip(cr);
    hatch_clipped(cr);
    cairo_restore(cr);
}

void tr_patch_plot_band(const tr_patch_plot *p, double top, double bottom) {
    if (!(p->a > 0)) return;
    fill_zones(p, true, top, bottom);
    tr_pen_hue(p->cr, TR_INK);
    cairo_rectangle(p->cr, p->x0 - p->a, top, 2 * p->a, bottom - top);
    cairo_set_line_width(p->cr, 2);
    cairo_stroke(p->cr);
}

void tr_patch_plot_arrows(const tr_patch_plot *p, double y, int way) {
    const double step = 46, half = 16;
    int last = p->a > half ? (int)((p->a - half) / step) : -1;
    tr_pen_hue(p->cr, TR_INK);
    for (int k = -last; k <= last; k++) {
        double x = p->x0 + k * step;
        int i = element_at(p, x - half), j = element_at(p, x), l = element_at(p, x + half);
        if (i < 0 || j < 0 || l < 0) continue;
        const signed char *side = p->state->side;
        if (side[j] == 0 || side[i] != side[j] || side[l] != side[j]) continue;
        double to = half * (side[j] < 0 ? -way : way);
        tr_pen_arrow(p->cr, (tr_point){x - to, y}, (tr_point){x + to, y}, 3);
    }
}

static void draw_bound(const tr_patch_plot *p) {
    cairo_t *cr = p->cr;
    double most = height_of(p, p->pair->mu * tr_patch_p0(p->pair, p->state->P));
    for (int k = 0; k < 180; k++) {
        double angle = k * M_PI / 90;
        cairo_line_to(cr, p->x0 + p->a * cos(angle), p->y0 - most * sin(angle));
    }
    cairo_close_path(cr);
    tr_pen_hue(cr, TR_DISK);
    cairo_fill_preserve(cr);
    tr_pen_hue(cr, TR_FAINT);
    cairo_set_line_width(cr, 2.5);
    cairo_stroke(cr);
    tr_text at = {.x = p->x0 + p->a + 0.3 * p->text, .size = p->text, .hue = TR_FAINT};
    at.y = p->y0 - fmax(0.45 * most, 0.35 * p->text); /* clear of the axis, also for a low bound */
    tr_pen_text(cr, at, "+μp");
    at.y = p->y0 + fmax(0.45 * most, 0.25 * p->text) + 0.75 * p->text;
    tr_pen_text(cr, at, "−μp");
}

/* Steps where they are wide enough, else a line through the middles: thin steps look ragged. */
static void draw_tau(const tr_patch_plot *p) {
    cairo_t *cr = p->cr;
    const tr_patch_state *s = p->state;
    double half = s->n <= 50 ? 1.0 / s->n : 0;
    cairo_move_to(cr, p->x0 - p->a, p->y0);
    for (int i = 0; i < s->n; i++) {
        double y = p->y0 - height_of(p, s->tau[i]), middle = (2.0 * i + 1) / s->n - 1;
        cairo_line_to(cr, p->x0 + p->a * (middle - half), y);
        cairo_line_to(cr, p->x0 + p->a * (middle + half), y);
    }
    cairo_line_to(cr, p->x0 + p->a, p->y0);
    tr_pen_hue(cr, TR_INK);
    cairo_set_line_width(cr, 0.16 * p->text);
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_BEVEL);
    cairo_stroke(cr);
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_MITER);
}

/* -1, 0, 1 stay readable when the contact is nearly open: their numbers keep a distance. */
static void draw_axis(const tr_patch_plot *p) {
    static const char *const number[] = {"−1", "0", "1"};
    double bottom = p->y0 + p->half, apart = fmax(p->a, 1.7 * p->text);
    tr_text at = {.y = bottom + 1.25 * p->text, .size = p->text, .align = TR_CENTRE};
    tr_pen_hue(p->cr, TR_INK);
    tr_pen_line(p->cr, (tr_point){p->x0 - p->reach, p->y0}, (tr_point){p->x0 + p->reach, p->y0}, 2);
    tr_pen_line(p->cr, (tr_point){p->x0 - p->reach, bottom}, (tr_point){p->x0 + p->reach, bottom}, 2);
    for (int k = -2; k <= 2 && p->a > 0; k++) {
        double x = p->x0 + k * p->a / 2;
        tr_pen_hue(p->cr, TR_INK);
        tr_pen_line(p->cr, (tr_point){x, bottom}, (tr_point){x, bottom - (k % 2 ? 6 : 10)}, 2);
        at.x = p->x0 + k * apart / 2;
        if (k % 2 == 0 && !p->plain) tr_pen_text(p->cr, at, number[k / 2 + 1]);
    }
    at.x = p->x0 + p->reach, at.align = TR_RIGHT;
    if (!p->plain) tr_pen_text(p->cr, at, "x/a");
}

void tr_patch_plot_draw(const tr_patch_plot *p) {
    if (p->a > 0) {
        draw_bound(p);
        fill_zones(p, false, 0, 0);
    }
    draw_axis(p);
    if (p->a > 0)
        draw_tau(p);
    else
        tr_pen_text(
            p->cr,
            (tr_text){
                .x = p->x0, .y = p->y0 - 0.8 * p->text, .size = 1.2 * p->text, .align = TR_CENTRE, .hue = TR_FAINT},
            TR_SAY(p->cr, no_traction));
}

/* Its own scale: hatched where it sticks; from light to dark the slip since the last step of the solver. */
static void draw_scale(const tr_patch_plot *p, double x, double y, double width) {
    const double box = 1.6 * p->text, high = 0.75 * p->text, ramp = (p->plain ? 1.6 : 3) * p->text;
    char label[64], number[24];
    tr_patch_plot_hatch(p->cr, x, y - high, box, high);
    tr_text at = {.x = x + box + 8, .y = y, .size = p->text};
    at.x += tr_pen_text(p->cr, at, TR_SAY(p->cr, sticks)) + p->text;
    for (int k = 0; k < (int)ramp && (p->slip_range > 0 || p->plain); k++) {
        cairo_rectangle(p->cr, nearbyint(at.x) + k, y - high, 1, high);
        tr_pen_rgb(p->cr, tr_palette_ramp(TR_RAMP_SLIDING, k / ramp));
        cairo_fill(p->cr);
    }
    if (p->slip_range > 0 || p->plain) at.x += ramp + 8;
    snprintf(label, sizeof label, "%s", p->plain ? TR_SAY(p->cr, slips) : TR_SAY(p->cr, no_slip));
    if (p->slip_range > 0 && !p->plain) {
        tr_unit unit = tr_frame_unit(p->slip_range, "m");
        unit.decimals = 0;
        tr_frame_number(number, sizeof number, p->slip_range, &unit, false);
        tr_words_fill(label, sizeof label, TR_SAY(p->cr, slip_to), number, unit.name);
    }
    at.room = x + width - at.x;
    tr_pen_text(p->cr, at, label);
}

void tr_draw_patch_inset(cairo_t *cr, tr_box box, const tr_patch_state *state, const tr_patch_pair *pair, bool expert) {
    const double x = box.x, y = box.y, width = box.w, height = box.h;
    double text = expert ? fmin(fmax(0.1 * height, 16), 24) : 24, reach = 0.5 * width - 4,
           half = 0.5 * (height - (expert ? 3 : 1.6) * text) - 4;
    bool open = !(state->P > 0);
    tr_patch_plot plot = {.cr = cr,
                          .pair = pair,
                          .state = state,
                          .x0 = nearbyint(x + 0.5 * width),
                          .y0 = nearbyint(y + 4 + half),
                          .a = open ? 0 : reach - 3 * text,
                          .reach = reach,
                          .half = half,
                          .slip_range = tr_patch_slip_range(state),
                          .text = text,
                          .plain = !expert};
    plot.scale = open ? 0 : 0.95 * half / (pair->mu * tr_patch_p0(pair, state->P));
    cairo_save(cr);
    tr_pen_hue(cr, TR_WHITE);
    cairo_rectangle(cr, x, y, width, height);
    cairo_fill(cr);
    tr_patch_plot_draw(&plot);
    if (!open) draw_scale(&plot, x, y + height - 0.3 * text, width);
    cairo_restore(cr);
}
