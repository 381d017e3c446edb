/* SPDX-License-Identifier: MIT */
/* Time of a step against the number of disks.
 *
 * PACKING. Compacting a million disks takes days, so a larger sample is a wall of tiles: one sample of 1000 disks,
 * compacted like any other, and its mirror images. A disk that pressed on a wall now presses on its own image, with
 * twice the overlap, which is a thousandth of a diameter, until both have moved. Numbers are by place, as in a
 * generated sample.
 *
 * MOTION. All start with the homogeneous approach of the walls that drive the shear. Otherwise, in a large sample, the
 * motion of the walls would need thousands of steps to reach the inside. The strain rate is the same for all sizes, so
 * in a larger sample disks move faster and lists are made more often. This is a cost of size and is measured.
 *
 * A CYCLE is all steps from a search (the wide list) up to the next. */
#include "study/bench_sizes.h"
#include "base/math.h"

#include "study/bench.h"

#include "base/alloc.h"
#include "core/biaxial.h"
#include "core/sample.h"
#include "core/step.h"
#include <math.h>
#include <stdlib.h>

enum { TILE = 1000 };

typedef struct subject {
    tr_scene scene; /* the scene of all, except for the number of disks */
    tr_biaxial b;
    double search; /* time of the forces at the start of the next cycle [s] */
    double us[TR_BENCH_CYCLES], ns[TR_BENCH_CYCLES];
} subject;

bool tr_bench_compact(tr_biaxial *b, tr_status *st) {
    double unbalanced;
    bool done = false;
    while (!done)
        if (!tr_biaxial_compact(b, 200, &unbalanced, &done, st)) return false;
    return true;
}

/* Coordinate v in tile number k of a row of tiles of this pitch; every other tile is a mirror image. */
static double unfold(double v, double pitch, int k) {
    return k % 2 ? (k + 1) * pitch - v : k * pitch + v;
}

bool tr_bench_tile(tr_biaxial *to, const tr_biaxial *tile, tr_status *st) {
    int n = to->world.disks.n, of_tile = tile->world.disks.n, tiles = n / of_tile, rows = (int)sqrt(tiles);
    while (tiles % rows) rows--;
    int columns = tiles / rows;
    const tr_wall *w = tile->world.wall;
    double x0 = w[TR_LEFT_WALL].x, y0 = w[TR_BOTTOM_WALL].y, width = w[TR_RIGHT_WALL].x - x0,
           height = w[TR_TOP_WALL].y - y0;
    double *pos = tr_alloc((size_t)n * 4, sizeof *pos, st);
    for (int i = 0; pos && i < n; i++) {
        const double *q = tile->world.disks.pos + tr_body(i % of_tile);
        pos[tr_body(i)] = unfold(q[0] - x0, width, i / of_tile % columns);
        pos[tr_body(i) + TR_Y] = unfold(q[1] - y0, height, i / of_tile / columns);
        pos[tr_body(i) + TR_RADIUS] = q[3];
    }
    double side = fmax(columns * width, rows * height);
    bool ok = pos && tr_sample_number(&to->world, pos, side, tile->scene->sample.density, st);
    tr_wall *wall = to->world.wall;
    wall[TR_LEFT_WALL].x = wall[TR_BOTTOM_WALL].y = 0;
    wall[TR_RIGHT_WALL].x = columns * width, wall[TR_TOP_WALL].y = rows * height;
    free(pos);
    return ok;
}

static void flow(tr_biaxial *b) {
    const tr_wall *w = b->world.wall;
    double y = (w[TR_BOTTOM_WALL].y + w[TR_TOP_WALL].y) / 2;
    for (int i = 0; i < b->world.disks.n; i++)
        b->world.disks.vel[tr_body(i) + TR_Y] = -b->rate * (b->world.disks.pos[tr_body(i) + TR_Y] - y);
}

