/* SPDX-License-Identifier: MIT */
/* The bodies of a lane: how far the rims have rolled, and how fast centres and rims move.
 *
 * Arcs lie inside their own rim, so that the two of a contact never cover each other; those of a disk's next contact
 * lie further in. An arc of a turn or more is a faint ring and the rest of the arc. Names come last and have a white
 * rim, so that they are always readable. A disk that is too small for a mark has none. */
#include "draw/show_stage.h"

#include "draw/arc.h"
#include "draw/show.h"
#include "draw/show_ground.h"
#include "draw/show_lamp.h"
#include "draw/show_marks.h"
#include "draw/stage.h"

#include <math.h>
#include <stdio.h>

static const double badge = 17; /* radius of the disk's number */

static bool place(const tr_stage *s, int disk, tr_point *p, double *radius) {
    const double *x = s->lane->world->disks.pos + tr_body(disk);
    *p = tr_stage_point(s, x[0], x[1]);
    *radius = fabs(x[3]) * s->map.scale;
    return tr_frame_seen(*p, *radius) && isfinite(x[2]);
}

/* At an angle of the turned plane. */
static tr_point around(tr_point centre, double radius, double angle) {
    return (tr_point){centre.x + radius * cos(angle), centre.y - radius * sin(angle)};
}

static double between(double low, double x, double high) {
    return fmin(fmax(x, low), high);
}

static double arc_width(double r) {
    return between(4, 0.11 * r, 9);
}

static void draw_disk(const tr_stage *s, int i) {
    tr_point p;
    double r;
    if (!place(s, i, &p, &r)) return;
    tr_pen_hue(s->cr, TR_WALL);
    tr_pen_dot(s->cr, p, r);
    tr_pen_hue(s->cr, TR_DISK);
    tr_pen_dot(s->cr, p, r - between(1, 0.1 * r, 3));
}

static void label_arc(cairo_t *cr, tr_point at, const char *label, unsigned hue) {
    tr_pen_text(
        cr, (tr_text){.x = at.x, .y = at.y + 9, .size = 26, .bold = true, .halo = true, .align = TR_CENTRE, .hue = hue},
        label);
}

static bool is_ring(const tr_stage *s, int i) {
    return i < s->lane->world->n_rings;
}

/* Of a ring, from its inside out [px]. */
static double band(const tr_stage *s, int i) {
    const tr_disks *d = &s->lane->world->disks;
    return fmax((d->outer[i] + d->pos[tr_body(i) + TR_RADIUS]) * s->map.scale, 2);
}

static void draw_ring(const tr_stage *s, int i) {
    tr_point p;
    double r;
    if (!place(s, i, &p, &r)) return;
    const double width = band(s, i), rim = between(1, 0.1 * width, 3);
    tr_pen_hue(s->cr, TR_WALL);
    tr_pen_arc(s->cr, p, r + 0.5 * width, 0, 2 * M_PI, width, false);
    if (width < 3 * rim) return;
    tr_pen_hue(s->cr, TR_DISK);
    tr_pen_arc(s->cr, p, r + 0.5 * width, 0, 2 * M_PI, width - 2 * rim, false);
}

/* What turns with a ring: ticks across the band. */
static void draw_ring_ticks(const tr_stage *s, int i) {
    tr_point p;
    double r, zero = s->lane->world->disks.pos[tr_body(i) + TR_TURN] + s->tilt;
    if (!place(s, i, &p, &r)) return;
    tr_pen_hue(s->cr, TR_INK);
    for (int k = 0; k < 24; k++) {
        double angle = zero + k * M_PI / 12, length = (k ? 0.5 : 1) * band(s, i);
        tr_pen_line(s->cr, around(p, r, angle), around(p, r + length, angle), k ? 2 : 5);
    }
}

/* The hub and the thread that pulls, as long as the disk is wide. */
static void draw_pull(const tr_stage *s, int i) {
    tr_point p;
    double r;
    if (!s->lane->disk || !place(s, i, &p, &r)) return;
    const tr_scene_pull *pull = &s->lane->disk[i].pull;
    if (!pull->given || pull->force == 0) return;
    double hub = fabs(pull->radius) * s->map.scale, turned = pull->angle + s->tilt;
    double way = turned + (pull->force < 0 ? M_PI : 0);
    tr_point from = around(p, pull->radius * s->map.scale, turned - M_PI / 2), to = around(from, 2.2 * r, way);
    tr_pen_hue(s->cr, TR_INK);
    if (hub > 2) tr_pen_arc(s->cr, p, hub, 0, 2 * M_PI, 2, false);
    tr_pen_line(s->cr, from, around(from, 1.9 * r, way), between(2, 0.04 * r, 4));
    tr_pen_arrow(s->cr, around(from, 1.6 * r, way), to, between(4, 0.08 * r, 8));
    double above = cos(way) < 0 ? -1 : 1;
    label_arc(s->cr, around(around(from, 2 * r, way), 22, way + above * M_PI / 2), "F", TR_INK);
}

