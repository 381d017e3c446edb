/* SPDX-License-Identifier: MIT */
/* A velocity as a bar and a number.
 *
 * A value that differs from what the class is told (tr_expect) gets a cross and a hatched bar, so that it is seen
 * without colours too. */

#include "draw/show_bar.h"

#include <math.h>
#include <stdio.h>

double tr_show_expected(const tr_show_lane *lane, const tr_record *r, bool rolling) {
    for (int i = 0; i < lane->n_expect; i++) {
        const tr_expect *e = &lane->expect[i];
        if (e->a == r->a && e->b == r->b) return rolling ? e->v_r : e->v_s;
    }
    return NAN;
}

bool tr_bar_wrong(const tr_bar *bar) {
    return !isnan(bar->expected) && !(fabs(bar->value - bar->expected) <= 0.01 * bar->range);
}

static void draw_strip(cairo_t *cr, tr_box box, const tr_bar *bar) {
    double zero = box.x + box.w / 2, u = bar->value / bar->range;
    double end = zero + box.w / 2 * fmin(fmax(isfinite(u) ? u : 0, -1), 1), left = fmin(zero, end);
    tr_pen_hue(cr, 0xF3F4F6);
    cairo_rectangle(cr, box.x, box.y, box.w, box.h);
    cairo_fill(cr);
    bool wrong = tr_bar_wrong(bar);
    cairo_save(cr);
    tr_pen_rgb(cr, tr_palette_diverging(bar->value < 0 ? -0.75 : 0.75));
    cairo_rectangle(cr, left, box.y, fabs(end - zero), box.h);
    if (wrong) {
        cairo_clip(cr);
        for (int k = (int)floor(left / 8) - 5; 8 * k < left + fabs(end - zero); k++) {
            cairo_move_to(cr, 8 * k, box.y + 40);
            cairo_line_to(cr, 8 * k + 40, box.y);
        }
        cairo_set_line_width(cr, 2.5);
        cairo_stroke(cr);
    } else {
        cairo_fill(cr);
    }
    cairo_restore(cr);
    tr_pen_hue(cr, TR_INK);
    tr_pen_line(cr, (tr_point){zero, box.y - 1}, (tr_point){zero, box.y + box.h + 1}, 2);
}

void tr_bar_draw(cairo_t *cr, tr_box box, const tr_bar *bar) {
    char number[32], text[48];
    bool beside = box.w >= 190;
    double size = beside ? fmin(0.78 * box.h, 22) : fmin(0.58 * box.h, 20), mark = 0.9 * size;
    /* where room is short, crosses only */
    bool verdict = !isnan(bar->expected) && (box.w > 80 || tr_bar_wrong(bar));
    double value = beside ? (bar->with_unit ? 6 : 3.6) * size : box.w, room = box.w - (verdict ? 1.1 * mark : 0);
    tr_box strip = beside ? (tr_box){box.x, box.y + 3, box.w - value - (bar->told ? 1.3 * mark : 0), box.h - 6}
                          : (tr_box){box.x, box.y + 0.72 * box.h, box.w, 0.2 * box.h};
    draw_strip(cr, strip, bar);
    tr_frame_number(number, sizeof number, bar->value, bar->unit, true);
    snprintf(text, sizeof text, "%s%s%s", number, bar->with_unit ? " " : "", bar->with_unit ? bar->unit->name : "");
    tr_text at = {.x = box.x + box.w,
                  .y = box.y + (beside ? 0.76 * box.h : 0.56 * box.h),
                  .size = size,
                  .align = TR_RIGHT,
                  .bold = bar->bold,
                  .room = beside ? value - 4 : room};
    double width = tr_pen_text(cr, at, text), x = beside ? strip.x + strip.w + 0.8 * mark : at.x - width - 0.7 * mark;
    if (verdict) tr_pen_verdict(cr, (tr_point){x, at.y}, size, !tr_bar_wrong(bar));
}

void tr_panel_pair(cairo_t *cr, tr_box box, const tr_show_lane *lane, double range) {
    tr_unit unit = tr_frame_unit(range, "m/s");
    if (lane->n_records == 0) {
        tr_pen_text(cr, (tr_text){.x = box.x, .y = box.y + 20, .size = 20, .hue = TR_FAINT}, "no contact");
        return;
    }
    const tr_record *r = lane->record;
    bool row = box.h < 40;
    for (int k = 0; k < 2; k++) {
        double w = row ? box.w / 2 - 8 : box.w, h = row ? box.h : box.h / 2;
        tr_box at = {box.x + (row ? k * (w + 16) : 0), box.y + (row ? 0 : k * h), w, h};
        tr_pen_text(cr, (tr_text){.x = at.x, .y = at.y + 0.76 * h, .size = 20, .bold = true}, k ? "V_r" : "V_s");
        tr_bar bar = {.value = k ? r->v_r_by[0] : r->v_s_by[0],
                      .expected = tr_show_expected(lane, r, k),
                      .range = range,
                      .unit = &unit,
                      .with_unit = true,
                      .told = lane->n_expect > 0};
        tr_bar_draw(cr, (tr_box){at.x + 38, at.y, w - 38, h}, &bar);
    }
}
