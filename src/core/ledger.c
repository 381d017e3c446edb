/* SPDX-License-Identifier: MIT */
#include "core/ledger.h"

#include "base/vector.h"
#include "core/cell.h"
#include <math.h>
#include <string.h>

/* What a contact remembers of the step before: one block for each law. A rolling law has more if it also has a force,
 * or if its two moments are not opposite. */
enum { F_D, DELTA, N_NORMAL };
enum { FORCE, STORED, N_SPRING }; /* of friction Q, of rolling the moment on 2 */

static int more_of_rolling(const tr_law *law) {
    return !!(law->needs & TR_GIVES_F_R) + !(law->claims & TR_BALANCED);
}

/* The start of the block of a slot; for TR_N_LAW_KINDS: the end of all blocks. */
static int block(const tr_group *g, int slot) {
    const tr_law *rolling = g->laws[TR_ROLLING].law;
    int at = g->ledger_sink.hist;
    if (slot > TR_NORMAL) at += N_NORMAL;
    if (slot > TR_FRICTION && g->laws[TR_FRICTION].law->step) at += N_SPRING;
    if (slot > TR_ROLLING && rolling->step) at += N_SPRING + more_of_rolling(rolling);
    return at;
}

static inline double cut(double value, double bound) {
    value = value > bound ? bound : value; /* not fmin: it is a call */
    return value < -bound ? -bound : value;
}

typedef int64_t quad_mask __attribute__((vector_size(32)));

/* Adds the losses of the contacts of a tile: the sum, and separately the sum of negative ones. Eight partial sums,
 * always the same, so that additions do not wait for each other. As vectors: from plain sums gcc makes permutations. */
TR_VECTOR static void book(int n, tr_lane lost, double *net, double *made) {
    for (int i = n; i % 8; i++) lost[i] = 0; /* behind the last contact */
    const tr_quad *x = (const tr_quad *)lost;
    tr_quad part[2] = {{0}}, below[2] = {{0}};
    for (int i = 0; i < (n + 7) / 8; i++)
        for (int k = 0; k < 2; k++) {
            tr_quad one = x[2 * i + k];
            part[k] += one;
            below[k] += (tr_quad)((quad_mask)(one < 0) & (quad_mask)one);
        }
    tr_quad p = part[0] + part[1], q = below[0] + below[1];
    *net += (p[0] + p[1]) + (p[2] + p[3]);
    *made -= (q[0] + q[1]) + (q[2] + q[3]);
}

/* The work done on a contact over the step: mean of the force before (cut to the bound) and the force now, times
 * velocity. */
static inline double work(double before, double now, double bound, double velocity, double dt) {
    return 0.5 * (cut(before, bound) + now) * velocity * dt;
}

/* Where nothing is stored. */
TR_VECTOR static void account_work(int n, double dt, const double *restrict force, const double *restrict velocity,
                                   const double *restrict bound, double *restrict before, double *restrict lost) {
    for (int i = 0; i < n; i++) {
        lost[i] = work(before[i], force[i], bound[i], velocity[i], dt);
        before[i] = force[i];
    }
}

/* A spring: stored energy is not lost. */
TR_VECTOR static void account_spring(int n, double dt, const double *restrict force, const double *restrict velocity,
                                     const double *restrict bound, const double *restrict energy,
                                     double *restrict before, double *restrict stored, double *restrict lost) {
    for (int i = 0; i < n; i++) {
        lost[i] = work(before[i], force[i], bound[i], velocity[i], dt) - (energy[i] - stored[i]);
        before[i] = force[i], stored[i] = energy[i];
    }
}

TR_VECTOR static void account_dashpot(const tr_tile *restrict tile, double *restrict before, double *restrict delta,
                                      double *restrict lost) {
    const double dt = tile->dt;
    for (int i = 0; i < tile->n; i++) {
        double now = tile->f_n[i] - tile->f_elastic[i], first = before[i] * tile->v_n[i];
        lost[i] = 0.5 * ((first > 0 ? first : 0) + now * tile->v_n[i]) * dt;
        before[i] = now, delta[i] = tile->delta[i];
    }
}

/* A force along t, as a couple f_r L turned by Vs/L: the arms, L in sum, are not those of the step before. f_r has
 * shared arms; where friction has others, v_s is not the velocity of f_r. What
 * that step left is cut by as much as its moments. */
