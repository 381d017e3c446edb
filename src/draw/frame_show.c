/* SPDX-License-Identifier: MIT */
/* A film of a few bodies: the layout.
 *
 *     title                                     time        cells: one stage, or a grid of the lanes, all to one scale
 *     equation                                              panel: checks, bars, inset, chart. Where lanes have neither
 *     cells                                    panel               chart nor checks the cells have its place
 *     scale bar   legend                      slower        The layout depends on nothing that changes while the film
 *     caption of a still                                    runs but contacts, so that nothing jumps. */
#include "draw/frame_show.h"

#include "draw/field.h"
#include "draw/patch_plot.h"
#include "draw/show.h"
#include "draw/show_chart.h"
#include "draw/show_class.h"
#include "draw/show_marks.h"
#include "draw/show_panel.h"
#include "draw/show_stage.h"
#include "draw/stage.h"
#include "draw/say.h"

#include <math.h>
#include <stdio.h>

enum {
    GAP = 14,
    LINE_H = 30,
    PAIR_H = TR_CLASS_PAIR_H,
    INSET_W = 240,
    INSET_H = 186,
    CHART_H = 178,
    BELOW_FLOOR = TR_MARKS_DEPTH + 32,
    BELOW_NAMES = 40
};

/* Where the lanes go. */
typedef struct tr_grid {
    tr_box box;
    int rows, columns, lines; /* lines: of a label */
    double scale;             /* 0: nothing can be shown */
} tr_grid;

typedef struct tr_cell {
    tr_box label, stage, pair, inset; /* h 0: has no place */
} tr_cell;

/* A wide cell has its numbers beside the label and the inset at the right, a tall one has them below. */
static tr_cell lay_cell(tr_box box, int lines, bool inset) {
    tr_box in = {box.x + 10, box.y + 4, box.w - 20, box.h - 8};
    double label = LINE_H * (lines > 1 ? 1.7 : 1);
    tr_cell cell = {.label = {in.x, in.y, in.w, label}};
    in.y += label, in.h -= label;
    if (box.w >= 700) {
        cell.pair = (tr_box){in.x + 0.3 * in.w, cell.label.y, 0.7 * in.w, LINE_H - 2};
        cell.label.w = 0.3 * in.w - 16;
    } else {
        in.h -= PAIR_H;
        cell.pair = (tr_box){in.x, in.y + in.h, in.w, PAIR_H};
    }
    if (inset && in.w > 1.4 * in.h && in.w > 2 * INSET_W && in.h >= 0.7 * INSET_H) {
        in.w -= INSET_W + GAP;
        cell.inset = (tr_box){in.x + in.w + GAP, in.y, INSET_W, in.h};
    } else if (inset && in.w >= INSET_W && in.h >= 1.6 * INSET_H) {
        in.h -= INSET_H + GAP;
        cell.inset = (tr_box){in.x, in.y + in.h + GAP, in.w, INSET_H};
    }
    cell.stage = in;
    return cell;
}

static tr_box grid_box(const tr_grid *grid, int i) {
    int row = i / grid->columns, column = i % grid->columns;
    double w = (grid->box.w + GAP) / grid->columns, h = (grid->box.h + GAP) / grid->rows;
    return (tr_box){grid->box.x + column * w, grid->box.y + row * h, w - GAP, h - GAP};
}

static tr_cell cell_of(const tr_grid *grid, const tr_show *show, int i) {
    if (show->n_lanes == 1) return (tr_cell){.stage = grid->box};
    bool inset = false;
    for (int k = 0; k < show->n_lanes; k++) inset |= show->lane[k].inset && show->lane[k].inset_pair;
    return lay_cell(grid_box(grid, i), grid->lines, inset);
}

/* A floor has its hatching and its arcs below it, a ring its arcs, and walls of different laws their names. */
static tr_box room_of(const tr_cell *cell, const tr_show_lane *lane) {
    tr_box room = cell->stage;
    if (lane->world->n_walls > 0 || lane->world->n_rings > 0) room.h -= BELOW_FLOOR;
    if (lane->world->wall_laws) room.h -= BELOW_NAMES;
    return room;
}

