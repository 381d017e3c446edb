/* SPDX-License-Identifier: MIT */
#include "core/resolution.h"
#include "base/math.h"

#include "core/timestep.h"
#include "core/wall.h"
#include <math.h>
#include <stdio.h>

/* From |x| to the next double [m]. */
static double spacing(double x) {
    x = fabs(x);
    return nextafter(x, INFINITY) - x;
}

static bool is_free(const tr_world *w, int i) {
    return w->disks.inv[tr_body(i)] > 0;
}

/* Duration of the run [s]; gravity, and its part along which bodies may fall: walls take the normal part, and held
 * disks carry [m/s^2]. */
typedef struct run {
    const tr_bodies *b;
    double T, gravity, fall[2];
} run;

static run run_of(const tr_bodies *b, bool start) {
    const tr_world *w = &b->world;
    run r = {.b = b, .T = start ? 0 : (double)b->steps * w->dt};
    double *g = r.fall;
    tr_bodies_gravity(b, g);
    r.gravity = tr_hypot(g[0], g[1]);
    for (int i = 0; i < w->disks.n; i++)
        if (!is_free(w, i)) g[0] = g[1] = 0;
    for (int k = 0; k < w->n_walls; k++) {
        const tr_wall *wall = &w->wall[k];
        double into = g[0] * wall->nx + g[1] * wall->ny;
        if (into < 0 && !wall->ends) g[0] -= into * wall->nx, g[1] -= into * wall->ny;
    }
    return r;
}

/* The largest |x| and |y| that disk i may reach. A spin may turn into a velocity along a wall. */
static void disk_reach(const run *r, int i, double reach[2]) {
    const tr_world *w = &r->b->world;
    const tr_scene_disk *d = &r->b->scene->disks[i];
    const double centre[2] = {d->orbit_x, d->orbit_y}, at[2] = {d->x, d->y}, T = r->T;
    double v[3];
    tr_bodies_velocity(w, i, v);
    for (int k = 0; k < 2; k++) {
        reach[k] = fabs(at[k]) + fabs(v[k]) * T + (is_free(w, i) ? 0.5 * fabs(r->fall[k]) * T * T : 0);
        if (d->motion == TR_ORBIT) reach[k] = fabs(centre[k]) + tr_hypot(at[0] - centre[0], at[1] - centre[1]);
    }
    for (int k = 0; k < w->n_walls && v[2] != 0 && is_free(w, i); k++) {
        reach[0] += fabs(w->wall[k].ny * v[2]) * d->radius * T;
        reach[1] += fabs(w->wall[k].nx * v[2]) * d->radius * T;
    }
}

static void wall_reach(const run *r, int wall, double reach[2]) {
    const tr_wall *w = &r->b->world.wall[wall];
    reach[0] = fabs(w->x) + fabs(w->vx) * r->T, reach[1] = fabs(w->y) + fabs(w->vy) * r->T;
}

/* Two bodies (a < 0: wall -1-a) and the known data of their contact. */
typedef struct pair {
    int a, b;
    double R1, R2, gap, velocity; /* relative [m/s] */
    double reach;                 /* of what makes up the overlap [m] */
} pair;

static double smaller(const pair *p) {
    return tr_world_smaller(p->R1, p->R2);
}

static pair wall_pair(const run *r, int wall, int i) {
    const tr_wall *w = &r->b->world.wall[wall];
    const double *q = r->b->world.disks.pos + tr_body(i);
    pair p = {.a = -1 - wall, .b = i, .R2 = q[3], .gap = tr_wall_distance(w, q) - q[3]};
    tr_wall_touch touch = tr_wall_nearest(w, q);
    double v[3], one[2], two[2];
    tr_bodies_velocity(&r->b->world, i, v);
    disk_reach(r, i, two);
    wall_reach(r, wall, one);
    p.velocity = fabs((v[0] - w->vx) * touch.nx + (v[1] - w->vy) * touch.ny);
    p.reach = fmax(fabs(touch.nx) * fmax(one[0], two[0]), fabs(touch.ny) * fmax(one[1], two[1]));
    return p;
}

static pair pair_of(const run *r, int a, int i) {
    if (a < 0) return wall_pair(r, -1 - a, i);
    const double *c = r->b->world.disks.pos + tr_body(a), *q = r->b->world.disks.pos + tr_body(i);
    pair p = {.a = a, .b = i, .R1 = c[3], .R2 = q[3], .gap = tr_world_gap(c, q)};
    double v1[3], v2[3], one[2], two[2];
    tr_bodies_velocity(&r->b->world, a, v1);
    tr_bodies_velocity(&r->b->world, i, v2);
    disk_reach(r, a, one);
    disk_reach(r, i, two);
    p.velocity = tr_hypot(v2[0] - v1[0], v2[1] - v1[1]);
    p.reach = fmax(fmax(one[0], one[1]), fmax(two[0], two[1]));
    return p;
}

/* The weight of the lighter [N/m] and the energy of a blow of the two [N]; false: they never meet. */
static bool loads(const run *r, const pair *p, double *weight, double *energy) {
    const tr_disks *d = &r->b->world.disks;
    double inv_a = p->a < 0 ? 0 : d->inv[tr_body(p->a)], inv_b = d->inv[tr_body(p->b)], v = p->velocity;
    double g = inv_a + inv_b > 0 ? r->gravity : 0;
    *weight = g > 0 ? g / fmax(inv_a, inv_b) : 0;
    *energy = inv_a + inv_b > 0 ? 0.5 * (v * v + 2 * g * fmax(p->gap, 0)) / (inv_a + inv_b) : 0;
    return p->gap <= v * r->T + 0.5 * g * r->T * r->T;
}

