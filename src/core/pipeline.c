/* SPDX-License-Identifier: MIT */
#include "core/pipeline.h"

#include "base/alloc.h"
#include "core/arcs.h"
#include "core/contacts.h"
#include "core/ledger.h"
#include "core/parallel_memory.h"
#include "laws/kinematics.h"
#include "laws/rolling_conjugate_spring.h"
#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of the mean diameter; the speed is flat around these. Overlaps are checked when a body has moved half the thin skin,
 * so the skin must not be thicker than the allowed overlap of the smallest disk. */
static const double WIDE_SKIN = 0.30, THIN_SKIN = 0.025;

static void group_take(tr_group *g, int which, const tr_law *law, const tr_scene_law *chosen) {
    tr_group_law *slot = &g->laws[which];
    slot->law = law;
    if (chosen) memcpy(slot->par, chosen->par, sizeof slot->par);
    slot->hist = g->n_hist, g->n_hist += law->n_hist;
    slot->pair = g->n_pair, g->n_pair += law->n_pair;
}

static void group_add_pass(tr_group *g, const char *name, tr_pass_run *run, const tr_group_law *slot) {
    assert(g->n_pass < TR_MAX_PASSES);
    tr_pass *pass = &g->pass[g->n_pass++];
    *pass = (tr_pass){.name = name, .run = run};
    if (slot) pass->data = tr_group_data(g, slot);
}

static tr_pass_run *kinematics_of(const tr_group *g, const tr_arms *arms) {
    if (g->rings) return arms->ring;
    return g->ends ? arms->edge : g->walls ? arms->wall : arms->pair;
}

/* The list of passes a scene asked for: what it leaves out is not there. */
static void group_choose(tr_group *g, const tr_scene_contact *contact, bool normal_only, tr_shape shape, bool images) {
    g->shape = shape;
    g->rolling_velocity = contact->rolling_velocity;
    g->n_pair = images ? TR_PAIR_IN_CELL : TR_PAIR_ALL;
    group_take(g, TR_NORMAL, tr_laws_normal[contact->normal.law], &contact->normal);
    group_take(g, TR_FRICTION, normal_only ? &tr_friction_none : tr_laws_friction[contact->friction.law],
               &contact->friction);
    group_take(g, TR_ROLLING, normal_only ? &tr_rolling_none : tr_laws_rolling[contact->rolling.law],
               &contact->rolling);
    const tr_law *friction = g->laws[TR_FRICTION].law, *rolling = g->laws[TR_ROLLING].law;
    g->spins = friction->step || rolling->step;

    group_add_pass(g, "kinematics", kinematics_of(g, &tr_arms_rows[contact->arms]), NULL);
    group_add_pass(g, "normal", g->laws[TR_NORMAL].law->step, &g->laws[TR_NORMAL]);
    if (friction->step) group_add_pass(g, "friction", friction->step, &g->laws[TR_FRICTION]);
    tr_pass_run *velocity = tr_law_rolling_velocity(rolling, g->rolling_velocity);
    if (velocity) group_add_pass(g, "rolling velocity", velocity, NULL);
    if (rolling->step) group_add_pass(g, "rolling", rolling->step, &g->laws[TR_ROLLING]);
    g->shared_arms = contact->arms == 0;
    tr_pass_run *pulls = g->shared_arms ? tr_resultant_rolling_force : tr_resultant_rolling_apart;
    tr_pass_run *torques = rolling->needs & TR_GIVES_F_R ? pulls : tr_resultant_full;
    group_add_pass(g, "resultant", g->spins ? torques : tr_resultant_central, NULL);
}

static bool is_law_of(const tr_world *world, int w, const tr_scene_contact *laws) {
    const tr_scene_contact *own = tr_world_wall_laws(world, w);
    return own == laws || (own && laws && memcmp(own, laws, sizeof *own) == 0); /* no byte of them is unset */
}

enum { MOST_GROUPS = TR_MAX_WALLS + 3 }; /* each wall with laws of its own */

/* Walls of the same laws, with ends or without, share a group; the first is that of endless walls with the laws of
 * disks. Makes the groups, and finds the laws of each; NULL: those of disks. */
static bool make_groups(tr_world *world, const tr_scene_contact *own[MOST_GROUPS], tr_status *st) {
    bool ends[MOST_GROUPS] = {false};
    int n = 2;
    own[0] = own[1] = NULL;
    for (int w = 0; w < world->n_walls; w++) {
        int k = 1;
        while (k < n && !(ends[k] == world->wall[w].ends && is_law_of(world, w, own[k]))) k++;
        if (k == n) ends[n] = world->wall[w].ends, own[n++] = tr_world_wall_laws(world, w);
        world->wall_kind[w] = (unsigned char)(k - 1);
    }
    if (world->n_rings > 0) own[n++] = NULL;
    tr_group *group = tr_alloc((size_t)n, sizeof *group, st);
    if (!group) return false;
    for (int k = 1; k < n; k++) group[k].walls = true, group[k].ends = ends[k];
    if (world->n_rings > 0) group[n - 1].walls = false, group[n - 1].rings = true;
    for (int k = 0; k < world->n_groups; k++) tr_group_free(&world->group[k]);
    free(world->group);
    world->group = group, world->n_groups = n;
    return true;
}