static double scale_of(const tr_grid *grid, const tr_show *show) {
    double scale = INFINITY;
    for (int i = 0; i < show->n_lanes; i++) {
        const tr_show_lane *l = &show->lane[i];
        tr_cell cell = cell_of(grid, show, i);
        double own = tr_frame_scale(room_of(&cell, l), l->x0, l->y0, l->x1, l->y1);
        if (own > 0) scale = fmin(scale, own);
    }
    return isfinite(scale) ? scale : 0;
}

/* The number of columns that makes the pictures largest. */
static tr_grid lay_grid(cairo_t *cr, const tr_show *show, tr_box box) {
    tr_grid best = {.rows = 1, .columns = 1, .scale = -1};
    for (int columns = 1; columns <= show->n_lanes; columns++) {
        tr_grid grid = {.box = box, .rows = (show->n_lanes + columns - 1) / columns, .columns = columns, .lines = 1};
        for (int i = 0; i < show->n_lanes; i++) {
            const char *label = show->lane[i].label;
            double room = cell_of(&grid, show, i).label.w - 26; /* beside the marker */
            if (label && tr_pen_width(cr, (tr_text){.size = 24, .bold = true}, label) > room) grid.lines = 2;
        }
        grid.scale = scale_of(&grid, show);
        if (grid.scale > best.scale) best = grid;
    }
    return best;
}

/* The contact enlarged, and a line to it while there is one. */
static void draw_inset(const tr_stage *s, tr_box box, bool expert) {
    const tr_show_lane *lane = s->lane;
    for (int i = 0; i < lane->n_records && lane->inset->P > 0; i++) {
        const tr_record *r = &lane->record[i];
        tr_point p = tr_stage_point(s, r->x, r->y);
        bool inside = p.x > s->box.x && p.x < s->box.x + s->box.w && p.y > s->box.y && p.y < s->box.y + s->box.h;
        if (r->a != lane->inset_a || r->b != lane->inset_b || !inside) continue;
        tr_point to = box.x >= s->box.x + s->box.w ? (tr_point){box.x - 2, box.y + 0.5 * box.h}
                                                   : (tr_point){box.x + 0.5 * box.w, box.y - 2};
        tr_pen_hue(s->cr, TR_INK);
        tr_pen_line(s->cr, p, to, 1.5);
    }
    tr_pen_text(s->cr, (tr_text){.x = box.x, .y = box.y + 18, .size = expert ? 18 : 24, .room = box.w},
                TR_SAY(s->cr, inside_enlarged));
    tr_draw_patch_inset(s->cr, (tr_box){box.x, box.y + 24, box.w, box.h - 24}, lane->inset, lane->inset_pair, expert);
}

static tr_stage draw_lane(cairo_t *cr, const tr_show *show, const tr_grid *grid, double range, int i) {
    const tr_show_lane *lane = &show->lane[i];
    tr_cell cell = cell_of(grid, show, i);
    tr_stage stage = tr_stage_of(cr, lane, cell.stage, room_of(&cell, lane), grid->scale, range);
    if (grid->scale > 0 && tr_frame_scale(stage.box, lane->x0, lane->y0, lane->x1, lane->y1) > 0) tr_stage_draw(&stage);
    if (show->n_lanes == 1) return stage;
    tr_box frame = grid_box(grid, i);
    tr_pen_hue(cr, 0xC3C8CE);
    cairo_set_line_width(cr, 2);
    cairo_rectangle(cr, frame.x, frame.y, frame.w, frame.h);
    cairo_stroke(cr);
    tr_text at = {.x = cell.label.x, .y = cell.label.y + 24, .size = 24, .bold = true, .room = cell.label.w};
    if (show->chart) {
        tr_pen_hue(cr, TR_INK);
        tr_lane_marker(cr, (tr_point){at.x + 9, at.y - 8}, 9, i);
        at.x += 26, at.room -= 26;
    }
    if (lane->label) tr_pen_paragraph(cr, at, grid->lines, lane->label, true);
    tr_class_pair(cr, cell.pair, lane, range);
    if (cell.inset.h > 0 && lane->inset && lane->inset_pair) draw_inset(&stage, cell.inset, show->expert);
    return stage;
}

