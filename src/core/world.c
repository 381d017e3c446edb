/* SPDX-License-Identifier: MIT */
#include "core/world.h"

#include "base/alloc.h"
#include "core/arcs.h"
#include "core/contacts.h"
#include "core/ledger.h"
#include "core/shares.h"
#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of the mean diameter; the speed is flat around these. Overlaps are looked at when a body has moved half the thin skin, so that it is
 * no thicker than what the smallest disk may overlap. */
static const double WIDE_SKIN = 0.30, THIN_SKIN = 0.025;

bool tr_world_init(tr_world *world, int n, tr_shape shape, tr_status *st) {
    *world = (tr_world){.shape = shape, .disks.n = n, .group[1].walls = true, .stale = true, .alone_to = TR_FEW_DISKS};
    tr_disks *d = &world->disks;
    size_t lanes = (size_t)n * 4;
    world->broad = tr_broad_choose(n);
    bool ok = (world->tile = tr_alloc(1, sizeof *world->tile, st)) && (d->pos = tr_alloc(lanes, sizeof(double), st)) &&
              (d->vel = tr_alloc(lanes, sizeof(double), st)) && (d->force = tr_alloc(lanes, sizeof(double), st)) &&
              (d->inv = tr_alloc(lanes, sizeof(double), st)) && (d->mass = tr_alloc((size_t)n, sizeof(double), st)) &&
              (d->coordination = tr_alloc((size_t)n, sizeof(int), st)) &&
              (world->wide_ref = tr_alloc(lanes / 2, sizeof(double), st)) &&
              (world->thin_ref = tr_alloc(lanes / 2, sizeof(double), st));
    if (!ok) tr_world_free(world);
    return ok;
}

static void group_free(tr_group *g) {
    free(g->a), free(g->b), free(g->old_a), free(g->old_b), free(g->source), free(g->spare);
    for (int k = 0; k < TR_GROUP_HIST; k++) free(g->hist[k]);
    for (int k = 0; k < TR_GROUP_PAIR; k++) free(g->pair[k]);
    *g = (tr_group){.walls = g->walls};
}

void tr_world_free(tr_world *world) {
    tr_disks *d = &world->disks;
    free(d->pos), free(d->vel), free(d->force), free(d->inv), free(d->load), free(d->mass);
    free(d->coordination);
    free(world->wide_ref), free(world->thin_ref), free(world->ledger), free(world->tile), free(world->picked);
    tr_shares_free(world->shares), tr_threads_free(world->threads);
    group_free(&world->group[0]), group_free(&world->group[1]);
    if (world->finder) world->broad->destroy(world->finder);
    tr_pairs_free(&world->near);
    *world = (tr_world){0};
}

void tr_world_set_disk(tr_world *world, int i, double x, double y, double angle, double radius, double density,
                       bool prescribed) {
    double *pos = world->disks.pos + 4 * (size_t)i, *inv = world->disks.inv + 4 * (size_t)i;
    bool sphere = world->shape == TR_SHAPE_SPHERE;
    double m = density * M_PI * radius * radius * (sphere ? 4 * radius / 3 : 1);
    pos[0] = x, pos[1] = y, pos[2] = angle, pos[3] = radius;
    world->disks.mass[i] = m;
    inv[0] = inv[1] = prescribed ? 0 : 1 / m;
    inv[2] = prescribed ? 0 : (sphere ? 2.5 : 2) / (m * radius * radius);
    world->stale = true;
}

static void group_take(tr_group *g, int which, const tr_law *law, const tr_scene_law *chosen) {
    tr_slot *slot = &g->slot[which];
    slot->law = law;
    if (chosen) memcpy(slot->par, chosen->par, sizeof slot->par);
    slot->hist = g->n_hist, g->n_hist += law->n_hist;
    slot->pair = g->n_pair, g->n_pair += law->n_pair;
}

