/* SPDX-License-Identifier: MIT */
#include "core/world.h"

#include "base/alloc.h"
#include "broad/choose.h"
#include "core/parallel_memory.h"
#include "base/math.h"
#include <assert.h>
#include <math.h>
#include <stdlib.h>

bool tr_world_init(tr_world *world, int n, tr_shape shape, tr_status *st) {
    *world = (tr_world){.shape = shape, .disks.n = n, .n_groups = 2, .stale = true, .alone_to = TR_FEW_DISKS};
    tr_disks *d = &world->disks;
    size_t lanes = (size_t)n * 4;
    world->broad = tr_broad_choose(n);
    bool ok = (world->group = tr_alloc(2, sizeof *world->group, st)) &&
              (world->tile = tr_alloc(1, sizeof *world->tile, st)) && (d->pos = tr_alloc(lanes, sizeof(double), st)) &&
              (d->vel = tr_alloc(lanes, sizeof(double), st)) && (d->force = tr_alloc(lanes, sizeof(double), st)) &&
              (d->inv = tr_alloc(lanes, sizeof(double), st)) && (d->mass = tr_alloc((size_t)n, sizeof(double), st)) &&
              (d->inertia = tr_alloc((size_t)n, sizeof(double), st)) &&
              (d->coordination = tr_alloc((size_t)n, sizeof(int), st)) &&
              (world->wide_ref = tr_alloc(lanes / 2, sizeof(double), st)) &&
              (world->thin_ref = tr_alloc(lanes / 2, sizeof(double), st));
    if (ok)
        world->group[1].walls = true;
    else
        tr_world_free(world);
    return ok;
}

void tr_group_free(tr_group *g) {
    free(g->a), free(g->b), free(g->old_a), free(g->old_b), free(g->source), free(g->block);
    *g = (tr_group){.walls = g->walls};
}

void tr_world_free(tr_world *world) {
    tr_disks *d = &world->disks;
    free(d->pos), free(d->vel), free(d->force), free(d->inv), free(d->load), free(d->mass), free(d->inertia),
        free(d->outer);
    free(d->coordination);
    free(world->wide_ref), free(world->thin_ref), free(world->ledger), free(world->tile), free(world->picked);
    tr_parallel_free(world->parallel), tr_threads_free(world->threads);
    for (int k = 0; k < world->n_groups && world->group; k++) tr_group_free(&world->group[k]);
    free(world->group), free(world->wall_laws);
    if (world->finder) world->broad->destroy(world->finder);
    tr_pairs_free(&world->near);
    *world = (tr_world){0};
}

void tr_world_set_disk(tr_world *world, int i, const tr_disk_start *start) {
    const double radius = start->radius, density = start->density;
    const bool prescribed = start->prescribed;
    double *pos = world->disks.pos + tr_body(i), *inv = world->disks.inv + tr_body(i);
    double m = density * M_PI * radius * radius * (world->shape == TR_SHAPE_SPHERE ? 4 * radius / 3 : 1);
    pos[0] = start->x, pos[1] = start->y, pos[2] = start->angle, pos[3] = radius;
    world->disks.mass[i] = m;
    world->disks.inertia[i] = tr_law_inertia(world->shape) * m * radius * radius;
    inv[0] = inv[1] = prescribed ? 0 : 1 / m;
    inv[2] = prescribed ? 0 : 1 / tr_law_inertia(world->shape) / (m * radius * radius);
    world->stale = true;
}

bool tr_world_set_wall_laws(tr_world *world, int w, const tr_scene_contact *laws, tr_status *st) {
    if (!world->wall_laws && !laws) return true;
    if (!world->wall_laws && !(world->wall_laws = tr_alloc(TR_MAX_WALLS, sizeof *world->wall_laws, st))) return false;
    world->wall_laws[w] = laws;
    return true;
}

