/* SPDX-License-Identifier: MIT */
#include "core/list.h"

#include "base/alloc.h"
#include "base/vector.h"
#include "core/cell.h"
#include <stdlib.h>
#include <string.h>

enum {
    BEHIND = 3, /* gather reads four contacts at a time: valid ids behind the end of the list */
    LINE = 8,   /* doubles in a cache line */
};

/* All histories and pair constants in one block, each an odd number of cache lines behind the one before. Large arrays
 * that are allocated one by one begin at the same place of a page; a law with many of them found few of its numbers in
 * the first-level cache. */
static bool grow_rows(tr_group *g, size_t keep, size_t length, tr_status *st) {
    double *block = tr_alloc((size_t)(g->n_hist + g->n_pair + 1) * length, sizeof *block, st), *row = block;
    if (!block) return false;
    for (int k = 0; k < g->n_hist + g->n_pair; k++, row += length) {
        double **array = k < g->n_hist ? &g->hist[k] : &g->pair[k - g->n_hist];
        if (*array) memcpy(row, *array, keep * sizeof *row);
        *array = row;
    }
    free(g->block);
    g->block = block, g->spare = row;
    return true;
}

bool tr_list_reserve(tr_group *g, int n, tr_status *st) {
    bool whole = !g->n_hist || g->hist[g->n_hist - 1]; /* a sink may have been added since */
    if (whole && n + BEHIND <= g->capacity) return true;
    size_t now = (size_t)g->n, old = (size_t)g->old_n;
    size_t grown = (((size_t)n + (size_t)n / 4 + TR_TILE) / LINE | 1) * LINE;
    bool ok = tr_alloc_grow(&g->a, now, grown, sizeof(int), st) && tr_alloc_grow(&g->b, now, grown, sizeof(int), st) &&
              tr_alloc_grow(&g->old_a, old, grown, sizeof(int), st) &&
              tr_alloc_grow(&g->old_b, old, grown, sizeof(int), st) &&
              tr_alloc_grow(&g->source, 0, grown, sizeof(int), st) && grow_rows(g, now > old ? now : old, grown, st);
    if (ok) g->capacity = (int)grown;
    return ok;
}

static void swap_ints(int **a, int **b) {
    int *t = *a;
    *a = *b, *b = t;
}

void tr_list_begin(tr_group *g) {
    swap_ints(&g->a, &g->old_a);
    swap_ints(&g->b, &g->old_b);
    g->old_n = g->n;
    g->n = 0;
}

/* Data of the threads: each has a range of the new list. */
typedef struct renewal {
    const tr_world *world;
    tr_group *g;
    int threads;
    double *from, *to;
    const tr_group_law *slot;
    const int *z;
} renewal;

static int first_of(const renewal *r, int k) {
    return tr_threads_chunk(r->g->n, k, r->threads);
}

static bool before(const tr_group *g, int old, int a, int b) {
    return g->old_a[old] < a || (g->old_a[old] == a && g->old_b[old] < b);
}

/* Number of the first contact of the old list that is not before (a, b). */
static int old_from(const tr_group *g, int a, int b) {
    int low = 0, high = g->old_n;
    while (low < high) {
        int mid = low + (high - low) / 2;
        if (before(g, mid, a, b))
            low = mid + 1;
        else
            high = mid;
    }
    return low;
}

static void find_sources(void *context, int k) {
    const renewal *r = context;
    tr_group *g = r->g;
    int low = first_of(r, k), high = first_of(r, k + 1), old = low < high ? old_from(g, g->a[low], g->b[low]) : 0;
    for (int i = low; i < high; i++) {
        int a = g->a[i], b = g->b[i];
        while (old < g->old_n && before(g, old, a, b)) old++;
        g->source[i] = old < g->old_n && g->old_a[old] == a && g->old_b[old] == b ? old : -1;
    }
}

static void carry(void *context, int k) {
    const renewal *r = context;
    const int *restrict source = r->g->source;
    const double *restrict from = r->from;
    double *restrict to = r->to;
    int high = first_of(r, k + 1);
    for (int i = first_of(r, k); i < high; i++) to[i] = source[i] < 0 ? 0 : from[source[i]];
}

