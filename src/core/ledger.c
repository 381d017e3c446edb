/* SPDX-License-Identifier: MIT */
#include "core/ledger.h"

#include <math.h>

enum { F_T, M1, M2, E_NORMAL, E_FRICTION, E_ROLLING, N_HIST }; /* what a contact remembers of the step before */

static double cut(double value, double bound) {
    value = value > bound ? bound : value; /* not fmin: it is a call */
    return value < -bound ? -bound : value;
}

/* Why friction is never below zero. Let q = Q before, s = cut(q), c = the bound, du = Vs dt, sliding with Q = +c, so
 * k du >= c - q. Work - store = ½(s + c) du - (c² - q²)/2k >= [(s + c)(c - q) - (c - q)(c + q)]/2k = (c - q)(s - q)/2k.
 * For |q| <= c s = q: zero. For q > c, s = c: (c - q)²/2k. For q < -c, s = -c: (c - q)(-c - q)/2k > 0. Sticking: (Q -
 * q)(s - q)/2k, same cases. */
static void step(tr_tile *tile, const tr_law_data *data) {
    const tr_sink *sink = data->par;
    tr_group *g = sink->group;
    tr_ledger *ledger = sink->ledger;
    const tr_slot *normal = &g->slot[TR_NORMAL], *friction = &g->slot[TR_FRICTION], *rolling = &g->slot[TR_ROLLING];
    double *h[N_HIST], dt = data->dt;
    for (int k = 0; k < N_HIST; k++) h[k] = g->hist[sink->hist + k] + tile->first;
    tr_lane energy, bound;

    tr_law_data law = tr_group_data(g, normal, tile->first, dt);
    normal->law->state(tile, &law, energy, bound);
    double lost = 0;
    for (int i = 0; i < tile->n; i++) {
        lost += (tile->f_n[i] - tile->f_elastic[i]) * tile->v_n[i] * dt;
        h[E_NORMAL][i] = energy[i];
    }
    ledger->damped += lost;
    if (friction->law->step) {
        law = tr_group_data(g, friction, tile->first, dt);
        friction->law->state(tile, &law, energy, bound);
        lost = 0;
        for (int i = 0; i < tile->n; i++) {
            double work = 0.5 * (cut(h[F_T][i], bound[i]) + tile->f_t[i]) * tile->v_s[i] * dt;
            lost += work - (energy[i] - h[E_FRICTION][i]);
            h[F_T][i] = tile->f_t[i], h[E_FRICTION][i] = energy[i];
        }
        ledger->friction += lost;
    }
    if (rolling->law->step) {
        law = tr_group_data(g, rolling, tile->first, dt);
        rolling->law->state(tile, &law, energy, bound);
        lost = 0;
        for (int i = 0; i < tile->n; i++) {
            double m1 = cut(h[M1][i], bound[i]) + tile->m1[i], m2 = cut(h[M2][i], bound[i]) + tile->m2[i];
            double work = -0.5 * (m1 * tile->v1[i][2] + m2 * tile->v2[i][2]) * dt;
            lost += work - (energy[i] - h[E_ROLLING][i]);
            h[M1][i] = tile->m1[i], h[M2][i] = tile->m2[i], h[E_ROLLING][i] = energy[i];
        }
        ledger->rolling += lost;
    }
}

void tr_ledger_attach(tr_group *group, tr_ledger *ledger) {
    group->ledger_sink.ledger = ledger;
    tr_group_attach(group, &group->ledger_sink, "ledger", step, N_HIST);
}

static void remember_walls(tr_world *world) {
    for (int w = 0; w < world->n_walls; w++)
        world->ledger->wall_fx[w] = world->wall[w].fx, world->ledger->wall_fy[w] = world->wall[w].fy;
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
    remember_walls(world);
}

tr_energy tr_ledger_read(const tr_world *world) {
    const tr_ledger *ledger = world->ledger;
    const tr_disks *d = &world->disks;
    tr_energy e = {
        .damped = ledger->damped, .friction = ledger->friction, .rolling = ledger->rolling, .work = ledger->work};
    /* K = ½ m v^(n-1/2) v^(n+1/2), the latter = v + dt F/m */
    for (int i = 0; i < d->n; i++)
        for (int k = 4 * i; k < 4 * i + 3; k++)
            if (d->inv[k] > 0) e.kinetic += 0.5 * d->vel[k] * (d->vel[k] / d->inv[k] + world->dt * d->force[k]);
    for (int k = 0; k < 2; k++) {
        const tr_group *g = &world->group[k];
        for (int i = 0; i < g->n; i++) {
            e.elastic_normal += g->hist[g->ledger_sink.hist + E_NORMAL][i];
            e.elastic_friction += g->hist[g->ledger_sink.hist + E_FRICTION][i];
            e.elastic_rolling += g->hist[g->ledger_sink.hist + E_ROLLING][i];
        }
    }
    double now = e.kinetic + e.elastic_normal + e.elastic_friction + e.elastic_rolling;
    e.residual = ledger->start + ledger->work - now - (ledger->damped + ledger->friction + ledger->rolling);
    return e;
}
