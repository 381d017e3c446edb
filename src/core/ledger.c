/* SPDX-License-Identifier: MIT */
#include "core/ledger.h"

#include "base/vector.h"
#include "core/cell.h"
#include <math.h>
#include <string.h>

/* What a contact remembers of the step before, one block for each law that is there; the last only where a rolling law has
 * a force. */
enum { F_D, E_NORMAL, N_NORMAL };
enum { F_T, E_FRICTION, N_FRICTION };
enum { M1, M2, E_ROLLING, F_R, N_ROLLING };

/* Where the block of a slot begins; of TR_N_SLOTS: where all of them end. */
static int block(const tr_group *g, int slot) {
    const tr_law *rolling = g->slot[TR_ROLLING].law;
    int at = g->ledger_sink.hist;
    if (slot > TR_NORMAL) at += N_NORMAL;
    if (slot > TR_FRICTION && g->slot[TR_FRICTION].law->step) at += N_FRICTION;
    if (slot > TR_ROLLING && rolling->step) at += rolling->needs & TR_GIVES_F_R ? N_ROLLING : F_R;
    return at;
}

static inline double cut(double value, double bound) {
    value = value > bound ? bound : value; /* not fmin: it is a call */
    return value < -bound ? -bound : value;
}

/* Books what the contacts of a tile lost: the sum, and that of what is below zero apart. Eight partial sums, so that adding up
 * is not a chain of waits; always the same eight. */
TR_VECTOR static void book(int n, const double *restrict lost, double *restrict net, double *restrict made) {
    double part[8] = {0}, below[8] = {0};
    int i = 0;
    for (; i + 8 <= n; i += 8)
        for (int k = 0; k < 8; k++) part[k] += lost[i + k], below[k] += lost[i + k] < 0 ? lost[i + k] : 0;
    for (; i < n; i++) part[i & 7] += lost[i], below[i & 7] += lost[i] < 0 ? lost[i] : 0;
    *net += ((part[0] + part[1]) + (part[2] + part[3])) + ((part[4] + part[5]) + (part[6] + part[7]));
    *made -= ((below[0] + below[1]) + (below[2] + below[3])) + ((below[4] + below[5]) + (below[6] + below[7]));
}

/* Adds the work done on contacts over the step: mean of the force before, cut to the bound, and now, times velocity. */
TR_VECTOR static void add_work(int n, double dt, const double *restrict force, const double *restrict velocity,
                               const double *restrict bound, double *restrict before, double *restrict lost) {
    for (int i = 0; i < n; i++) {
        lost[i] += 0.5 * (cut(before[i], bound[i]) + force[i]) * velocity[i] * dt;
        before[i] = force[i];
    }
}

/* What went into the store is not lost. */
TR_VECTOR static void take_store(int n, const double *restrict energy, double *restrict before, double *restrict lost) {
    for (int i = 0; i < n; i++) {
        lost[i] -= energy[i] - before[i];
        before[i] = energy[i];
    }
}

/* Why friction is never below zero. Let q = Q before, s = cut(q), c = the bound, du = Vs dt, sliding with Q = +c, so
 * k du >= c - q. Work - store = ½(s + c) du - (c² - q²)/2k >= [(s + c)(c - q) - (c - q)(c + q)]/2k = (c - q)(s - q)/2k.
 * For |q| <= c s = q: zero. For q > c, s = c: (c - q)²/2k. For q < -c, s = -c: (c - q)(-c - q)/2k > 0. Sticking: (Q -
 * q)(s - q)/2k, same cases. */