static bool prepare(subject *s, const tr_scene *scene, int disks, int threads, const tr_biaxial *tile,
                    tr_status *st) {
    s->scene = *scene;
    s->scene.sample.disks = disks;
    if (!tr_biaxial_init(&s->b, &s->scene, st) || !tr_world_set_threads(&s->b.world, threads, st)) return false;
    if (disks <= TILE ? !tr_bench_compact(&s->b, st) : !tr_bench_tile(&s->b, tile, st)) return false;
    if (!tr_biaxial_begin_shear(&s->b, st)) return false;
    flow(&s->b);
    double start = tr_bench_clock(&s->b.world);
    if (!tr_biaxial_forces(&s->b, st)) return false; /* the first search */
    s->search = tr_bench_clock(&s->b.world) - start;
    return true;
}

/* Cycle -1 is not counted. A cycle of a million disks takes two minutes, as long as all others: only one, and it
 * counts. */
static int cycles(int disks) {
    return disks > 100000 ? 1 : TR_BENCH_CYCLES;
}

static bool has_cycle(int disks, int k) {
    return k < cycles(disks) && (k >= 0 || cycles(disks) == TR_BENCH_CYCLES);
}

/* The clock is read only at new lists: reading it takes a tenth of a step of 100 disks. */
static bool run_cycle(subject *s, int k, tr_bench_size *r, tr_status *st) {
    tr_world *world = &s->b.world;
    int64_t searches = world->searches, refreshes = world->refreshes, updates = world->contact_updates, last = updates,
            steps = 0;
    double listed = world->group[0].n + world->group[1].n, renewing = s->search,
           start = tr_bench_clock(world) - s->search, end = start;
    do {
        tr_step_advance(world);
        steps++;
        bool renew = world->stale;
        if (renew) end = tr_bench_clock(world), last = world->contact_updates;
        if (!tr_biaxial_forces(&s->b, st)) return false;
        if (renew) s->search = tr_bench_clock(world) - end;
        if (world->searches == searches && renew) renewing += s->search;
    } while (world->searches == searches);
    if (k < 0) return true;
    double seconds = end - start, lists = (double)(world->refreshes - refreshes), n = (double)steps;
    double touched = (double)(last - updates) * n / (n - 1); /* in the last n - 1 force calculations */
    s->us[k] = 1e6 * seconds / n;
    s->ns[k] = 1e9 * seconds / touched;
    double part = 1.0 / cycles(r->disks);
    r->touching += part * touched / n, r->listed += part * listed;
    r->steps += part * n, r->refreshes += part * lists;
    r->rebuild += part * (1 - (seconds - renewing) / (n - lists) * n / seconds);
    return true;
}

bool tr_bench_sizes(const tr_scene *scene, int threads, tr_bench_size *sizes, int n, tr_status *st) {
    subject *s = tr_alloc((size_t)n + 1, sizeof *s, st), *tile = s + n;
    bool ok = s != NULL;
    if (ok && sizes[n - 1].disks > TILE) {
        tile->scene = *scene;
        tile->scene.sample.disks = TILE;
        ok = tr_biaxial_init(&tile->b, &tile->scene, st) && tr_bench_compact(&tile->b, st);
    }
    for (int i = 0; ok && i < n; i++) ok = prepare(&s[i], scene, sizes[i].disks, threads, &tile->b, st);
    for (int k = -1; ok && k < TR_BENCH_CYCLES; k++)
        for (int i = 0; ok && i < n; i++)
            if (has_cycle(sizes[i].disks, k)) ok = run_cycle(&s[i], k, &sizes[i], st);
    for (int i = 0; ok && i < n; i++) {
        sizes[i].us = tr_bench_quartiles(s[i].us, cycles(sizes[i].disks));
        sizes[i].ns = tr_bench_quartiles(s[i].ns, cycles(sizes[i].disks));
        sizes[i].bytes_per_disk = (double)tr_world_bytes(&s[i].b.world) / sizes[i].disks;
    }
    for (int i = 0; s && i <= n; i++) tr_biaxial_free(&s[i].b);
    free(s);
    return ok;
}

double tr_bench_slope(const double *x, const double *y, int n) {
    double mx = 0, my = 0, xx = 0, xy = 0;
    for (int i = 0; i < n; i++) mx += tr_log(x[i]) / n, my += tr_log(y[i]) / n;
    for (int i = 0; i < n; i++)
        xx += (tr_log(x[i]) - mx) * (tr_log(x[i]) - mx), xy += (tr_log(x[i]) - mx) * (tr_log(y[i]) - my);
    return xy / xx;
}
