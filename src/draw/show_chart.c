/* SPDX-License-Identifier: MIT */
/* Curves over time: their names with the values now, axes over the whole film, and where the closed form says that
 * something happens. A lane is told by the shape along its curves; a colour is what the curve means, and a second
 * curve is dashed. In class view axes have no numbers but their ends. */

#include "draw/show_chart.h"

#include "draw/say.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* A disk, then polygons. */
void tr_lane_marker(cairo_t *cr, tr_point at, double size, int lane) {
    static const int corners[] = {0, 4, 3, 4, 3, 6};
    static const double first[] = {0, M_PI / 4, M_PI / 2, 0, -M_PI / 2, 0};
    int n = corners[lane % 6];
    if (n == 0) tr_pen_add_disk(cr, at, 0.85 * size);
    for (int k = 0; k < n; k++) {
        double angle = first[lane % 6] + 2 * M_PI * k / n;
        cairo_line_to(cr, at.x + size * cos(angle), at.y - size * sin(angle));
    }
    if (n) cairo_close_path(cr);
    cairo_fill(cr);
}

typedef struct tr_axes {
    cairo_t *cr;
    const tr_show *show;
    tr_box plot;
    double end, bottom, top; /* of time and of the values */
    tr_unit unit;
} tr_axes;

static tr_point at_value(const tr_axes *a, double time, double value) {
    return (tr_point){a->plot.x + a->plot.w * time / a->end,
                      a->plot.y + a->plot.h * (a->top - value) / (a->top - a->bottom)};
}

static void choose_dash(cairo_t *cr, int curve) {
    static const double dashes[] = {9, 6};
    cairo_set_dash(cr, dashes, curve ? 2 : 0, 0);
}

static unsigned hue_of(const tr_axes *a, int curve) {
    unsigned hue = a->show->chart->hue[curve];
    return hue ? hue : TR_INK;
}

/* A class reads words in the place of symbols. */
static const char *name_of(const tr_axes *a, int curve) {
    static const struct {
        const char *name;
        tr_word_key word;
        bool symbol;
    } known[] = {{"V_s", TR_WORD_slides, true},
                 {"V_r", TR_WORD_rolls, true},
                 {"speed", TR_WORD_speed, false},
                 {"spin", TR_WORD_spin_rate, false},
                 {"creepage", TR_WORD_creepage, false}};
    const char *name = a->show->chart->name[curve];
    for (int i = 0; i < 5; i++)
        if (strcmp(name, known[i].name) == 0 && !(known[i].symbol && a->show->expert))
            return tr_say(a->cr, known[i].word);
    return name;
}

/* Name of a curve and how it is drawn; returns where it ends. */
static double draw_name(const tr_axes *a, double x, double y, int curve) {
    const char *name = name_of(a, curve);
    tr_pen_hue(a->cr, hue_of(a, curve));
    choose_dash(a->cr, curve);
    tr_pen_line(a->cr, (tr_point){x, y - 7}, (tr_point){x + 40, y - 7}, 4);
    choose_dash(a->cr, 0);
    return x + 48 +
           tr_pen_text(a->cr, (tr_text){.x = x + 48, .y = y, .size = 24, .bold = true, .hue = hue_of(a, curve)}, name) +
           24;
}

static void draw_lane_name(const tr_axes *a, tr_box box, int lane) {
    const tr_chart *chart = a->show->chart;
    const double *value = chart->value[lane][0];
    double y = box.y + 0.78 * box.h, room = box.w - 28;
    tr_pen_hue(a->cr, TR_INK);
    tr_lane_marker(a->cr, (tr_point){box.x + 10, y - 7}, 9, lane);
    if (value && chart->n > 0 && !chart->name[1]) {
        char number[32];
        tr_frame_number(number, sizeof number, value[chart->n - 1], &a->unit, false);
        tr_text at = {.x = box.x + box.w, .y = y, .size = 20, .align = TR_RIGHT, .room = 0.4 * room};
        room -= tr_pen_text(a->cr, at, number) + 12;
    }
    const char *label = a->show->lane[lane].label;
    tr_pen_text(a->cr, (tr_text){.x = box.x + 28, .y = y, .size = 20, .bold = true, .room = room}, label ? label : "");
}

/* Round steps of about that part of a length; decimals that show one in this unit. */
static double round_step(double length, double part, tr_unit *unit) {
    double step = tr_frame_round_up(part * length);
    unit->decimals = (int)fmax(0, ceil(-log10(step / unit->size) - 1e-9));
    return step;
}