static void carry_array(renewal *r, double **array) {
    tr_group *g = r->g;
    r->from = *array, r->to = g->spare;
    tr_threads_run(r->world->threads, carry, r);
    g->spare = *array, *array = r->to;
}

static void new_pairs(void *context, int k) {
    const renewal *r = context;
    const tr_periodic_cell *cell = &r->world->cell;
    tr_group *g = r->g;
    const double *pos = r->world->disks.pos;
    int high = first_of(r, k + 1);
    for (int i = first_of(r, k); i < high; i++) {
        if (g->source[i] >= 0) continue;
        double R1 = g->walls ? 0 : pos[tr_body(g->a[i]) + TR_RADIUS], R2 = pos[tr_body(g->b[i]) + TR_RADIUS];
        g->pair[TR_PAIR_R1][i] = R1, g->pair[TR_PAIR_R2][i] = R2;
        g->pair[TR_PAIR_G1][i] = g->walls ? 1 : R1 / (R1 + R2);
    }
    for (int i = first_of(r, k); i < high && !g->walls && cell->side[0] > 0; i++)
        for (int axis = 0; axis < 2; axis++) {
            double p = pos[tr_body(g->a[i]) + (size_t)axis], q = pos[tr_body(g->b[i]) + (size_t)axis];
            g->pair[TR_PAIR_IMAGE_X + axis][i] = tr_broad_image(p, q, cell->side[axis]);
        }
}

void tr_list_carry(const tr_world *world, tr_group *g) {
    if (!g->capacity) return;
    renewal r = {.world = world, .g = g, .threads = tr_world_threads(world)};
    tr_threads_run(world->threads, find_sources, &r);
    for (int k = 0; k < g->n_hist; k++) carry_array(&r, &g->hist[k]);
    for (int k = 0; k < g->n_pair; k++) carry_array(&r, &g->pair[k]);
    tr_threads_run(world->threads, new_pairs, &r);
    for (int k = 0; k < BEHIND; k++) g->a[g->n + k] = g->b[g->n + k] = 0;
}

static void constants(void *context, int k) {
    const renewal *r = context;
    const tr_group *g = r->g;
    const tr_law *law = r->slot->law;
    bool all = law->needs & TR_NEEDS_Z;
    int high = first_of(r, k + 1);
    for (int i = first_of(r, k); i < high; i++) {
        if (!all && g->source[i] >= 0) continue;
        double made[TR_MAX_PAIR];
        tr_pair_bodies bodies = tr_world_pair(r->world, g, g->a[i], g->b[i]);
        if (all) bodies.z1 = g->walls ? 1 : r->z[g->a[i]], bodies.z2 = r->z[g->b[i]];
        law->pair(r->slot->par, &bodies, made);
        for (int c = 0; c < law->n_pair; c++) g->pair[r->slot->pair + c][i] = made[c];
    }
}

static void count_listed(const tr_world *world, int *z) {
    const tr_group *g = world->group;
    memset(z, 0, (size_t)world->disks.n * sizeof *z);
    for (int i = 0; i < g[0].n; i++) z[g[0].a[i]]++, z[g[0].b[i]]++;
    for (int k = 1; k < world->n_groups; k++)
        for (int i = 0; i < g[k].n; i++) z[g[k].b[i]]++;
}

void tr_list_constants(tr_world *world, int *z) {
    for (int k = 0; k < world->n_groups; k++)
        for (int s = 0; s < TR_N_LAW_KINDS; s++) {
            tr_group *g = &world->group[k];
            const tr_group_law *slot = &g->laws[s];
            if (!slot->law->n_pair || !g->n) continue;
            if (slot->law->needs & TR_NEEDS_Z) count_listed(world, z);
            renewal r = {.world = world, .g = g, .threads = tr_world_threads(world), .slot = slot, .z = z};
            tr_threads_run(world->threads, constants, &r);
        }
}