/* From the top: checks, bars, inset, chart. The chart gets what the others leave. */
static void draw_panel(const tr_show *show, const tr_stage *stage, tr_box box) {
    cairo_t *cr = stage->cr;
    const bool one = show->n_lanes == 1, inset = one && stage->lane->inset && stage->lane->inset_pair;
    double checks = show->expert ? fmin(tr_panel_checks_height(show->check, show->n_checks), 0.7 * box.h)
                                 : tr_class_checks_height(show->check, show->n_checks);
    const double inset_h = show->chart && !show->expert ? 0.78 * INSET_H : INSET_H; /* large type needs room */
    double inside = inset ? inset_h + GAP : 0;
    if (checks > 0)
        (show->expert ? tr_panel_checks : tr_class_checks)(cr, (tr_box){box.x, box.y, box.w, checks}, show->check,
                                                           show->n_checks);
    box.y += checks, box.h -= checks;
    double bars = box.h - inside - (show->chart ? CHART_H : 0);
    if (one && !show->expert) {
        bars = tr_class_panel(cr, (tr_box){box.x, box.y, box.w, bars}, stage->lane, stage->range);
        box.y += bars, box.h -= bars;
    } else if (one) {
        if (show->chart) bars = fmin(bars, 0.62 * box.h);
        bool drawn = tr_panel_bars(cr, (tr_box){box.x, box.y, box.w, bars}, stage->lane, stage->range);
        if (drawn) box.y += bars, box.h -= bars;
    }
    if (inset) draw_inset(stage, (tr_box){box.x, box.y + GAP, box.w, inset_h}, show->expert);
    box.y += inside, box.h -= inside;
    if (show->chart && box.h > 0.66 * CHART_H) /* less than that is a legend without curves */
        tr_show_chart(cr, (tr_box){box.x, box.y + 6, box.w, box.h - 6}, show);
}

/* Below the pictures: what arrows, lines and marks are, as many as there is room for. A class has no scale bar, whose
 * number nobody needs. */
static void draw_legend(cairo_t *cr, const tr_show *show, double x, double end, double y) {
    bool trace = false, rubbed = false, meshed = false,
         arcs = show->n_lanes > 1 && show->expert; /* one: in its panel */
    for (int i = 0; i < show->n_lanes; i++) {
        trace |= show->lane[i].trace && show->lane[i].n_trace > 0;
        for (int k = 0; k < show->lane[i].n_marks; k++) *(show->lane[i].mark[k].number ? &meshed : &rubbed) = true;
    }
    const struct {
        bool is;
        const char *text;
        unsigned hue;
        bool bold;
    } item[] = {{rubbed, TR_SAY(cr, rubbed), TR_SLIDES, true},
                {meshed, TR_SAY(cr, meshed), TR_ROLLS, true},
                {true, TR_SAY(cr, velocity), TR_GREEN, false},
                {true, TR_SAY(cr, spin), TR_PURPLE, false},
                {arcs, "Δa", TR_ARC_A, true},
                {arcs, "Δb", TR_ARC_B, true},
                {trace, TR_SAY(cr, way_of_contact), 0, false}};
    for (int i = 0; i < (int)(sizeof item / sizeof *item); i++) {
        tr_text at = {
            .x = x, .y = y, .size = show->expert ? 20 : TR_CLASS_TYPE, .hue = item[i].hue, .bold = item[i].bold};
        const double dots = item[i].hue ? 0 : 46;
        if (!item[i].is || x + dots + tr_pen_width(cr, at, item[i].text) > end) continue;
        tr_pen_hue(cr, TR_WALL);
        for (int k = 0; k < 6 && dots > 0; k++) tr_pen_dot(cr, (tr_point){x + 2 + 7 * k, y - 6}, 1.75);
        at.x += dots;
        x += dots + tr_pen_text(cr, at, item[i].text) + 24;
    }
}

