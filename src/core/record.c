/* SPDX-License-Identifier: MIT */
#include "core/record.h"

#include "base/alloc.h"
#include "core/arcs.h"
#include "core/cell.h"
#include "core/step.h"
#include <assert.h>
#include <math.h>

typedef struct collector {
    tr_world *world;
    tr_record **records;
    int n, *capacity;
    tr_status *st;
} collector;

/* bound: unchanged without a law. */
static void bounds(const tr_group *g, const tr_group_law *slot, const tr_tile *tile, tr_lane bound) {
    tr_lane energy;
    tr_law_data data = tr_group_data(g, slot);
    if (slot->law->step) slot->law->state(tile, &data, energy, bound);
}

static void collect(void *context, tr_group *g, tr_tile *tile) {
    collector *c = context;
    tr_lane friction_bound = {0}, rolling_bound = {0};
    if (c->st->code) return;
    int need = c->n + tile->n;
    if (need > *c->capacity) {
        if (!tr_alloc_grow(c->records, (size_t)c->n, (size_t)need * 2, sizeof(tr_record), c->st)) return;
        *c->capacity = need * 2;
    }
    assert(tr_n_rolling_velocities <= TR_MAX_VELOCITY_MEASURES && tr_n_sliding_velocities <= TR_MAX_VELOCITY_MEASURES);
    tr_record *out = *c->records + c->n;
    bounds(g, &g->laws[TR_FRICTION], tile, friction_bound);
    bounds(g, &g->laws[TR_ROLLING], tile, rolling_bound);
    int kept[TR_TILE], n = 0;
    for (int i = 0; i < tile->n; i++)
        if (tile->delta[i] > 0) kept[n++] = i;
    for (int j = 0; j < n; j++) {
        int i = kept[j], a = g->a[tile->first + i], b = g->b[tile->first + i];
        const double *q = c->world->disks.pos + tr_body(b);
        out[j] = (tr_record){
            .a = g->walls ? -1 - a : a,
            .b = b,
            .x = q[0] + tr_cell_offset(&c->world->cell, g, tile->first + i, 0) - tile->r2[i] * tile->nx[i],
            .y = q[1] + tr_cell_offset(&c->world->cell, g, tile->first + i, 1) - tile->r2[i] * tile->ny[i],
            .nx = tile->nx[i],
            .ny = tile->ny[i],
            .R1 = tile->R1[i],
            .R2 = tile->R2[i],
            .delta = tile->delta[i],
            .f_n = tile->f_n[i],
            .f_t = tile->f_t[i],
            .f_r = g->laws[TR_ROLLING].law->needs & TR_GIVES_F_R ? tile->f_r[i] + 0.0 : 0,
            .m1 = tile->m1[i],
            .m2 = tile->m2[i],
            .v_n = tile->v_n[i],
            .v_s = tile->v_s[i],
            .s1 = tile->s1[i],
            .s2 = tile->s2[i],
            .mobilisation = friction_bound[i] > 0 ? fabs(tile->f_t[i]) / friction_bound[i] : 0,
            .rolling_mobilisation =
                rolling_bound[i] > 0 ? fmax(fabs(tile->m1[i]), fabs(tile->m2[i])) / rolling_bound[i] : 0,
            .increment = tr_increments_of(g, tile->first + i),
            .da = tr_arcs_a(g, tile->first + i),
            .db = tr_arcs_b(g, tile->first + i),
        };
    }
    for (int v = 0; v < tr_n_rolling_velocities; v++) {
        tr_rolling_velocities[v].step(tile, NULL);
        for (int j = 0; j < n; j++) out[j].v_r_by[v] = tile->v_r[kept[j]];
    }
    for (int v = 0; v < tr_n_sliding_velocities; v++) {
        tr_sliding_velocities[v].step(tile, NULL);
        for (int j = 0; j < n; j++) out[j].v_s_by[v] = tile->v_s[kept[j]];
    }
    for (int j = 0; j < n; j++) out[j].v_r = out[j].v_r_by[g->rolling_velocity];
    c->n += n;
}

/* The pipelines walk again with dt = 0 and without sinks, which changes no history. Spins are gathered even if no law
 * needs them, so frictionless scenes also have sliding and rolling velocities. */
int tr_record_all(tr_world *world, tr_record **records, int *capacity, tr_status *st) {
    collector c = {world, records, 0, capacity, st};
    for (int k = 0; k < world->n_groups; k++) {
        tr_group *g = &world->group[k];
        int n_pass = g->n_pass;
        while (g->n_pass > 0 && g->pass[g->n_pass - 1].sink) g->n_pass--;
        tr_step_walk(world, g, 0, collect, &c);
        g->n_pass = n_pass;
    }
    return c.n;
}
