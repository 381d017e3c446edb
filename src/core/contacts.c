/* SPDX-License-Identifier: MIT */
/* Two skins. `near` holds every pair closer than the wide skin at the last search; while disks have not moved too far
 * since, it still holds every pair closer than the thin skin, and the list of the step is pruned from it. The list
 * stays complete until a disk has moved too far for the thin skin (tr_step_advance watches that). The stretch of the
 * whole sample is subtracted: stretch.h. In a sheared sample 40 % of the pairs of a wide list do not touch: the thin
 * one makes the contact loop short. */
#include "core/contacts.h"
#include "base/math.h"

#include "base/alloc.h"
#include "core/cell.h"
#include "core/crush.h"
#include "core/list.h"
#include "core/stretch.h"
#include "core/timestep.h"
#include "core/wall.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static void copy_centres(const tr_disks *d, double *ref) {
    for (int i = 0; i < d->n; i++) ref[2 * i] = d->pos[tr_body(i)], ref[2 * i + 1] = d->pos[tr_body(i) + TR_Y];
}

/* Less the stretch. */
static double largest_move(const tr_disks *d, const double *ref, const tr_stretch *s) {
    double largest = 0;
    for (int i = 0; i < d->n; i++) {
        double dx = d->pos[tr_body(i)] - (s->scale[0] * ref[2 * i] + s->offset[0]);
        double dy = d->pos[tr_body(i) + TR_Y] - (s->scale[1] * ref[2 * i + 1] + s->offset[1]);
        double square = dx * dx + dy * dy;
        largest = square > largest ? square : largest;
    }
    return sqrt(largest);
}

/* Whether `near` still holds all pairs within the thin skin. */
static bool is_near_whole(const tr_world *world, const tr_extent *now) {
    if (!world->searches || !world->near.n) return false;
    tr_stretch s = tr_stretch_of(&world->wide_extent, now);
    double reach = tr_stretch_reach(world, &s, world->wide_skin, world->thin_skin);
    return largest_move(&world->disks, world->wide_ref, &s) <= reach;
}

static bool search(tr_world *world, tr_status *st) {
    const double *cell = world->cell.side[0] > 0 ? world->cell.side : NULL;
    const int rings = world->n_rings; /* which are in no pair of the broad phase */
    tr_broad_input input = {world->disks.n - rings, world->disks.pos + tr_body(rings), world->wide_skin, cell,
                            world->threads};
    world->wide_extent = tr_stretch_extent(world);
    copy_centres(&world->disks, world->wide_ref);
    world->searches++;
    if (!world->broad->find(world->finder, &input, &world->near, st)) return false;
    for (int k = 0; k < world->near.n && rings; k++) world->near.a[k] += rings, world->near.b[k] += rings;
    return true;
}

static bool fail_at(const tr_world *world, tr_status *st, const char *what, const char *which) {
    return tr_status_fail(st, TR_NUMERICAL, "error: %s: %s, at step %lld, time %.9g s", which, what,
                          (long long)world->steps, (double)world->steps * world->dt);
}

static void name_contact(const tr_world *world, bool walls, int a, int b, char *text, size_t size) {
    bool ring = !walls && a < world->n_rings;
    const char *format = walls  ? "contact of wall %d with disk %d"
                         : ring ? "contact of ring %d with disk %d"
                                : "contact of disks %d and %d";
    snprintf(text, size, format, a, b);
}

/* For a biaxial test biaxial.c knows better which value would hold. */
static bool fail_crushed(tr_world *world, bool walls, int a, int b, double delta, double R, tr_status *st) {
    char which[96], what[160], hint[200] = "";
    world->crush = (tr_crush){true, walls, a, b, delta};
    name_contact(world, walls, a, b, which, sizeof which);
    snprintf(what, sizeof what, "overlap %.3g m is above 0.3 of the radius %.3g m", delta, R);
    fail_at(world, st, what, which);
    if (!world->boxed && !(world->cell.side[0] > 0)) tr_crush_say(world, &world->crush, hint, sizeof hint);
    return tr_status_more(st, "%s", hint);
}

static double wall_overlap(const tr_world *world, int wall, int i) {
    const double *pos = world->disks.pos + tr_body(i);
    return pos[3] - tr_wall_distance(&world->wall[wall], pos);
}

