/* SPDX-License-Identifier: MIT */
#include "core/checkpoint.h"

#include "core/list.h"
#include "core/shares.h"

static void keep_near(tr_pairs *near, tr_checkpoint *c) {
    int n = near->n;
    TR_KEEP(c, &n, 1);
    if (c->st->code || !tr_pairs_reserve(near, (size_t)n, c->st)) return;
    near->n = n;
    TR_KEEP(c, near->a, n);
    TR_KEEP(c, near->b, n);
}

static void keep_group(tr_group *g, tr_checkpoint *c) {
    int n = g->n;
    TR_KEEP(c, &n, 1);
    if (c->st->code || (n && !tr_list_reserve(g, n, c->st))) return;
    g->n = n;
    TR_KEEP(c, g->a, n);
    TR_KEEP(c, g->b, n);
    for (int k = 0; k < g->n_hist; k++) TR_KEEP(c, g->hist[k], n);
    for (int k = 0; k < g->n_pair; k++) TR_KEEP(c, g->pair[k], n);
}

void tr_world_checkpoint(tr_world *world, tr_checkpoint *c) {
    tr_disks *d = &world->disks;
    if (c->loading) tr_shares_free(world->shares), world->shares = NULL; /* which are of another list */
    TR_KEEP(c, d->pos, 4 * d->n);
    TR_KEEP(c, d->vel, 4 * d->n);
    TR_KEEP(c, world->wall, world->n_walls);
    TR_KEEP(c, &world->cell, 1);
    TR_KEEP(c, &world->steps, 1);
    TR_KEEP(c, &world->contact_updates, 1);
    TR_KEEP(c, &world->searches, 1);
    TR_KEEP(c, &world->refreshes, 1);
    TR_KEEP(c, &world->fresh, 1);
    TR_KEEP(c, &world->stale, 1);
    TR_KEEP(c, &world->wall_moved, 1);
    TR_KEEP(c, world->wide_ref, 2 * d->n);
    TR_KEEP(c, world->thin_ref, 2 * d->n);
    TR_KEEP(c, &world->wide_extent, 1);
    TR_KEEP(c, &world->thin_extent, 1);
    keep_near(&world->near, c);
    for (int k = 0; k < 2; k++) keep_group(&world->group[k], c);
    if (world->ledger) TR_KEEP(c, world->ledger, 1);
}

void tr_biaxial_checkpoint(tr_biaxial *b, tr_checkpoint *c) {
    tr_world_checkpoint(&b->world, c);
    TR_KEEP(c, &b->mu, 1);
    TR_KEEP(c, &b->height0, 1);
    TR_KEEP(c, &b->shear_start, 1);
    TR_KEEP(c, b->stress_sum, 4);
    TR_KEEP(c, &b->stress_steps, 1);
    TR_KEEP(c, &b->held_sum, 1);
    TR_KEEP(c, &b->held_strain, 1);
}

void tr_biaxial_packing(tr_biaxial *b, tr_checkpoint *c) {
    tr_world *world = &b->world;
    TR_KEEP(c, world->disks.pos, 4 * world->disks.n);
    TR_KEEP(c, world->disks.vel, 4 * world->disks.n);
    TR_KEEP(c, world->wall, world->n_walls);
    TR_KEEP(c, &world->cell, 1);
    TR_KEEP(c, &world->steps, 1);
    TR_KEEP(c, &world->searches, 1);
    TR_KEEP(c, &world->refreshes, 1);
    if (world->group[0].n_hist) keep_group(&world->group[0], c);
}
