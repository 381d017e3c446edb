/* SPDX-License-Identifier: MIT */
#include "core/step.h"

#include "base/vector.h"
#include "core/cell.h"
#include "core/contacts.h"
#include "core/parallel_forces.h"
#include "core/stretch.h"
#include "core/tile.h"
#include "base/math.h"
#include <math.h>
#include <string.h>

/* ---- the walk over the tiles ---- */

static void run_passes(tr_world *world, tr_group *g, int first, double dt) {
    tr_tile *tile = world->tile;
    tr_tile_gather(world, g, tile, first, dt);
    for (int k = 0; k < g->n_pass; k++) g->pass[k].run(tile, &g->pass[k].data);
}

void tr_step_walk(tr_world *world, tr_group *g, double dt, void (*done)(void *, tr_group *, tr_tile *), void *context) {
    /* Lanes that this pipeline does not write may have values of the other group. */
    tr_tile *tile = world->tile;
    if (!g->laws[TR_FRICTION].law->step) memset(tile->f_t, 0, sizeof tile->f_t);
    if (!g->laws[TR_ROLLING].law->step) memset(tile->m1, 0, sizeof tile->m1), memset(tile->m2, 0, sizeof tile->m2);
    for (int first = 0; first < g->n; first += TR_TILE) {
        run_passes(world, g, first, dt);
        done(context, g, tile);
    }
}

static void group_forces(tr_world *world, tr_group *g, double dt) {
    for (int first = 0; first < g->n; first += TR_TILE) {
        run_passes(world, g, first, dt);
        world->contact_updates += world->tile->touching;
        tr_tile_scatter(world->tile, g, world);
        if (!g->walls && world->cell.side[0] > 0) tr_cell_add_virial(&world->cell, world->tile);
    }
}

bool tr_step_forces(tr_world *world, tr_status *st) {
    if (world->stale && !tr_contacts_refresh(world, st)) return false;
    for (int w = 0; w < world->n_walls; w++) world->wall[w].fx = world->wall[w].fy = 0;
    world->cell.virial[0] = world->cell.virial[1] = 0;
    double dt = world->fresh ? 0 : world->dt;
    if (!world->spent || world->disks.load) tr_tile_begin(&world->disks);
    world->spent = false;
    if (tr_world_threads(world) > 1 && !world->group[0].in_order) {
        if (!tr_parallel_forces(world, dt, st)) return false;
    } else {
        group_forces(world, &world->group[0], dt);
    }
    for (int k = 1; k < world->n_groups; k++) group_forces(world, &world->group[k], dt);
    world->fresh = false;
    return true;
}

/* ---- integration ---- */

/* Forces are left at 0 for the next step: a pass over them less, 8 % of a step of 100,000 disks. */
TR_VECTOR static void kick_and_drift(int lanes, double dt, double *restrict pos, double *restrict vel,
                                     double *restrict force, const double *restrict inv) {
    for (int k = 0; k < lanes; k++) {
        vel[k] += dt * inv[k] * force[k];
        force[k] = 0;
        pos[k] += dt * vel[k];
    }
}

/* The number of centres further than `reach` from their stretched place; NaN counts as one. */
TR_VECTOR static int count_moved(int n, double reach, const tr_stretch *s, const double *restrict pos,
                                 const double *restrict ref) {
    const double sx = s->scale[0], sy = s->scale[1], ox = s->offset[0], oy = s->offset[1];
    int moved = 0;
    for (int i = 0; i < n; i++) {
        double dx = pos[tr_body(i)] - (sx * ref[2 * i] + ox), dy = pos[tr_body(i) + TR_Y] - (sy * ref[2 * i + 1] + oy);
        moved += !(dx * dx + dy * dy <= reach * reach);
    }
    return moved;
}

static void move_walls(tr_world *world) {
    double fastest = 0;
    for (int w = 0; w < world->n_walls; w++) {
        tr_wall *wall = &world->wall[w];
        if (wall->mass > 0) { /* a piston: the outside pushes with load along n, the disks push back */
            double v = wall->vx * wall->nx + wall->vy * wall->ny,
                   push = wall->load + wall->fx * wall->nx + wall->fy * wall->ny;
            v += world->dt * push / wall->mass;
            v = fmin(fmax(v, -wall->v_max), wall->v_max);
            wall->vx = v * wall->nx, wall->vy = v * wall->ny;
        } else if (wall->gain != 0) {
            wall->vx += world->dt * wall->gain * wall->nx, wall->vy += world->dt * wall->gain * wall->ny;
        }
        wall->x += world->dt * wall->vx, wall->y += world->dt * wall->vy;
        fastest =
            fmax(fastest, wall->ends ? tr_hypot(wall->vx, wall->vy) : fabs(wall->vx * wall->nx + wall->vy * wall->ny));
    }
    if (!world->boxed) world->wall_moved += world->dt * fastest;
}

typedef struct motion {
    tr_world *world;
    int threads;
    double reach;
    tr_stretch stretch;
} motion;

/* In blocks, so that a disk is still in the cache when it is checked. */
static void advance_disks(void *context, int k) {
    enum { BLOCK = 256 };
    const motion *m = context;
    const tr_disks *d = &m->world->disks;
    int high = tr_threads_chunk(d->n, k + 1, m->threads), moved = 0;
    for (int first = tr_threads_chunk(d->n, k, m->threads); first < high; first += BLOCK) {
        int n = high - first < BLOCK ? high - first : BLOCK;
        size_t at = tr_body(first);
        kick_and_drift(4 * n, m->world->dt, d->pos + at, d->vel + at, d->force + at, d->inv + at);
        moved += count_moved(n, m->reach, &m->stretch, d->pos + at, m->world->thin_ref + at / 2);
    }
    if (moved) __atomic_store_n(&m->world->stale, true, __ATOMIC_RELAXED);
}

void tr_step_advance(tr_world *world) {
    if (world->cell.side[0] > 0) tr_cell_advance(world);
    move_walls(world);
    tr_extent now = tr_stretch_extent(world);
    motion m = {
        .world = world, .threads = tr_world_threads(world), .stretch = tr_stretch_of(&world->thin_extent, &now)};
    m.reach = tr_stretch_reach(world, &m.stretch, world->thin_skin, 0);
    tr_threads_run(world->threads, advance_disks, &m);
    world->spent = true;
    world->steps++;
    if (!(m.reach >= world->wall_moved)) world->stale = true; /* also where it is negative */
}
