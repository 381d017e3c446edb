/* SPDX-License-Identifier: MIT */
/* The inside of one line contact, as [Kuhn2014 Fig. 2] but for any instant of any path.
 *
 * Above the two bodies, 1 below and 2 above as n points up and t to the right; between them the contact, and below it
 * the tractions over the same x. The gap beside the contact is Hertz's, much exaggerated [Johnson1985 sec. 4.2]:
 *
 *   h(x) = (a^2/(2 R_star)) (X sqrt(X^2 - 1) - arcosh X),   X = |x|/a > 1;   x^2/(2 R_star) for a = 0
 *
 * Velocities of the rims along t, seen from the contact: v_1 = v_roll - v_slide/2, v_2 = v_roll + v_slide/2. The small
 * arrows beside the contact are the slip, which moves 2 against 1. */
#include "draw/frame_patch.h"

#include "draw/frame.h"
#include "draw/patch_plot.h"
#include "draw/say.h"

#include <math.h>
#include <stdio.h>

/* The contact at its widest is 2 WIDEST px; the bodies reach further out than the axes, left of which are numbers. */
enum { MIDDLE = 448, REACH = 364, AXES = 330, WIDEST = 225, CONTACT_Y = 184, BAND = 13, BODY = 106, PLOT_Y = 490 };
enum { PLOT_HALF = 160, PLOT_HIGH = 150 };

static const double curvature = 1 / 240.0; /* 1/R_star of the picture [1/px] */

/* Half the gap, at x from the middle [px]. */
static double gap(double x, double a) {
    double far = fmax(fabs(x), a), root = sqrt((far - a) * (far + a));
    return 0.25 * curvature * (far * root - (a > 0 ? a * a * log((far + root) / a) : 0));
}

/* way 1: body 1, below. */
static void draw_body(cairo_t *cr, double a, double apart, int way) {
    double rim = CONTACT_Y + way * (BAND + apart), back = CONTACT_Y + way * BODY;
    cairo_save(cr);
    cairo_rectangle(cr, MIDDLE - REACH, CONTACT_Y - BODY, 2 * REACH, 2 * BODY);
    cairo_clip(cr);
    for (int x = -REACH; x <= REACH; x += 4) cairo_line_to(cr, MIDDLE + x, rim + way * gap(x, a));
    cairo_path_t *outline = cairo_copy_path(cr);
    cairo_line_to(cr, MIDDLE + REACH, back);
    cairo_line_to(cr, MIDDLE - REACH, back);
    cairo_close_path(cr);
    tr_pen_hue(cr, TR_DISK);
    cairo_fill(cr);
    cairo_append_path(cr, outline);
    cairo_path_destroy(outline);
    tr_pen_hue(cr, TR_WALL);
    cairo_set_line_width(cr, 3);
    cairo_stroke(cr);
    cairo_restore(cr);
}

static void draw_velocity(cairo_t *cr, double v, double y, const char *body, const char *name) {
    const double longest = 170, from = 24;
    double way = v < 0 ? -1 : 1, tip = MIDDLE + way * (from + longest * fabs(v));
    tr_pen_text(cr, (tr_text){.x = MIDDLE, .y = y + 12, .size = 34, .bold = true, .align = TR_CENTRE}, body);
    if (!(longest * fabs(v) > 14)) return; /* half a head */
    tr_pen_hue(cr, TR_GREEN);
    tr_pen_arrow(cr, (tr_point){MIDDLE + way * from, y}, (tr_point){tip, y}, 7);
    tr_pen_text(
        cr,
        (tr_text){.x = tip + 10 * way, .y = y + 8, .size = 26, .align = v < 0 ? TR_RIGHT : TR_LEFT, .hue = TR_GREEN},
        name);
}

static void draw_edges(cairo_t *cr, double v_roll) {
    static const tr_word_key name[] = {TR_WORD_enters, TR_WORD_leaves};
    for (int i = 0; i < 2 && v_roll != 0; i++) { /* v_roll > 0: enters at the left */
        double x = MIDDLE + ((v_roll > 0) == (i == 0) ? -1 : 1) * (REACH - 50);
        tr_text at = {.x = x, .y = CONTACT_Y - 3, .size = 22, .align = TR_CENTRE};
        tr_pen_text(cr, at, TR_SAY(cr, material));
        at.y += 24;
        tr_pen_text(cr, at, tr_say(cr, name[i]));
    }
}

static void draw_bodies(const tr_patch_view *view, const tr_patch_plot *plot) {
    cairo_t *cr = plot->cr;
    double slide = view->v_slide, roll = view->v_roll, unit = fmax(fabs(slide), fabs(roll));
    slide = unit > 0 ? tr_patch_limited(slide / unit) : 0, roll = unit > 0 ? tr_patch_limited(roll / unit) : 0;
    double v1 = roll - 0.5 * slide, v2 = roll + 0.5 * slide, fastest = fmax(fmax(fabs(v1), fabs(v2)), 1e-9);
    double apart = plot->a > 0 ? 0 : 8;
    draw_body(cr, plot->a, apart, -1);
    draw_body(cr, plot->a, apart, 1);
    tr_patch_plot_band(plot, CONTACT_Y - BAND, CONTACT_Y + BAND);
    tr_patch_plot_arrows(plot, CONTACT_Y - BAND - 13, 1);
    tr_patch_plot_arrows(plot, CONTACT_Y + BAND + 13, -1);
    draw_velocity(cr, v2 / fastest, CONTACT_Y - 70, "2", "v_2");
    draw_velocity(cr, v1 / fastest, CONTACT_Y + 70, "1", "v_1");
    draw_edges(cr, roll);
}