TR_VECTOR static void account_couple(const tr_tile *restrict tile, const double *restrict moment,
                                     const double *restrict bound, bool shared_arms, double *restrict before,
                                     double *restrict lost) {
    const double dt = tile->dt;
    for (int i = 0; i < tile->n; i++) {
        double turn = (tile->s1[i] - tile->s2[i]) / (tile->R1[i] + tile->R2[i]); /* Vs/L by shared arms */
        double L = tr_tile_length(tile, i), couple = tile->f_r[i] * L, share = bound[i] / fabs(moment[i]);
        double first = share < 1 ? before[i] * share : before[i];
        turn = shared_arms ? tile->v_s[i] / L : turn;
        lost[i] = 0.5 * (first + couple) * turn * dt;
        before[i] = couple;
    }
}

TR_VECTOR static void add(int n, const double *restrict more, double *restrict lost) {
    for (int i = 0; i < n; i++) lost[i] += more[i];
}

TR_VECTOR static void find_spin(const tr_tile *restrict tile, double share_of_1, double *restrict spin) {
    for (int i = 0; i < tile->n; i++) spin[i] = share_of_1 * tile->w1[i] - tile->w2[i];
}

/* Opposite moments turn 2 against 1, others each its own body. */
static void account_rolling(tr_group *g, const tr_tile *tile, const double *energy, const double *bound, double *lost) {
    const tr_law *law = g->laws[TR_ROLLING].law;
    double **h = g->hist + block(g, TR_ROLLING), **more = h + N_SPRING, dt = tile->dt;
    bool force = law->needs & TR_GIVES_F_R, opposite = law->claims & TR_BALANCED;
    int n = tile->n, first = tile->first;
    tr_lane spin, couple, of_1;
    if (force) account_couple(tile, h[FORCE] + first, bound, g->shared_arms, *more++ + first, couple);
    find_spin(tile, opposite ? 1 : 0, spin);
    account_spring(n, dt, tile->m2, spin, bound, energy, h[FORCE] + first, h[STORED] + first, lost);
    if (force) add(n, couple, lost);
    if (opposite) return;
    for (int i = 0; i < n; i++) spin[i] = -tile->w1[i];
    account_work(n, dt, tile->m1, spin, bound, *more + first, of_1);
    add(n, of_1, lost);
}

/* Why friction is never below zero. Let q = Q before, s = cut(q), c = the bound, du = Vs dt, sliding with Q = +c, so
 * k du >= c - q. Work - store = ½(s + c) du - (c² - q²)/2k >= [(s + c)(c - q) - (c - q)(c + q)]/2k = (c - q)(s -
 * q)/2k. For |q| <= c s = q: zero. For q > c, s = c: (c - q)²/2k. For q < -c, s = -c: (c - q)(-c - q)/2k > 0.
 * Sticking: (Q - q)(s - q)/2k, same cases. */
static void step(tr_tile *restrict tile, const tr_law_data *restrict data) {
    const tr_sink *sink = data->par;
    tr_group *g = sink->group;
    tr_ledger *ledger = sink->ledger;
    const tr_group_law *friction = &g->laws[TR_FRICTION], *rolling = &g->laws[TR_ROLLING];
    double **h = g->hist + block(g, TR_NORMAL);
    int n = tile->n, first = tile->first;
    tr_lane energy, bound, lost;
    account_dashpot(tile, h[F_D] + first, h[DELTA] + first, lost);
    book(n, lost, &ledger->damped, &ledger->made[TR_NORMAL]);
    if (friction->law->step) {
        tr_law_data law = tr_group_data(g, friction);
        h = g->hist + block(g, TR_FRICTION);
        friction->law->state(tile, &law, energy, bound);
        account_spring(n, tile->dt, tile->f_t, tile->v_s, bound, energy, h[FORCE] + first, h[STORED] + first, lost);
        book(n, lost, &ledger->friction, &ledger->made[TR_FRICTION]);
    }
    if (rolling->law->step) {
        tr_law_data law = tr_group_data(g, rolling);
        rolling->law->state(tile, &law, energy, bound);
        account_rolling(g, tile, energy, bound, lost);
        book(n, lost, &ledger->rolling, &ledger->made[TR_ROLLING]);
    }
}

