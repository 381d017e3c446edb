/* SPDX-License-Identifier: MIT */
#include "draw/show_lamp.h"

#include "draw/say.h"

#include <math.h>

double tr_lamp_rolling(const tr_world *world, const tr_record *r) {
    return r->v_r_by[world->rolling_velocity];
}

tr_lamp tr_lamp_of(const tr_world *world, const tr_record *r, double range) {
    bool slides = fabs(r->v_s_by[0]) > 0.01 * range, rolls = fabs(tr_lamp_rolling(world, r)) > 0.01 * range;
    return (tr_lamp)(TR_LAMP_SLIDES * slides + TR_LAMP_ROLLS * rolls);
}

void tr_lamp_draw(cairo_t *cr, tr_box box, tr_lamp lamp) {
    static const tr_word_key word[] = {TR_WORD_lamp_neither, TR_WORD_lamp_slides, TR_WORD_lamp_rolls,
                                       TR_WORD_lamp_both};
    const double slides = lamp == TR_LAMP_BOTH ? nearbyint(box.w / 2) : lamp == TR_LAMP_SLIDES ? box.w : 0;
    tr_pen_hue(cr, TR_SLIDES); /* of BOTH the left half */
    cairo_rectangle(cr, box.x, box.y, slides, box.h);
    cairo_fill(cr);
    tr_pen_hue(cr, lamp == TR_LAMP_NEITHER ? TR_WHITE : TR_ROLLS);
    cairo_rectangle(cr, box.x + slides, box.y, box.w - slides, box.h);
    cairo_fill(cr);
    tr_pen_hue(cr, TR_INK);
    cairo_rectangle(cr, box.x, box.y, box.w, box.h);
    cairo_set_line_width(cr, 2);
    cairo_stroke(cr);
    double size = fmax(0.62 * box.h, 24);
    tr_text at = {.x = box.x + box.w / 2, .y = box.y + box.h / 2 + 0.36 * size, .size = size, .align = TR_CENTRE};
    at.bold = true, at.room = box.w - 8;
    if (lamp != TR_LAMP_NEITHER) at.hue = TR_WHITE;
    tr_pen_text(cr, at, tr_say(cr, word[lamp]));
}

void tr_lamp_dot(cairo_t *cr, tr_point at, double radius, tr_lamp lamp) {
    tr_pen_hue(cr, TR_WHITE);
    tr_pen_dot(cr, at, radius);
    tr_pen_hue(cr, lamp == TR_LAMP_NEITHER ? TR_INK : lamp == TR_LAMP_ROLLS ? TR_ROLLS : TR_SLIDES);
    tr_pen_dot(cr, at, 0.7 * radius);
    if (lamp != TR_LAMP_BOTH) return;
    tr_pen_hue(cr, TR_ROLLS);
    cairo_arc(cr, at.x, at.y, 0.7 * radius, -M_PI / 2, M_PI / 2);
    cairo_fill(cr);
}