/* Faint lines from the bodies down to the ends of the traction. */
static void draw_links(const tr_patch_plot *p) {
    cairo_save(p->cr);
    cairo_set_dash(p->cr, (double[]){4, 6}, 2, 0);
    tr_pen_hue(p->cr, TR_RIM);
    for (int side = -1; side <= 1 && p->a > 0; side += 2)
        tr_pen_line(p->cr, (tr_point){p->x0 + side * p->a, CONTACT_Y + BODY},
                    (tr_point){p->x0 + side * p->a, PLOT_Y + PLOT_HALF}, 2);
    cairo_restore(p->cr);
}

/* most: traction of PLOT_HIGH px. */
static void draw_stress_axis(cairo_t *cr, double most) {
    const double left = MIDDLE - AXES;
    char text[64];
    tr_unit unit = tr_frame_unit(most, "Pa");
    snprintf(text, sizeof text, "τ [%s]", unit.name);
    tr_pen_text(cr, (tr_text){.x = TR_EDGE, .y = PLOT_Y - PLOT_HALF - 14, .size = 24}, most > 0 ? text : "τ");
    tr_pen_hue(cr, TR_INK);
    tr_pen_line(cr, (tr_point){left, PLOT_Y - PLOT_HALF}, (tr_point){left, PLOT_Y + PLOT_HALF}, 2);
    double step = most > 0 ? tr_frame_round_down(most / 1.5) : 0;
    unit.decimals = step / unit.size < 1;
    int last = most > 0 ? 4 : 0;
    for (int k = -last; k <= last; k++) {
        double y = PLOT_Y - (k ? PLOT_HIGH * (k * step / most) : 0);
        if (fabs(y - PLOT_Y) > PLOT_HALF) continue;
        tr_frame_number(text, sizeof text, k * step, &unit, false);
        tr_pen_hue(cr, TR_INK);
        tr_pen_line(cr, (tr_point){left, y}, (tr_point){left + 8, y}, 2);
        tr_pen_text(cr, (tr_text){.x = left - 8, .y = y + 8, .size = 24, .room = left - 8 - TR_EDGE, .align = TR_RIGHT},
                    text);
    }
}

static void draw_key(cairo_t *cr, double slip_range) {
    static const tr_word_key name[] = {TR_WORD_patch_bound, TR_WORD_patch_traction, TR_WORD_patch_stick,
                                       TR_WORD_patch_slip};
    const double x = TR_PANEL_X, y = TR_FRAME_HEIGHT - TR_EDGE - 72, middle[] = {y - 168, y - 130, y - 92, y - 54};
    for (int i = 0; i < 4; i++)
        tr_pen_text(cr, (tr_text){.x = x + 64, .y = middle[i] + 8, .size = 24, .room = TR_PANEL_W - 64},
                    tr_say(cr, name[i]));
    cairo_rectangle(cr, x, middle[0] - 12, 48, 24);
    tr_pen_hue(cr, TR_DISK);
    cairo_fill_preserve(cr);
    tr_pen_hue(cr, TR_FAINT);
    cairo_set_line_width(cr, 2.5);
    cairo_stroke(cr);
    tr_pen_hue(cr, TR_INK);
    tr_pen_line(cr, (tr_point){x, middle[1]}, (tr_point){x + 48, middle[1]}, 4);
    tr_patch_plot_hatch(cr, x, middle[2] - 12, 48, 24);
    tr_pen_hue(cr, TR_INK);
    tr_pen_arrow(cr, (tr_point){x + 8, middle[3]}, (tr_point){x + 40, middle[3]}, 3);
    tr_unit unit = tr_frame_unit(slip_range, "m");
    if (slip_range > 0)
        tr_frame_color_bar(cr, &(tr_scale){TR_SAY(cr, patch_scale), slip_range, &unit, TR_RAMP_SLIDING, false, false},
                           y);
}

static double draw_head(cairo_t *cr, const tr_patch_view *view) {
    char done[16];
    snprintf(done, sizeof done, "%.0f %%", 100 * fmax(tr_patch_limited(view->progress), 0));
    return tr_frame_head(cr, &(tr_head){view->title, TR_SAY(cr, patch_path), done, view->line, view->n_lines});
}

/* x if it can be drawn, else 0. */
static double sane(double x) {
    return x > 1e-100 && x < 1e100 ? x : 0;
}

void tr_draw_patch(tr_canvas *canvas, const tr_patch_view *view) {
    cairo_t *cr = canvas->cr;
    const tr_patch_state *s = view->state;
    double a = sane(s->P) > 0 ? sane(s->a) : 0, a_max = fmax(sane(view->a_max), a);
    double p_max = sane(view->p_max) > 0 ? view->p_max : tr_patch_p0(view->pair, s->P),
           most = sane(view->pair->mu * p_max);
    double slip = sane(view->slip_max) > 0 ? tr_frame_round_up(0.98 * view->slip_max) : tr_patch_slip_range(s);
    tr_patch_plot plot = {.cr = cr,
                          .pair = view->pair,
                          .state = s,
                          .x0 = MIDDLE,
                          .y0 = PLOT_Y,
                          .a = a > 0 ? WIDEST * (a / a_max) : 0,
                          .scale = most > 0 ? PLOT_HIGH / most : 0,
                          .reach = AXES,
                          .half = PLOT_HALF,
                          .slip_range = slip,
                          .text = 26};
    draw_head(cr, view);
    draw_links(&plot);
    draw_bodies(view, &plot);
    draw_stress_axis(cr, most);
    tr_patch_plot_draw(&plot);
    draw_key(cr, slip);
}
