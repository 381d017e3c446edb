/* SPDX-License-Identifier: MIT */
/* A few bodies, for teaching: what the rims have rolled, and how fast centres and rims move.
 *
 * Arcs lie inside their own rim, so that the two of a contact never cover each other; those of a disk's next contact
 * lie further in. An arc of a turn or more is a faint ring and what is left of it. */
#include "draw/arc.h"
#include "draw/bodies_panel.h"

#include <math.h>
#include <stdio.h>

typedef struct tr_stage {
    cairo_t *cr;
    const tr_view *view;
    tr_map map;
    double range;
} tr_stage;

static const double arc_width = 9;

static bool place(const tr_stage *s, int disk, tr_point *p, double *radius) {
    const double *x = s->view->world->disks.pos + 4 * disk;
    *p = tr_frame_point(&s->map, x[0], x[1]);
    *radius = x[3] * s->map.scale;
    return tr_frame_seen(*p, *radius) && isfinite(x[2]);
}

static void draw_wall(const tr_stage *s, const tr_wall *wall) {
    tr_point o = tr_frame_point(&s->map, wall->x, wall->y), t = {wall->ny, wall->nx}; /* along it, y down */
    if (!tr_frame_seen(o, 1)) return;
    double reach = wall->length > 0 ? 0.5 * wall->length * s->map.scale : 2e3;
    reach = fmin(reach, 1e4);
    tr_pen_hue(s->cr, TR_RIM);
    for (int k = 0; k < 2 * reach / 16; k++) { /* hatch on the far side */
        double u = 16 * k - reach;
        tr_point p = {o.x + u * t.x, o.y + u * t.y};
        cairo_move_to(s->cr, p.x, p.y);
        cairo_line_to(s->cr, p.x - 14 * (wall->nx + t.x), p.y + 14 * (wall->ny - t.y));
    }
    cairo_set_line_width(s->cr, 2);
    cairo_stroke(s->cr);
    tr_pen_hue(s->cr, TR_WALL);
    tr_pen_line(s->cr, (tr_point){o.x - reach * t.x, o.y - reach * t.y},
                (tr_point){o.x + reach * t.x, o.y + reach * t.y}, 4);
}

static void draw_disk(const tr_stage *s, int i) {
    cairo_t *cr = s->cr;
    tr_point p;
    double r;
    if (!place(s, i, &p, &r)) return;
    tr_pen_hue(cr, TR_WALL);
    tr_pen_dot(cr, p, r);
    tr_pen_hue(cr, TR_DISK);
    tr_pen_dot(cr, p, fmax(r - 3, 0.5 * r));
    const double *x = s->view->world->disks.pos + 4 * i;
    tr_pen_hue(cr, TR_INK);
    for (int k = 0; k < 12; k++) {
        double angle = x[2] + k * M_PI / 6, c = cos(angle), n = sin(angle), in = k ? 0.9 * r : 0.62 * r;
        tr_pen_line(cr, (tr_point){p.x + in * c, p.y - in * n}, (tr_point){p.x + (r - 1) * c, p.y - (r - 1) * n},
                    k ? 2 : 6);
    }
}

/* Label of an arc: inside the disk, beside the arc's middle. */
static void label_arc(cairo_t *cr, tr_point at, const char *label, unsigned hue) {
    tr_pen_text(cr, (tr_text){.x = at.x, .y = at.y + 9, .size = 26, .bold = true, .align = TR_CENTRE, .hue = hue},
                label);
}

static void draw_arc(const tr_stage *s, int disk, tr_arc arc, int depth, const char *label, unsigned hue) {
    tr_point p;
    double r;
    if (!place(s, disk, &p, &r) || !isfinite(arc.sweep) || !isfinite(arc.from)) return;
    double radius = r - 3 - arc_width * (0.5 + 1.4 * depth), rest = fmod(arc.sweep, 2 * M_PI);
    if (radius < arc_width) return;
    if (fabs(arc.sweep) >= 2 * M_PI) {
        tr_rgb c = tr_palette_hue(hue);
        cairo_set_source_rgba(s->cr, c.r, c.g, c.b, 0.3);
        tr_pen_arc(s->cr, p, radius, arc.from, 2 * M_PI, arc_width, false);
    }
    tr_pen_hue(s->cr, hue);
    tr_pen_arc(s->cr, p, radius, arc.from, rest, arc_width, false);
    double end = arc.from + rest, mid = arc.from + rest / 2, inner = radius - 28;
    if (fabs(rest) * radius < 3) return;
    tr_pen_dot(s->cr, (tr_point){p.x + radius * cos(end), p.y - radius * sin(end)}, 0.8 * arc_width);
    if (inner > 20 && depth == 0) /* of more arcs the colour tells, as in the panel */
        label_arc(s->cr, (tr_point){p.x + inner * cos(mid), p.y - inner * sin(mid)}, label, hue);
}