TR_VECTOR static void step(tr_tile *restrict tile, const tr_law_data *restrict data) {
    const tr_sink *sink = data->par;
    tr_group *g = sink->group;
    tr_ledger *ledger = sink->ledger;
    const tr_slot *normal = &g->slot[TR_NORMAL], *friction = &g->slot[TR_FRICTION], *rolling = &g->slot[TR_ROLLING];
    double **h = g->hist + block(g, TR_NORMAL), *f_d = h[F_D] + tile->first, dt = tile->dt;
    int n = tile->n, first = tile->first;
    tr_lane energy, bound, lost, spin;
    tr_law_data law = tr_group_data(g, normal);
    normal->law->state(tile, &law, h[E_NORMAL] + first, bound);
    for (int i = 0; i < n; i++) {
        double now = tile->f_n[i] - tile->f_elastic[i], before = f_d[i] * tile->v_n[i];
        lost[i] = 0.5 * ((before > 0 ? before : 0) + now * tile->v_n[i]) * dt;
        f_d[i] = now;
    }
    book(n, lost, &ledger->damped, &ledger->made[TR_NORMAL]);
    if (friction->law->step) {
        h = g->hist + block(g, TR_FRICTION);
        law = tr_group_data(g, friction);
        friction->law->state(tile, &law, energy, bound);
        memset(lost, 0, sizeof lost);
        add_work(n, dt, tile->f_t, tile->v_s, bound, h[F_T] + first, lost);
        take_store(n, energy, h[E_FRICTION] + first, lost);
        book(n, lost, &ledger->friction, &ledger->made[TR_FRICTION]);
    }
    if (rolling->law->step) {
        h = g->hist + block(g, TR_ROLLING);
        law = tr_group_data(g, rolling);
        rolling->law->state(tile, &law, energy, bound);
        memset(lost, 0, sizeof lost);
        if (rolling->law->needs & TR_GIVES_F_R) {
            /* As a couple f_r L turned by Vs/L: the arms, L in sum, are not those of the step before. What that step
             * left is cut by as much as its moments. */
            tr_lane couple, no_bound;
            for (int i = 0; i < n; i++) {
                double L = tile->r1[i] + tile->r2[i], cut_by = bound[i] / fabs(h[M2][first + i]);
                couple[i] = tile->f_r[i] * L, spin[i] = tile->v_s[i] / L, no_bound[i] = INFINITY;
                if (cut_by < 1) h[F_R][first + i] *= cut_by;
            }
            add_work(n, dt, couple, spin, no_bound, h[F_R] + first, lost);
        }
        for (int i = 0; i < n; i++) spin[i] = -tile->w1[i];
        add_work(n, dt, tile->m1, spin, bound, h[M1] + first, lost);
        for (int i = 0; i < n; i++) spin[i] = -tile->w2[i];
        add_work(n, dt, tile->m2, spin, bound, h[M2] + first, lost);
        take_store(n, energy, h[E_ROLLING] + first, lost);
        book(n, lost, &ledger->rolling, &ledger->made[TR_ROLLING]);
    }
}

void tr_ledger_attach(tr_group *group, tr_ledger *ledger) {
    group->ledger_sink.ledger = ledger;
    tr_group_attach(group, &group->ledger_sink, "ledger", step, block(group, TR_N_SLOTS) - group->ledger_sink.hist);
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
            0.5 * world->dt * ((ledger->wall_fx[w] + wall->fx) * wall->vx + (ledger->wall_fy[w] + wall->fy) * wall->vy);
    }
    for (int k = 0; k < 2 && world->cell.side[0] > 0; k++)
        ledger->work -=
            0.5 * world->dt * world->cell.rate[k] * (ledger->cell_force[k] + tr_cell_force(&world->cell, k)) +
            tr_cell_kinetic_work(world, k);
    remember_walls(world);
}

/* Energy in the contacts of a group, in one slot. */
static double stored(const tr_group *g, int slot, int which) {
    double energy = 0;
    if (!g->slot[slot].law->step) return 0;
    for (int i = 0; i < g->n; i++) energy += g->hist[block(g, slot) + which][i];
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
        for (int lane = 0, k = 4 * i; lane < 3; lane++, k++) {
            double v = d->vel[k] - flow[lane] * d->pos[k];
            if (d->inv[k] > 0) e.kinetic += 0.5 * v * (v / d->inv[k] + world->dt * d->force[k]);
        }
    for (int k = 0; k < 2; k++) {
        const tr_group *g = &world->group[k];
        e.elastic_normal += stored(g, TR_NORMAL, E_NORMAL);
        e.elastic_friction += stored(g, TR_FRICTION, E_FRICTION);
        e.elastic_rolling += stored(g, TR_ROLLING, E_ROLLING);
    }
    double now = e.kinetic + e.elastic_normal + e.elastic_friction + e.elastic_rolling;
    e.residual = ledger->start + ledger->work - now - (ledger->damped + ledger->friction + ledger->rolling);
    return e;
}
