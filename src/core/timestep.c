/* SPDX-License-Identifier: MIT */
#include "core/timestep.h"
#include "base/math.h"

#include "core/cell.h"
#include "core/wall.h"
#include <math.h>
#include <string.h>

/* Inverse of the part of a body's mass and inertia for one contact. */
typedef struct share {
    double inv_m, inv_I;
} share;

/* The largest stable step with at most the stiffness w2 and the damping g per mass: dt^2 w2 + 2 dt g = 4, written
 * without cancellation. Infinite without both. */
static double mode_limit(double w2, double g) {
    return 4 / (g + sqrt(g * g + 4 * w2));
}

/* Sliding and rolling: their inverse masses, and their coupling. */
typedef struct tangential {
    double slide, roll, mixed;
} tangential;

/* The larger eigenvalue of f (slide) (slide)' + r (roll) (roll)': of stiffnesses, or of dashpots. */
static double larger(const tangential *t, double f, double r) {
    double p = f * t->slide, q = r * t->roll, both = sqrt(f * r) * t->mixed;
    return 0.5 * (p + q + sqrt((p - q) * (p - q) + 4 * both * both));
}

/* The cases of a rolling velocity: its partial derivatives at one direction of (s1, s2) within each half quadrant. This
 * finds all cases that change where a rim stops or where both run equally. Returns the number; equal neighbours count
 * once. */
enum { CASES = 8 };
static int cases_of(const tr_velocity_measure *definition, const tr_pair_bodies *b, double p1[CASES],
                    double p2[CASES]) {
    static const double s1[CASES] = {2, 1, -1, -2, -2, -1, 1, 2}, s2[CASES] = {1, 2, 2, 1, -1, -2, -2, -1};
    double R1[CASES], R2[CASES], g1[CASES];
    tr_tile tile;
    tile.n = CASES, tile.R1 = R1, tile.R2 = R2, tile.g1 = g1;
    for (int k = 0; k < CASES; k++) {
        R1[k] = b->R1, R2[k] = b->R2, g1[k] = b->R1 != 0 ? b->R1 / (b->R1 + b->R2) : 1;
        tile.s1[k] = s1[k], tile.s2[k] = s2[k], tile.w1[k] = tile.w2[k] = 0;
    }
    definition->partials(&tile, NULL);
    int n = 0;
    for (int k = 0; k < CASES; k++)
        if (n == 0 || tile.p1[k] != p1[n - 1] || tile.p2[k] != p2[n - 1]) p1[n] = tile.p1[k], p2[n] = tile.p2[k], n++;
    return n;
}

static double tangential_limit(const tr_pair_bodies *bodies, share one, share two, tr_stiffness f, tr_stiffness r) {
    /* V_s = Vt + r1 w1 + r2 w2 and V_r = l1 w1 - l2 w2 + e Vt */
    const double r1 = bodies->R1, r2 = bodies->R2;
    const double s = one.inv_m + two.inv_m, l1 = r.lever1, l2 = r.lever2, e = r.along;
    const tangential t = {.slide = s + r1 * r1 * one.inv_I + r2 * r2 * two.inv_I,
                          .roll = l1 * l1 * one.inv_I + l2 * l2 * two.inv_I + e * e * s,
                          .mixed = r1 * l1 * one.inv_I - r2 * l2 * two.inv_I + e * s};
    return mode_limit(larger(&t, f.k, r.k), larger(&t, f.c, r.c));
}

/* bodies.delta: the overlap to expect. */
static double contact_limit(const tr_group *g, tr_pair_bodies bodies, share one, share two) {
    const tr_group_law *spring = &g->laws[TR_NORMAL], *friction = &g->laws[TR_FRICTION],
                       *rolling = &g->laws[TR_ROLLING];
    tr_elastic there = spring->law->elastic(spring->par, bodies.R1, bodies.R2, bodies.delta);
    bodies.f_n = there.force, bodies.k_n = there.stiffness;
    tr_stiffness f = {0}, r = {0}, n = spring->law->stiffness(spring->par, &bodies);
    const double s = one.inv_m + two.inv_m;
    /* Equal to mode_limit except for the last bit, which would change every number of a chaotic sample. */
    double least = n.k > 0 && s > 0 ? (sqrt(n.c * n.c + 4 * n.k / s) - n.c) / n.k : mode_limit(0, n.c * s);
    if (friction->law->step) f = friction->law->stiffness(friction->par, &bodies);
    double p1[CASES] = {0}, p2[CASES] = {0};
    int cases = rolling->law->needs & TR_NEEDS_PARTIALS
                    ? cases_of(&tr_rolling_velocities[g->rolling_velocity], &bodies, p1, p2)
                    : 1;
    for (int k = 0; k < cases; k++) {
        bodies.p1 = p1[k], bodies.p2 = p2[k];
        if (rolling->law->step) r = rolling->law->stiffness(rolling->par, &bodies);
        least = fmin(least, tangential_limit(&bodies, one, two, f, r));
    }
    return least;
}