static void group_add_pass(tr_group *g, const char *name, tr_pass_run *run, const tr_slot *slot) {
    assert(g->n_pass < TR_MAX_PASSES);
    tr_pass *pass = &g->pass[g->n_pass++];
    *pass = (tr_pass){.name = name, .run = run};
    if (slot) pass->data = tr_group_data(g, slot);
}

void tr_group_attach(tr_group *group, tr_sink *sink, const char *name, tr_pass_run *run, int n_hist) {
    assert(group->n_pass < TR_MAX_PASSES && group->n_hist + n_hist <= TR_GROUP_HIST);
    sink->group = group;
    sink->hist = group->n_hist, group->n_hist += n_hist;
    group->pass[group->n_pass++] = (tr_pass){.name = name, .run = run, .sink = true, .data.par = sink};
}

/* The list of passes a scene asked for: what it leaves out is not there. */
static void group_choose(tr_group *g, const tr_scene_contact *contact, bool normal_only, int rolling_velocity,
                         tr_shape shape, bool images) {
    group_free(g);
    g->shape = shape;
    g->n_pair = images ? 5 : 3;
    group_take(g, TR_NORMAL, tr_laws_normal[contact->normal.law], &contact->normal);
    group_take(g, TR_FRICTION, normal_only ? &tr_friction_none : tr_laws_friction[contact->friction.law],
               &contact->friction);
    group_take(g, TR_ROLLING, normal_only ? &tr_rolling_none : tr_laws_rolling[contact->rolling.law],
               &contact->rolling);
    const tr_law *friction = g->slot[TR_FRICTION].law, *rolling = g->slot[TR_ROLLING].law;
    g->spins = friction->step || rolling->step;

    group_add_pass(g, "kinematics", g->walls ? tr_kinematics_wall : tr_kinematics_pair, NULL);
    group_add_pass(g, "normal", g->slot[TR_NORMAL].law->step, &g->slot[TR_NORMAL]);
    if (friction->step) group_add_pass(g, "friction", friction->step, &g->slot[TR_FRICTION]);
    tr_pass_run *velocity = tr_law_rolling_velocity(rolling, rolling_velocity);
    if (velocity) group_add_pass(g, "rolling velocity", velocity, NULL);
    if (rolling->step) group_add_pass(g, "rolling", rolling->step, &g->slot[TR_ROLLING]);
    tr_pass_run *torques = rolling->needs & TR_GIVES_F_R ? tr_resultant_rolling_force : tr_resultant_full;
    group_add_pass(g, "resultant", g->spins ? torques : tr_resultant_central, NULL);
}

bool tr_world_set_laws(tr_world *world, const tr_scene_contact *contact, bool smooth_walls, unsigned sinks,
                       tr_status *st) {
    double sum = 0, r_min = INFINITY;
    world->r_max = 0;
    for (int i = 0; i < world->disks.n; i++) {
        double R = world->disks.pos[4 * (size_t)i + 3];
        sum += 2 * R, r_min = fmin(r_min, R), world->r_max = fmax(world->r_max, R);
    }
    world->wide_skin = WIDE_SKIN * sum / world->disks.n;
    world->thin_skin = fmin(THIN_SKIN * sum / world->disks.n, TR_LARGEST_OVERLAP * r_min);
    world->rolling_velocity = contact->rolling_velocity;
    world->stale = world->fresh = true;
    world->sure_dt = 0;
    tr_shares_free(world->shares), world->shares = NULL; /* lanes again */
    world->near.n = 0;
    memset(world->tile, 0, sizeof *world->tile); /* lanes that no pass of the new pipeline writes are 0 */
    free(world->ledger);
    world->ledger = NULL;
    if (sinks & TR_SINK_LEDGER && !(world->ledger = tr_alloc(1, sizeof *world->ledger, st))) return false;
    for (int k = 0; k < 2; k++) {
        tr_group *g = &world->group[k];
        group_choose(g, contact, g->walls && smooth_walls, contact->rolling_velocity, world->shape,
                     !g->walls && world->cell.side[0] > 0);
        if (sinks & TR_SINK_LEDGER) tr_ledger_attach(g, world->ledger);
        if (sinks & TR_SINK_ARCS) tr_arcs_attach(g);
    }
    if (world->finder) world->broad->destroy(world->finder);
    world->finder =
        world->broad->create(&(tr_broad_input){world->disks.n, world->disks.pos, world->wide_skin, NULL, NULL}, st);
    return world->finder != NULL;
}

