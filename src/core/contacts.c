/* SPDX-License-Identifier: MIT */
/* Two skins. `near` holds every pair closer than the wide skin at the last search; while no centre has moved further
 * than (wide - thin)/2 since, it still holds every pair closer than the thin skin, and the list of the step is pruned
 * from it. The list stays complete until a centre has moved thin/2 (tr_step_advance watches that). In a sheared sample
 * 40 % of the pairs of a wide list do not touch: the thin one is what makes the contact loop short. */
#include "core/contacts.h"

#include "base/alloc.h"
#include "base/threads.h"
#include "core/cell.h"
#include "core/timestep.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { BEHIND = 3 }; /* gather reads four contacts at a time: valid ids behind the end of the list */

bool tr_contacts_reserve(tr_group *g, int n, tr_status *st) {
    if (n + BEHIND <= g->capacity) return true;
    size_t now = (size_t)g->n, old = (size_t)g->old_n, grown = (size_t)n + (size_t)n / 4 + TR_TILE;
    bool ok = tr_alloc_grow(&g->a, now, grown, sizeof(int), st) && tr_alloc_grow(&g->b, now, grown, sizeof(int), st) &&
              tr_alloc_grow(&g->old_a, old, grown, sizeof(int), st) &&
              tr_alloc_grow(&g->old_b, old, grown, sizeof(int), st);
    for (int k = 0; ok && k < g->n_hist; k++)
        ok = tr_alloc_grow(&g->hist[k], now, grown, sizeof(double), st) &&
             tr_alloc_grow(&g->old_hist[k], old, grown, sizeof(double), st);
    for (int k = 0; ok && k < g->n_pair; k++) ok = tr_alloc_grow(&g->pair[k], now, grown, sizeof(double), st);
    if (ok) g->capacity = (int)grown;
    return ok;
}

static void swap_ints(int **a, int **b) {
    int *t = *a;
    *a = *b, *b = t;
}

/* Keeps the present list as the old one and starts an empty new one. */
static void group_begin(tr_group *g) {
    swap_ints(&g->a, &g->old_a);
    swap_ints(&g->b, &g->old_b);
    for (int k = 0; k < g->n_hist; k++) {
        double *h = g->old_hist[k];
        g->old_hist[k] = g->hist[k], g->hist[k] = h;
    }
    g->old_n = g->n;
    g->n = 0;
}

/* Number of the first contact of the old list that is not before (a, b). */
static int old_from(const tr_group *g, int a, int b) {
    int low = 0, high = g->old_n;
    while (low < high) {
        int mid = low + (high - low) / 2;
        if (g->old_a[mid] < a || (g->old_a[mid] == a && g->old_b[mid] < b))
            low = mid + 1;
        else
            high = mid;
    }
    return low;
}

/* Contact i is (a, b), in a cell with that image of b; *old walks the old list, which is sorted like the new one. */
static void group_put(const tr_world *world, tr_group *g, int i, int a, int b, const double *image, int *old) {
    g->a[i] = a, g->b[i] = b;
    tr_pair_bodies bodies = tr_world_pair(world, g, a, b);
    g->pair[0][i] = bodies.R1, g->pair[1][i] = bodies.R2;
    g->pair[2][i] = g->walls ? 1 : bodies.R1 / (bodies.R1 + bodies.R2);
    for (int k = 0; k < 2 && !g->walls && world->cell.side[0] > 0; k++) g->pair[3 + k][i] = image[k];
    while (*old < g->old_n && (g->old_a[*old] < a || (g->old_a[*old] == a && g->old_b[*old] < b))) ++*old;
    bool known = *old < g->old_n && g->old_a[*old] == a && g->old_b[*old] == b;
    for (int k = 0; k < g->n_hist; k++) g->hist[k][i] = known ? g->old_hist[k][*old] : 0;
}

static void count_listed(const tr_world *world, int *z) {
    const tr_group *g = world->group;
    memset(z, 0, (size_t)world->disks.n * sizeof *z);
    for (int i = 0; i < g[0].n; i++) z[g[0].a[i]]++, z[g[0].b[i]]++;
    for (int i = 0; i < g[1].n; i++) z[g[1].b[i]]++;
}

/* When both lists are there: a body has no more contacts than are listed until the next refresh. */
static void group_constants(const tr_world *world, tr_group *g, const int *z) {
    for (int s = 0; s < TR_N_SLOTS; s++) {
        const tr_slot *slot = &g->slot[s];
        TR_OMP(omp parallel for schedule(static) if (tr_world_threads(world) > 1))
        for (int i = 0; i < (slot->law->n_pair ? g->n : 0); i++) {
            double constants[TR_MAX_PAIR];
            tr_pair_bodies bodies = tr_world_pair(world, g, g->a[i], g->b[i]);
            bodies.z1 = g->walls ? 1 : z[g->a[i]], bodies.z2 = z[g->b[i]];
            slot->law->pair(slot->par, &bodies, constants);
            for (int k = 0; k < slot->law->n_pair; k++) g->pair[slot->pair + k][i] = constants[k];
        }
    }
}

