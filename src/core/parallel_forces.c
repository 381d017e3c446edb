/* SPDX-License-Identifier: MIT */
#include "core/parallel_forces.h"

#include "base/alloc.h"
#include "base/vector.h"
#include "core/cell.h"
#include "core/parallel_memory.h"
#include "core/tile.h"
#include <stdlib.h>
#include <string.h>

typedef tr_parallel_sums sums;
typedef tr_parallel_deferred late;
typedef tr_parallel_thread part;

/* ---- who owns what */

static int end_of(const tr_group *g, int tile) {
    int end = (tile + 1) * TR_TILE;
    return end < g->n ? end : g->n;
}

/* Late parts are counted, and room for them is made before a step needs it. */
static bool mark(tr_parallel *s, const tr_group *g, int k, tr_status *st) {
    part *p = &s->part[k];
    int n = 0;
    for (int tile = tr_threads_chunk(s->tiles, k, s->threads); tile < tr_threads_chunk(s->tiles, k + 1, s->threads);
         tile++) {
        int before = n;
        for (int i = tile * TR_TILE; i < end_of(g, tile); i++) n += (s->owner[g->a[i]] < k) + (s->owner[g->b[i]] < k);
        s->sums[tile].mixed = n > before;
    }
    if (n <= p->capacity) return true;
    if (!tr_alloc_grow(&p->late, 0, 2 * (size_t)n, sizeof(late), st)) return false;
    p->capacity = 2 * n;
    return true;
}

static bool assign(tr_parallel *s, const tr_group *g, tr_status *st) {
    for (int k = s->threads - 1; k >= 0; k--) {
        int end = tr_threads_chunk(s->tiles, k + 1, s->threads) * TR_TILE;
        for (int i = tr_threads_chunk(s->tiles, k, s->threads) * TR_TILE; i < end && i < g->n; i++)
            s->owner[g->a[i]] = s->owner[g->b[i]] = (uint16_t)k;
    }
    for (int k = 0; k < s->threads; k++)
        if (!mark(s, g, k, st)) return false;
    return true;
}

static tr_parallel *create(int n, int threads, tr_status *st) {
    tr_parallel *s = tr_alloc(1, sizeof *s, st);
    uint16_t *owner = tr_alloc((size_t)n, sizeof *owner, st);
    part *parts = tr_alloc((size_t)threads, sizeof *parts, st);
    if (s && owner && parts) {
        *s = (tr_parallel){.threads = threads, .list = -1, .owner = owner, .part = parts};
        return s;
    }
    free(parts), free(owner), free(s);
    return NULL;
}

static bool prepare(tr_world *world, tr_status *st) {
    const tr_group *g = &world->group[0];
    int threads = tr_world_threads(world);
    if (world->parallel && world->parallel->threads != threads)
        tr_parallel_free(world->parallel), world->parallel = NULL;
    if (!world->parallel && !(world->parallel = create(world->disks.n, threads, st))) return false;
    tr_parallel *s = world->parallel;
    if (s->list == world->refreshes) return true;
    s->list = -1;
    s->tiles = (g->n + TR_TILE - 1) / TR_TILE;
    if (!s->sums || s->tiles > s->n_sums) {
        int room = g->capacity / TR_TILE + 1;
        if (!tr_alloc_grow(&s->sums, 0, (size_t)room, sizeof(sums), st)) return false;
        s->n_sums = room;
    }
    if (!assign(s, g, st)) return false;
    s->list = world->refreshes;
    return true;
}

/* ---- the step */

static void run_passes(tr_world *world, tr_tile *tile, int first, sums *to) {
    tr_group *g = &world->group[0];
    tr_ledger lost = {.damped = 0};
    tr_sink sink = g->ledger_sink;
    sink.ledger = &lost;
    tr_tile_gather(world, g, tile, first, world->parallel->dt);
    for (int k = 0; k < g->n_pass; k++) {
        tr_law_data data = g->pass[k].data;
        if (data.par == &g->ledger_sink) data.par = &sink;
        g->pass[k].run(tile, &data);
    }
    tr_periodic_cell cell = {0};
    if (world->cell.side[0] > 0) tr_cell_add_virial(&cell, tile);
    *to = (sums){.virial = {cell.virial[0], cell.virial[1]},
                 .lost = {lost.damped, lost.friction, lost.rolling},
                 .made = {lost.made[0], lost.made[1], lost.made[2]},
                 .touching = tile->touching,
                 .mixed = to->mixed};
}

/* Like tr_tile_scatter, but parts for disks of an earlier thread are kept. */
static void scatter_mixed(tr_world *world, part *p, int k) {
    const tr_group *g = &world->group[0];
    const tr_tile *tile = &p->tile;
    const uint16_t *owner = world->parallel->owner;
    tr_quad *force = (tr_quad *)world->disks.force;
    for (int i = 0; i < tile->n; i++) {
        int disk[2] = {g->a[tile->first + i], g->b[tile->first + i]};
        const tr_quad part[2] = {{-tile->fx[i], -tile->fy[i], tile->q1[i], 0},
                                 {tile->fx[i], tile->fy[i], tile->q2[i], 0}};
        for (int side = 0; side < 2; side++) {
            if (owner[disk[side]] == k)
                force[disk[side]] += part[side];
            else
                p->late[p->n_late++] = (late){part[side], disk[side]};
        }
    }
}

static void work(void *context, int k) {
    tr_world *world = context;
    tr_parallel *s = world->parallel;
    part *p = &s->part[k];
    int end = tr_threads_chunk(s->tiles, k + 1, s->threads);
    p->n_late = 0;
    for (int tile = tr_threads_chunk(s->tiles, k, s->threads); tile < end; tile++) {
        run_passes(world, &p->tile, tile * TR_TILE, &s->sums[tile]);
        if (s->sums[tile].mixed)
            scatter_mixed(world, p, k);
        else
            tr_tile_scatter(&p->tile, &world->group[0], world);
    }
}

bool tr_parallel_forces(tr_world *world, double dt, tr_status *st) {
    if (!prepare(world, st)) return false;
    tr_parallel *s = world->parallel;
    tr_quad *force = (tr_quad *)world->disks.force;
    s->dt = dt;
    tr_threads_run(world->threads, work, world);
    for (int k = 0; k < s->threads; k++)
        for (int i = 0; i < s->part[k].n_late; i++) force[s->part[k].late[i].disk] += s->part[k].late[i].force;
    for (int tile = 0; tile < s->tiles; tile++) {
        const sums *t = &s->sums[tile];
        world->contact_updates += t->touching;
        for (int axis = 0; axis < 2; axis++) world->cell.virial[axis] += t->virial[axis];
        if (!world->ledger) continue;
        world->ledger->damped += t->lost[0], world->ledger->friction += t->lost[1],
            world->ledger->rolling += t->lost[2];
        for (int slot = 0; slot < TR_N_LAW_KINDS; slot++) world->ledger->made[slot] += t->made[slot];
    }
    return true;
}
