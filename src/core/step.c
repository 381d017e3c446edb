/* SPDX-License-Identifier: MIT */
#include "core/step.h"

#include "base/vector.h"
#include "core/cell.h"
#include "core/contacts.h"
#include <math.h>
#include <string.h>

/* ---- gather: from the bodies to the tile ---- */
/* Four contacts at a time: loads of 32 bytes, turned in registers into lanes, stored as whole vectors. Against one
 * number at a time the whole step gains 15 % (`trundle bench`). It may read up to three contacts behind the end of the
 * list; see contacts.c. */

/* Numbers 0, 1 and 2 of four quads, each as a vector. */
typedef struct lanes {
    tr_quad x, y, z;
} lanes;

static inline lanes turn(const tr_quad *p, const tr_quad *q, const tr_quad *r, const tr_quad *s) {
    tr_quad even_pq = __builtin_shufflevector(*p, *q, 0, 4, 2, 6), odd_pq = __builtin_shufflevector(*p, *q, 1, 5, 3, 7);
    tr_quad even_rs = __builtin_shufflevector(*r, *s, 0, 4, 2, 6), odd_rs = __builtin_shufflevector(*r, *s, 1, 5, 3, 7);
    return (lanes){__builtin_shufflevector(even_pq, even_rs, 0, 1, 4, 5),
                   __builtin_shufflevector(odd_pq, odd_rs, 0, 1, 4, 5),
                   __builtin_shufflevector(even_pq, even_rs, 2, 3, 6, 7)};
}

TR_VECTOR static void gather_disks(tr_tile *restrict tile, const tr_group *g, const tr_disks *d) {
    const tr_quad *restrict pos = (const tr_quad *)d->pos, *restrict vel = (const tr_quad *)d->vel;
    for (int i = 0; i < tile->n; i += 4) {
        const int *a = g->a + tile->first + i, *b = g->b + tile->first + i;
        lanes x1 = turn(&pos[a[0]], &pos[a[1]], &pos[a[2]], &pos[a[3]]);
        lanes x2 = turn(&pos[b[0]], &pos[b[1]], &pos[b[2]], &pos[b[3]]);
        lanes v1 = turn(&vel[a[0]], &vel[a[1]], &vel[a[2]], &vel[a[3]]);
        lanes v2 = turn(&vel[b[0]], &vel[b[1]], &vel[b[2]], &vel[b[3]]);
        *(tr_quad *)&tile->dx[i] = x2.x - x1.x, *(tr_quad *)&tile->dy[i] = x2.y - x1.y;
        *(tr_quad *)&tile->dvx[i] = v2.x - v1.x, *(tr_quad *)&tile->dvy[i] = v2.y - v1.y;
        *(tr_quad *)&tile->w1[i] = v1.z, *(tr_quad *)&tile->w2[i] = v2.z;
    }
}

static void gather_walls(tr_tile *restrict tile, const tr_group *g, const tr_disks *d, const tr_wall *wall) {
    for (int i = 0; i < tile->n; i++) {
        const tr_wall *w = &wall[g->a[tile->first + i]];
        const double *q = d->pos + 4 * (size_t)g->b[tile->first + i], *v = d->vel + 4 * (size_t)g->b[tile->first + i];
        tile->nx[i] = w->nx, tile->ny[i] = w->ny;
        tile->dx[i] = tr_contacts_wall_distance(w, q);
        tile->dvx[i] = v[0] - w->vx, tile->dvy[i] = v[1] - w->vy;
        tile->w1[i] = 0, tile->w2[i] = v[2];
    }
}

/* ---- scatter: from the tile to the bodies ---- */
/* The force of a body is the sum over its contacts in the order of the list, whoever adds it up. */

TR_VECTOR static void scatter_disks(const tr_tile *restrict tile, const tr_group *g, const tr_disks *d) {
    const int *restrict a = g->a + tile->first, *restrict b = g->b + tile->first;
    tr_quad *force = (tr_quad *)d->force;
    for (int i = 0; i < tile->n; i++) {
        force[a[i]] += (tr_quad){-tile->fx[i], -tile->fy[i], tile->q1[i], 0};
        force[b[i]] += (tr_quad){tile->fx[i], tile->fy[i], tile->q2[i], 0};
    }
}

static void scatter_walls(const tr_tile *tile, const tr_group *g, const tr_disks *d, tr_wall *wall) {
    for (int i = 0; i < tile->n; i++) {
        tr_wall *w = &wall[g->a[tile->first + i]];
        w->fx -= tile->fx[i], w->fy -= tile->fy[i];
        ((tr_quad *)d->force)[g->b[tile->first + i]] += (tr_quad){tile->fx[i], tile->fy[i], tile->q2[i], 0};
    }
}