/* Whether the pair reaches this overlap. */
static bool gets_to(const tr_bodies *b, const pair *p, double overlap, double weight, double energy) {
    const tr_group_law *normal = &tr_world_group(&b->world, p->a)->laws[TR_NORMAL];
    if (p->gap <= -overlap) return true;
    if (overlap > TR_LARGEST_OVERLAP * smaller(p)) return false;
    if (p->gap > -4 * spacing(p->reach) && weight == 0 && energy == 0) /* 0, to rounding */
        return overlap <= TR_EXPECTED_OVERLAP * smaller(p);
    tr_elastic e = normal->law->elastic(normal->par, p->R1, p->R2, overlap);
    return (weight > 0 && e.force <= weight) || (energy > 0 && e.energy <= energy);
}

/* The largest overlap that it reaches, by bisection of its logarithm. */
static double expected(const tr_bodies *b, const pair *p, double weight, double energy) {
    double low = tr_log(1e-30 * smaller(p)), high = tr_log(TR_LARGEST_OVERLAP * smaller(p));
    if (gets_to(b, p, tr_exp(high), weight, energy)) return tr_exp(high);
    for (int k = 0; k < 60; k++) {
        double middle = 0.5 * (low + high);
        if (gets_to(b, p, tr_exp(middle), weight, energy))
            low = middle;
        else
            high = middle;
    }
    return tr_exp(low);
}

bool tr_resolution_overlap(const tr_bodies *b, tr_resolution *worst) {
    const tr_world *w = &b->world;
    const run r = run_of(b, false);
    int n = 0;
    for (int i = w->n_rings; i < w->disks.n; i++)
        for (int a = -w->n_walls; a < i; a++) {
            pair p = pair_of(&r, a, i);
            double weight, energy, needed = spacing(p.reach) / TR_RESOLVED;
            if (!loads(&r, &p, &weight, &energy) || gets_to(b, &p, needed, weight, energy)) continue;
            tr_resolution now = {a, i, p.reach, spacing(p.reach), expected(b, &p, weight, energy), 0};
            if (n++ == 0 || now.spacing / now.size > worst->spacing / worst->size) *worst = now;
        }
    if (n) worst->more = n - 1;
    return n > 0;
}

/* x + v dt, rounded, is off by half a spacing at most. */
static void check_way(const tr_bodies *b, int body, const double reach[2], const double v[2], int *n,
                      tr_resolution *worst) {
    double far = fmax(reach[0], reach[1]), way = tr_hypot(v[0], v[1]) * b->world.dt;
    if (way == 0 || 0.5 * spacing(far) <= TR_RESOLVED * way) return;
    tr_resolution r = {body, body, far, spacing(far), way, 0};
    if ((*n)++ == 0 || r.spacing / r.size > worst->spacing / worst->size) *worst = r;
}

bool tr_resolution_way(const tr_bodies *b, tr_resolution *worst) {
    const tr_world *w = &b->world;
    const run r = run_of(b, false);
    double reach[2], v[3];
    int n = 0;
    for (int i = 0; i < w->disks.n; i++) {
        if (b->scene->disks[i].motion == TR_ORBIT) continue; /* its place follows from the time */
        disk_reach(&r, i, reach);
        tr_bodies_velocity(w, i, v);
        check_way(b, i, reach, v, &n, worst);
    }
    for (int k = 0; k < w->n_walls; k++) {
        const double of_wall[2] = {w->wall[k].vx, w->wall[k].vy};
        wall_reach(&r, k, reach);
        check_way(b, -1 - k, reach, of_wall, &n, worst);
    }
    if (n) worst->more = n - 1;
    return n > 0;
}

bool tr_resolution_biaxial(const tr_biaxial *b, tr_resolution *found) {
    const tr_group_law *normal = &b->world.group[0].laws[TR_NORMAL];
    double R = b->mean_radius, P = 2 * R * fmin(b->scene->compaction.pressure, b->scene->shear.lateral_pressure);
    double side = fmax(b->world.wall[TR_TOP_WALL].y, b->world.cell.side[1]);
    *found =
        (tr_resolution){.reach = side, .spacing = spacing(side), .size = normal->law->overlap(normal->par, R, R, P)};
    return found->spacing > TR_RESOLVED * found->size;
}

double tr_resolution_force(const tr_bodies *b, int a, int disk) {
    const run r = run_of(b, false);
    const pair p = pair_of(&r, a, disk);
    const tr_group_law *normal = &tr_world_group(&b->world, a)->laws[TR_NORMAL];
    double weight, energy;
    bool meet = loads(&r, &p, &weight, &energy), known = p.gap < -4 * spacing(p.reach) || weight > 0 || energy > 0;
    if (!meet || !known) return 0;
    return normal->law->elastic(normal->par, p.R1, p.R2, expected(b, &p, weight, energy)).force;
}

bool tr_resolution_check(const tr_bodies *b, tr_status *st) {
    const tr_world *w = &b->world;
    const run start = run_of(b, true);
    for (int i = w->n_rings; i < w->disks.n; i++)
        for (int a = -w->n_walls; a < i; a++) {
            pair p = pair_of(&start, a, i);
            double most = TR_LARGEST_OVERLAP * smaller(&p);
            if (spacing(p.reach) <= 0.01 * most) continue;
            char names[80];
            snprintf(names, sizeof names, a < 0 ? "wall %d and disk %d" : "disks %d and %d", a < 0 ? -1 - a : a, i);
            return tr_status_fail(
                st, TR_BAD_CASE,
                "error: %s: numbers near %.4g m are %.2g m apart in double precision, too far for any "
                "overlap of a radius of %.3g m; move the scene towards the origin (0, 0)",
                names, p.reach, spacing(p.reach), smaller(&p));
        }
    return true;
}
