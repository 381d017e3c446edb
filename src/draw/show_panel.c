/* SPDX-License-Identifier: MIT */
/* Numbers of a film of a few bodies: V_s and V_r by every definition as a table of bars, all to the same scale, and the
 * table of checks. */
#include "draw/show_panel.h"

#include "draw/show.h"
#include "draw/show_bar.h"
#include "draw/say.h"
#include "laws/kinematics.h"
#include "scene/contact_name.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { LABEL_W = 156, LABEL_W_MANY = 134 };

static const double row_least = 20, row_most = 38, check_height = 28;

/* The rows of the table. */
typedef struct tr_rows {
    cairo_t *cr;
    tr_box box;
    const tr_show_lane *lane;
    const tr_record *record;
    double y, height, label, column, range;
    tr_unit unit;
    int shown, most; /* contacts; definitions of a kind */
    bool differ;     /* some of them */
} tr_rows;

static double column_x(const tr_rows *rows, int i) {
    return rows->box.x + rows->label + i * rows->column;
}

static tr_text label_of(const tr_rows *rows, bool bold, unsigned hue) {
    double size = fmin(0.78 * rows->height, 20);
    return (tr_text){.x = rows->box.x,
                     .y = rows->y + 0.5 * rows->height + 0.36 * size,
                     .size = size,
                     .room = rows->label - 8,
                     .bold = bold,
                     .hue = hue};
}

static void draw_heading(tr_rows *rows) {
    tr_text at = label_of(rows, true, 0);
    tr_pen_text(rows->cr, at, rows->shown == 1 ? TR_SAY(rows->cr, contact) : TR_SAY(rows->cr, disks));
    at.align = TR_RIGHT, at.room = rows->column - 12;
    for (int i = 0; i < rows->shown; i++) {
        const tr_record *r = &rows->record[i];
        char name[64];
        const char *wall = TR_SAY(rows->cr, wall), *gap = rows->shown == 1 ? " " : "";
        const char *disk = rows->shown == 1 ? TR_SAY(rows->cr, disk) : "";
        if (r->a < 0 && rows->lane->world->n_walls == 1)
            snprintf(name, sizeof name, "%s – %s%s%d", wall, disk, gap, r->b);
        else if (r->R1 < 0)
            snprintf(name, sizeof name, "%s %d – %s%s%d", TR_SAY(rows->cr, ring), r->a, disk, gap, r->b);
        else if (r->a < 0)
            snprintf(name, sizeof name, "%s %d – %s%s%d", wall, -1 - r->a, disk, gap, r->b);
        else
            snprintf(name, sizeof name, "%s%s%d – %s%s%d", disk, gap, r->a, disk, gap, r->b);
        at.x = column_x(rows, i + 1);
        tr_pen_text(rows->cr, at, name);
    }
    rows->y += rows->height;
}

/* How far the rims have rolled. */
static void draw_arcs(tr_rows *rows) {
    double most = 0;
    for (int i = 0; i < rows->shown; i++) most = fmax(most, fmax(fabs(rows->record[i].da), fabs(rows->record[i].db)));
    tr_unit unit = tr_frame_unit(fmax(most, 1e-3 * rows->record[0].R2), "m"); /* no unit for rounding */
    for (int b = 0; b < 2; b++) {
        char text[48];
        tr_text at = label_of(rows, false, b ? TR_ARC_B : TR_ARC_A);
        snprintf(text, sizeof text, "%s  [%s]", b ? "Δb" : "Δa", unit.name);
        tr_pen_text(rows->cr, at, text);
        at.align = TR_RIGHT, at.room = rows->column - 12;
        for (int i = 0; i < rows->shown; i++) {
            const tr_record *r = &rows->record[i];
            tr_frame_number(text, sizeof text, b ? r->db : r->da, &unit, true);
            at.x = column_x(rows, i + 1);
            tr_pen_text(rows->cr, at, text);
        }
        rows->y += rows->height;
    }
}

/* Whose velocity the laws of the scene take. */
static bool is_used(const tr_world *world, const tr_velocity_measure *measure, bool rolling) {
    return !strcmp(measure->name, rolling ? tr_rolling_velocities[world->rolling_velocity].name
                                          : tr_arms_rows[world->arms].sliding);
}