/* ---- the walk over the tiles ---- */

static void run_passes(tr_world *world, tr_group *g, int first, double dt) {
    tr_tile *tile = world->tile;
    tile->dt = dt;
    tile->first = first;
    tile->n = g->n - first < TR_TILE ? g->n - first : TR_TILE;
    tile->R1 = g->pair[0] + first, tile->R2 = g->pair[1] + first, tile->g1 = g->pair[2] + first;
    if (g->walls)
        gather_walls(tile, g, &world->disks, world->wall);
    else
        gather_disks(tile, g, &world->disks);
    if (!g->walls && world->cell.side[0] > 0) tr_cell_shift(&world->cell, g, tile);
    for (int k = 0; k < g->n_pass; k++) g->pass[k].run(tile, &g->pass[k].data);
}

void tr_step_walk(tr_world *world, tr_group *g, double dt, void (*done)(void *, tr_group *, tr_tile *), void *context) {
    /* Lanes that this pipeline does not write may hold those of the other group. */
    tr_tile *tile = world->tile;
    if (!g->slot[TR_FRICTION].law->step) memset(tile->f_t, 0, sizeof tile->f_t);
    if (!g->slot[TR_ROLLING].law->step) memset(tile->m1, 0, sizeof tile->m1), memset(tile->m2, 0, sizeof tile->m2);
    for (int first = 0; first < g->n; first += TR_TILE) {
        run_passes(world, g, first, dt);
        done(context, g, tile);
    }
}

static void group_forces(tr_world *world, tr_group *g, double dt) {
    for (int first = 0; first < g->n; first += TR_TILE) {
        run_passes(world, g, first, dt);
        world->contact_updates += world->tile->touching;
        if (g->walls)
            scatter_walls(world->tile, g, &world->disks, world->wall);
        else
            scatter_disks(world->tile, g, &world->disks);
        if (!g->walls && world->cell.side[0] > 0) tr_cell_add_virial(&world->cell, world->tile);
    }
}

bool tr_step_forces(tr_world *world, tr_status *st) {
    tr_disks *d = &world->disks;
    if (world->stale && !tr_contacts_refresh(world, st)) return false;
    if (d->load)
        memcpy(d->force, d->load, (size_t)d->n * 4 * sizeof *d->force);
    else
        memset(d->force, 0, (size_t)d->n * 4 * sizeof *d->force);
    for (int w = 0; w < world->n_walls; w++) world->wall[w].fx = world->wall[w].fy = 0;
    world->cell.virial[0] = world->cell.virial[1] = 0;
    double dt = world->fresh ? 0 : world->dt;
    group_forces(world, &world->group[0], dt);
    group_forces(world, &world->group[1], dt);
    world->fresh = false;
    return true;
}

/* ---- integration ---- */

TR_VECTOR static void kick_and_drift(int lanes, double dt, double *restrict pos, double *restrict vel,
                                     const double *restrict force, const double *restrict inv) {
    for (int k = 0; k < lanes; k++) {
        vel[k] += dt * inv[k] * force[k];
        pos[k] += dt * vel[k];
    }
}

/* How many centres are further than `reach` from where they were; NaN counts as gone. */
TR_VECTOR static int count_moved(int n, double reach, const double *restrict pos, const double *restrict ref) {
    int moved = 0;
    for (int i = 0; i < n; i++) {
        double dx = pos[4 * i] - ref[2 * i], dy = pos[4 * i + 1] - ref[2 * i + 1];
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
        }
        wall->x += world->dt * wall->vx, wall->y += world->dt * wall->vy;
        fastest = fmax(fastest, fabs(wall->vx * wall->nx + wall->vy * wall->ny));
    }
    world->wall_moved += world->dt * fastest;
}

void tr_step_advance(tr_world *world) {
    const tr_disks *d = &world->disks;
    if (world->cell.side[0] > 0) tr_cell_advance(world);
    kick_and_drift(4 * d->n, world->dt, d->pos, d->vel, d->force, d->inv);
    move_walls(world);
    world->steps++;
    /* Two bodies that approach each other move half the skin each, less what the image of one has moved besides. */
    double reach = (world->thin_skin - world->cell.moved[0]) / 2;
    if (!(reach >= world->wall_moved) || count_moved(d->n, reach, d->pos, world->thin_ref)) world->stale = true;
}
