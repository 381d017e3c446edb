/* SPDX-License-Identifier: MIT */
/* A biaxial test: packing, force network over it, walls with what drives them. Of a periodic cell the outline; the
 * images within a diameter around it are drawn too, and then paled.
 *
 * Where disks are too small for lines over them, and to see how far each has spun, the disks themselves are coloured.
 *
 * Cost is in strokes, so all disks are filled as one path (rims first, then the slightly smaller bodies: two fills cost
 * less than one stroke), as polygons, and contact lines are quadrilaterals, one path for each of a few dozen
 * colours. */
#include "draw/frame_biaxial.h"

#include "core/cell.h"
#include "draw/field.h"
#include "draw/frame.h"
#include "draw/frame_slip.h"
#include "draw/frame_history.h"
#include "draw/patch_plot.h"
#include "draw/say.h"

#include <math.h>
#include <stdio.h>

enum { N_COLORS = 33 }; /* odd: zero has a colour of its own in the diverging palette */

static tr_point disk_point(const tr_view *view, const tr_map *map, int i, double *radius) {
    const double *p = view->world->disks.pos + tr_body(i);
    *radius = p[3] * map->scale;
    return tr_frame_point(map, p[0], p[1]);
}

/* Disk b, or in a periodic cell its image next to a. */
static tr_point partner_point(const tr_view *view, const tr_map *map, int a, int b, double *radius) {
    const double *p = view->world->disks.pos + tr_body(a), *q = view->world->disks.pos + tr_body(b);
    double image[2] = {0};
    const double *side = view->world->cell.side;
    tr_cell_distance(&view->world->cell, p, q, image);
    *radius = q[3] * map->scale;
    return tr_frame_point(map, q[0] + image[0] * side[0], q[1] + image[1] * side[1]);
}

/* A regular polygon that leaves the circle by at most 1/8 px, half outwards, half inwards: for that Cairo takes twice
 * the corners. */
static void add_disk(cairo_t *cr, tr_point centre, double radius) {
    int n = (int)fmax(8, ceil(M_PI * sqrt(2 * radius)));
    double c = cos(2 * M_PI / n), s = sin(2 * M_PI / n), x = radius * (1.5 - 0.5 * cos(M_PI / n)), y = 0;
    cairo_new_sub_path(cr);
    for (int k = 0; k < n; k++) {
        cairo_line_to(cr, centre.x + x, centre.y + y);
        double turned = c * x - s * y;
        y = s * x + c * y, x = turned;
    }
    cairo_close_path(cr);
}

static void add_disks(cairo_t *cr, const tr_view *view, const tr_map *map, double rim) {
    double r;
    for (int k = 0; k < tr_frame_images(view); k++)
        for (int i = 0; i < view->world->disks.n; i++) {
            tr_point p = tr_frame_image(view, map, disk_point(view, map, i, &r), k);
            if (tr_frame_shown(view, map, p, r)) add_disk(cr, p, fmax(r - rim, 0.5 * r));
        }
}

/* That show rotation. */
static void add_ticks(cairo_t *cr, const tr_view *view, const tr_map *map) {
    double r;
    for (int k = 0; k < tr_frame_images(view); k++)
        for (int i = 0; i < view->world->disks.n; i++) {
            tr_point p = tr_frame_image(view, map, disk_point(view, map, i, &r), k);
            double angle = view->world->disks.pos[tr_body(i) + TR_TURN], c = cos(angle), s = sin(angle);
            if (!tr_frame_shown(view, map, p, r) || !isfinite(angle)) continue;
            cairo_move_to(cr, p.x + 0.4 * r * c, p.y - 0.4 * r * s);
            cairo_line_to(cr, p.x + r * c, p.y - r * s);
        }
}

