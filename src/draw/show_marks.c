/* SPDX-License-Identifier: MIT */
/* A rubbed trace is a band of short strokes along the rim; a tick has a number, and the tick with the same number on
 * the other rim was laid at the same time: while the contact rolls the two mesh. */
#include "draw/show_marks.h"

#include "draw/show_class.h"
#include "draw/show_lamp.h"

#include <math.h>
#include <stdio.h>

double tr_marks_width(double radius) {
    return fmin(fmax(0.09 * radius, 3), 9);
}

static double sane(double x) {
    return isfinite(x) && fabs(x) < 1e6 ? x : 0;
}

/* A way along the surface of a body: on a disk an arc about `centre`, on a wall a line. */
typedef struct tr_surface {
    bool disk;
    tr_point centre, along, normal; /* of a wall: its point, along it, and out of it, y down */
    double radius, turned;          /* [px, rad]; of a wall: pixels of a metre, 0 */
} tr_surface;

static bool surface_of(const tr_stage *s, int body, tr_surface *u) {
    const tr_world *world = s->lane->world;
    if (body >= 0 && body < world->disks.n) {
        const double *x = world->disks.pos + tr_body(body);
        *u = (tr_surface){.disk = true, .centre = tr_stage_point(s, x[0], x[1])};
        u->radius = x[3] * s->map.scale, u->turned = x[2] + s->tilt;
        return tr_frame_seen(u->centre, u->radius) && isfinite(u->turned);
    }
    if (body >= 0 || -1 - body >= world->n_walls) return false;
    const tr_wall *w = &world->wall[-1 - body];
    tr_point n = tr_stage_turned(s, w->nx, w->ny);
    *u = (tr_surface){false, tr_stage_point(s, w->x, w->y), {n.y, n.x}, {n.x, -n.y}, s->map.scale, 0};
    return isfinite(u->centre.x) && isfinite(u->centre.y);
}

/* The point at `at` of the surface, `out` px above it. */
static tr_point on(const tr_surface *u, double at, double out) {
    if (u->disk) {
        double angle = at + u->turned;
        return (tr_point){u->centre.x + (u->radius + out) * cos(angle), u->centre.y - (u->radius + out) * sin(angle)};
    }
    double d = at * u->radius;
    return (tr_point){u->centre.x + d * u->along.x + out * u->normal.x,
                      u->centre.y + d * u->along.y + out * u->normal.y};
}

static void draw_rubbed(const tr_stage *s, const tr_surface *u, const tr_rim_mark *m) {
    static const double strokes[] = {3.5, 2.5};
    double from = sane(m->from), to = sane(m->to), least = 6 / u->radius; /* one place, rubbed all along, is seen too */
    if (to - from < least) from = (from + to - least) / 2, to = from + least;
    tr_pen_hue(s->cr, TR_SLIDES);
    cairo_set_dash(s->cr, strokes, 2, 0);
    if (u->disk) {
        double w = tr_marks_width(u->radius);
        tr_pen_arc(s->cr, u->centre, u->radius - w / 2, from + u->turned, fmin(to - from, 2 * M_PI), w, false);
    } else {
        tr_point p = on(u, from, -7), q = on(u, to, -7);
        if (tr_frame_seen(p, 1) && tr_frame_seen(q, 1)) tr_pen_line(s->cr, p, q, 9);
    }
    cairo_set_dash(s->cr, NULL, 0, 0);
}