void tr_ledger_attach(tr_group *group, tr_ledger *ledger) {
    group->ledger_sink.ledger = ledger;
    tr_group_attach(group, &group->ledger_sink, "ledger", step, block(group, TR_N_LAW_KINDS) - group->ledger_sink.hist);
}

static void remember_walls(tr_world *world) {
    for (int w = 0; w < world->n_walls; w++)
        world->ledger->wall_fx[w] = world->wall[w].fx, world->ledger->wall_fy[w] = world->wall[w].fy;
    for (int k = 0; k < 2; k++) world->ledger->cell_force[k] = tr_cell_force(&world->cell, k);
}

void tr_ledger_begin(tr_world *world) {
    tr_ledger *ledger = world->ledger;
    *ledger = (tr_ledger){0};
    tr_energy now = tr_ledger_read(world);
    ledger->start = now.kinetic + now.elastic_normal + now.elastic_friction + now.elastic_rolling;
    remember_walls(world);
}

void tr_ledger_walls(tr_world *world) {
    tr_ledger *ledger = world->ledger;
    for (int w = 0; w < world->n_walls; w++) {
        const tr_wall *wall = &world->wall[w];
        ledger->work -=
            0.5 * world->dt *
            ((ledger->wall_fx[w] + wall->fx) * (wall->vx + wall->belt * wall->ny) +
             (ledger->wall_fy[w] + wall->fy) * (wall->vy - wall->belt * wall->nx)); /* of a belt, but for its corners */
    }
    for (int k = 0; k < 2 && world->cell.side[0] > 0; k++)
        ledger->work -=
            0.5 * world->dt * world->cell.rate[k] * (ledger->cell_force[k] + tr_cell_force(&world->cell, k)) +
            tr_cell_kinetic_work(world, k);
    remember_walls(world);
}

/* Energy in the contacts of a group: of the normal law from the overlaps, of the others in the spring of a slot. */
static double in_overlaps(const tr_group *g) {
    const tr_group_law *normal = &g->laws[TR_NORMAL];
    const double *delta = g->hist[block(g, TR_NORMAL) + DELTA];
    double energy = 0;
    for (int i = 0; i < g->n; i++)
        if (delta[i] > 0)
            energy +=
                normal->law->elastic(normal->par, g->pair[TR_PAIR_R1][i], g->pair[TR_PAIR_R2][i], delta[i]).energy;
    return energy;
}

static double in_springs(const tr_group *g, int slot) {
    double energy = 0;
    if (!g->laws[slot].law->step) return 0;
    for (int i = 0; i < g->n; i++) energy += g->hist[block(g, slot) + STORED][i];
    return energy;
}

tr_energy tr_ledger_read(const tr_world *world) {
    const tr_ledger *ledger = world->ledger;
    const tr_disks *d = &world->disks;
    tr_energy e = {
        .damped = ledger->damped, .friction = ledger->friction, .rolling = ledger->rolling, .work = ledger->work};
    memcpy(e.made, ledger->made, sizeof e.made);
    /* K = ½ m v^(n-1/2) v^(n+1/2), the latter = v + dt F/m; in a cell v is relative to its homogeneous flow */
    const double flow[3] = {tr_cell_strain_rate(&world->cell, 0), tr_cell_strain_rate(&world->cell, 1), 0};
    for (int i = 0; i < d->n; i++)
        for (int lane = 0, k = TR_LANES * i; lane < 3; lane++, k++) {
            double v = d->vel[k] - flow[lane] * d->pos[k];
            if (d->inv[k] > 0) e.kinetic += 0.5 * v * (v / d->inv[k] + world->dt * d->force[k]);
        }
    for (int k = 0; k < world->n_groups; k++) {
        const tr_group *g = &world->group[k];
        e.elastic_normal += in_overlaps(g);
        e.elastic_friction += in_springs(g, TR_FRICTION);
        e.elastic_rolling += in_springs(g, TR_ROLLING);
    }
    double now = e.kinetic + e.elastic_normal + e.elastic_friction + e.elastic_rolling;
    e.residual = ledger->start + ledger->work - now - (ledger->damped + ledger->friction + ledger->rolling);
    return e;
}