bool tr_world_set_ring(tr_world *world, int i, double radius, double outer, double density, tr_status *st) {
    tr_disks *d = &world->disks;
    double *inv = d->inv + tr_body(i), a = radius, b = outer;
    if (!d->outer && !(d->outer = tr_alloc((size_t)d->n, sizeof *d->outer, st))) return false;
    bool shell = world->shape == TR_SHAPE_SPHERE;
    double m = density * M_PI * (shell ? 4.0 / 3 * (b * b * b - a * a * a) : b * b - a * a);
    double I =
        shell ? 0.4 * m * (tr_pow(b, 5) - tr_pow(a, 5)) / (tr_pow(b, 3) - tr_pow(a, 3)) : 0.5 * m * (a * a + b * b);
    d->pos[tr_body(i) + TR_RADIUS] = -radius, d->outer[i] = outer;
    d->mass[i] = m, d->inertia[i] = I;
    for (int k = 0; k < 3; k++)
        if (inv[k] > 0) inv[k] = 1 / (k < 2 ? m : I);
    return true;
}

void tr_world_set_inertia(tr_world *world, int i, double inertia) {
    double *inv = world->disks.inv + tr_body(i);
    world->disks.inertia[i] = inertia;
    if (inv[2] > 0) inv[2] = 1 / inertia;
}

void tr_group_attach(tr_group *group, tr_sink *sink, const char *name, tr_pass_run *run, int n_hist) {
    assert(group->n_pass < TR_MAX_PASSES && group->n_hist + n_hist <= TR_GROUP_HIST);
    sink->group = group;
    sink->hist = group->n_hist, group->n_hist += n_hist;
    group->pass[group->n_pass++] = (tr_pass){.name = name, .run = run, .sink = true, .data.par = sink};
}

/* A prescribed motion has infinite mass: inv is 0. */
static void weigh_body(const tr_world *world, int i, double *R, double *m, double *I) {
    const double *inv = world->disks.inv + tr_body(i);
    *R = world->disks.pos[tr_body(i) + TR_RADIUS];
    *m = inv[0] > 0 ? world->disks.mass[i] : INFINITY;
    *I = inv[2] > 0 ? world->disks.inertia[i] : INFINITY;
}

tr_pair_bodies tr_world_pair(const tr_world *world, const tr_group *group, int a, int b) {
    tr_pair_bodies bodies = {.m1 = INFINITY, .I1 = INFINITY};
    if (!group->walls) weigh_body(world, a, &bodies.R1, &bodies.m1, &bodies.I1);
    weigh_body(world, b, &bodies.R2, &bodies.m2, &bodies.I2);
    return bodies;
}

tr_law_data tr_group_data(const tr_group *group, const tr_group_law *slot) {
    const tr_group_law *normal = &group->laws[TR_NORMAL];
    return (tr_law_data){.par = slot->par,
                         .hist = group->hist + slot->hist,
                         .pair = group->pair + slot->pair,
                         .normal = normal->law,
                         .normal_par = normal->par,
                         .shape = group->shape};
}

bool tr_world_set_threads(tr_world *world, int n, tr_status *st) {
    if (n < 1 || world->disks.n <= world->alone_to) n = 1;
    if (n == tr_world_threads(world)) return true;
    tr_threads_free(world->threads);
    world->threads = n > 1 ? tr_threads_new(n, st) : NULL;
    return world->threads || n == 1;
}

int tr_world_threads(const tr_world *world) {
    return tr_threads_count(world->threads);
}

size_t tr_world_bytes(const tr_world *world) {
    size_t bytes = sizeof *world + (size_t)world->n_groups * sizeof *world->group + sizeof *world->tile +
                   (size_t)world->disks.n * ((4 * 4 + 2 + 4) * sizeof(double) + sizeof(int));
    if (world->ledger) bytes += sizeof *world->ledger;
    if (world->disks.load) bytes += (size_t)world->disks.n * 4 * sizeof(double);
    for (int k = 0; k < world->n_groups; k++) {
        const tr_group *g = &world->group[k];
        bytes += (size_t)g->capacity * (5 * sizeof(int) + (size_t)(1 + g->n_hist + g->n_pair) * sizeof(double));
    }
    bytes += tr_parallel_bytes(world->parallel, world->disks.n);
    return bytes + ((size_t)world->near.capacity * 2 + (size_t)world->picks) * sizeof(int);
}

int tr_world_histories(const tr_world *world) {
    int arrays = 0;
    for (int k = 0; k < world->n_groups; k++)
        for (int h = 0; h < TR_GROUP_HIST; h++) arrays += world->group[k].hist[h] != NULL;
    return arrays;
}
