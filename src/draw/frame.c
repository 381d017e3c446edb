/* SPDX-License-Identifier: MIT */
/* What all frames share: see frame.h. */
#include "draw/frame.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* 1, 2, 5, 10, 20, ... for k = 0, 1, 2, ...; also below 1. */
static double round_number(int k) {
    static const double digit[] = {1, 2, 5};
    int decade = (int)floor(k / 3.0);
    return digit[k - 3 * decade] * pow(10, decade);
}

/* Largest round number <= x, for x > 0. */
static double round_down(double x) {
    int k = 3 * (int)floor(log10(x)) + 3;
    while (round_number(k) > x * (1 + 1e-9)) k--;
    return round_number(k);
}

static double round_up(double x) {
    int k = 3 * (int)floor(log10(x));
    while (round_number(k) < x * (1 - 1e-9)) k++;
    return round_number(k);
}

static double speed_of(const tr_record *r, tr_color color) {
    return fabs(color == TR_COLOR_SLIDING ? r->v_s : r->v_r);
}

double tr_frame_range(const tr_record *record, int n, tr_color color) {
    if (color == TR_COLOR_MOBILISATION) return 1;
    double max = 0;
    for (int i = 0; i < n; i++)
        if (isfinite(speed_of(&record[i], color))) max = fmax(max, speed_of(&record[i], color));
    if (!(max > 1e-100)) return 1;
    for (double range = round_up(max);;) { /* ends: below the smallest speed nothing is covered */
        double next = round_down(0.9 * range);
        int above = 0;
        for (int i = 0; i < n; i++) above += speed_of(&record[i], color) > next;
        if (above > 0.05 * n || next < 1e-6 * max) return range;
        range = next;
    }
}

double tr_frame_range_bodies(const tr_world *world, const tr_record *record, int n) {
    double max = 0;
    for (int i = 0; i < world->disks.n; i++) {
        const double *v = world->disks.vel + 4 * i;
        max = fmax(max, fmax(hypot(v[0], v[1]), fabs(v[2]) * world->disks.pos[4 * i + 3]));
    }
    for (int i = 0; i < n; i++) max = fmax(max, fmax(fabs(record[i].v_s), fabs(record[i].v_r)));
    /* Bars are cut at the range: a hundredth over it, as a dashpot's last flutter gives, must not halve them all. */
    return max > 1e-100 && isfinite(max) ? round_up(0.98 * max) : 1;
}

tr_unit tr_frame_unit(double largest, const char *si_unit) {
    static const char *const prefix[] = {"n", "µ", "m", "", "k", "M", "G"};
    tr_unit unit = {.size = 1e-9};
    int i = 0;
    if (!(fabs(largest) > 0) || !isfinite(largest)) largest = 1;
    largest = fabs(largest) * (1 + 1e-9);
    for (; i < 6 && largest >= 1000 * unit.size; i++) unit.size *= 1000;
    unit.size = pow(10, 3 * i - 9); /* exact, unlike the product */
    double top = largest / unit.size;
    unit.decimals = top < 10 ? 2 : top < 100 ? 1 : 0;
    snprintf(unit.name, sizeof unit.name, "%s%s", prefix[i], si_unit);
    return unit;
}

void tr_frame_number(char *text, size_t size, double value, const tr_unit *unit, bool sign) {
    char digits[24];
    snprintf(digits, sizeof digits, "%.*f", unit->decimals, fabs(value / unit->size));
    bool zero = strspn(digits, "0.") == strlen(digits);
    snprintf(text, size, "%s%s", zero ? "" : value < 0 ? "−" : sign ? "+" : "", digits);
}

static void draw_scale_bar(cairo_t *cr, const tr_map *map) {
    double length = round_down(0.22 * map->width / map->scale);
    tr_unit unit = tr_frame_unit(length, "m");
    unit.decimals = 0;
    char number[32], label[48];
    tr_frame_number(number, sizeof number, length, &unit, false);
    snprintf(label, sizeof label, "%s %s", number, unit.name);
    double x = TR_EDGE, y = TR_FRAME_HEIGHT - 32, w = length * map->scale;
    tr_pen_hue(cr, TR_INK);
    tr_pen_line(cr, (tr_point){x, y}, (tr_point){x + w, y}, 5);
    tr_pen_line(cr, (tr_point){x + 1, y - 9}, (tr_point){x + 1, y + 9}, 2);
    tr_pen_line(cr, (tr_point){x + w - 1, y - 9}, (tr_point){x + w - 1, y + 9}, 2);
    tr_pen_text(cr, (tr_text){.x = x + w + 14, .y = y + 8, .size = 24}, label);
}

static double draw_panel(cairo_t *cr, const tr_view *view) {
    const double right = TR_PANEL_X + TR_PANEL_W;
    double y = TR_EDGE + 28;
    tr_unit unit = tr_frame_unit(view->time_end, "s");
    char number[32], time[64];
    unit.decimals++;
    tr_frame_number(number, sizeof number, view->time, &unit, false);
    snprintf(time, sizeof time, "%s %s", number, unit.name);
    double free = TR_PANEL_W;
    free -= tr_pen_text(cr, (tr_text){.x = TR_PANEL_X, .y = y, .size = 26, .hue = TR_FAINT}, "time") + 16;
    tr_pen_text(cr, (tr_text){.x = right, .y = y, .size = 32, .bold = true, .align = TR_RIGHT, .room = free}, time);
    for (int i = 0; i < view->n_lines; i++) {
        const tr_view_line *line = &view->line[i];
        y += 40;
        free = TR_PANEL_W - 16;
        free -= tr_pen_text(
            cr, (tr_text){.x = right, .y = y, .size = 26, .bold = true, .align = TR_RIGHT, .room = 0.6 * free},
            line->value);
        tr_pen_text(cr, (tr_text){.x = TR_PANEL_X, .y = y, .size = 24, .room = free, .hue = TR_FAINT}, line->label);
    }
    return y + 24;
}

tr_map tr_frame_start(cairo_t *cr, const tr_view *view, double *panel_y) {
    tr_pen_hue(cr, TR_WHITE);
    cairo_paint(cr);
    *panel_y = draw_panel(cr, view);
    double top = TR_EDGE, width = TR_PANEL_X - 40 - TR_EDGE;
    if (view->title) {
        tr_pen_text(cr, (tr_text){.x = TR_EDGE, .y = top + 28, .size = 34, .bold = true, .room = width}, view->title);
        top += 52;
    }
    double height = TR_FRAME_HEIGHT - 64 - top, box_w = view->x1 - view->x0, box_h = view->y1 - view->y0;
    double scale = fmin(width / box_w, height / box_h);
    if (!(box_w > 0 && box_h > 0) || !isfinite(scale) || !(scale > 0)) return (tr_map){0};
    tr_map map = {.scale = scale, .width = box_w * scale, .height = box_h * scale};
    map.left = TR_EDGE + (width - map.width) / 2;
    map.top = top + (height - map.height) / 2;
    map.x = map.left - scale * view->x0;
    map.y = map.top + scale * view->y1;
    draw_scale_bar(cr, &map);
    return map;
}

tr_point tr_frame_point(const tr_map *map, double x, double y) {
    return (tr_point){map->x + map->scale * x, map->y - map->scale * y};
}

bool tr_frame_seen(tr_point p, double radius) {
    return fabs(p.x) < 1e4 && fabs(p.y) < 1e4 && radius > 0 && radius < 1e4;
}
