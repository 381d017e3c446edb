/* SPDX-License-Identifier: MIT */
#include "core/tangent.h"
#include "base/math.h"

#include "core/wall.h"
#include <math.h>

/* Of the smaller radius. Smaller overlaps come from rounding: 30 mm - 20 mm - 10 mm is 3e-18 m. Smaller gaps come from
 * rounded numbers: three disks in a ring have sqrt(3) in their places, with four digits in a case. */
static const double ROUNDED = 1e-9, WRITTEN = 1e-3;
static const double SMALL = 1e-6;  /* of a speed: allowance for the rounded direction of a place */
static const double LITTLE = 0.01; /* of the overlap that a weight needs */

/* Two bodies at the start: body 1 is a disk or a wall, the normal is from 1 to 2. */
typedef struct pair {
    int a, b; /* a < 0: wall -1-a */
    double R1, R2, nx, ny, gap;
} pair;

static pair pair_of(const tr_world *w, int a, int b) {
    const double *q = w->disks.pos + tr_body(b);
    if (a < 0) {
        const tr_wall *wall = &w->wall[-1 - a];
        tr_wall_touch touch = tr_wall_nearest(wall, q);
        return (pair){a, b, 0, q[3], touch.nx, touch.ny, touch.distance - q[3]};
    }
    const double *p = w->disks.pos + tr_body(a), dx = q[0] - p[0], dy = q[1] - p[1],
                 L = copysign(sqrt(dx * dx + dy * dy), p[3]);
    return (pair){a, b, p[3], q[3], dx / L, dy / L, tr_world_gap(p, q)};
}

static double smaller(const pair *p) {
    return tr_world_smaller(p->R1, p->R2);
}

static bool is_free(const tr_world *w, int i) {
    return i >= 0 && w->disks.inv[tr_body(i)] > 0;
}

/* A spin that follows from moments. */
static bool may_turn(const tr_world *w, int i) {
    return i >= 0 && w->disks.inv[tr_body(i) + TR_TURN] > 0;
}

/* Whether a disk or a wall below, as near as a contact, keeps disk i from falling. */
static bool is_carried(const tr_world *w, int i, const double g[2]) {
    for (int a = -w->n_walls; a < w->disks.n && i >= w->n_rings; a++) {
        if (a == i) continue;
        pair p = pair_of(w, a, i);
        if (g[0] * p.nx + g[1] * p.ny < 0 && p.gap < WRITTEN * smaller(&p)) return true;
    }
    return false;
}

/* The part of the weight of the upper body that presses the two together [N/m]. A falling body carries nothing. */
static double weight_on(const tr_bodies *b, const pair *p) {
    const tr_world *w = &b->world;
    double g[2];
    tr_bodies_gravity(b, g);
    double along = g[0] * p->nx + g[1] * p->ny; /* below 0: down is from 2 to 1 */
    int upper = along < 0 ? p->b : p->a, lower = along < 0 ? p->a : p->b;
    if (fabs(along) <= SMALL * tr_hypot(g[0], g[1]) || !is_free(w, upper) ||
        (is_free(w, lower) && !is_carried(w, lower, g)))
        return 0;
    return fabs(along) / w->disks.inv[tr_body(upper)];
}

/* The relative motion of the two, then the spins of 1 and 2. */
static void motion_of(const tr_bodies *b, const pair *p, double *across, double *along, double spin[2]) {
    double v1[3], v2[3];
    tr_bodies_velocity(&b->world, p->b, v2);
    if (p->a >= 0) {
        tr_bodies_velocity(&b->world, p->a, v1);
    } else {
        const tr_wall *wall = &b->world.wall[-1 - p->a];
        v1[0] = wall->vx + wall->belt * p->ny, v1[1] = wall->vy - wall->belt * p->nx, v1[2] = 0;
    }
    double dvx = v2[0] - v1[0], dvy = v2[1] - v1[1];
    *along = dvx * p->nx + dvy * p->ny, *across = dvx * p->ny - dvy * p->nx;
    spin[0] = v1[2], spin[1] = v2[2];
}

/* The advice: the disk to move along the normal, and its place. */
static tr_tangent describe(const tr_bodies *b, const pair *p, double weight) {
    const tr_world *w = &b->world;
    const tr_group_law *normal = &tr_world_group(w, p->a)->laws[TR_NORMAL];
    tr_tangent t = {.a = p->a, .b = p->b, .gap = p->gap, .weight = weight > 0, .force = weight};
    t.overlap = TR_TINY_OVERLAP * smaller(p);
    if (t.weight)
        t.overlap = normal->law->overlap(normal->par, p->R1, p->R2, weight);
    else
        t.force = normal->law->elastic(normal->par, p->R1, p->R2, t.overlap).force;
    bool first = is_free(w, p->a) && !is_free(w, p->b);
    t.moved = first ? p->a : p->b;
    const double *at = w->disks.pos + tr_body(t.moved), way = (first ? 1 : -1) * (t.overlap + p->gap);
    t.x = at[0] + way * p->nx, t.y = at[1] + way * p->ny;
    return t;
}

static bool is_tangent(const tr_bodies *b, const pair *p, double *weight) {
    const tr_world *w = &b->world;
    double R = smaller(p), across, along, spin[2];
    *weight = 0;
    if (!(p->gap > -R && p->gap < WRITTEN * R)) return false;
    motion_of(b, p, &across, &along, spin);
    if (fabs(along) > SMALL * fabs(across)) return false; /* they meet, or part */
    *weight = weight_on(b, p);
    if (*weight > 0) {
        const tr_group_law *normal = &tr_world_group(w, p->a)->laws[TR_NORMAL];
        double needs = normal->law->overlap(normal->par, p->R1, p->R2, *weight);
        return p->gap > -LITTLE * needs &&
               p->gap < fmax(needs, ROUNDED * R); /* a fall from at most this height is not intended */
    }
    bool held = !is_free(w, p->a) && !is_free(w, p->b), turned = may_turn(w, p->a) || may_turn(w, p->b);
    return p->gap > -ROUNDED * R && (across != 0 || spin[0] != 0 || spin[1] != 0 || (held && turned));
}

bool tr_tangent_find(const tr_bodies *b, tr_tangent *found) {
    const tr_world *w = &b->world;
    int n = 0;
    for (int i = w->n_rings; i < w->disks.n; i++)
        for (int a = -w->n_walls; a < i; a++) {
            pair p = pair_of(w, a, i);
            double weight;
            if (is_tangent(b, &p, &weight) && n++ == 0) *found = describe(b, &p, weight);
        }
    if (n) found->more = n - 1;
    return n > 0;
}