/* One long tick shows the spin; the short ones the way along the rim. */
static void draw_ticks(const tr_stage *s, int i) {
    tr_point p;
    double r, zero = s->lane->world->disks.pos[tr_body(i) + TR_TURN] + s->tilt;
    if (!place(s, i, &p, &r)) return;
    tr_pen_hue(s->cr, TR_INK);
    for (int k = 0; k < (r > 24 ? 12 : 1); k++) {
        double angle = zero + k * M_PI / 6;
        tr_pen_line(s->cr,
                    around(p,
                           (k        ? 0.9
                            : r > 24 ? 0.62
                                     : 0) *
                               r,
                           angle),
                    around(p, 0.99 * r, angle), k ? 2 : between(2, 0.08 * r, 6));
    }
}

static double spin_radius(double r) {
    return fmax(0.36 * r, r > 30 ? badge + 7 : 0);
}

/* label NULL: the arc; else its label, inside the disk beside the arc's middle, where it fits. */
static void draw_arc(const tr_stage *s, int disk, tr_arc arc, int depth, const char *label, tr_hue hue) {
    tr_point p;
    double r;
    if (!place(s, disk, &p, &r) || !isfinite(arc.sweep) || !isfinite(arc.from)) return;
    const bool ring = is_ring(s, disk); /* the arcs of a ring lie outside of its rim */
    double width = arc_width(ring ? 80 : r), in = ring ? -1 : 1, rim = ring ? 3 : tr_marks_width(r) + 2;
    double radius = r - in * (rim + width * (0.5 + 1.4 * depth)), rest = fmod(arc.sweep, 2 * M_PI);
    double from = arc.from + s->tilt, inner = radius - in * 28;
    if (radius < 2.5 * width) return;
    if (label) {
        if ((ring || inner > spin_radius(r) + 20) && depth == 0 &&
            fabs(rest) * radius > 3) /* of more arcs the line tells */
            label_arc(s->cr, around(p, inner, from + rest / 2), label, hue);
        return;
    }
    if (fabs(arc.sweep) >= 2 * M_PI) {
        tr_rgb c = tr_palette_hue(hue);
        cairo_set_source_rgba(s->cr, c.r, c.g, c.b, 0.3);
        tr_pen_arc(s->cr, p, radius, from, 2 * M_PI, width, false);
    }
    tr_pen_hue(s->cr, hue);
    tr_pen_arc(s->cr, p, radius, from, rest, width, false);
    if (fabs(rest) * radius > 3) tr_pen_dot(s->cr, around(p, radius, from + rest), 0.8 * width);
    if (hue != TR_ARC_B) return;
    tr_pen_hue(s->cr, TR_WHITE);
    tr_pen_arc(s->cr, p, radius, from, rest, 0.4 * width, false);
    if (fabs(rest) * radius > 3) tr_pen_dot(s->cr, around(p, radius, from + rest), 0.4 * width);
}

static void draw_wall_arc(const tr_stage *s, const tr_record *r, const char *label) {
    double x, y, under = TR_MARKS_DEPTH, width = arc_width(r->R2 * s->map.scale);
    const tr_wall *wall = &s->lane->world->wall[-1 - r->a];
    if (wall->ends && fabs(fabs(wall->nx * r->nx + wall->ny * r->ny) - 1) > 1e-9) return; /* at a corner */
    tr_arc_wall(r, &x, &y);
    tr_point p = tr_stage_point(s, r->x, r->y), q = tr_stage_point(s, x, y), n = tr_stage_turned(s, r->nx, r->ny);
    if (!tr_frame_seen(p, 1) || !tr_frame_seen(q, 1) || !(hypot(q.x - p.x, q.y - p.y) > 3)) return;
    p.x -= under * n.x, q.x -= under * n.x;
    p.y += under * n.y, q.y += under * n.y;
    tr_pen_hue(s->cr, TR_ARC_A);
    if (label) {
        if (r->R2 * s->map.scale > 40)
            label_arc(s->cr, (tr_point){(p.x + q.x) / 2 - 22 * n.x, (p.y + q.y) / 2 + 22 * n.y}, label, TR_ARC_A);
        return;
    }
    tr_pen_line(s->cr, p, q, width);
    tr_pen_dot(s->cr, q, 0.8 * width);
}