/* Zero, the top, and the end of the time: so large that they are read from afar. */
static void draw_plain_axes(tr_axes *a) {
    cairo_t *cr = a->cr;
    const tr_box p = a->plot;
    tr_unit time = tr_frame_unit(a->end, "s"), value = a->unit;
    char number[32], label[64];
    double top = tr_frame_round_down(fmax(a->top, 1e-100)), zero = at_value(a, 0, 0).y;
    if (!(zero <= p.y + p.h + 1) || !(zero >= p.y - 1)) zero = p.y + p.h;
    tr_pen_hue(cr, TR_RIM);
    tr_pen_line(cr, (tr_point){p.x, zero}, (tr_point){p.x + p.w, zero}, 2);
    tr_pen_hue(cr, TR_INK);
    tr_pen_line(cr, (tr_point){p.x, p.y}, (tr_point){p.x, p.y + p.h}, 2);
    tr_text at = {.x = p.x - 8, .y = zero + 9, .size = 24, .align = TR_RIGHT};
    tr_pen_text(cr, at, "0");
    if (top > 0.2 * (a->top - a->bottom)) {
        round_step(top, 1, &value);
        at.y = at_value(a, 0, top).y + 9;
        tr_frame_number(number, sizeof number, top, &value, false);
        if (at.y < zero - 18) tr_pen_text(cr, at, number);
    }
    round_step(tr_frame_round_down(a->end), 0.1, &time);
    tr_frame_number(number, sizeof number, a->end, &time, false);
    snprintf(label, sizeof label, "%s %s", number, time.name);
    at.x = p.x + p.w, at.y = p.y + p.h + 28;
    tr_pen_text(cr, at, label);
    at.x = p.x, at.align = TR_LEFT;
    tr_pen_text(cr, at, TR_SAY(cr, time));
}

static void draw_axes(tr_axes *a) {
    cairo_t *cr = a->cr;
    const tr_box p = a->plot;
    tr_unit time = tr_frame_unit(a->end, "s"), value = a->unit;
    char number[32], label[64];
    double step = round_step(a->top - a->bottom, a->plot.h < 200 ? 0.3 : 0.2, &value);
    double first = ceil(a->bottom / step - 1e-9), last = floor(a->top / step + 1e-9);
    for (int k = 0; k <= (int)(last - first); k++) {
        double v = step * (first + k);
        tr_point q = at_value(a, 0, v);
        tr_pen_hue(cr, first + k == 0 ? TR_RIM : TR_DISK);
        tr_pen_line(cr, q, (tr_point){p.x + p.w, q.y}, 2);
        tr_frame_number(number, sizeof number, v, &value, false);
        tr_pen_text(cr, (tr_text){.x = p.x - 8, .y = q.y + 6, .size = 18, .align = TR_RIGHT, .room = 60}, number);
    }
    tr_pen_hue(cr, TR_INK);
    tr_pen_line(cr, (tr_point){p.x, p.y}, (tr_point){p.x, p.y + p.h}, 2);
    tr_pen_line(cr, (tr_point){p.x, p.y + p.h}, (tr_point){p.x + p.w, p.y + p.h}, 2);
    tr_text at = {.x = p.x + p.w, .y = p.y + p.h + 24, .size = 18, .align = TR_RIGHT};
    snprintf(label, sizeof label, "t [%s]", time.name);
    double free = p.x + p.w - tr_pen_text(cr, at, label) - 24;
    step = round_step(a->end, 0.16, &time);
    for (int k = 0; k <= (int)(a->end / step + 1e-9); k++) {
        tr_point q = at_value(a, k * step, a->bottom);
        tr_pen_hue(cr, TR_INK);
        tr_pen_line(cr, q, (tr_point){q.x, q.y + 6}, 2);
        at.x = q.x, at.align = TR_CENTRE;
        tr_frame_number(number, sizeof number, k * step, &time, false);
        if (q.x < free) tr_pen_text(cr, at, number);
    }
}

static void draw_mark(const tr_axes *a, double x, double top, double bottom) {
    static const double dashes[] = {5, 5};
    tr_pen_hue(a->cr, TR_FAINT);
    cairo_set_dash(a->cr, dashes, 2, 0);
    tr_pen_line(a->cr, (tr_point){x, top}, (tr_point){x, bottom}, 2.5);
    cairo_set_dash(a->cr, NULL, 0, 0);
}

/* The meaning of the marks is beside a single mark; for many lanes it follows the names of the curves, at (x, y). */
static void draw_marks(const tr_axes *a, double x, double y) {
    const int n = a->show->n_lanes;
    int marks = 0;
    for (int i = 0; i < n; i++) {
        double mark = a->show->chart->mark[i];
        if (!(mark >= 0 && mark <= a->end)) continue;
        double at = at_value(a, mark, a->top).x;
        draw_mark(a, at, a->plot.y, a->plot.y + a->plot.h);
        if (n > 1) tr_lane_marker(a->cr, (tr_point){at, a->plot.y + 6 + 16 * (i % 3)}, 7, i);
        if (n == 1) x = at, y = a->plot.y + 16;
        marks++;
    }
    if (marks == 0) return;
    bool left = n == 1 && x > a->plot.x + 0.75 * a->plot.w;
    if (n > 1) draw_mark(a, x, y - 18, y + 4);
    tr_pen_text(
        a->cr,
        (tr_text){.x = x + (left ? -8 : 8), .y = y, .size = 24, .halo = true, .align = left ? TR_RIGHT : TR_LEFT},
        TR_SAY(a->cr, theory));
}