static void draw_disks(cairo_t *cr, const tr_view *view, const tr_map *map) {
    add_disks(cr, view, map, 0);
    tr_pen_hue(cr, TR_RIM);
    cairo_fill(cr);
    add_disks(cr, view, map, 1.2);
    tr_pen_hue(cr, TR_DISK);
    cairo_fill(cr);
    add_ticks(cr, view, map);
    tr_pen_hue(cr, TR_FAINT);
    cairo_set_line_width(cr, 2.5);
    cairo_stroke(cr);
}

static bool is_two_sided(const tr_view *view) {
    return view->color == TR_COLOR_SPIN || view->color == TR_COLOR_MOTION;
}

/* u from 0 to 1: from one end of the colour bar to the other. */
static tr_rgb color_at(const tr_view *view, double u) {
    return view->color == TR_COLOR_SPIN     ? tr_palette_diverging(2 * u - 1)
           : view->color == TR_COLOR_MOTION ? tr_palette_motion(2 * u - 1)
                                            : tr_palette_ramp(tr_frame_ramp(view->color), u);
}

/* Disks in the colour of a field, without rims, which would cover what is a few pixels large. */
static void draw_field(cairo_t *cr, const tr_view *view, const tr_map *map, double range) {
    bool diverging = is_two_sided(view);
    double low = diverging ? -range : 0, r;
    for (int c = 0; c < N_COLORS; c++) {
        for (int i = 0; i < view->world->disks.n; i++) {
            double u = (view->fill[i] - low) / (range - low);
            int color = u > 0 ? (u < 1 ? (int)(u * N_COLORS) : N_COLORS - 1) : 0;
            tr_point p = disk_point(view, map, i, &r);
            if (color == c && tr_frame_seen(p, r)) add_disk(cr, p, r);
        }
        double u = (c + 0.5) / N_COLORS;
        tr_pen_rgb(cr, color_at(view, u));
        cairo_fill(cr);
    }
}

static double mean_force(const tr_view *view) {
    double sum = 0;
    for (int i = 0; i < view->n_records; i++) sum += view->record[i].f_n;
    return view->n_records ? sum / view->n_records : 0;
}

/* From centre to centre; at a wall from the contact point to the centre. */
static bool branch(const tr_view *view, const tr_map *map, const tr_record *r, int image, tr_point *p, tr_point *q) {
    double rp = 1, rq;
    *p = r->a >= 0 ? disk_point(view, map, r->a, &rp) : tr_frame_point(map, r->x, r->y);
    *q = r->a >= 0 ? partner_point(view, map, r->a, r->b, &rq) : disk_point(view, map, r->b, &rq);
    *p = tr_frame_image(view, map, *p, image), *q = tr_frame_image(view, map, *q, image);
    bool seen = tr_frame_seen(*p, rp) && tr_frame_seen(*q, rq);
    return seen && (tr_frame_shown(view, map, *p, rp) || tr_frame_shown(view, map, *q, rq));
}

/* Width of a line of mean force: a quarter of the mean radius [px]. */
static double mean_width(const tr_view *view, const tr_map *map) {
    double sum = 0;
    for (int i = 0; i < view->world->disks.n; i++) sum += view->world->disks.pos[tr_body(i) + TR_RADIUS];
    return 0.25 * map->scale * sum / fmax(view->world->disks.n, 1);
}