bool tr_world_set_laws(tr_world *world, const tr_scene_contact *contact, bool smooth_walls, unsigned sinks,
                       tr_status *st) {
    double sum = 0, r_min = INFINITY;
    world->r_max = 0;
    const int first = world->n_rings, n = world->disks.n - first;
    for (int i = first; i < world->disks.n; i++) {
        double R = world->disks.pos[tr_body(i) + TR_RADIUS];
        sum += 2 * R, r_min = fmin(r_min, R), world->r_max = fmax(world->r_max, R);
    }
    world->wide_skin = WIDE_SKIN * sum / n;
    world->thin_skin = fmin(THIN_SKIN * sum / n, TR_LARGEST_OVERLAP * r_min);
    world->rolling_velocity = contact->rolling_velocity;
    world->arms = contact->arms;
    world->stale = world->fresh = true;
    world->sure_dt = 0;
    tr_parallel_free(world->parallel), world->parallel = NULL; /* lanes again */
    world->near.n = 0;
    memset(world->tile, 0, sizeof *world->tile); /* lanes that no pass of the new pipeline writes are 0 */
    free(world->ledger);
    world->ledger = NULL;
    if (sinks & TR_SINK_LEDGER && !(world->ledger = tr_alloc(1, sizeof *world->ledger, st))) return false;
    const tr_scene_contact *own[MOST_GROUPS];
    if (!make_groups(world, own, st)) return false;
    for (int k = 0; k < world->n_groups; k++) {
        tr_group *g = &world->group[k];
        group_choose(g, own[k] ? own[k] : contact, g->walls && smooth_walls, world->shape,
                     !g->walls && world->cell.side[0] > 0);
        if (sinks & TR_SINK_LEDGER) tr_ledger_attach(g, world->ledger);
        if (sinks & TR_SINK_ARCS) tr_arcs_attach(g);
    }
    if (world->finder) world->broad->destroy(world->finder);
    world->finder =
        world->broad->create(&(tr_broad_input){n, world->disks.pos + tr_body(first), world->wide_skin, NULL, NULL}, st);
    return world->finder != NULL;
}

static bool is_before(int a, int b, int other_a, int other_b) {
    return a < other_a || (a == other_a && b < other_b);
}

/* Both lists are sorted by their ids. */
static void carry(tr_group *to, const tr_group *from, int slot) {
    int first = to->laws[slot].hist, old_first = from->laws[slot].hist, old = 0;
    for (int i = 0; i < to->n; i++) {
        while (old < from->n && is_before(from->a[old], from->b[old], to->a[i], to->b[i])) old++;
        if (old == from->n) return;
        if (from->a[old] != to->a[i] || from->b[old] != to->b[i]) continue;
        for (int h = 0; h < to->laws[slot].law->n_hist; h++) to->hist[first + h][i] = from->hist[old_first + h][old];
    }
}

/* Has it a history that the law of before kept too? */
static bool carries(const tr_group *now, const tr_group *before, int slot) {
    const tr_law *law = now->laws[slot].law;
    return before->n && law->n_hist && law == before->laws[slot].law;
}

bool tr_world_change_laws(tr_world *world, const tr_scene_contact *contact, bool smooth_walls, unsigned sinks,
                          tr_status *st) {
    static const int slots[] = {TR_FRICTION, TR_ROLLING};
    tr_group *before = world->group;
    const int n = world->n_groups;
    world->group = NULL, world->n_groups = 0;
    bool ok = tr_world_set_laws(world, contact, smooth_walls, sinks, st), any = false;
    const int both = world->n_groups < n ? world->n_groups : n;
    tr_group *now = world->group;
    for (int k = 0; ok && k < 2 * both; k++) any |= carries(&now[k / 2], &before[k / 2], slots[k % 2]);
    if (any) {
        ok = tr_contacts_refresh(world, st);
        for (int k = 0; ok && k < 2 * both; k++)
            if (carries(&now[k / 2], &before[k / 2], slots[k % 2])) carry(&now[k / 2], &before[k / 2], slots[k % 2]);
        world->stale = true; /* sinks may still come, and want their arrays */
    }
    for (int k = 0; k < n; k++) tr_group_free(&before[k]);
    free(before);
    return ok;
}