static bool is_before(int a, int b, int other_a, int other_b) {
    return a < other_a || (a == other_a && b < other_b);
}

/* Both lists are sorted by their ids. */
static void carry_friction(tr_group *to, const tr_group *from) {
    int first = to->slot[TR_FRICTION].hist, old_first = from->slot[TR_FRICTION].hist, old = 0;
    for (int i = 0; i < to->n; i++) {
        while (old < from->n && is_before(from->a[old], from->b[old], to->a[i], to->b[i])) old++;
        if (old == from->n) return;
        if (from->a[old] != to->a[i] || from->b[old] != to->b[i]) continue;
        for (int h = 0; h < to->slot[TR_FRICTION].law->n_hist; h++)
            to->hist[first + h][i] = from->hist[old_first + h][old];
    }
}

bool tr_world_change_laws(tr_world *world, const tr_scene_contact *contact, bool smooth_walls, unsigned sinks,
                          tr_status *st) {
    tr_group before = world->group[0], *now = &world->group[0];
    *now = (tr_group){0};
    bool ok = tr_world_set_laws(world, contact, smooth_walls, sinks, st);
    const tr_law *friction = before.slot[TR_FRICTION].law;
    if (ok && before.n && friction->n_hist && friction == now->slot[TR_FRICTION].law) {
        ok = tr_contacts_refresh(world, st);
        if (ok) carry_friction(now, &before);
        world->stale = true; /* sinks may still come, and want their arrays */
    }
    group_free(&before);
    return ok;
}

/* Given motion is infinite mass: inv is 0 there. */
static void weigh_body(const tr_world *world, int i, double *R, double *m, double *I) {
    const double *inv = world->disks.inv + 4 * (size_t)i, of_mass = world->shape == TR_SHAPE_SPHERE ? 0.4 : 0.5;
    double mass = world->disks.mass[i];
    *R = world->disks.pos[4 * (size_t)i + 3];
    *m = inv[0] > 0 ? mass : INFINITY;
    *I = inv[2] > 0 ? of_mass * mass * *R * *R : INFINITY;
}

tr_pair_bodies tr_world_pair(const tr_world *world, const tr_group *group, int a, int b) {
    tr_pair_bodies bodies = {.m1 = INFINITY, .I1 = INFINITY};
    if (!group->walls) weigh_body(world, a, &bodies.R1, &bodies.m1, &bodies.I1);
    weigh_body(world, b, &bodies.R2, &bodies.m2, &bodies.I2);
    return bodies;
}

tr_law_data tr_group_data(const tr_group *group, const tr_slot *slot) {
    const tr_slot *normal = &group->slot[TR_NORMAL];
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
    size_t bytes =
        sizeof *world + sizeof *world->tile + (size_t)world->disks.n * ((4 * 4 + 1 + 4) * sizeof(double) + sizeof(int));
    if (world->ledger) bytes += sizeof *world->ledger;
    if (world->disks.load) bytes += (size_t)world->disks.n * 4 * sizeof(double);
    for (int k = 0; k < 2; k++) {
        const tr_group *g = &world->group[k];
        bytes += (size_t)g->capacity * (5 * sizeof(int) + (size_t)(1 + g->n_hist + g->n_pair) * sizeof(double));
    }
    bytes += tr_shares_bytes(world->shares, world->disks.n);
    return bytes + ((size_t)world->near.capacity * 2 + (size_t)world->picks) * sizeof(int);
}

int tr_world_histories(const tr_world *world) {
    int arrays = 0;
    for (int k = 0; k < 2; k++)
        for (int h = 0; h < TR_GROUP_HIST; h++) arrays += world->group[k].hist[h] != NULL;
    return arrays;
}
