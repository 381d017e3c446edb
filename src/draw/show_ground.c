/* SPDX-License-Identifier: MIT */
/* Walls, the angle of a slope, and the path of the contact points. */

#include "draw/show_ground.h"

#include "draw/stage.h"

#include <math.h>
#include <stdio.h>

/* The part of a wall that is shown: its middle, way along it (y down), and half its length [px]. */
typedef struct tr_stretch {
    tr_point middle, along, normal;
    double from, to; /* from the wall's own point */
    tr_point origin;
} tr_stretch;

static bool stretch_of(const tr_stage *s, const tr_wall *wall, tr_stretch *w) {
    tr_point n = tr_stage_turned(s, wall->nx, wall->ny);
    w->origin = tr_stage_point(s, wall->x, wall->y);
    w->normal = (tr_point){n.x, -n.y};
    w->along = (tr_point){n.y, n.x};
    /* around the middle of the stage: the given point of an endless wall may be far away */
    double near =
        (s->box.x + s->box.w / 2 - w->origin.x) * w->along.x + (s->box.y + s->box.h / 2 - w->origin.y) * w->along.y;
    double reach = hypot(s->box.w, s->box.h);
    w->from = near - reach, w->to = near + reach;
    if (wall->length > 0) {
        double half = 0.5 * wall->length * s->map.scale;
        w->from = fmax(w->from, -half), w->to = fmin(w->to, half);
    }
    if (wall->ends) {
        w->from = fmax(w->from, wall->from * s->map.scale), w->to = fmin(w->to, wall->to * s->map.scale);
    }
    tr_point p = {w->origin.x + w->from * w->along.x, w->origin.y + w->from * w->along.y};
    return w->from < w->to && fabs(hypot(n.x, n.y) - 1) < 1e-6 && fabs(w->from) < 1e9 && tr_frame_seen(p, 1);
}

static tr_point on_wall(const tr_stretch *w, double u) {
    return (tr_point){w->origin.x + u * w->along.x, w->origin.y + u * w->along.y};
}

static void draw_wall(const tr_stage *s, const tr_wall *wall) {
    const double step = 26, depth = 12;
    tr_stretch w;
    if (!stretch_of(s, wall, &w)) return;
    tr_pen_hue(s->cr, TR_RIM);
    double time = (double)s->lane->world->steps * s->lane->world->dt;
    double moved = fmod(wall->belt * time * s->map.scale, step); /* the hatch of a belt goes along with it */
    for (double k = ceil((w.from - moved) / step); k * step + moved < w.to; k++) { /* on the far side */
        tr_point p = on_wall(&w, k * step + moved);
        cairo_move_to(s->cr, p.x, p.y);
        cairo_line_to(s->cr, p.x - depth * (w.normal.x + w.along.x), p.y - depth * (w.normal.y + w.along.y));
    }
    cairo_set_line_width(s->cr, 2);
    cairo_stroke(s->cr);
    tr_pen_hue(s->cr, TR_WALL);
    tr_pen_line(s->cr, on_wall(&w, w.from), on_wall(&w, w.to), 4);
}

/* Where walls have laws of their own, the friction of each, below the middle of what is seen of it and the names of
 * arcs. */
static void name_wall(const tr_stage *s, int i) {
    const tr_group_law *friction = &tr_world_group(s->lane->world, -1 - i)->laws[TR_FRICTION];
    const double *mu = friction->law->step ? tr_law_value(friction->law, friction->par, "mu") : NULL;
    tr_stretch w;
    char text[32];
    if (!stretch_of(s, &s->lane->world->wall[i], &w)) return;
    double left = s->box.x, right = s->box.x + s->box.w, from = w.from, to = w.to;
    if (fabs(w.along.x) > 0.1) { /* the part between the sides of the stage */
        double a = (left - w.origin.x) / w.along.x, b = (right - w.origin.x) / w.along.x;
        from = fmax(from, fmin(a, b)), to = fmin(to, fmax(a, b));
    }
    tr_point p = on_wall(&w, 0.5 * (from + to));
    snprintf(text, sizeof text, "μ = %.3g", mu ? *mu : 0);
    tr_text at = {.x = p.x - 62 * w.normal.x,
                  .y = p.y - 62 * w.normal.y + 8,
                  .size = 22,
                  .bold = true,
                  .halo = true,
                  .align = TR_CENTRE};
    if (to - from > tr_pen_width(s->cr, at, text)) tr_pen_text(s->cr, at, text);
}