static void copy_centres(const tr_disks *d, double *ref) {
    for (int i = 0; i < d->n; i++) ref[2 * i] = d->pos[4 * i], ref[2 * i + 1] = d->pos[4 * i + 1];
}

static double largest_move(const tr_disks *d, const double *ref) {
    double largest = 0;
    for (int i = 0; i < d->n; i++) {
        double dx = d->pos[4 * i] - ref[2 * i], dy = d->pos[4 * i + 1] - ref[2 * i + 1];
        double square = dx * dx + dy * dy;
        largest = square > largest ? square : largest;
    }
    return sqrt(largest);
}

static bool search(tr_world *world, tr_status *st) {
    const double *cell = world->cell.side[0] > 0 ? world->cell.side : NULL;
    tr_broad_input input = {world->disks.n, world->disks.pos, world->wide_skin, cell, tr_world_threads(world)};
    world->cell.moved[1] = 0;
    copy_centres(&world->disks, world->wide_ref);
    world->searches++;
    return world->broad->find(world->finder, &input, &world->near, st);
}

static bool fail_at(const tr_world *world, tr_status *st, const char *what, const char *which) {
    return tr_status_fail(st, TR_NUMERICAL, "error: %s: %s, at step %lld, time %.9g s", which, what,
                          (long long)world->steps, (double)world->steps * world->dt);
}

static void name_contact(bool walls, int a, int b, char *text, size_t size) {
    snprintf(text, size, walls ? "contact of wall %d with disk %d" : "contact of disks %d and %d", a, b);
}

static bool is_crushed(double delta, double R1, double R2) {
    return delta > TR_LARGEST_OVERLAP * fmin(R1, R2);
}

static bool fail_crushed(const tr_world *world, bool walls, int a, int b, double delta, double R, tr_status *st) {
    char which[96], what[160];
    name_contact(walls, a, b, which, sizeof which);
    snprintf(what, sizeof what, "overlap %.3g m is above 0.3 of the radius %.3g m", delta, R);
    return fail_at(world, st, what, which);
}

/* Every disk and wall is looked at: n_walls n, at refreshes only. */
static bool refresh_walls(tr_world *world, tr_status *st) {
    const double no_image[2] = {0};
    tr_group *g = &world->group[1];
    int old = 0;
    group_begin(g);
    for (int w = 0; w < world->n_walls; w++)
        for (int i = 0; i < world->disks.n; i++) {
            const double *pos = world->disks.pos + 4 * (size_t)i;
            double delta = pos[3] - tr_contacts_wall_distance(&world->wall[w], pos);
            if (delta <= -world->thin_skin) continue;
            if (is_crushed(delta, pos[3], pos[3])) return fail_crushed(world, true, w, i, delta, pos[3], st);
            if (!tr_contacts_reserve(g, g->n + 1, st)) return false;
            group_put(world, g, g->n++, w, i, no_image, &old);
        }
    return true;
}

/* A thread's share of `near`. */
typedef struct share {
    int low, high;
    int first, n; /* its contacts in the list */
    int crushed;  /* the first pair with too large an overlap; -1: none */
} share;

/* The overlap of pair i of `near`; image: as tr_cell_distance. */
static double near_overlap(const tr_world *world, int i, double *image) {
    const double *p = world->disks.pos + 4 * (size_t)world->near.a[i];
    const double *q = world->disks.pos + 4 * (size_t)world->near.b[i];
    return p[3] + q[3] - tr_cell_distance(&world->cell, p, q, image);
}

static void count_share(const tr_world *world, share *s) {
    int n = 0; /* not in *s, which shares its cache line with those of other threads */
    for (int i = s->low; i < s->high; i++) n += near_overlap(world, i, NULL) > -world->thin_skin;
    s->n = n;
}

static void list_share(const tr_world *world, tr_group *g, share *s) {
    int to = s->first, old = s->low < s->high ? old_from(g, world->near.a[s->low], world->near.b[s->low]) : 0;
    s->crushed = -1;
    for (int i = s->low; i < s->high; i++) {
        double image[2] = {0}, delta = near_overlap(world, i, image);
        if (delta <= -world->thin_skin) continue;
        int a = world->near.a[i], b = world->near.b[i];
        group_put(world, g, to, a, b, image, &old);
        if (is_crushed(delta, g->pair[0][to], g->pair[1][to]) && s->crushed < 0) s->crushed = i;
        to++;
    }
    s->n = to - s->first;
}

