/* SPDX-License-Identifier: MIT */
#include "draw/show_bar.h"

#include "draw/show.h"

#include <math.h>
#include <stdio.h>

static void draw_strip(cairo_t *cr, tr_box box, const tr_bar *bar) {
    double zero = box.x + box.w / 2, u = bar->value / bar->range;
    double end = zero + box.w / 2 * fmin(fmax(isfinite(u) ? u : 0, -1), 1), left = fmin(zero, end);
    tr_pen_hue(cr, 0xF3F4F6);
    cairo_rectangle(cr, box.x, box.y, box.w, box.h);
    cairo_fill(cr);
    cairo_save(cr);
    tr_pen_hue(cr, bar->hue);
    cairo_rectangle(cr, left, box.y, fabs(end - zero), box.h);
    if (bar->differs) {
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
    double size = beside ? fmin(0.78 * box.h, 28) : fmin(0.58 * box.h, 20);
    double value = bar->unit ? (beside ? (bar->with_unit ? 6.2 : 3.6) * size : box.w) : 0;
    tr_box strip = beside || !bar->unit ? (tr_box){box.x, box.y + 3, box.w - value, box.h - 6}
                                        : (tr_box){box.x, box.y + 0.72 * box.h, box.w, 0.2 * box.h};
    draw_strip(cr, strip, bar);
    if (!bar->unit) return;
    tr_frame_number(number, sizeof number, bar->size_only ? fabs(bar->value) : bar->value, bar->unit, !bar->size_only);
    snprintf(text, sizeof text, "%s%s%s", number, bar->with_unit ? " " : "", bar->with_unit ? bar->unit->name : "");
    tr_text at = {.x = box.x + box.w,
                  .y = box.y + (beside ? 0.5 * box.h + 0.36 * size : 0.56 * box.h),
                  .size = size,
                  .align = TR_RIGHT,
                  .bold = bar->bold,
                  .room = beside ? value - 4 : box.w};
    tr_pen_text(cr, at, text);
}