static void draw_contacts(cairo_t *cr, const tr_view *view, const tr_map *map, double range, double mean) {
    const bool slip = view->color == TR_COLOR_SLIP; /* one pale colour: bars across the lines tell the rest */
    double unit = mean_width(view, map), thinnest = 0.15 * unit, widest = 4 * unit;
    for (int c = 0; c < N_COLORS; c++) {
        for (int k = 0; k < tr_frame_images(view) * view->n_records; k++) {
            const tr_record *r = &view->record[k % view->n_records];
            double u = slip ? 0 : tr_frame_field(view->world, r, view->color) / range;
            if (view->color == TR_COLOR_MOTION) u = 0.5 * (1 + u);
            int color = u > 0 ? (u < 1 ? (int)(u * N_COLORS) : N_COLORS - 1) : 0;
            tr_point p, q;
            if (color != c || !(r->f_n > 0) || !branch(view, map, r, k / view->n_records, &p, &q)) continue;
            double length = hypot(q.x - p.x, q.y - p.y);
            double width = fmin(fmax(unit * r->f_n / mean, thinnest), widest);
            if (!(length > 0)) continue;
            /* half a width along and across; a little longer than the branch, so that bends of a chain close */
            double ex = 0.5 * width * (q.x - p.x) / length, ey = 0.5 * width * (q.y - p.y) / length;
            p = (tr_point){p.x - 0.4 * ex, p.y - 0.4 * ey};
            q = (tr_point){q.x + 0.4 * ex, q.y + 0.4 * ey};
            cairo_move_to(cr, p.x - ey, p.y + ex);
            cairo_line_to(cr, q.x - ey, q.y + ex);
            cairo_line_to(cr, q.x + ey, q.y - ex);
            cairo_line_to(cr, p.x + ey, p.y - ex);
            cairo_close_path(cr);
        }
        tr_pen_rgb(cr, slip ? tr_palette_hue(TR_FORCE) : color_at(view, (c + 0.5) / N_COLORS));
        cairo_fill(cr);
    }
    if (slip) tr_frame_slip(cr, view, map, mean);
}

/* What the view shows outside the cell. */
static void pale(cairo_t *cr, const tr_view *view, const tr_map *map) {
    const double *side = view->world->cell.side;
    double w = side[0] * map->scale, h = side[1] * map->scale;
    cairo_rectangle(cr, map->left, map->top, map->width, map->height);
    cairo_rectangle(cr, map->x - w / 2, map->y - h / 2, w, h);
    cairo_set_fill_rule(cr, CAIRO_FILL_RULE_EVEN_ODD);
    cairo_set_source_rgba(cr, 1, 1, 1, 0.75);
    cairo_fill(cr);
    cairo_set_fill_rule(cr, CAIRO_FILL_RULE_WINDING);
}

/* The sides of a cell, each half of what its two have in common. */
static void walls_of_cell(const tr_periodic_cell *cell, tr_wall wall[4]) {
    for (int w = 0; w < 4; w++) {
        int axis = w < 2, out = w % 2 ? 1 : -1;
        double at = 0.5 * out * cell->side[axis], v = 0.5 * out * cell->rate[axis];
        wall[w] = axis ? (tr_wall){.y = at, .ny = -out, .vy = v} : (tr_wall){.x = at, .nx = -out, .vx = v};
        wall[w].mass = cell->mass[axis], wall[w].gain = -0.5 * cell->gain[axis];
    }
}

/* Bars along the box that the four walls make, thin ones of a cell; a loaded wall gets a row of pressure arrows, a
 * driven one an arrow its way. */
static void draw_walls(cairo_t *cr, const tr_view *view, const tr_map *map) {
    tr_wall made[4];
    const tr_wall *wall = view->world->wall;
    const bool cell = view->world->cell.side[0] > 0;
    const double bar = cell ? 3 : 10;
    if (cell)
        walls_of_cell(&view->world->cell, made), wall = made;
    else if (view->world->n_walls < 4)
        return;
    tr_point low = tr_frame_point(map, wall[2].x, wall[0].y), high = tr_frame_point(map, wall[3].x, wall[1].y);
    if (!tr_frame_seen(low, 1) || !tr_frame_seen(high, 1)) return;
    tr_point corner[4][2] = {
        {low, {high.x, low.y}}, {{low.x, high.y}, high}, {low, {low.x, high.y}}, {{high.x, low.y}, high}};
    for (int w = 0; w < 4; w++) {
        tr_point p = corner[w][0], q = corner[w][1], out = {-wall[w].nx, wall[w].ny}; /* away from the disks, y down */
        double ex = out.x * bar / 2, ey = out.y * bar / 2;
        tr_pen_hue(cr, TR_WALL);
        double over = w < 2 ? bar : 0; /* the horizontal bars close the corners */
        tr_pen_line(cr, (tr_point){p.x + ex - over, p.y + ey}, (tr_point){q.x + ex + over, q.y + ey}, bar);
        double gain = wall[w].gain; /* at the start of a shear the driven ones are still at rest */
        bool loaded = wall[w].mass > 0, driven = !loaded && (wall[w].vx != 0 || wall[w].vy != 0 || gain != 0);
        int n = loaded ? 7 : driven ? 1 : 0;
        double inward = loaded || wall[w].vx * wall[w].nx + wall[w].vy * wall[w].ny + gain > 0 ? 1 : -1;
        tr_pen_hue(cr, loaded ? TR_FAINT : TR_INK);
        for (int k = 0; k < n; k++) {
            double f = (k + 0.5) / n, length = loaded ? 26 : 40, near = bar + 4, far = near + length;
            tr_point at = {p.x + f * (q.x - p.x), p.y + f * (q.y - p.y)};
            tr_point from = {at.x + far * out.x, at.y + far * out.y}, to = {at.x + near * out.x, at.y + near * out.y};
            tr_pen_arrow(cr, inward > 0 ? from : to, inward > 0 ? to : from, loaded ? 2.5 : 7);
        }
    }
}

