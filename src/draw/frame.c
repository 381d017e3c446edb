/* SPDX-License-Identifier: MIT */
/* What all frames share: see frame.h. */
#include "draw/frame.h"

#include "draw/say.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* 1, 2, 5, 10, 20, ... for k = 0, 1, 2, ...; also below 1. */
static double round_number(int k) {
    static const double digit[] = {1, 2, 5};
    int decade = (int)floor(k / 3.0);
    return digit[k - 3 * decade] * pow(10, decade);
}

double tr_frame_round_down(double x) {
    int k = 3 * (int)floor(log10(x)) + 3;
    while (round_number(k) > x * (1 + 1e-9)) k--;
    return round_number(k);
}

double tr_frame_round_up(double x) {
    int k = 3 * (int)floor(log10(x));
    while (round_number(k) < x * (1 - 1e-9)) k++;
    return round_number(k);
}

tr_unit tr_frame_unit(double largest, const char *si_unit) {
    static const char *const prefix[] = {"p", "n", "µ", "m", "", "k", "M", "G"};
    tr_unit unit = {.size = 1e-12};
    int i = 0;
    if (!(fabs(largest) > 0) || !isfinite(largest)) largest = 1;
    largest = fabs(largest) * (1 + 1e-9);
    for (; i < 7 && largest >= 1000 * unit.size; i++) unit.size *= 1000;
    unit.size = pow(10, 3 * i - 12); /* exact, unlike the product */
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

double tr_frame_scale_bar(cairo_t *cr, double scale, double base) {
    double length = tr_frame_round_down(0.22 * TR_PICTURE_W / scale);
    tr_unit unit = tr_frame_unit(length, "m");
    unit.decimals = 0;
    char number[32], label[48];
    tr_frame_number(number, sizeof number, length, &unit, false);
    snprintf(label, sizeof label, "%s %s", number, unit.name);
    double x = TR_EDGE, y = base - 8, w = length * scale;
    tr_pen_hue(cr, TR_INK);
    tr_pen_line(cr, (tr_point){x, y}, (tr_point){x + w, y}, 5);
    tr_pen_line(cr, (tr_point){x + 1, y - 9}, (tr_point){x + 1, y + 9}, 2);
    tr_pen_line(cr, (tr_point){x + w - 1, y - 9}, (tr_point){x + w - 1, y + 9}, 2);
    return x + w + 14 + tr_pen_text(cr, (tr_text){.x = x + w + 14, .y = base, .size = 24}, label);
}

double tr_frame_head(cairo_t *cr, const tr_head *head) {
    const double right = TR_PANEL_X + TR_PANEL_W;
    double y = TR_EDGE + 28, free = TR_PANEL_W;
    tr_pen_hue(cr, TR_WHITE);
    cairo_paint(cr);
    if (head->title)
        tr_pen_text(cr, (tr_text){.x = TR_EDGE, .y = y, .size = 34, .bold = true, .room = TR_PICTURE_W}, head->title);
    free -= tr_pen_text(cr, (tr_text){.x = TR_PANEL_X, .y = y, .size = 26, .hue = TR_FAINT}, head->label) + 16;
    tr_pen_text(cr, (tr_text){.x = right, .y = y, .size = 32, .bold = true, .align = TR_RIGHT, .room = free},
                head->value);
    for (int i = 0; i < head->n_lines; i++) {
        const tr_view_line *line = &head->line[i];
        y += 40;
        free = TR_PANEL_W - 16;
        free -= tr_pen_text(
            cr, (tr_text){.x = right, .y = y, .size = 26, .bold = true, .align = TR_RIGHT, .room = 0.6 * free},
            line->value);
        tr_pen_text(cr, (tr_text){.x = TR_PANEL_X, .y = y, .size = 24, .room = free, .hue = TR_FAINT}, line->label);
    }
    return y + 24;
}

tr_ramp tr_frame_ramp(tr_color color) {
    return color == TR_COLOR_ROLLING                             ? TR_RAMP_ROLLING
           : color == TR_COLOR_SLIDING || color == TR_COLOR_SLIP ? TR_RAMP_SLIDING
                                                                 : TR_RAMP_PLAIN;
}

void tr_frame_color_bar(cairo_t *cr, const tr_scale *scale, double y) {
    tr_unit shown = *scale->unit;
    double range = scale->range, low = scale->diverging ? -range : 0, middle = range / 2 / shown.size;
    static const tr_word_key motion[] = {TR_WORD_slides, TR_WORD_both, TR_WORD_rolls};
    char label[96], number[32];
    snprintf(label, sizeof label, "%s%s%s%s", scale->name, *shown.name ? "  [" : "", shown.name,
             *shown.name ? "]" : "");
    tr_pen_text(cr, (tr_text){.x = TR_PANEL_X, .y = y, .size = 24, .room = TR_PANEL_W}, label);
    cairo_pattern_t *ramp = cairo_pattern_create_linear(TR_PANEL_X, 0, TR_PANEL_X + TR_PANEL_W, 0);
    for (int i = 0; i <= 40; i++) {
        tr_rgb c = scale->motion      ? tr_palette_motion(i / 20.0 - 1)
                   : scale->diverging ? tr_palette_diverging(i / 20.0 - 1)
                                      : tr_palette_ramp(scale->ramp, i / 40.0);
        cairo_pattern_add_color_stop_rgb(ramp, i / 40.0, c.r, c.g, c.b);
    }
    cairo_rectangle(cr, TR_PANEL_X, y + 16, TR_PANEL_W, 28);
    cairo_set_source(cr, ramp);
    cairo_fill(cr);
    cairo_pattern_destroy(ramp);
    shown.decimals = !scale->diverging && fabs(middle - nearbyint(middle)) > 1e-3; /* the range is a round number */
    for (int i = 0; i <= 2; i++) {
        tr_text at = {.x = TR_PANEL_X + i * TR_PANEL_W / 2.0, .y = y + 70, .size = 24, .align = (tr_align)i};
        tr_frame_number(number, sizeof number, low + i * (range - low) / 2, &shown, scale->diverging);
        at.hue = !scale->motion || i == 1 ? TR_INK : i ? TR_ROLLS : TR_SLIDES, at.bold = scale->motion;
        tr_pen_text(cr, at, !scale->motion ? number : tr_say(cr, motion[i]));
    }
}

void tr_frame_time(char *text, size_t size, double time, double time_end) {
    tr_unit unit = tr_frame_unit(time_end, "s");
    char number[32];
    unit.decimals++;
    tr_frame_number(number, sizeof number, time, &unit, false);
    snprintf(text, size, "%s %s", number, unit.name);
}

double tr_frame_scale(tr_box box, double x0, double y0, double x1, double y1) {
    double scale = fmin(box.w / (x1 - x0), box.h / (y1 - y0));
    bool sound = x1 > x0 && y1 > y0 && box.w > 0 && box.h > 0 && isfinite(x1 - x0) && isfinite(y1 - y0);
    return sound && isfinite(scale) ? scale : 0;
}

tr_map tr_frame_map(tr_box box, double scale, double x0, double y0, double x1, double y1) {
    tr_map map = {.scale = scale, .width = (x1 - x0) * scale, .height = (y1 - y0) * scale};
    map.left = box.x + (box.w - map.width) / 2;
    map.top = box.y + (box.h - map.height) / 2;
    map.x = map.left - scale * x0;
    map.y = map.top + scale * y1;
    return map;
}

tr_map tr_frame_start(cairo_t *cr, const tr_view *view, double *panel_y) {
    char time[64];
    tr_frame_time(time, sizeof time, view->time, view->time_end);
    *panel_y = tr_frame_head(cr, &(tr_head){view->title, TR_SAY(cr, time), time, view->line, view->n_lines});
    double top = view->title ? TR_EDGE + 52 : TR_EDGE;
    tr_box box = {TR_EDGE, top, TR_PICTURE_W, TR_FRAME_HEIGHT - 64 - top};
    double scale = tr_frame_scale(box, view->x0, view->y0, view->x1, view->y1);
    if (scale == 0) return (tr_map){0};
    tr_frame_scale_bar(cr, scale, TR_FRAME_HEIGHT - 24);
    return tr_frame_map(box, scale, view->x0, view->y0, view->x1, view->y1);
}

tr_point tr_frame_point(const tr_map *map, double x, double y) {
    return (tr_point){map->x + map->scale * x, map->y - map->scale * y};
}

bool tr_frame_seen(tr_point p, double radius) {
    return fabs(p.x) < 1e4 && fabs(p.y) < 1e4 && radius > 0 && radius < 1e4;
}

int tr_frame_images(const tr_view *view) {
    return view->world->cell.side[0] > 0 ? 9 : 1;
}

tr_point tr_frame_image(const tr_view *view, const tr_map *map, tr_point p, int image) {
    const double *side = view->world->cell.side;
    int i = (image + 1) % 3 - 1, j = (image / 3 + 1) % 3 - 1;
    return (tr_point){p.x + i * side[0] * map->scale, p.y - j * side[1] * map->scale};
}

bool tr_frame_shown(const tr_view *view, const tr_map *map, tr_point p, double radius) {
    const double *side = view->world->cell.side;
    bool near = !(side[0] > 0) || (fabs(p.x - map->x) < 0.5 * side[0] * map->scale + 2 * radius &&
                                   fabs(p.y - map->y) < 0.5 * side[1] * map->scale + 2 * radius);
    return near && tr_frame_seen(p, radius);
}