/* Nothing else is there: no other disk, no contact, nor the edge of the stage. */
static bool is_free(const tr_stage *s, const tr_surface *u, tr_point p) {
    const double half = 0.6 * TR_CLASS_TYPE;
    for (int i = 0; i < s->lane->n_records && u->disk; i++) {
        tr_point q = tr_stage_point(s, s->lane->record[i].x, s->lane->record[i].y);
        if (hypot(p.x - q.x, p.y - q.y) < 2.2 * half) return false;
    }
    for (int w = 0; w < s->lane->world->n_walls && u->disk; w++) {
        tr_surface wall;
        if (surface_of(s, -1 - w, &wall) &&
            (p.x - wall.centre.x) * wall.normal.x + (p.y - wall.centre.y) * wall.normal.y < half)
            return false;
    }
    for (int i = 0; i < s->lane->world->disks.n; i++) {
        tr_surface disk;
        if (surface_of(s, i, &disk) && hypot(p.x - disk.centre.x, p.y - disk.centre.y) < disk.radius + half)
            return false;
    }
    return p.x > s->box.x + half && p.x < s->box.x + s->box.w - half && p.y > s->box.y + half &&
           p.y < s->box.y + s->box.h - half;
}

static void draw_tick(const tr_stage *s, const tr_surface *u, const tr_rim_mark *m) {
    double at = sane(m->to), length = u->disk ? fmin(fmax(0.12 * u->radius, 4), 11) : 11;
    tr_point p = on(u, at, u->disk ? -0.5 * length : -length - 3), q = on(u, at, u->disk ? length : 0);
    if (!tr_frame_seen(p, 1) || !tr_frame_seen(q, 1)) return;
    tr_pen_hue(s->cr, TR_ROLLS);
    tr_pen_line(s->cr, p, q, 4);
    double apart = m->apart * s->map.scale, every = apart > 0 ? ceil((u->disk ? 56 : 44) / apart) : 1;
    if ((u->disk && u->radius < 45) || fmod(m->number, every) != 0) return; /* else numbers would run into each other */
    char number[16];
    snprintf(number, sizeof number, "%d", m->number);
    p = on(u, at, u->disk ? length + 0.62 * TR_CLASS_TYPE : -length - 3 - 0.6 * TR_CLASS_TYPE);
    if (!is_free(s, u, p)) return;
    tr_text text = {.x = p.x, .y = p.y + 0.36 * TR_CLASS_TYPE, .size = TR_CLASS_TYPE, .hue = TR_ROLLS};
    text.align = TR_CENTRE, text.bold = true;
    tr_pen_text(s->cr, text, number);
}

void tr_marks_draw(const tr_stage *s) {
    for (int ticks = 0; ticks < 2; ticks++)
        for (int i = 0; i < s->lane->n_marks; i++) {
            const tr_rim_mark *m = &s->lane->mark[i];
            tr_surface u;
            if ((m->number > 0) != ticks || !surface_of(s, m->body, &u)) continue;
            if (ticks)
                draw_tick(s, &u, m);
            else
                draw_rubbed(s, &u, m);
        }
}

void tr_marks_sliding(const tr_stage *s) {
    for (int i = 0; i < s->lane->n_records; i++) {
        const tr_record *r = &s->lane->record[i];
        if (!(tr_lamp_of(s->lane->world, r, s->range) & TR_LAMP_SLIDES)) continue;
        tr_point p = tr_stage_point(s, r->x, r->y), n = tr_stage_turned(s, r->nx, r->ny);
        if (!tr_frame_seen(p, 1) || !isfinite(n.x) || !isfinite(n.y)) continue;
        double smaller = (r->a >= 0 ? fmin(r->R1, r->R2) : r->R2) * s->map.scale,
               half = fmin(fmax(0.5 * smaller, 14), 34);
        for (int body = -1; body <= 1; body += 2) {
            double way = (r->v_s_by[0] > 0 ? half : -half) * body, off = 11 * body;
            tr_point c = {p.x + off * n.x, p.y - off * n.y}, t = {n.y * way, n.x * way}; /* t = (n_y, -n_x), y down */
            tr_point from = {c.x - t.x, c.y - t.y}, to = {c.x + t.x, c.y + t.y};
            tr_pen_hue(s->cr, TR_WHITE); /* an edge, to be seen on whatever lies below */
            tr_pen_line(s->cr, from, to, 10);
            tr_pen_hue(s->cr, TR_SLIDES);
            tr_pen_arrow(s->cr, from, to, 5);
        }
    }
}
