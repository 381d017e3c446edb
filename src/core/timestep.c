/* SPDX-License-Identifier: MIT */
#include "core/timestep.h"

#include "core/cell.h"
#include "core/contacts.h"
#include <math.h>
#include <string.h>

/* Inverse of the share of a body's mass and inertia that one contact gets. */
typedef struct share {
    double inv_m, inv_I;
} share;

/* bodies.delta: the overlap to expect. */
static double contact_limit(const tr_group *g, tr_pair_bodies bodies, share one, share two) {
    const tr_slot *spring = &g->slot[TR_NORMAL], *friction = &g->slot[TR_FRICTION], *rolling = &g->slot[TR_ROLLING];
    double r1 = bodies.R1, r2 = bodies.R2;
    tr_elastic there = spring->law->elastic(spring->par, r1, r2, bodies.delta);
    bodies.f_n = there.force, bodies.k_n = there.stiffness;
    tr_stiffness f = {0}, r = {0}, n = spring->law->stiffness(spring->par, &bodies);
    if (friction->law->step) f = friction->law->stiffness(friction->par, &bodies);
    if (rolling->law->step) r = rolling->law->stiffness(rolling->par, &bodies);

    double s = one.inv_m + two.inv_m;
    double normal = s > 0 ? (sqrt(n.c * n.c + 4 * n.k / s) - n.c) / n.k : INFINITY;

    /* V_s = Vt + r1 w1 + r2 w2 and V_r = l1 w1 - l2 w2 + e Vt: inverse masses along each, and what couples them. */
    double slide = f.k * (s + r1 * r1 * one.inv_I + r2 * r2 * two.inv_I);
    double spins = r.lever1 * r.lever1 * one.inv_I + r.lever2 * r.lever2 * two.inv_I;
    double roll = r.k * (spins + r.along * r.along * s);
    double mixed = sqrt(f.k * r.k) * (r1 * r.lever1 * one.inv_I - r2 * r.lever2 * two.inv_I + r.along * s);
    double w2 = 0.5 * (slide + roll + sqrt((slide - roll) * (slide - roll) + 4 * mixed * mixed));
    double tangential = w2 > 0 ? 2 / sqrt(w2) : INFINITY, damp = r.c * spins;
    if (damp > 0 && w2 > 0)
        tangential = (sqrt(damp * damp + 4 * w2) - damp) / w2; /* as if all of w2 were damped: cautious */
    return fmin(normal, tangential);
}

static double overlap(const tr_world *world, const tr_group *g, int i) {
    const double *q = world->disks.pos + 4 * (size_t)g->b[i];
    if (g->walls) return q[3] - tr_contacts_wall_distance(&world->wall[g->a[i]], q);
    const double *p = world->disks.pos + 4 * (size_t)g->a[i];
    return p[3] + q[3] - tr_cell_distance(&world->cell, p, q, NULL);
}

tr_timestep_limit tr_timestep_contacts(const tr_world *world) {
    tr_timestep_limit limit = {.dt = INFINITY};
    const tr_disks *d = &world->disks;
    int wall_z[TR_MAX_WALLS] = {0}, *z = d->coordination;
    memset(z, 0, (size_t)d->n * sizeof *z);
    for (int k = 0; k < 2; k++) {
        const tr_group *g = &world->group[k];
        for (int i = 0; i < g->n; i++) {
            if (!(overlap(world, g, i) > 0)) continue;
            z[g->b[i]]++;
            if (g->walls)
                wall_z[g->a[i]]++;
            else
                z[g->a[i]]++;
        }
    }
    for (int k = 0; k < 2; k++) {
        const tr_group *g = &world->group[k];
        for (int i = 0; i < g->n; i++) {
            if (!(overlap(world, g, i) > 0)) continue;
            size_t a = (size_t)g->a[i], b = (size_t)g->b[i];
            const tr_wall *wall = &world->wall[g->walls ? a : 0];
            tr_pair_bodies bodies = tr_world_pair(world, g, g->a[i], g->b[i]);
            bodies.delta = overlap(world, g, i);
            share two = {z[b] * d->inv[4 * b], z[b] * d->inv[4 * b + 2]};
            share one = {wall->mass > 0 ? wall_z[a < TR_MAX_WALLS ? a : 0] / wall->mass : 0, 0};
            if (!g->walls) one = (share){z[a] * d->inv[4 * a], z[a] * d->inv[4 * a + 2]};
            double dt = contact_limit(g, bodies, one, two);
            if (dt < limit.dt) limit = (tr_timestep_limit){dt, k, i};
        }
    }
    return limit;
}