static void draw_arcs(const tr_stage *s, bool labels) {
    int n;
    const tr_record *record = tr_show_records(s->lane, &n);
    for (int i = 0; i < n && i < TR_SHOW_CONTACTS; i++) {
        const tr_record *r = &record[i];
        int depth_a = 0, depth_b = 0; /* earlier contacts on the same disks */
        for (int k = 0; k < i; k++) {
            depth_a += record[k].a == r->a || record[k].b == r->a;
            depth_b += record[k].a == r->b || record[k].b == r->b;
        }
        tr_arc a, b;
        tr_arc_angles(r, &a, &b);
        if (r->a >= 0)
            draw_arc(s, r->a, a, depth_a, labels ? "Δa" : NULL, TR_ARC_A);
        else
            draw_wall_arc(s, r, labels ? "Δa" : NULL);
        draw_arc(s, r->b, b, depth_b, labels ? "Δb" : NULL, TR_ARC_B);
    }
}

static void draw_contacts(const tr_stage *s) {
    for (int i = 0; i < s->lane->n_records; i++) {
        const tr_record *r = &s->lane->record[i];
        tr_point p = tr_stage_point(s, r->x, r->y);
        double smaller = tr_world_smaller(r->R1, r->R2), dot = between(3, 0.2 * smaller * s->map.scale, 8);
        if (!tr_frame_seen(p, 1)) continue;
        tr_lamp_dot(s->cr, p, dot, tr_lamp_of(s->lane->world, r, s->range));
    }
}

static double limited(double u) {
    return isfinite(u) ? between(-1, u, 1) : 0;
}

/* Longest arrows: a straight one of a quarter of the stage, a curved one of 300 degrees. The straight one starts at the
 * rim of the disk's number, which would hide a short one. */
static void draw_motion(const tr_stage *s, int i) {
    tr_point p;
    double r;
    if (!place(s, i, &p, &r)) return;
    const double *v = s->lane->world->disks.vel + tr_body(i), *x = s->lane->world->disks.pos + tr_body(i);
    const bool ring = is_ring(s, i), number = ring || r > 30;
    double turns = limited(v[2] * fabs(x[3]) / s->range) * (ring ? 0.25 : 1) * 5 * M_PI / 3;
    tr_pen_hue(s->cr, TR_PURPLE);
    tr_pen_arc(s->cr, p, ring ? r + band(s, i) + 10 : spin_radius(r), M_PI / 2, turns, between(2, 0.06 * r, 4), true);
    if (ring) p = around(p, r + 0.5 * band(s, i), M_PI / 2); /* its middle is that of others */
    double longest = fmax(0.25 * fmin(s->box.w, s->box.h), 60);
    double speed = hypot(v[0], v[1]), length = longest * limited(speed / s->range);
    double from = number ? badge : 0;
    tr_pen_hue(s->cr, TR_GREEN);
    if (speed > 0 && length > 0) {
        tr_point u = tr_stage_turned(s, v[0] / speed, v[1] / speed);
        tr_pen_arrow(s->cr, (tr_point){p.x + from * u.x, p.y - from * u.y},
                     (tr_point){p.x + (from + length) * u.x, p.y - (from + length) * u.y}, between(3, 0.1 * r, 5));
    }
    tr_pen_hue(s->cr, TR_INK);
    tr_pen_dot(s->cr, p, number ? badge : between(1.5, 0.1 * r, 4));
    if (!number) return;
    tr_pen_hue(s->cr, TR_WHITE);
    tr_pen_dot(s->cr, p, badge - 1.5);
    char text[16];
    snprintf(text, sizeof text, "%d", i);
    tr_pen_text(s->cr,
                (tr_text){.x = p.x, .y = p.y + 9, .size = 24, .bold = true, .align = TR_CENTRE, .room = 2 * badge - 6},
                text);
}

void tr_stage_draw(const tr_stage *s) {
    const int n = s->lane->world->disks.n;
    cairo_save(s->cr);
    cairo_rectangle(s->cr, s->box.x, s->box.y, s->box.w, s->box.h);
    cairo_clip(s->cr);
    tr_ground_walls(s);
    for (int i = 0; i < n; i++) is_ring(s, i) ? draw_ring(s, i) : draw_disk(s, i);
    tr_ground_trace(s);
    for (int i = 0; i < n; i++) is_ring(s, i) ? draw_ring_ticks(s, i) : draw_ticks(s, i);
    draw_arcs(s, false);
    tr_marks_draw(s);
    tr_marks_sliding(s);
    draw_contacts(s);
    for (int i = 0; i < n; i++) draw_motion(s, i);
    for (int i = 0; i < n; i++) draw_pull(s, i);
    draw_arcs(s, true);
    tr_ground_slope(s);
    cairo_restore(s->cr);
}