void tr_ground_walls(const tr_stage *s) {
    const tr_world *world = s->lane->world;
    for (int i = 0; i < world->n_walls; i++) draw_wall(s, &world->wall[i]);
    for (int i = 0; i < world->n_walls && world->wall_laws; i++) name_wall(s, i);
}

void tr_ground_trace(const tr_stage *s) {
    static const double dots[] = {0, 8};
    bool down = false;
    for (int i = 0; i < s->lane->n_trace && s->lane->trace; i++) {
        tr_point p = tr_stage_point(s, s->lane->trace[2 * i], s->lane->trace[2 * i + 1]);
        bool seen = tr_frame_seen(p, 1);
        if (seen && down)
            cairo_line_to(s->cr, p.x, p.y);
        else if (seen)
            cairo_move_to(s->cr, p.x, p.y);
        down = seen;
    }
    cairo_set_line_cap(s->cr, CAIRO_LINE_CAP_ROUND);
    cairo_set_dash(s->cr, dots, 2, 0);
    tr_pen_hue(s->cr, TR_WHITE); /* a rim, visible on a floor */
    cairo_set_line_width(s->cr, 6);
    cairo_stroke_preserve(s->cr);
    tr_pen_hue(s->cr, TR_INK);
    cairo_set_line_width(s->cr, 3.5);
    cairo_stroke(s->cr);
    cairo_set_dash(s->cr, NULL, 0, 0);
    cairo_set_line_cap(s->cr, CAIRO_LINE_CAP_BUTT);
}

/* Where the floor comes in at its lower end with room for a number below, and which way is uphill. */
static bool find_slope(const tr_stage *s, double room, tr_point *foot, double *uphill) {
    double left = s->box.x + 12, right = s->box.x + s->box.w - 12, bottom = s->box.y + s->box.h - room;
    for (int i = 0; i < s->lane->world->n_walls; i++) {
        tr_stretch w;
        if (!stretch_of(s, &s->lane->world->wall[i], &w) || w.normal.y >= 0) continue;
        if (fabs(atan2(fabs(w.along.y), fabs(w.along.x)) - fabs(s->lane->slope)) > 1e-3) continue;
        double sign = w.along.y > 0 ? -1 : 1; /* uphill is along the wall, or against it */
        *uphill = sign * w.along.x > 0 ? 1 : -1;
        for (int u = 0; u < w.to - w.from; u++) { /* by pixels */
            *foot = on_wall(&w, sign > 0 ? w.from + u : w.to - u);
            if (foot->y < bottom && foot->x > left && foot->x < right) return true;
        }
    }
    return false;
}

/* Below the floor, free of bodies: a level line uphill, and the angle from it to the floor. Without room at the lower
 * end, only the number. */
void tr_ground_slope(const tr_stage *s) {
    const double size = 24, level = fmin(130, 0.25 * s->box.w), radius = 0.74 * level;
    if (!isfinite(s->lane->slope)) return;
    char number[32];
    snprintf(number, sizeof number, "%.1f°", fabs(s->lane->slope) * 180 / M_PI);
    tr_text at = {.size = size, .bold = true, .halo = true, .align = TR_CENTRE};
    tr_point p;
    double way;
    bool found = find_slope(s, size + 8, &p, &way);
    double from_end = found ? (way > 0 ? p.x - s->box.x : s->box.x + s->box.w - p.x) : 0;
    if (!found || from_end + level > 0.5 * s->box.w) {
        bool left = found && way > 0;
        at.x = left ? s->box.x + 8 : s->box.x + s->box.w - 8, at.y = s->box.y + size;
        at.align = left ? TR_LEFT : TR_RIGHT;
        tr_pen_text(s->cr, at, number);
        return;
    }
    tr_pen_hue(s->cr, TR_INK);
    tr_pen_line(s->cr, p, (tr_point){p.x + way * level, p.y}, 2);
    tr_pen_arc(s->cr, p, radius, way > 0 ? 0 : M_PI, way * fabs(s->lane->slope), 3, false);
    double half = 0.5 * tr_pen_width(s->cr, at, number) + 4; /* clear of both sides */
    at.x = fmin(fmax(p.x + way * 0.6 * level, s->box.x + half), s->box.x + s->box.w - half), at.y = p.y + size;
    tr_pen_text(s->cr, at, number);
}