/* Tests every disk with every wall, only at refreshes. */
static bool check_walls(tr_world *world, tr_status *st) {
    for (int w = 0; w < world->n_walls; w++)
        for (int i = world->n_rings; i < world->disks.n; i++) {
            double R = world->disks.pos[tr_body(i) + TR_RADIUS], delta = wall_overlap(world, w, i);
            if (delta > TR_LARGEST_OVERLAP * R) return fail_crushed(world, true, w, i, delta, R, st);
        }
    return true;
}

static bool list_walls(tr_world *world, int group, tr_status *st) {
    tr_group *g = &world->group[group];
    tr_list_begin(g);
    for (int w = 0; w < world->n_walls; w++)
        for (int i = world->n_rings; i < world->disks.n && world->wall_kind[w] == group - 1; i++) {
            if (wall_overlap(world, w, i) <= -world->thin_skin) continue;
            if (!tr_list_reserve(g, g->n + 1, st)) return false;
            g->a[g->n] = w, g->b[g->n++] = i;
        }
    return true;
}

/* Every ring and disk is looked at, as with walls. */
static bool check_rings(tr_world *world, tr_status *st) {
    for (int a = 0; a < world->n_rings; a++)
        for (int i = world->n_rings; i < world->disks.n; i++) {
            const double *p = world->disks.pos + tr_body(a), *q = world->disks.pos + tr_body(i);
            double delta = -tr_world_gap(p, q);
            if (delta > TR_LARGEST_OVERLAP * q[3]) return fail_crushed(world, false, a, i, delta, q[3], st);
        }
    return true;
}

static bool list_rings(tr_world *world, tr_group *g, tr_status *st) {
    tr_list_begin(g);
    for (int a = 0; a < world->n_rings; a++)
        for (int i = world->n_rings; i < world->disks.n; i++) {
            const double *p = world->disks.pos + tr_body(a), *q = world->disks.pos + tr_body(i);
            if (tr_world_gap(p, q) >= world->thin_skin) continue;
            if (!tr_list_reserve(g, g->n + 1, st)) return false;
            g->a[g->n] = a, g->b[g->n++] = i;
        }
    return true;
}

/* A thread's share of `near`. */
typedef struct share {
    int first, n; /* its contacts in the list */
    int crushed;  /* the first pair with too large an overlap; near.n: none */
} share;

typedef struct pruning {
    tr_world *world;
    int threads;
    share share[TR_MOST_THREADS];
} pruning;

/* Numbers of the pairs closer than the thin skin, from the place of the first pair of the share in world->picked. */
static void pick(void *context, int k) {
    pruning *p = context;
    const tr_world *world = p->world;
    const tr_pairs *near = &world->near;
    const double *pos = world->disks.pos, *side = world->cell.side, skin = world->thin_skin;
    int low = tr_threads_chunk(near->n, k, p->threads), high = tr_threads_chunk(near->n, k + 1, p->threads);
    int to = low, crushed = near->n;
    for (int i = low; i < high; i++) {
        const double *one = pos + tr_body(near->a[i]), *two = pos + tr_body(near->b[i]);
        double d[2] = {two[0] - one[0], two[1] - one[1]}, reach = one[3] + two[3];
        for (int axis = 0; axis < 2 && side[axis] > 0; axis++)
            d[axis] += side[axis] * tr_broad_image(one[axis], two[axis], side[axis]);
        double square = d[0] * d[0] + d[1] * d[1], least = reach - TR_LARGEST_OVERLAP * fmin(one[3], two[3]);
        world->picked[to] = i;
        to += square < (reach + skin) * (reach + skin);
        crushed = square < least * least && i < crushed ? i : crushed;
    }
    p->share[k].n = to - low, p->share[k].crushed = crushed;
}

static void put(void *context, int k) {
    const pruning *p = context;
    const tr_pairs *near = &p->world->near;
    const share *s = &p->share[k];
    tr_group *g = &p->world->group[0];
    int from = tr_threads_chunk(near->n, k, p->threads);
    for (int i = 0; i < s->n; i++) {
        int pair = p->world->picked[from + i];
        g->a[s->first + i] = near->a[pair], g->b[s->first + i] = near->b[pair];
    }
}