static void draw_color_bar(cairo_t *cr, const tr_view *view, double range, double y) {
    static const tr_word_key name[] = {TR_WORD_friction_used, TR_WORD_sliding_speed, TR_WORD_rolling_speed,
                                       TR_WORD_slip_share,    TR_WORD_rotation,      TR_WORD_motion};
    tr_unit unit = {.size = 1};
    char label[96];
    bool spin = view->color == TR_COLOR_SPIN, motion = view->color == TR_COLOR_MOTION;
    if (spin)
        unit = (tr_unit){.size = M_PI / 180, .name = "°"};
    else if (view->color == TR_COLOR_SLIDING || view->color == TR_COLOR_ROLLING)
        unit = tr_frame_unit(range, "m/s");
    const char *text = tr_say(cr, name[view->color]);
    if (view->fill && !spin)
        tr_words_fill(label, sizeof label, TR_SAY(cr, mean_of), text, "");
    else
        snprintf(label, sizeof label, "%s", text);
    if (view->color == TR_COLOR_SLIP) /* of disks too small for bars across their contacts */
        tr_pen_text(cr, (tr_text){.x = TR_PANEL_X, .y = y - 34, .size = 22, .room = TR_PANEL_W, .hue = TR_FAINT},
                    tr_frame_slip_limit(cr, view));
    tr_frame_color_bar(cr, &(tr_scale){label, range, &unit, tr_frame_ramp(view->color), spin, motion}, y);
}

static void draw_width_key(cairo_t *cr, tr_shape shape, double mean, double width, double y) {
    tr_unit unit = tr_frame_unit(mean, shape == TR_SHAPE_SPHERE ? "N" : "N/m");
    char number[32], label[64];
    tr_frame_number(number, sizeof number, mean, &unit, false);
    tr_words_fill(label, sizeof label, TR_SAY(cr, force_is), number, unit.name);
    tr_pen_hue(cr, TR_FAINT);
    tr_pen_line(cr, (tr_point){TR_PANEL_X, y - 8}, (tr_point){TR_PANEL_X + 48, y - 8}, width);
    tr_pen_text(cr, (tr_text){.x = TR_PANEL_X + 64, .y = y, .size = 22, .room = TR_PANEL_W - 64}, label);
}

void tr_frame_inset_numbers(const tr_view *view, tr_language language, char text[TR_INSET_NUMBERS]) {
    const tr_patch_state *s = view->inset;
    tr_unit unit = {.size = 1, .decimals = 2};
    char law[24], exact[24];
    if (!(s->P > 0)) {
        snprintf(text, TR_INSET_NUMBERS, "%s", tr_words_of(language, TR_WORD_open));
        return;
    }
    tr_frame_number(law, sizeof law, view->inset_law, &unit, false);
    tr_frame_number(exact, sizeof exact, s->Q / (view->inset_pair->mu * s->P), &unit, false);
    tr_words_fill(text, TR_INSET_NUMBERS, tr_words_of(language, TR_WORD_inset_numbers), law, exact);
}

