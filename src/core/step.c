/* SPDX-License-Identifier: MIT */
#include "core/step.h"

#include "base/alloc.h"
#include "base/threads.h"
#include "base/vector.h"
#include "core/cell.h"
#include "core/contacts.h"
#include <math.h>
#include <string.h>

/* ---- gather: from the bodies to the tile ---- */
/* Four contacts at a time: loads of 32 bytes, of which differences are taken before they are turned in registers into lanes, stored
 * as whole vectors. Against one number at a time the whole step gains 15 % (`trundle bench`). It may read up to three
 * contacts behind the end of the list; see contacts.c. */

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

/* A tile's contacts with one wall lie side by side: those from i to before the end that is returned. */
static int same_wall(const tr_tile *tile, const tr_group *g, int i) {
    const int *a = g->a + tile->first;
    int end = i + 1;
    while (end < tile->n && a[end] == a[i]) end++;
    return end;
}

TR_VECTOR static void gather_walls(tr_tile *restrict tile, const tr_group *g, const tr_disks *d, const tr_wall *wall) {
    for (int i = 0, end; i < tile->n; i = end) {
        const tr_wall w = wall[g->a[tile->first + i]];
        end = same_wall(tile, g, i);
        for (int k = i; k < end; k++) {
            size_t at = 4 * (size_t)g->b[tile->first + k];
            const double *q = d->pos + at, *v = d->vel + at;
            tile->nx[k] = w.nx, tile->ny[k] = w.ny;
            tile->dx[k] = tr_contacts_wall_distance(&w, q);
            tile->dvx[k] = v[0] - w.vx, tile->dvy[k] = v[1] - w.vy;
            tile->w1[k] = 0, tile->w2[k] = v[2];
        }
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

/* ---- the walk over the tiles ---- */

static void gather(const tr_world *world, const tr_group *g, tr_tile *tile, int first, double dt) {
    tile->dt = dt;
    tile->first = first;
    tile->n = g->n - first < TR_TILE ? g->n - first : TR_TILE;
    tile->R1 = g->pair[0] + first, tile->R2 = g->pair[1] + first, tile->g1 = g->pair[2] + first;
    if (g->walls)
        gather_walls(tile, g, &world->disks, world->wall);
    else
        gather_disks(tile, g, &world->disks);
    if (!g->walls && world->cell.side[0] > 0) tr_cell_shift(&world->cell, g, tile);
}

static void run_passes(tr_world *world, tr_group *g, int first, double dt) {
    tr_tile *tile = world->tile;
    gather(world, g, tile, first, dt);
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

static void begin_forces(const tr_disks *d, int low, int high) {
    size_t at = 4 * (size_t)low, bytes = 4 * (size_t)(high - low) * sizeof *d->force;
    if (d->load)
        memcpy(d->force + at, d->load + at, bytes);
    else
        memset(d->force + at, 0, bytes);
}

/* ---- threads ---- */
/* The bits are those of one thread: what tiles give is stored, and then each thread adds up the forces on its share of the disks
 * in the order of the list; sums over tiles follow in theirs. One thread alone needs no store. */

static void tile_result(const tr_world *world, tr_group *g, tr_tile *tile, int first, double dt, tr_result *r) {
    tr_ledger lost = {.damped = 0};
    tr_sink sink = g->ledger_sink;
    sink.ledger = &lost;
    gather(world, g, tile, first, dt);
    for (int k = 0; k < g->n_pass; k++) {
        tr_law_data data = g->pass[k].data;
        if (data.par == &g->ledger_sink) data.par = &sink;
        g->pass[k].run(tile, &data);
    }
    memcpy(r->fx, tile->fx, sizeof r->fx), memcpy(r->fy, tile->fy, sizeof r->fy);
    memcpy(r->q1, tile->q1, sizeof r->q1), memcpy(r->q2, tile->q2, sizeof r->q2);
    r->lost[0] = lost.damped, r->lost[1] = lost.friction, r->lost[2] = lost.rolling;
    tr_periodic_cell cell = {0};
    if (world->cell.side[0] > 0) tr_cell_add_virial(&cell, tile);
    r->virial[0] = cell.virial[0], r->virial[1] = cell.virial[1];
    r->touching = tile->touching, r->last = 0;
    for (int i = 0; i < tile->n; i++) r->last = g->b[first + i] > r->last ? g->b[first + i] : r->last;
}

/* Forces on the disks from low to high - 1. Most tiles have none of them: a >= high, or b < low. */
TR_VECTOR static void add_results(const tr_result *result, const tr_group *g, const tr_disks *d, int low, int high) {
    tr_quad *force = (tr_quad *)d->force;
    for (int first = 0; first < g->n && g->a[first] < high; first += TR_TILE, result++) {
        const int *a = g->a + first, *b = g->b + first;
        if (result->last < low) continue;
        for (int i = 0; i < TR_TILE && first + i < g->n; i++) {
            double fx = result->fx[i], fy = result->fy[i];
            if (a[i] >= low && a[i] < high) force[a[i]] += (tr_quad){-fx, -fy, result->q1[i], 0};
            if (b[i] >= low && b[i] < high) force[b[i]] += (tr_quad){fx, fy, result->q2[i], 0};
        }
    }
}

static bool disk_forces(tr_world *world, double dt, tr_status *st) {
    tr_group *g = &world->group[0];
    const tr_disks *d = &world->disks;
    int tiles = (g->n + TR_TILE - 1) / TR_TILE, shares = tr_threads();
    if (tiles > world->results) {
        int grown = g->capacity / TR_TILE + 1;
        if (!tr_alloc_grow(&world->result, 0, (size_t)grown, sizeof *world->result, st)) return false;
        world->results = grown;
    }
    TR_OMP(omp parallel) {
        tr_tile tile;
        memset(&tile, 0, sizeof tile);
        TR_OMP(omp for schedule(static))
        for (int k = 0; k < tiles; k++) tile_result(world, g, &tile, k * TR_TILE, dt, &world->result[k]);
        TR_OMP(omp for schedule(static))
        for (int k = 0; k < shares; k++) {
            int low = (int)((int64_t)d->n * k / shares), high = (int)((int64_t)d->n * (k + 1) / shares);
            begin_forces(d, low, high);
            add_results(world->result, g, d, low, high);
        }
    }
    for (int k = 0; k < tiles; k++) {
        const tr_result *r = &world->result[k];
        world->contact_updates += r->touching;
        for (int axis = 0; axis < 2; axis++) world->cell.virial[axis] += r->virial[axis];
        if (!world->ledger) continue;
        world->ledger->damped += r->lost[0], world->ledger->friction += r->lost[1],
            world->ledger->rolling += r->lost[2];
    }
    return true;
}

bool tr_step_forces(tr_world *world, tr_status *st) {
    if (world->stale && !tr_contacts_refresh(world, st)) return false;
    for (int w = 0; w < world->n_walls; w++) world->wall[w].fx = world->wall[w].fy = 0;
    world->cell.virial[0] = world->cell.virial[1] = 0;
    double dt = world->fresh ? 0 : world->dt;
    if (tr_world_threads(world) > 1 && !world->group[0].in_order) {
        if (!disk_forces(world, dt, st)) return false;
    } else {
        begin_forces(&world->disks, 0, world->disks.n);
        group_forces(world, &world->group[0], dt);
    }
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

/* Block by block, so that a disk is still near when it is looked at. */
static int advance_disks(tr_world *world, double reach) {
    enum { BLOCK = 256 };
    const tr_disks *d = &world->disks;
    int moved = 0;
    TR_OMP(omp parallel for schedule(static) reduction(+ : moved) if (tr_world_threads(world) > 1))
    for (int first = 0; first < d->n; first += BLOCK) {
        int n = d->n - first < BLOCK ? d->n - first : BLOCK;
        size_t at = 4 * (size_t)first;
        kick_and_drift(4 * n, world->dt, d->pos + at, d->vel + at, d->force + at, d->inv + at);
        moved += count_moved(n, reach, d->pos + at, world->thin_ref + at / 2);
    }
    return moved;
}

void tr_step_advance(tr_world *world) {
    if (world->cell.side[0] > 0) tr_cell_advance(world);
    /* Two bodies that approach each other move half the skin each, less what the image of one has moved besides. */
    double reach = (world->thin_skin - world->cell.moved[0]) / 2;
    int moved = advance_disks(world, reach);
    move_walls(world);
    world->steps++;
    if (!(reach >= world->wall_moved) || moved) world->stale = true;
}
