/* SPDX-License-Identifier: MIT */
#include "core/sample.h"

#include "base/alloc.h"
#include "base/random.h"
#include <math.h>
#include <stdlib.h>

static const double LOOSE_FRACTION =
    0.4; /* random sequential addition jams near 0.55; at this density a try succeeds soon */

enum { IN_CACHE = 2000 }; /* disks: so many are near in memory whatever their numbers */

/* Cells as wide as the largest disk, each with a chain of disks: neighbours are in the 3 x 3 cells around. */
typedef struct grid {
    int cells, *head, *next;
    double width, side; /* side: of a periodic box, else 0 */
} grid;

static int cell_of(const grid *g, double v) {
    int c = (int)(v / g->width);
    return c < 0 ? 0 : c >= g->cells ? g->cells - 1 : c;
}

static bool is_free(const grid *g, const double *pos, double x, double y, double R) {
    int cx = cell_of(g, x), cy = cell_of(g, y);
    for (int j = cy - 1; j <= cy + 1; j++)
        for (int i = cx - 1; i <= cx + 1; i++) {
            bool inside = i >= 0 && i < g->cells && j >= 0 && j < g->cells;
            if (!inside && !(g->side > 0)) continue;
            int cell = (j + g->cells) % g->cells * g->cells + (i + g->cells) % g->cells;
            for (int k = g->head[cell]; k >= 0; k = g->next[k]) {
                double dx = pos[tr_body(k)] - x, dy = pos[tr_body(k) + TR_Y] - y,
                       reach = pos[tr_body(k) + TR_RADIUS] + R;
                if (g->side > 0) dx -= g->side * rint(dx / g->side), dy -= g->side * rint(dy / g->side);
                if (dx * dx + dy * dy < reach * reach) return false;
            }
        }
    return true;
}

/* The position of the cell (x, y) along Hilbert's curve through a square of 2^16 x 2^16 cells [Hilbert1891]: quarter by
 * quarter, the first and the last one turned about their diagonals. */
static uint32_t along_curve(uint32_t x, uint32_t y) {
    uint32_t key = 0;
    for (uint32_t half = 1u << 15; half; half >>= 1) {
        bool right = x & half, upper = y & half;
        key = 4 * key + ((3u * right) ^ upper);
        if (upper) continue;
        if (right) x = ~x, y = ~y;
        uint32_t t = x;
        x = y, y = t;
    }
    return key;
}

typedef struct placed {
    uint32_t key;
    int i;
} placed;

static int compare(const void *a, const void *b) {
    const placed *p = a, *q = b;
    return p->key != q->key ? (p->key > q->key) - (p->key < q->key) : (p->i > q->i) - (p->i < q->i);
}

bool tr_sample_number(tr_world *world, const double *pos, double side, double density, tr_status *st) {
    int n = world->disks.n;
    placed *order = tr_alloc((size_t)n, sizeof *order, st);
    for (int i = 0; order && i < n; i++) {
        const double *q = pos + tr_body(i), cells = 65535 / side;
        order[i] = (placed){n > IN_CACHE ? along_curve((uint32_t)(q[0] * cells), (uint32_t)(q[1] * cells)) : 0, i};
    }
    if (order) qsort(order, (size_t)n, sizeof *order, compare);
    for (int i = 0; order && i < n; i++) {
        const double *q = pos + tr_body(order[i].i);
        tr_world_set_disk(world, i, &(tr_disk_start){q[0], q[1], 0, q[3], density, false});
    }
    free(order);
    return order != NULL;
}

/* Puts each disk in the first free random place. False: one found none; with few disks this is chance, because two can
 * leave no room for a third. A box that is wide enough always has room. */
static bool fill(grid *g, double *pos, int n, double L, tr_random *random) {
    enum { MOST_TRIES = 10000000 };
    for (int c = 0; c < g->cells * g->cells; c++) g->head[c] = -1;
    for (int i = 0; i < n; i++) {
        double R = pos[tr_body(i) + TR_RADIUS], edge = g->side > 0 ? 0 : R, x, y;
        int tries = 0;
        do {
            if (tries++ == MOST_TRIES) return false;
            x = edge + (L - 2 * edge) * tr_random_uniform(random);
            y = edge + (L - 2 * edge) * tr_random_uniform(random);
        } while (!is_free(g, pos, x, y, R));
        pos[tr_body(i)] = x, pos[tr_body(i) + TR_Y] = y;
        int *head = &g->head[cell_of(g, y) * g->cells + cell_of(g, x)];
        g->next[i] = *head, *head = i;
    }
    return true;
}

bool tr_sample_place(tr_world *world, const tr_scene_sample *sample, double side[2], tr_status *st) {
    if (!sample->place)
        return tr_status_fail(st, TR_BAD_CASE, "error: sample.file = %s has not been read: that is for trundle run",
                              sample->file);
    side[0] = sample->side[0], side[1] = sample->side[1];
    return tr_sample_number(world, sample->place, fmax(side[0], side[1]), sample->density, st);
}

bool tr_sample_throw(tr_world *world, const tr_scene_sample *sample, bool periodic, uint64_t seed, double *side,
                     tr_status *st) {
    const double wider = 1.25;
    tr_random random = tr_random_seed(seed, 1);
    int n = sample->disks;
    double *pos = tr_alloc((size_t)n * 4, sizeof *pos, st), area = 0;
    if (!pos) return false;
    for (int i = 0; i < n; i++) {
        double R = pos[tr_body(i) + TR_RADIUS] =
            sample->r_min + (sample->r_max - sample->r_min) * tr_random_uniform(&random);
        area += M_PI * R * R;
    }
    grid g = {.next = tr_alloc((size_t)n, sizeof(int), st)};
    bool filled = false;
    double L = fmax(sqrt(area / LOOSE_FRACTION), 4 * sample->r_max);
    for (; g.next && !filled && !st->code; L *= filled ? 1 : wider) {
        g.cells = (int)fmax(1, fmin(L / (2 * sample->r_max), 20000));
        g.width = L / g.cells, g.side = periodic ? L : 0;
        g.head = tr_alloc((size_t)g.cells * (size_t)g.cells, sizeof(int), st);
        filled = g.head && fill(&g, pos, n, L, &random);
        free(g.head);
    }
    *side = L;
    bool ok = filled && tr_sample_number(world, pos, L, sample->density, st);
    free(pos), free(g.next);
    return ok;
}