/* Overlaps that are too large are found before the list changes. */
static bool pick_disks(pruning *p, tr_status *st) {
    tr_world *world = p->world;
    const tr_pairs *near = &world->near;
    int crushed = near->n;
    if (near->n > world->picks) {
        if (!tr_alloc_grow(&world->picked, 0, (size_t)near->capacity, sizeof(int), st)) return false;
        world->picks = near->capacity;
    }
    tr_threads_run(p->world->threads, pick, p);
    for (int k = 0; k < p->threads; k++) crushed = p->share[k].crushed < crushed ? p->share[k].crushed : crushed;
    if (crushed == near->n) return true;
    int a = near->a[crushed], b = near->b[crushed];
    const double *one = world->disks.pos + tr_body(a), *two = world->disks.pos + tr_body(b);
    double delta = one[3] + two[3] - tr_cell_distance(&world->cell, one, two, NULL);
    return fail_crushed(world, false, a, b, delta, fmin(one[3], two[3]), st);
}

/* Each thread lists its pairs, after those of earlier threads. */
static bool list_disks(pruning *p, tr_status *st) {
    tr_group *g = &p->world->group[0];
    int n = 0;
    for (int k = 0; k < p->threads; k++) p->share[k].first = n, n += p->share[k].n;
    tr_list_begin(g);
    if (!tr_list_reserve(g, n, st)) return false;
    g->n = n;
    tr_threads_run(p->world->threads, put, p);
    return true;
}

static bool check_finite(const tr_world *world, tr_status *st) {
    const double *pos = world->disks.pos, *vel = world->disks.vel;
    for (int i = 0; i < world->disks.n; i++) {
        const size_t k = tr_body(i);
        double zero = 0 * (pos[k] + pos[k + 1] + pos[k + 2] + vel[k] + vel[k + 1] + vel[k + 2]); /* of what is finite */
        if (zero == 0) continue;
        char which[32];
        snprintf(which, sizeof which, "disk %d", i);
        return fail_at(world, st, "its position or velocity is not finite", which);
    }
    return true;
}

static bool check_step(tr_world *world, tr_status *st) {
    char which[96], what[160];
    if (world->allow_unstable || tr_timestep_sure(world)) return true;
    tr_timestep_limit limit = tr_timestep_contacts(world);
    if (world->dt <= limit.dt) return true;
    const tr_group *g = &world->group[limit.group];
    name_contact(world, g->walls, g->a[limit.contact], g->b[limit.contact], which, sizeof which);
    snprintf(what, sizeof what, "the step %.4g s is above the stability bound %.4g s", world->dt, limit.dt);
    return fail_at(world, st, what, which);
}

/* A disk that moves too far in one step could pass through another one. */
static bool check_leap(const tr_world *world, tr_status *st) {
    for (int i = 0; i < world->disks.n; i++) {
        const double *v = world->disks.vel + tr_body(i);
        double leap = TR_LARGEST_OVERLAP * fabs(world->disks.pos[tr_body(i) + TR_RADIUS]) / world->dt;
        if (v[0] * v[0] + v[1] * v[1] <= leap * leap) continue;
        char which[32], what[160];
        snprintf(which, sizeof which, "disk %d", i);
        snprintf(what, sizeof what, "it moves %.3g m in one step, more than 0.3 of its radius; give a smaller step.dt",
                 tr_hypot(v[0], v[1]) * world->dt);
        return fail_at(world, st, what, which);
    }
    return true;
}

bool tr_contacts_refresh(tr_world *world, tr_status *st) {
    if (!check_finite(world, st) || !check_leap(world, st)) return false;
    if (!tr_cell_check(world, st)) return false;
    tr_cell_wrap(world);
    tr_extent now = tr_stretch_extent(world);
    if (!is_near_whole(world, &now) && !search(world, st)) return false;
    pruning p;
    p.world = world, p.threads = tr_world_threads(world);
    if (!pick_disks(&p, st) || !check_walls(world, st) || !check_rings(world, st)) return false;
    if (!list_disks(&p, st)) return false;
    for (int k = 1; k < world->n_groups; k++)
        if (!(world->group[k].rings ? list_rings(world, &world->group[k], st) : list_walls(world, k, st))) return false;
    for (int k = 0; k < world->n_groups; k++) tr_list_carry(world, &world->group[k]);
    tr_list_constants(world, world->disks.coordination);
    copy_centres(&world->disks, world->thin_ref);
    world->thin_extent = now;
    world->wall_moved = 0;
    world->stale = false;
    world->refreshes++;
    return check_step(world, st);
}
