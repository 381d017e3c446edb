/* SPDX-License-Identifier: MIT */
#include "core/wall.h"

#include "base/math.h"
#include <math.h>

/* Along and away from a wall: u along t = (ny, -nx), h along n. */
typedef struct place {
    double u, h;
} place;

static place place_of(const tr_wall *w, const double *pos) {
    double dx = pos[0] - w->x, dy = pos[1] - w->y;
    return (place){dx * w->ny - dy * w->nx, dx * w->nx + dy * w->ny};
}

static bool is_over_face(const tr_wall *w, double u) {
    return !w->ends || (u > w->from && u < w->to);
}

static double nearer_end(const tr_wall *w, double u) {
    return u <= w->from ? w->from : w->to;
}

tr_wall_touch tr_wall_nearest(const tr_wall *w, const double *pos) {
    place p = place_of(w, pos);
    if (!w->ends) return (tr_wall_touch){p.h, w->nx, w->ny, false};
    if (is_over_face(w, p.u)) {
        double side = p.h < 0 ? -1 : 1;
        return (tr_wall_touch){fabs(p.h), side * w->nx, side * w->ny, false};
    }
    double along = p.u - nearer_end(w, p.u), distance = tr_hypot(along, p.h);
    if (!(distance > 0)) return (tr_wall_touch){0, w->nx, w->ny, true};
    double t = along / distance, n = p.h / distance;
    return (tr_wall_touch){distance, t * w->ny + n * w->nx, -t * w->nx + n * w->ny, true};
}

bool tr_wall_taken(const tr_world *world, int w, const double *pos) {
    const tr_wall *wall = &world->wall[w];
    double end = nearer_end(wall, place_of(wall, pos).u);
    const double corner[] = {wall->x + end * wall->ny, wall->y - end * wall->nx};
    for (int k = 0; k < world->n_walls; k++) {
        const tr_wall *other = &world->wall[k];
        place at = place_of(other, corner), disk = place_of(other, pos);
        double rounding = 1e-9 * pos[3]; /* places of corners are made of decimal numbers */
        if (k == w || fabs(at.h) > rounding) continue;
        if (other->ends && (at.u < other->from - rounding || at.u > other->to + rounding)) continue;
        if (is_over_face(other, disk.u)) return true;
        if (k < w && fabs(nearer_end(other, disk.u) - at.u) <= rounding) return true;
    }
    return false;
}