/* As many contacts as fit around disk i: the smallest disks side by side, and no more bodies than there are. */
static double most_contacts(const tr_world *world, int i, double r_min) {
    double R = world->disks.pos[4 * (size_t)i + 3], kissing = floor(M_PI / asin(r_min / (R + r_min)) + 1e-9);
    return fmin(kissing, world->disks.n - 1 + world->n_walls);
}

static double pair_limit(const tr_world *world, int i, int j, double r_min) {
    const tr_disks *d = &world->disks;
    size_t a = 4 * (size_t)i, b = 4 * (size_t)j;
    double za = most_contacts(world, i, r_min), zb = most_contacts(world, j, r_min);
    tr_pair_bodies bodies = tr_world_pair(world, &world->group[0], i, j);
    bodies.delta = TR_EXPECTED_OVERLAP * fmin(bodies.R1, bodies.R2);
    return contact_limit(&world->group[0], bodies, (share){za * d->inv[a], za * d->inv[a + 2]},
                         (share){zb * d->inv[b], zb * d->inv[b + 2]});
}

double tr_timestep_worst(const tr_world *world) {
    const int few = 1000; /* so many disks are paired with each other; more, only with the smallest and the largest */
    const tr_disks *d = &world->disks;
    double bound = INFINITY;
    int smallest = 0, largest = 0;
    for (int i = 0; i < d->n; i++) {
        if (d->pos[4 * (size_t)i + 3] < d->pos[4 * (size_t)smallest + 3]) smallest = i;
        if (d->pos[4 * (size_t)i + 3] > d->pos[4 * (size_t)largest + 3]) largest = i;
    }
    double r_min = d->pos[4 * (size_t)smallest + 3];
    for (int i = 0; i < d->n; i++) {
        if (d->n > 1) {
            bound = fmin(bound, pair_limit(world, i, smallest, r_min));
            bound = fmin(bound, pair_limit(world, i, largest, r_min));
        }
        for (int j = i + 1; j < d->n && d->n <= few; j++) bound = fmin(bound, pair_limit(world, i, j, r_min));
        if (!world->n_walls) continue;
        double z = most_contacts(world, i, r_min), R = d->pos[4 * (size_t)i + 3];
        tr_pair_bodies wall = tr_world_pair(world, &world->group[1], 0, i);
        wall.delta = TR_EXPECTED_OVERLAP * R;
        share own = {z * d->inv[4 * (size_t)i], z * d->inv[4 * (size_t)i + 2]};
        bound = fmin(bound, contact_limit(&world->group[1], wall, (share){0, 0}, own));
    }
    return bound;
}

bool tr_timestep_choose(tr_world *world, const tr_scene_step *step, double fallback, double *bound, tr_status *st) {
    *bound = tr_timestep_worst(world);
    world->dt = step->dt > 0 ? step->dt : isinf(*bound) ? fallback : step->safety * *bound;
    world->allow_unstable = step->allow_unstable;
    if (world->dt <= *bound || step->allow_unstable) return true;
    return tr_status_fail(
        st, TR_BAD_CASE,
        "error: step.dt = %.4g s is above the stability bound %.4g s; give less, or step.allow_unstable: yes",
        world->dt, *bound);
}
