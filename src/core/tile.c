/* SPDX-License-Identifier: MIT */
#include "core/tile.h"

#include "base/vector.h"
#include "core/cell.h"
#include "core/wall.h"
#include <string.h>

/* ---- gather: from the bodies to the tile ---- */
/* Four contacts at a time: loads of 32 bytes. Differences are taken first; then registers are transposed into lanes and
 * stored as whole vectors. Compared with one number at a time, the whole step gains 15 % (`trundle bench`). It may read
 * up to three contacts after the end of the list; see list.c. */

/* Two numbers of four quads, each as a vector. */
typedef struct lanes {
    tr_quad one, two;
} lanes;

static inline lanes turn(const tr_quad *even, const tr_quad *odd) {
    return (lanes){__builtin_shufflevector(*even, *odd, 0, 4, 2, 6), __builtin_shufflevector(*even, *odd, 1, 5, 3, 7)};
}
static inline lanes numbers_01(const tr_quad q[4]) {
    tr_quad even = __builtin_shufflevector(q[0], q[2], 0, 1, 4, 5),
            odd = __builtin_shufflevector(q[1], q[3], 0, 1, 4, 5);
    return turn(&even, &odd);
}
static inline lanes numbers_23(const tr_quad q[4]) {
    tr_quad even = __builtin_shufflevector(q[0], q[2], 2, 3, 6, 7),
            odd = __builtin_shufflevector(q[1], q[3], 2, 3, 6, 7);
    return turn(&even, &odd);
}

TR_VECTOR static void gather_disks(tr_tile *restrict tile, const tr_group *g, const tr_disks *d) {
    const tr_quad *restrict pos = (const tr_quad *)d->pos, *restrict vel = (const tr_quad *)d->vel;
    for (int i = 0; i < tile->n; i += 4) {
        const int *a = g->a + tile->first + i, *b = g->b + tile->first + i;
        tr_quad x[4], v[4], v1[4], v2[4];
        for (int k = 0; k < 4; k++) {
            x[k] = pos[b[k]] - pos[a[k]];
            v1[k] = vel[a[k]], v2[k] = vel[b[k]], v[k] = v2[k] - v1[k];
        }
        lanes dx = numbers_01(x), dv = numbers_01(v);
        *(tr_quad *)&tile->dx[i] = dx.one, *(tr_quad *)&tile->dy[i] = dx.two;
        *(tr_quad *)&tile->dvx[i] = dv.one, *(tr_quad *)&tile->dvy[i] = dv.two;
        *(tr_quad *)&tile->w1[i] = numbers_23(v1).one, *(tr_quad *)&tile->w2[i] = numbers_23(v2).one;
    }
}

/* A tile's contacts with one wall are consecutive: from i to before the returned end. */
static int same_wall(const tr_tile *tile, const tr_group *g, int i) {
    const int *a = g->a + tile->first;
    int end = i + 1;
    while (end < tile->n && a[end] == a[i]) end++;
    return end;
}

TR_VECTOR static void gather_walls(tr_tile *restrict tile, const tr_group *g, const tr_disks *d, const tr_wall *wall) {
    for (int i = 0, end; i < tile->n; i = end) {
        const tr_wall w = wall[g->a[tile->first + i]];
        const double vx = w.vx + w.belt * w.ny, vy = w.vy - w.belt * w.nx; /* of its surface */
        end = same_wall(tile, g, i);
        for (int k = i; k < end; k++) {
            size_t at = tr_body(g->b[tile->first + k]);
            const double *q = d->pos + at, *v = d->vel + at;
            tile->nx[k] = w.nx, tile->ny[k] = w.ny;
            tile->dx[k] = tr_wall_height(&w, q);
            tile->dvx[k] = v[0] - vx, tile->dvy[k] = v[1] - vy;
            tile->w1[k] = 0, tile->w2[k] = v[2];
        }
    }
}

/* Of walls with ends; g1 tells a face, 1, from a corner, 0. A corner that is another wall's touches nothing. */
static void gather_edges(tr_tile *tile, const tr_group *g, const tr_world *world) {
    for (int i = 0; i < tile->n; i++) {
        int contact = tile->first + i, number = g->a[contact];
        size_t at = tr_body(g->b[contact]);
        const double *q = world->disks.pos + at, *v = world->disks.vel + at;
        const tr_wall *w = &world->wall[number];
        tr_wall_touch touch = tr_wall_nearest(w, q);
        bool taken = touch.corner && tr_wall_taken(world, number, q);
        tile->nx[i] = touch.nx, tile->ny[i] = touch.ny;
        tile->dx[i] = taken ? 2 * q[3] : touch.distance;
        tile->dvx[i] = v[0] - w->vx - w->belt * touch.ny, tile->dvy[i] = v[1] - w->vy + w->belt * touch.nx;
        tile->w1[i] = 0, tile->w2[i] = v[2];
        g->pair[TR_PAIR_G1][contact] = touch.corner ? 0 : 1;
    }
}

/* ---- scatter: from the tile to the bodies ---- */
/* The force of a body is the sum over its contacts in the order of the list, in any thread. */

TR_VECTOR static void scatter_disks(const tr_tile *restrict tile, const tr_group *g, const tr_disks *d) {
    const int *restrict a = g->a + tile->first, *restrict b = g->b + tile->first;
    tr_quad *force = (tr_quad *)d->force;
    for (int i = 0; i < tile->n; i++) {
        force[a[i]] += (tr_quad){-tile->fx[i], -tile->fy[i], tile->q1[i], 0};
        force[b[i]] += (tr_quad){tile->fx[i], tile->fy[i], tile->q2[i], 0};
    }
}

TR_VECTOR static void scatter_walls(const tr_tile *restrict tile, const tr_group *g, const tr_disks *d, tr_wall *wall) {
    tr_quad *force = (tr_quad *)d->force;
    for (int i = 0, end; i < tile->n; i = end) {
        tr_wall *w = &wall[g->a[tile->first + i]];
        double fx = w->fx, fy = w->fy; /* in registers: through memory each sum would wait for the one before */
        end = same_wall(tile, g, i);
        for (int k = i; k < end; k++) {
            fx -= tile->fx[k], fy -= tile->fy[k];
            force[g->b[tile->first + k]] += (tr_quad){tile->fx[k], tile->fy[k], tile->q2[k], 0};
        }
        w->fx = fx, w->fy = fy;
    }
}

void tr_tile_gather(const tr_world *world, const tr_group *g, tr_tile *tile, int first, double dt) {
    tile->dt = dt;
    tile->first = first;
    tile->n = g->n - first < TR_TILE ? g->n - first : TR_TILE;
    tile->R1 = g->pair[TR_PAIR_R1] + first, tile->R2 = g->pair[TR_PAIR_R2] + first;
    tile->g1 = g->pair[TR_PAIR_G1] + first;
    if (g->ends)
        gather_edges(tile, g, world);
    else if (g->walls)
        gather_walls(tile, g, &world->disks, world->wall);
    else
        gather_disks(tile, g, &world->disks);
    if (!g->walls && world->cell.side[0] > 0) tr_cell_shift(&world->cell, g, tile);
}

void tr_tile_begin(const tr_disks *d) {
    size_t bytes = tr_body(d->n) * sizeof *d->force;
    if (d->load)
        memcpy(d->force, d->load, bytes);
    else
        memset(d->force, 0, bytes);
}

void tr_tile_scatter(const tr_tile *tile, const tr_group *g, tr_world *world) {
    if (g->walls)
        scatter_walls(tile, g, &world->disks, world->wall);
    else
        scatter_disks(tile, g, &world->disks);
}