static double overlap(const tr_world *world, const tr_group *g, int i) {
    const double *q = world->disks.pos + tr_body(g->b[i]);
    if (g->walls) return q[3] - tr_wall_distance(&world->wall[g->a[i]], q);
    const double *p = world->disks.pos + tr_body(g->a[i]);
    if (g->rings) return -tr_world_gap(p, q);
    return p[3] + q[3] - tr_cell_distance(&world->cell, p, q, NULL);
}

tr_timestep_limit tr_timestep_contacts(const tr_world *world) {
    tr_timestep_limit limit = {.dt = INFINITY};
    const tr_disks *d = &world->disks;
    int wall_z[TR_MAX_WALLS] = {0}, *z = d->coordination;
    memset(z, 0, (size_t)d->n * sizeof *z);
    for (int k = 0; k < world->n_groups; k++) {
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
    for (int k = 0; k < world->n_groups; k++) {
        const tr_group *g = &world->group[k];
        for (int i = 0; i < g->n; i++) {
            if (!(overlap(world, g, i) > 0)) continue;
            size_t a = (size_t)g->a[i], b = (size_t)g->b[i];
            const tr_wall *wall = &world->wall[g->walls ? a : 0];
            tr_pair_bodies bodies = tr_world_pair(world, g, g->a[i], g->b[i]);
            bodies.delta = overlap(world, g, i);
            share two = {z[b] * d->inv[tr_body(b)], z[b] * d->inv[tr_body(b) + TR_TURN]};
            share one = {wall->mass > 0 ? wall_z[a < TR_MAX_WALLS ? a : 0] / wall->mass : 0, 0};
            if (!g->walls) one = (share){z[a] * d->inv[tr_body(a)], z[a] * d->inv[tr_body(a) + TR_TURN]};
            double dt = contact_limit(g, bodies, one, two);
            if (dt < limit.dt) limit = (tr_timestep_limit){dt, k, i};
        }
    }
    return limit;
}

/* As many contacts as fit around disk i: the smallest disks side by side, and no more bodies than there are. If
 * overlaps up to q of the smaller radius r are allowed: neighbours are no further away than R + r, their distances from
 * it differ by q r or less, and that between them is 2r - q r or more, so that sin^2 of half the angle between them is
 * ((2-q)^2 - q^2) r^2/(4 (R+r)^2) or more. */
static double most_contacts(const tr_world *world, int i, double r_min, double q) {
    double R = world->disks.pos[tr_body(i) + TR_RADIUS];
    if (i < world->n_rings) return world->disks.n - world->n_rings;
    double fit = floor(M_PI / tr_asin(sqrt(1 - q) * r_min / (R + r_min)) + 1e-9);
    if (q > 0 && !world->boxed) fit += world->n_walls + world->n_rings; /* which may be in one place */
    return fmin(fit, world->disks.n - 1 + world->n_walls);
}

/* Allowed packings. */
typedef struct packings {
    double overlap; /* of the smaller radius, expected in a contact */
    double q;       /* the same, at most, for the number of contacts that fit */
    double r_min;
    const int *z; /* most contacts of each disk; NULL: not counted yet */
} packings;

static share share_of(const tr_world *world, int i, const packings *p) {
    const double *inv = world->disks.inv + tr_body(i);
    double z = p->z ? p->z[i] : most_contacts(world, i, p->r_min, p->q);
    return (share){z * inv[0], z * inv[2]};
}

static double pair_limit(const tr_world *world, int i, int j, const packings *p) {
    const tr_group *g = tr_world_group(world, i);
    tr_pair_bodies bodies = tr_world_pair(world, g, i, j);
    bodies.delta = p->overlap * tr_world_smaller(bodies.R1, bodies.R2);
    return contact_limit(g, bodies, share_of(world, i, p), share_of(world, j, p));
}

/* wall: the share of the wall that disk i touches, of those of one group. */
static double wall_limit(const tr_world *world, const tr_group *g, int i, share wall, const packings *p) {
    tr_pair_bodies bodies = tr_world_pair(world, g, 0, i);
    bodies.delta = p->overlap * bodies.R2;
    return contact_limit(g, bodies, wall, share_of(world, i, p));
}

/* The least of all walls. */
static double walls_limit(const tr_world *world, int i, share wall, const packings *p) {
    double bound = INFINITY;
    for (int k = 1; k < world->n_groups && world->n_walls; k++)
        if (world->group[k].walls) bound = fmin(bound, wall_limit(world, &world->group[k], i, wall, p));
    return bound;
}

static double smallest_radius(const tr_world *world, int *smallest, int *largest) {
    const tr_disks *d = &world->disks;
    *smallest = *largest = world->n_rings;
    for (int i = world->n_rings; i < d->n; i++) {
        if (d->pos[tr_body(i) + TR_RADIUS] < d->pos[tr_body(*smallest) + TR_RADIUS]) *smallest = i;
        if (d->pos[tr_body(i) + TR_RADIUS] > d->pos[tr_body(*largest) + TR_RADIUS]) *largest = i;
    }
    return d->pos[tr_body(*smallest) + TR_RADIUS];
}

/* For pistons with a known length: as many contacts as mean disks fit side by side. */
static share piston_share(const tr_world *world) {
    share piston = {0, 0};
    double diameters = 0;
    for (int i = 0; i < world->disks.n; i++) diameters += 2 * world->disks.pos[tr_body(i) + TR_RADIUS];
    for (int w = 0; w < world->n_walls; w++) {
        const tr_wall *wall = &world->wall[w];
        if (wall->mass > 0) piston.inv_m = fmax(piston.inv_m, wall->length * world->disks.n / (diameters * wall->mass));
    }
    return piston;
}

/* Each disk is paired with a wall, the smallest and the largest disk, and with all disks if there are at most `few`. */
static double all_limits(const tr_world *world, packings p, int few, share wall) {
    int n = world->disks.n, rings = world->n_rings, smallest, largest;
    double bound = INFINITY;
    p.r_min = smallest_radius(world, &smallest, &largest);
    int *z = world->disks.coordination; /* as room */
    for (int i = 0; i < n; i++) z[i] = (int)most_contacts(world, i, p.r_min, p.q);
    p.z = z;
    for (int i = rings; i < n; i++) {
        for (int a = 0; a < rings; a++) bound = fmin(bound, pair_limit(world, a, i, &p));
        if (n - rings > 1) {
            bound = fmin(bound, pair_limit(world, i, smallest, &p));
            bound = fmin(bound, pair_limit(world, i, largest, &p));
        }
        for (int j = i + 1; j < n && n <= few; j++) bound = fmin(bound, pair_limit(world, i, j, &p));
        bound = fmin(bound, walls_limit(world, i, wall, &p));
    }
    return bound;
}

double tr_timestep_worst(const tr_world *world) {
    return all_limits(world, (packings){.overlap = TR_EXPECTED_OVERLAP}, 1000, piston_share(world));
}

/* If all disks have one density and are free, the smallest and the largest are enough as partners, as in
 * tr_timestep_worst of many. */
static bool are_alike(const tr_world *world) {
    const tr_disks *d = &world->disks;
    if (world->n_rings) return false;
    double first = d->mass[0] / tr_pow(d->pos[3], world->shape == TR_SHAPE_SPHERE ? 3 : 2);
    for (int i = 0; i < d->n; i++) {
        double density = d->mass[i] / tr_pow(d->pos[tr_body(i) + TR_RADIUS], world->shape == TR_SHAPE_SPHERE ? 3 : 2);
        double whole =
            tr_law_inertia(world->shape) * d->mass[i] * d->pos[tr_body(i) + TR_RADIUS] * d->pos[tr_body(i) + TR_RADIUS];
        if (d->inv[tr_body(i)] == 0 || d->inv[tr_body(i) + TR_TURN] == 0 || fabs(density / first - 1) > 1e-9 ||
            fabs(d->inertia[i] / whole - 1) > 1e-9)
            return false;
    }
    return true;
}

bool tr_timestep_sure(tr_world *world) {
    packings p = {.overlap = TR_LARGEST_OVERLAP, .q = TR_LARGEST_OVERLAP};
    const tr_group *g = &world->group[1];
    int z[TR_MAX_WALLS] = {0}, smallest, largest;
    if (world->sure_dt == 0) world->sure_dt = all_limits(world, p, are_alike(world) ? 0 : 1000, (share){0, 0});
    if (world->dt > world->sure_dt) return false;
    bool pistons = false;
    for (int w = 0; w < world->n_walls; w++) pistons = pistons || world->wall[w].mass > 0;
    if (!pistons) return true;
    p.r_min = smallest_radius(world, &smallest, &largest);
    for (int i = 0; i < g->n; i++) z[g->a[i]]++;
    for (int i = 0; i < g->n; i++) {
        double mass = world->wall[g->a[i]].mass;
        if (mass > 0 && world->dt > wall_limit(world, g, g->b[i], (share){z[g->a[i]] / mass, 0}, &p)) return false;
    }
    return true;
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