static void draw_wall_arc(const tr_stage *s, const tr_record *r) {
    double x, y, under = 10;
    tr_arc_wall(r, &x, &y);
    tr_point p = tr_frame_point(&s->map, r->x, r->y), q = tr_frame_point(&s->map, x, y);
    if (!tr_frame_seen(p, 1) || !tr_frame_seen(q, 1) || hypot(q.x - p.x, q.y - p.y) < 3) return;
    p.x -= under * r->nx, q.x -= under * r->nx;
    p.y += under * r->ny, q.y += under * r->ny;
    tr_pen_hue(s->cr, TR_BLUE);
    tr_pen_line(s->cr, p, q, arc_width);
    tr_pen_dot(s->cr, q, 0.8 * arc_width);
    label_arc(s->cr, (tr_point){(p.x + q.x) / 2 - 26 * r->nx, (p.y + q.y) / 2 + 26 * r->ny}, "Δa", TR_BLUE);
}

static void draw_arcs(const tr_stage *s) {
    const tr_record *record = s->view->record;
    for (int i = 0; i < s->view->n_records && i < TR_BODIES_CONTACTS; i++) {
        const tr_record *r = &record[i];
        int depth_a = 0, depth_b = 0; /* earlier contacts on the same disks */
        for (int k = 0; k < i; k++) {
            depth_a += record[k].a == r->a || record[k].b == r->a;
            depth_b += record[k].a == r->b || record[k].b == r->b;
        }
        tr_arc a, b;
        tr_arc_angles(r, &a, &b);
        if (r->a >= 0)
            draw_arc(s, r->a, a, depth_a, "Δa", TR_BLUE);
        else
            draw_wall_arc(s, r);
        draw_arc(s, r->b, b, depth_b, "Δb", TR_VERMILLION);
    }
    for (int i = 0; i < s->view->n_records; i++) {
        tr_point p = tr_frame_point(&s->map, record[i].x, record[i].y);
        if (!tr_frame_seen(p, 1)) continue;
        tr_pen_hue(s->cr, TR_WHITE);
        tr_pen_dot(s->cr, p, 8);
        tr_pen_hue(s->cr, TR_INK);
        tr_pen_dot(s->cr, p, 5.5);
    }
}

static double limited(double u) {
    return isfinite(u) ? fmin(fmax(u, -1), 1) : 0;
}

/* Longest arrows: a straight one of a quarter of the picture's height, a curved one of 300 degrees. */
static void draw_motion(const tr_stage *s, int i) {
    tr_point p;
    double r;
    if (!place(s, i, &p, &r)) return;
    const double *v = s->view->world->disks.vel + 4 * i, *x = s->view->world->disks.pos + 4 * i;
    tr_pen_hue(s->cr, TR_PURPLE);
    tr_pen_arc(s->cr, p, 0.34 * r, M_PI / 2, limited(v[2] * x[3] / s->range) * 5 * M_PI / 3, 4, true);
    double longest = 0.25 * s->map.height, speed = hypot(v[0], v[1]), length = longest * limited(speed / s->range);
    tr_pen_hue(s->cr, TR_GREEN);
    if (speed > 0) tr_pen_arrow(s->cr, p, (tr_point){p.x + length * v[0] / speed, p.y - length * v[1] / speed}, 5);
    tr_pen_hue(s->cr, TR_INK);
    tr_pen_dot(s->cr, p, 4.5);
    char number[16];
    snprintf(number, sizeof number, "%d", i);
    if (r > 40)
        tr_pen_text(s->cr, (tr_text){.x = p.x - 12, .y = p.y + 26, .size = 22, .bold = true, .align = TR_RIGHT},
                    number);
}

void tr_draw_bodies(tr_canvas *canvas, const tr_view *view) {
    tr_stage s = {.cr = canvas->cr, .view = view, .range = view->range};
    if (!(s.range > 0)) s.range = tr_frame_range_bodies(view->world, view->record, view->n_records);
    double y;
    s.map = tr_frame_start(s.cr, view, &y);
    tr_bodies_panel(s.cr, view, s.range, y);
    if (s.map.scale == 0) return;
    cairo_save(s.cr);
    cairo_rectangle(s.cr, s.map.left, s.map.top, s.map.width, s.map.height);
    cairo_clip(s.cr);
    for (int i = 0; i < view->world->n_walls; i++) draw_wall(&s, &view->world->wall[i]);
    for (int i = 0; i < view->world->disks.n; i++) draw_disk(&s, i);
    draw_arcs(&s);
    for (int i = 0; i < view->world->disks.n; i++) draw_motion(&s, i);
    cairo_restore(s.cr);
    double base = TR_FRAME_HEIGHT - 24, right = TR_PANEL_X - 40;
    right -=
        tr_pen_text(s.cr, (tr_text){.x = right, .y = base, .size = 22, .align = TR_RIGHT, .hue = TR_PURPLE}, "spin ↺") +
        24;
    tr_pen_text(s.cr, (tr_text){.x = right, .y = base, .size = 22, .align = TR_RIGHT, .hue = TR_GREEN}, "velocity →");
}
