/* SPDX-License-Identifier: MIT */
#include "core/checkpoint.h"
#include "base/math.h"

#include "core/list.h"
#include "core/parallel_memory.h"
#include <math.h>

/* Pairs are sorted. Of two disks a is below b. */
static void check_pairs(tr_checkpoint *c, const int *a, const int *b, int n, int walls, int disks) {
    bool ok = true;
    for (int i = 0; i < n && !c->st->code; i++) {
        ok = ok && a[i] >= 0 && a[i] < (walls ? walls : b[i]) && b[i] >= 0 && b[i] < disks;
        if (i) ok = ok && (a[i] > a[i - 1] || (a[i] == a[i - 1] && b[i] > b[i - 1]));
    }
    tr_checkpoint_check(c, ok, "a pair of bodies");
}

/* Radii are those of the sample. */
static void keep_disks(tr_world *world, tr_checkpoint *c) {
    const tr_disks *d = &world->disks;
    bool ok = true;
    TR_KEEP(c, d->pos, TR_LANES * d->n);
    TR_KEEP(c, d->vel, TR_LANES * d->n);
    for (int i = 0; i < world->n_rings; i++) ok = ok && d->pos[tr_body(i) + TR_RADIUS] < 0;
    for (int i = world->n_rings; i < d->n; i++)
        ok = ok && d->pos[tr_body(i) + TR_RADIUS] > 0 && d->pos[tr_body(i) + TR_RADIUS] <= world->r_max;
    tr_checkpoint_check(c, ok, "a radius");
}

/* An unlimited piston has an infinite v_max, so walls are not checked as numbers. */
static void keep_box(tr_world *world, tr_checkpoint *c) {
    bool ok = true;
    const tr_wall *w = world->wall;
    const tr_periodic_cell *cell = &world->cell;
    TR_KEEP(c, world->wall, world->n_walls);
    TR_KEEP(c, &world->cell, 1);
    for (int k = 0; k < world->n_walls; k++, w++) {
        double sum = w->x + w->y + w->vx + w->vy + w->gain + w->load + w->fx + w->fy + w->length;
        ok = ok && sum - sum == 0 && fabs(tr_hypot(w->nx, w->ny) - 1) < 1e-9 && w->mass >= 0 && w->v_max >= 0;
    }
    for (int k = 0; k < 2; k++) {
        double sum = cell->side[k] + cell->rate[k] + cell->gain[k] + cell->load[k] + cell->virial[k];
        ok = ok && sum - sum == 0 && cell->side[k] >= 0 && cell->mass[k] >= 0 && cell->v_max[k] >= 0;
    }
    ok = ok && (cell->side[0] > 0) == (cell->side[1] > 0);
    if (world->boxed)
        ok = ok && world->wall[TR_LEFT_WALL].x < world->wall[TR_RIGHT_WALL].x &&
             world->wall[TR_BOTTOM_WALL].y < world->wall[TR_TOP_WALL].y;
    tr_checkpoint_check(c, ok, "a wall or the cell");
}

static void keep_near(tr_pairs *near, int disks, tr_checkpoint *c) {
    int n = near->n;
    TR_KEEP_COUNT(c, &n, 2 * sizeof(int));
    if (c->st->code || !tr_pairs_reserve(near, (size_t)n, c->st)) return;
    near->n = n;
    TR_KEEP(c, near->a, n);
    TR_KEEP(c, near->b, n);
    check_pairs(c, near->a, near->b, n, 0, disks);
}

static void keep_group(tr_group *g, const tr_world *world, tr_checkpoint *c) {
    int n = g->n, disks = world->disks.n;
    TR_KEEP_COUNT(c, &n, 2 * sizeof(int));
    if (c->st->code || (n && !tr_list_reserve(g, n, c->st))) return;
    g->n = n;
    TR_KEEP(c, g->a, n);
    TR_KEEP(c, g->b, n);
    check_pairs(c, g->a, g->b, n, g->walls ? world->n_walls : 0, disks);
    for (int k = 0; k < g->n_hist; k++) TR_KEEP(c, g->hist[k], n);
    for (int k = 0; k < g->n_pair; k++) TR_KEEP(c, g->pair[k], n);
}

void tr_world_checkpoint(tr_world *world, tr_checkpoint *c) {
    tr_disks *d = &world->disks;
    if (c->loading) tr_parallel_free(world->parallel), world->parallel = NULL; /* which are of another list */
    keep_disks(world, c);
    keep_box(world, c);
    TR_KEEP(c, &world->steps, 1);
    TR_KEEP(c, &world->contact_updates, 1);
    TR_KEEP(c, &world->searches, 1);
    TR_KEEP(c, &world->refreshes, 1);
    TR_KEEP(c, &world->fresh, 1);
    TR_KEEP(c, &world->stale, 1);
    TR_KEEP(c, &world->wall_moved, 1);
    TR_KEEP(c, world->wide_ref, 2 * d->n);
    TR_KEEP(c, world->thin_ref, 2 * d->n);
    TR_KEEP_NUMBERS(c, &world->wide_extent, 1);
    TR_KEEP_NUMBERS(c, &world->thin_extent, 1);
    keep_near(&world->near, d->n, c);
    for (int k = 0; k < world->n_groups; k++) keep_group(&world->group[k], world, c);
    if (world->ledger) TR_KEEP_NUMBERS(c, world->ledger, 1);
}

void tr_biaxial_checkpoint(tr_biaxial *b, tr_checkpoint *c) {
    tr_world_checkpoint(&b->world, c);
    TR_KEEP(c, &b->mu, 1);
    TR_KEEP(c, &b->height0, 1);
    TR_KEEP(c, &b->shear_start, 1);
    int64_t sheared = b->world.steps - b->shear_start;
    tr_checkpoint_check(c, sheared >= 0 && (!b->shear_steps || sheared <= b->shear_steps), "a number of steps");
    tr_checkpoint_check(c, !b->shear_steps || b->height0 > 0, "a height");
    TR_KEEP(c, b->stress_sum, 4);
    TR_KEEP(c, &b->stress_steps, 1);
    TR_KEEP(c, &b->held_sum, 1);
    TR_KEEP(c, &b->held_strain, 1);
}

void tr_biaxial_packing(tr_biaxial *b, tr_checkpoint *c) {
    tr_world *world = &b->world;
    keep_disks(world, c);
    keep_box(world, c);
    TR_KEEP(c, &world->steps, 1);
    TR_KEEP(c, &world->searches, 1);
    TR_KEEP(c, &world->refreshes, 1);
    if (world->group[0].n_hist) keep_group(&world->group[0], world, c);
}
