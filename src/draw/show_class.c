/* SPDX-License-Identifier: MIT */
#include "draw/show_class.h"

#include "draw/show.h"
#include "draw/show_bar.h"
#include "draw/show_lamp.h"
#include "draw/say.h"
#include "scene/contact_name.h"

#include <math.h>
#include <stdio.h>

static const double bar_h = 34, lamp_h = 48, slid_h = 36, line_h = 32;

static void draw_none(cairo_t *cr, tr_box box, const tr_show_lane *lane) {
    char text[64 + TR_CONTACT_NAME];
    int used = snprintf(text, 64, "%s ", TR_SAY(cr, no_contact));
    if (lane->contact.a != lane->contact.b) tr_contact_name_write(lane->contact, text + used);
    tr_pen_text(cr, (tr_text){.x = box.x, .y = box.y + 32, .size = 28, .hue = TR_FAINT, .room = box.w}, text);
}

/* "slides" and "rolls", each in its colour. unit NULL: without numbers. Returns their height. */
static double draw_bars(cairo_t *cr, tr_box box, const tr_show_lane *lane, const tr_record *r, double range,
                        const tr_unit *unit) {
    const tr_text slides = {.size = TR_CLASS_TYPE, .bold = true, .hue = TR_SLIDES}, rolls = slides;
    double label = 14 + fmax(tr_pen_width(cr, slides, TR_SAY(cr, slides)), tr_pen_width(cr, rolls, TR_SAY(cr, rolls)));
    for (int k = 0; k < 2; k++) {
        tr_text at = slides;
        at.x = box.x, at.y = box.y + k * bar_h + 26, at.hue = k ? TR_ROLLS : TR_SLIDES;
        tr_pen_text(cr, at, k ? TR_SAY(cr, rolls) : TR_SAY(cr, slides));
        tr_bar bar = {.value = k ? tr_lamp_rolling(lane->world, r) : r->v_s_by[0], .range = range, .hue = at.hue};
        bar.size_only = true, bar.unit = unit, bar.bold = bar.with_unit = true;
        tr_bar_draw(cr, (tr_box){box.x + label, box.y + k * bar_h, box.w - label, bar_h}, &bar);
    }
    return 2 * bar_h;
}

static void draw_slid(cairo_t *cr, tr_box box, const tr_record *r) {
    double slid = fabs(r->da + r->db);
    bool none = !(slid >= 1e-4 * r->R2); /* rounding, and springs */
    tr_unit unit = tr_frame_unit(none ? r->R2 : slid, "m");
    if (none) slid = unit.decimals = 0;
    char number[32], text[48];
    tr_frame_number(number, sizeof number, slid, &unit, false);
    snprintf(text, sizeof text, "%s %s", number, unit.name);
    tr_text at = {.x = box.x, .y = box.y + 26, .size = TR_CLASS_TYPE, .bold = true, .hue = TR_SLIDES};
    tr_pen_text(cr, at, TR_SAY(cr, slid));
    at.x += box.w, at.align = TR_RIGHT, at.size = 28;
    tr_pen_text(cr, at, text);
}

/* "0 – 1", "wall – 0" */
static double draw_name(cairo_t *cr, tr_box box, const tr_record *r) {
    char name[64];
    if (r->a < 0)
        snprintf(name, sizeof name, "%s – %d", TR_SAY(cr, wall), r->b);
    else
        snprintf(name, sizeof name, "%d – %d", r->a, r->b);
    return tr_pen_text(cr, (tr_text){.x = box.x, .y = box.y + 34, .size = TR_CLASS_TYPE, .bold = true}, name);
}

double tr_class_panel(cairo_t *cr, tr_box box, const tr_show_lane *lane, double range) {
    int all;
    const tr_record *record = tr_show_records(lane, &all);
    int n = all < TR_SHOW_CONTACTS ? all : TR_SHOW_CONTACTS;
    const double gap = 14, bars = 2 * bar_h + lamp_h + 6;
    if (n == 0) return draw_none(cr, box, lane), fmin(44, box.h);
    bool slid = n <= TR_CLASS_NUMBERS && n * (bars + slid_h + gap) <= box.h;
    if (n == 1 && !slid) box.h = fmax(box.h, bars + gap);
    double each = bars + (slid ? slid_h : 0) + gap;
    if (n * each > box.h) n = (int)(box.h / each);
    tr_unit unit = tr_frame_unit(range, "m/s");
    for (int i = 0; i < n; i++) {
        const tr_record *r = &record[i];
        tr_box at = {box.x, box.y + i * each, box.w, lamp_h};
        double name = all > 1 ? fmax(draw_name(cr, at, r) + 16, 0.3 * box.w) : 0;
        tr_lamp_draw(cr, (tr_box){at.x + name, at.y + 1, at.w - name - 1, lamp_h - 2},
                     tr_lamp_of(lane->world, r, range));
        at.y += lamp_h + 6;
        at.y += draw_bars(cr, at, lane, r, range, all == 1 ? &unit : NULL);
        if (slid) draw_slid(cr, at, r);
    }
    return n * each;
}