static void draw_footer(cairo_t *cr, const tr_show *show, double scale, double y) {
    double x = show->expert && scale > 0 ? tr_frame_scale_bar(cr, scale, y) + 40 : TR_EDGE;
    double slower = show->slower, factor = slower > 1 ? slower : 1 / slower, end = TR_PANEL_X + TR_PANEL_W;
    if (factor > 1.005 && isfinite(factor)) {
        char number[32], text[96];
        snprintf(number, sizeof number, factor < 100 ? "%.2g" : "%.0f", factor);
        tr_words_fill(text, sizeof text, slower > 1 ? TR_SAY(cr, slower) : TR_SAY(cr, faster), number, "");
        tr_text at = {.x = end, .y = y, .size = show->expert ? 20 : TR_CLASS_TYPE, .align = TR_RIGHT};
        end -= tr_pen_text(cr, at, text) + 24;
    }
    draw_legend(cr, show, x, end, y);
}

/* Returns its lower end. */
static double draw_header(cairo_t *cr, const tr_show *show) {
    char time[64];
    tr_frame_time(time, sizeof time, show->time, show->time_end);
    tr_head head = {
        .title = show->title, .label = show->expert ? TR_SAY(cr, time) : "", .value = show->expert ? time : ""};
    tr_frame_head(cr, &head);
    if (!show->expert) tr_class_time(cr, show->time, show->time_end);
    double y = TR_EDGE + 48;
    if (!show->equation) return y;
    tr_text at = {.x = TR_EDGE, .y = y + 26, .size = show->expert ? 30 : 34, .room = TR_FRAME_WIDTH - 2 * TR_EDGE};
    tr_pen_text(cr, at, show->equation); /* of a class its indices are as large as the smallest type */
    return y + 46;
}

void tr_draw_show(tr_canvas *canvas, const tr_show *given) {
    cairo_t *cr = canvas->cr;
    tr_show show = *given;
    if (show.n_lanes > TR_MAX_LANES) show.n_lanes = TR_MAX_LANES;
    double top = draw_header(cr, &show), bottom = TR_FRAME_HEIGHT - 20, range = show.range;
    const double width = TR_FRAME_WIDTH - 2 * TR_EDGE;
    if (show.n_lanes < 1) return;
    for (int i = 0; i < show.n_lanes && !(given->range > 0 && given->range < 1e100); i++) {
        const tr_show_lane *l = &show.lane[i];
        range = fmax(i ? range : 0, tr_frame_range_bodies(l->world, l->record, l->n_records));
    }
    if (show.caption) {
        tr_text at = {.x = TR_EDGE, .size = 25, .room = width};
        bottom -= tr_pen_paragraph(cr, at, 3, show.caption, false) + 12;
        at.y = bottom + 36;
        tr_pen_paragraph(cr, at, 3, show.caption, true);
    }
    bool panel = show.n_lanes == 1 || show.chart || show.n_checks > 0;
    tr_grid grid = lay_grid(cr, &show, (tr_box){TR_EDGE, top, panel ? TR_PICTURE_W : width, bottom - 44 - top});
    draw_footer(cr, &show, grid.scale, bottom - 6);
    for (int i = show.n_lanes - 1; i > 0; i--) draw_lane(cr, &show, &grid, range, i);
    tr_stage stage = draw_lane(cr, &show, &grid, range, 0);
    if (panel) draw_panel(&show, &stage, (tr_box){TR_PANEL_X, top, TR_PANEL_W, bottom - 44 - top});
}