/* Each thread lists a share of the pairs, behind the shares before it: they are counted first, where there is more than one. */
static bool refresh_disks(tr_world *world, tr_status *st) {
    tr_group *g = &world->group[0];
    share all[TR_MOST_THREADS] = {{0}};
    int n = tr_world_threads(world), crushed = -1;
    if (!tr_contacts_reserve(g, world->near.n, st)) return false;
    group_begin(g);
    for (int k = 0; k < n; k++) {
        all[k].low = (int)((int64_t)world->near.n * k / n), all[k].high = (int)((int64_t)world->near.n * (k + 1) / n);
    }
    TR_OMP(omp parallel for schedule(static, 1) if (n > 1))
    for (int k = 0; k < n - 1; k++) count_share(world, &all[k]);
    for (int k = 1; k < n; k++) all[k].first = all[k - 1].first + all[k - 1].n;
    TR_OMP(omp parallel for schedule(static, 1) if (n > 1))
    for (int k = 0; k < n; k++) list_share(world, g, &all[k]);
    g->n = all[n - 1].first + all[n - 1].n;
    for (int k = 0; k < n && crushed < 0; k++) crushed = all[k].crushed;
    if (crushed >= 0) {
        int a = world->near.a[crushed], b = world->near.b[crushed];
        const double *p = world->disks.pos + 4 * (size_t)a, *q = world->disks.pos + 4 * (size_t)b;
        return fail_crushed(world, false, a, b, near_overlap(world, crushed, NULL), fmin(p[3], q[3]), st);
    }
    for (int k = 0; k < BEHIND && g->capacity; k++) g->a[g->n + k] = g->b[g->n + k] = 0;
    return true;
}

static bool check_finite(const tr_world *world, tr_status *st) {
    const double *pos = world->disks.pos, *vel = world->disks.vel;
    for (int i = 0; i < world->disks.n; i++) {
        const size_t k = 4 * (size_t)i;
        double zero = 0 * (pos[k] + pos[k + 1] + pos[k + 2] + vel[k] + vel[k + 1] + vel[k + 2]); /* of what is finite */
        if (zero == 0) continue;
        char which[32];
        snprintf(which, sizeof which, "disk %d", i);
        return fail_at(world, st, "its position or velocity is not finite", which);
    }
    return true;
}

static bool check_step(const tr_world *world, tr_status *st) {
    char which[96], what[160];
    tr_timestep_limit limit = tr_timestep_contacts(world);
    if (world->dt <= limit.dt || world->allow_unstable) return true;
    const tr_group *g = &world->group[limit.group];
    name_contact(g->walls, g->a[limit.contact], g->b[limit.contact], which, sizeof which);
    snprintf(what, sizeof what, "the step %.4g s is above the stability bound %.4g s", world->dt, limit.dt);
    return fail_at(world, st, what, which);
}

/* A disk that leaps in one step could pass through another one unseen. */
static bool check_leap(const tr_world *world, tr_status *st) {
    for (int i = 0; i < world->disks.n; i++) {
        const double *v = world->disks.vel + 4 * (size_t)i;
        double leap = TR_LARGEST_OVERLAP * world->disks.pos[4 * (size_t)i + 3] / world->dt;
        if (v[0] * v[0] + v[1] * v[1] <= leap * leap) continue;
        char which[32], what[160];
        snprintf(which, sizeof which, "disk %d", i);
        snprintf(what, sizeof what, "it moves %.3g m in one step, more than 0.3 of its radius; give a smaller step.dt",
                 hypot(v[0], v[1]) * world->dt);
        return fail_at(world, st, what, which);
    }
    return true;
}

bool tr_contacts_refresh(tr_world *world, tr_status *st) {
    if (!check_finite(world, st) || !check_leap(world, st)) return false;
    if (!tr_cell_check(world, st)) return false;
    tr_cell_wrap(world);
    double moved = 2 * largest_move(&world->disks, world->wide_ref) + world->cell.moved[1];
    bool enough = world->searches > 0 && world->near.n && moved + world->thin_skin <= world->wide_skin;
    if (!enough && !search(world, st)) return false;
    if (!refresh_disks(world, st) || !refresh_walls(world, st)) return false;
    int *z = world->disks.coordination; /* which check_step counts anew */
    count_listed(world, z);
    for (int k = 0; k < 2; k++) group_constants(world, &world->group[k], z);
    copy_centres(&world->disks, world->thin_ref);
    world->wall_moved = world->cell.moved[0] = 0;
    world->stale = false;
    world->refreshes++;
    return check_step(world, st);
}