void tr_class_pair(cairo_t *cr, tr_box box, const tr_show_lane *lane, double range) {
    int n;
    const tr_record *record = tr_show_records(lane, &n);
    if (n == 0) {
        draw_none(cr, box, lane);
        return;
    }
    bool row = box.h < TR_CLASS_PAIR_H - 2;
    double lamp = row ? fmin(0.3 * box.w, 170) : fmin(box.w, 190);
    tr_lamp_draw(cr, (tr_box){box.x, box.y, lamp, row ? box.h : 30}, tr_lamp_of(lane->world, record, range));
    if (row) {
        double w = (box.w - lamp - 32) / 2;
        for (int k = 0; k < 2; k++) {
            tr_bar bar = {.range = range, .hue = k ? TR_ROLLS : TR_SLIDES};
            bar.value = k ? tr_lamp_rolling(lane->world, record) : record->v_s_by[0];
            tr_text at = {
                .x = box.x + lamp + 16 + k * (w + 16), .y = box.y + 24, .size = 24, .bold = true, .hue = bar.hue};
            double label = tr_pen_text(cr, at, k ? TR_SAY(cr, rolls) : TR_SAY(cr, slides)) + 10;
            tr_bar_draw(cr, (tr_box){at.x + label, box.y, w - label, box.h}, &bar);
        }
        return;
    }
    draw_bars(cr, (tr_box){box.x, box.y + 30, box.w, 0}, lane, record, range, NULL);
}

/* The checks that fail; of those that do not fit one line tells. Without one that fails a line for all. */
static int lines_of(const tr_show_check *check, int n) {
    int failed = 0;
    for (int i = 0; i < n; i++) failed += !check[i].ok;
    return n == 0 ? 0 : failed == 0 ? 1 : failed < 4 ? failed : 4;
}

double tr_class_checks_height(const tr_show_check *check, int n) {
    return n > 0 ? lines_of(check, n) * line_h + 12 : 0;
}

static void draw_verdict(cairo_t *cr, tr_box box, int line, bool ok, const char *text) {
    double y = box.y + line * line_h + 24;
    tr_pen_verdict(cr, (tr_point){box.x + 9, y}, 22, ok);
    tr_pen_text(cr, (tr_text){.x = box.x + 28, .y = y, .size = TR_CLASS_TYPE, .room = box.w - 28}, text);
}

void tr_class_checks(cairo_t *cr, tr_box box, const tr_show_check *check, int n) {
    int lines = lines_of(check, n), line = 0;
    for (int i = 0; i < n && line < lines; i++) {
        if (check[i].ok) continue;
        char text[160];
        tr_words_fill(text, sizeof text, TR_SAY(cr, not_exact), check[i].what, "");
        draw_verdict(cr, box, line++, false, text);
    }
    if (line == 0 && n > 0) draw_verdict(cr, box, 0, true, TR_SAY(cr, agrees_with_exact));
}

void tr_class_time(cairo_t *cr, double time, double time_end) {
    double y = TR_EDGE + 28,
           label =
               tr_pen_text(cr, (tr_text){.x = TR_PANEL_X, .y = y, .size = 26, .hue = TR_FAINT}, TR_SAY(cr, time)) + 16;
    double w = TR_PANEL_W - label, part = time / time_end;
    tr_pen_hue(cr, TR_DISK);
    cairo_rectangle(cr, TR_PANEL_X + label, y - 14, w, 10);
    cairo_fill(cr);
    tr_pen_hue(cr, TR_FAINT);
    cairo_rectangle(cr, TR_PANEL_X + label, y - 14, w * (part > 0 ? fmin(part, 1) : 0), 10);
    cairo_fill(cr);
}