/* Along the curve, where those of other lanes are not: at each 1/6 of the time, a little later for each lane. */
static void draw_markers(const tr_axes *a, int lane, const double *value) {
    const tr_chart *chart = a->show->chart;
    int next = 0;
    for (int i = 0; i < chart->n; i++) {
        double due = a->end * (next + (lane + 1.0) / (a->show->n_lanes + 1.0)) / 6;
        if (!(chart->time[i] >= due)) continue;
        tr_point p = at_value(a, chart->time[i], value[i]);
        next = (int)(6 * chart->time[i] / a->end) + 1;
        if (!tr_frame_seen(p, 1) || p.y < a->plot.y - 2 || p.y > a->plot.y + a->plot.h + 2) continue;
        tr_pen_hue(a->cr, TR_WHITE);
        tr_lane_marker(a->cr, p, 9, lane);
        tr_pen_hue(a->cr, TR_INK);
        tr_lane_marker(a->cr, p, 6.5, lane);
    }
}

static void draw_curve(const tr_axes *a, int lane, int curve) {
    const tr_chart *chart = a->show->chart;
    const double *value = chart->value[lane][curve];
    tr_point last = {NAN, NAN};
    if (!value || !chart->time) return;
    cairo_save(a->cr);
    cairo_rectangle(a->cr, a->plot.x, a->plot.y - 2, a->plot.w, a->plot.h + 4);
    cairo_clip(a->cr);
    for (int i = 0; i < chart->n; i++) {
        tr_point p = at_value(a, chart->time[i], value[i]);
        bool seen = tr_frame_seen(p, 1);
        if (!seen)
            cairo_new_sub_path(a->cr);
        else
            cairo_line_to(a->cr, p.x, p.y), last = p;
    }
    tr_pen_hue(a->cr, hue_of(a, curve));
    cairo_set_line_width(a->cr, 3.5);
    cairo_set_line_join(a->cr, CAIRO_LINE_JOIN_BEVEL);
    choose_dash(a->cr, curve);
    cairo_stroke(a->cr);
    choose_dash(a->cr, 0);
    cairo_set_line_join(a->cr, CAIRO_LINE_JOIN_MITER);
    cairo_restore(a->cr);
    bool inside = last.x >= a->plot.x && last.x <= a->plot.x + a->plot.w + 1 && last.y >= a->plot.y - 2 &&
                  last.y <= a->plot.y + a->plot.h + 2;
    if (a->show->n_lanes > 1) draw_markers(a, lane, value);
    tr_pen_hue(a->cr, hue_of(a, curve));
    if (inside) tr_lane_marker(a->cr, last, 8, a->show->n_lanes == 1 ? curve : lane);
}

void tr_show_chart(cairo_t *cr, tr_box box, const tr_show *show) {
    const tr_chart *chart = show->chart;
    const double row = 28;
    tr_axes a = {.cr = cr, .show = show, .end = show->time_end, .bottom = chart->bottom, .top = chart->top};
    double rise = a.top - a.bottom;
    if (!(rise > 1e-12 * fabs(a.top)) || !(rise > 1e-100) || !(fabs(a.top) < 1e100 && fabs(a.bottom) < 1e100)) {
        double middle = fabs(a.top) < 1e100 ? a.top : 0, half = fmax(0.5 * fabs(middle), 1e-3);
        a.top = middle + half, a.bottom = middle - half;
    }
    if (!(a.end > 1e-100 && a.end < 1e100)) a.end = 1;
    bool number = chart->unit && chart->unit[0] == '1';
    a.unit = (tr_unit){.size = 1, .decimals = 3};
    if (!number) a.unit = tr_frame_unit(fmax(fabs(a.top), fabs(a.bottom)), chart->unit ? chart->unit : "");
    double x = box.x, y = box.y;
    for (int k = 0; k < 2; k++)
        if (chart->name[k]) x = draw_name(&a, x, y + 20, k);
    char text[24];
    snprintf(text, sizeof text, "[%s]", a.unit.name);
    if (!number)
        tr_pen_text(cr, (tr_text){.x = box.x + box.w, .y = y + 20, .size = 24, .align = TR_RIGHT, .hue = TR_FAINT},
                    text);
    y += row;
    for (int i = 0; i < show->n_lanes && show->n_lanes > 1 && show->expert;
         i++, y += row) /* a class has them in the cells */
        draw_lane_name(&a, (tr_box){box.x, y, box.w, row}, i);
    a.plot = (tr_box){box.x + 68, y + 10, box.w - 80, box.y + box.h - 34 - y - 10};
    if (!(a.plot.h > 40)) return;
    if (show->expert)
        draw_axes(&a);
    else
        draw_plain_axes(&a);
    draw_marks(&a, x, box.y + 20);
    for (int i = 0; i < show->n_lanes; i++)
        for (int k = 0; k < 2; k++) draw_curve(&a, i, k);
}