static void draw_definitions(tr_rows *rows, bool rolling) {
    const tr_velocity_measure *measure = rolling ? tr_rolling_velocities : tr_sliding_velocities;
    int n = rolling ? tr_n_rolling_velocities : tr_n_sliding_velocities;
    for (int k = 0; k < n && k < rows->most; k++) {
        char label[64];
        bool used = is_used(rows->lane->world, &measure[k], rolling);
        snprintf(label, sizeof label, "%s %s", rolling ? "V_r" : "V_s", measure[k].name);
        const unsigned hue = rolling ? TR_ROLLS : TR_SLIDES;
        tr_pen_text(rows->cr, label_of(rows, used, hue), label);
        for (int i = 0; i < rows->shown; i++) {
            const tr_record *r = &rows->record[i];
            const double *by = rolling ? r->v_r_by : r->v_s_by;
            tr_bar bar = {.value = by[k], .range = rows->range, .hue = hue, .unit = &rows->unit, .bold = used};
            bar.differs = !(fabs(by[k] - by[0]) <= 0.01 * rows->range);
            rows->differ |= bar.differs;
            tr_bar_draw(rows->cr, (tr_box){column_x(rows, i) + 8, rows->y, rows->column - 8, rows->height}, &bar);
        }
        rows->y += rows->height;
    }
    rows->y += 0.3 * rows->height;
}

static void draw_notes(tr_rows *rows) {
    tr_unit whole = rows->unit; /* the range is a round number */
    whole.decimals = rows->range / whole.size < 1 ? 1 : 0;
    char number[32], text[96];
    tr_frame_number(number, sizeof number, rows->range, &whole, false);
    tr_words_fill(text, sizeof text, TR_SAY(rows->cr, bars_end), rows->unit.name, number);
    tr_text at = {.x = rows->box.x, .y = rows->y + 17, .size = 18, .room = rows->box.w, .hue = TR_FAINT};
    tr_pen_text(rows->cr, at, text);
    if (rows->lane->n_records > rows->shown) {
        char shown[16], all[16];
        snprintf(shown, sizeof shown, "%d", rows->shown), snprintf(all, sizeof all, "%d", rows->lane->n_records);
        tr_words_fill(text, sizeof text, TR_SAY(rows->cr, of_contacts), shown, all);
        at.x += rows->box.w, at.align = TR_RIGHT, at.room = 0.4 * rows->box.w;
        tr_pen_text(rows->cr, at, text);
    }
    if (!rows->differ) return;
    tr_bar sample = {.value = 1, .range = 1, .hue = TR_FAINT, .differs = true};
    tr_bar_draw(rows->cr, (tr_box){rows->box.x - 30, rows->y + 26, 60, 18}, &sample);
    tr_pen_hue(rows->cr, TR_WHITE); /* its left half */
    cairo_rectangle(rows->cr, rows->box.x - 31, rows->y + 24, 31, 22);
    cairo_fill(rows->cr);
    tr_pen_text(rows->cr, (tr_text){.x = rows->box.x + 40, .y = rows->y + 40, .size = 18, .room = rows->box.w - 40},
                TR_SAY(rows->cr, differs));
}