/* In the panel, where it covers no disk, from top to bottom; a line leads to its contact while there is one. */
static void draw_inset(cairo_t *cr, const tr_view *view, const tr_map *map, double top, double bottom) {
    double r1, r2;
    tr_point p = disk_point(view, map, view->inset_a, &r1),
             q = partner_point(view, map, view->inset_a, view->inset_b, &r2);
    double part = r1 / (r1 + r2), ring = 0.5 * fmin(r1, r2);
    tr_point at = {p.x + part * (q.x - p.x), p.y + part * (q.y - p.y)}, to = {TR_PANEL_X - 12, 0.5 * (top + bottom)};
    char label[64], numbers[TR_INSET_NUMBERS];
    char a[16], b[16];
    snprintf(a, sizeof a, "%d", view->inset_a), snprintf(b, sizeof b, "%d", view->inset_b);
    tr_words_fill(label, sizeof label, TR_SAY(cr, inset_of), a, b);
    tr_frame_inset_numbers(view, tr_say_language(cr), numbers);
    tr_pen_hue(cr, TR_INK);
    if (view->inset->P > 0 && tr_frame_seen(at, ring)) {
        double length = hypot(to.x - at.x, to.y - at.y);
        tr_point from = {at.x + ring * (to.x - at.x) / length, at.y + ring * (to.y - at.y) / length};
        tr_pen_line(cr, from, to, 2);
        cairo_arc(cr, at.x, at.y, ring, 0, 2 * M_PI);
        cairo_set_line_width(cr, 3);
        cairo_stroke(cr);
    }
    tr_pen_text(cr, (tr_text){.x = TR_PANEL_X, .y = top + 20, .size = 22, .room = TR_PANEL_W}, label);
    tr_pen_text(cr, (tr_text){.x = TR_PANEL_X, .y = top + 48, .size = 24, .bold = true, .room = TR_PANEL_W}, numbers);
    tr_draw_patch_inset(cr, (tr_box){TR_PANEL_X, top + 56, TR_PANEL_W, bottom - top - 56}, view->inset,
                        view->inset_pair, true);
}

void tr_draw_biaxial(tr_canvas *canvas, const tr_view *view) {
    cairo_t *cr = canvas->cr;
    double y, panel, mean = view->f_mean > 0 ? view->f_mean : mean_force(view);
    double range = view->range > 0 ? view->range : tr_frame_range(view->record, view->n_records, view->color);
    tr_map map = tr_frame_start(cr, view, &panel);
    y = TR_FRAME_HEIGHT - TR_EDGE - 72;
    if (view->color == TR_COLOR_SLIP && !view->fill)
        tr_frame_slip_key(cr, view, y);
    else
        draw_color_bar(cr, view, range, y);
    if (map.scale == 0) return;
    cairo_save(cr);
    if (tr_frame_images(view) > 1) cairo_rectangle(cr, map.left, map.top, map.width, map.height), cairo_clip(cr);
    if (view->fill)
        draw_field(cr, view, &map, range);
    else
        draw_disks(cr, view, &map);
    bool forces = !view->fill && mean > 0 && isfinite(mean);
    if (forces) draw_contacts(cr, view, &map, range, mean);
    if (tr_frame_images(view) > 1) pale(cr, view, &map);
    cairo_restore(cr);
    draw_walls(cr, view, &map);
    if (view->inset)
        draw_inset(cr, view, &map, panel, y - 88);
    else if (view->history)
        tr_frame_history(cr, (tr_box){TR_PANEL_X, panel, TR_PANEL_W, y - 88 - panel}, view->history);
    if (forces) draw_width_key(cr, view->world->shape, mean, mean_width(view, &map), y - 52);
}