bool tr_panel_bars(cairo_t *cr, tr_box box, const tr_show_lane *lane, double range) {
    tr_rows rows = {.cr = cr, .box = box, .lane = lane, .y = box.y, .range = range, .most = TR_MAX_VELOCITY_MEASURES};
    const bool chosen = lane->contact.a != lane->contact.b;
    int n_records;
    rows.record = tr_show_records(lane, &n_records);
    rows.shown = n_records < TR_SHOW_CONTACTS ? n_records : TR_SHOW_CONTACTS;
    if (rows.shown == 0) {
        char text[64 + TR_CONTACT_NAME];
        int used = snprintf(text, 64, "%s ", TR_SAY(cr, no_contact));
        if (chosen) tr_contact_name_write(lane->contact, text + used);
        tr_pen_text(cr, (tr_text){.x = box.x, .y = box.y + 32, .size = 28, .hue = TR_FAINT}, text);
        return true;
    }
    rows.label = rows.shown > 2 ? LABEL_W_MANY : LABEL_W;
    rows.column = (box.w - rows.label) / rows.shown;
    rows.unit = tr_frame_unit(range, "m/s");
    double notes = 46, least = rows.column < 200 ? 1.25 * row_least : row_least;
    bool arcs = true, heading;
    for (int n_s = tr_n_sliding_velocities, n_r = tr_n_rolling_velocities;;) {
        int most = n_s > n_r ? n_s : n_r;
        if (rows.most > most) rows.most = most;
        heading = arcs || chosen || rows.shown > 1;
        double n = heading + 2 * arcs + (n_s < rows.most ? n_s : rows.most) + (n_r < rows.most ? n_r : rows.most) + 0.6;
        rows.height = fmin((box.h - notes) / n, row_most);
        if (rows.height >= least || rows.most == 1) break;
        if (arcs)
            arcs = false;
        else
            rows.most--;
    }
    if (rows.height < 0.8 * row_least) return false;
    if (heading) draw_heading(&rows);
    if (arcs) draw_arcs(&rows);
    draw_definitions(&rows, false);
    draw_definitions(&rows, true);
    draw_notes(&rows);
    return true;
}

/* Heads, groups and numbers are lines of the same height. */
static int lines_of(const tr_show_check *check, int n) {
    int lines = n > 0;
    for (int i = 0; i < n; i++) lines += *check[i].group && (i == 0 || strcmp(check[i].group, check[i - 1].group) != 0);
    return lines + n;
}

double tr_panel_checks_height(const tr_show_check *check, int n) {
    return n > 0 ? lines_of(check, n) * check_height + 12 : 0;
}

static void draw_check(cairo_t *cr, tr_box line, const tr_show_check *check, double size) {
    double y = line.y + 0.72 * line.h, exact = line.x + line.w, measured = exact - 0.3 * line.w;
    tr_pen_verdict(cr, (tr_point){line.x + 9, y + 0.05 * size}, size, check->ok);
    tr_pen_text(cr, (tr_text){.x = line.x + 26, .y = y, .size = size, .bold = true, .room = 0.4 * line.w - 26},
                check->what);
    tr_pen_text(cr, (tr_text){.x = measured, .y = y, .size = size, .align = TR_RIGHT, .room = 0.29 * line.w},
                check->measured);
    tr_pen_text(cr, (tr_text){.x = exact, .y = y, .size = size, .align = TR_RIGHT, .room = 0.28 * line.w},
                check->exact);
}

void tr_panel_checks(cairo_t *cr, tr_box box, const tr_show_check *check, int n) {
    double height = fmin(check_height, (box.h - 12) / lines_of(check, n)), smallest = 17, size;
    int fit = (int)((box.h - 12) / smallest), used = 1;
    height = fmax(height, smallest), size = 0.72 * height;
    tr_text head = {.y = box.y + 0.72 * height, .size = size, .align = TR_RIGHT, .hue = TR_FAINT};
    head.x = box.x + 0.7 * box.w, tr_pen_text(cr, head, TR_SAY(cr, measured));
    head.x = box.x + box.w, tr_pen_text(cr, head, TR_SAY(cr, exact));
    for (int i = 0; i < n; i++) {
        bool group = *check[i].group && (i == 0 || strcmp(check[i].group, check[i - 1].group) != 0);
        tr_box line = {box.x, box.y + used * height, box.w, height};
        if (used + group + (i < n - 1) >= fit) {
            char text[64], number[16];
            snprintf(number, sizeof number, "%d", n - i);
            tr_words_fill(text, sizeof text, TR_SAY(cr, and_more), number, "");
            tr_pen_text(cr, (tr_text){.x = box.x, .y = line.y + 0.72 * height, .size = size, .hue = TR_FAINT}, text);
            return;
        }
        if (group)
            tr_pen_text(cr, (tr_text){.x = box.x, .y = line.y + 0.72 * height, .size = size, .room = box.w},
                        check[i].group);
        line.y += group * height;
        used += 1 + group;
        draw_check(cr, line, &check[i], size);
    }
}
