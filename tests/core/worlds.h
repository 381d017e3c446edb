/* SPDX-License-Identifier: MIT */
/* What the tests of core/ share: laws chosen by name, small worlds, steps that must succeed, and worlds compared bit by
 * bit. */
#ifndef TR_TEST_WORLDS_H
#define TR_TEST_WORLDS_H

#include "assert_close.h"
#include "base/random.h"
#include "core/biaxial.h"
#include "core/pipeline.h"
#include "core/step.h"
#include "core/timestep.h"
#include "laws/kinematics.h"
#include <stdlib.h>
#include <string.h>

/* mu == 0: no friction law; mu_r == 0: no rolling law; rolling_velocity NULL: wang; arms NULL: shared. */
typedef struct test_laws {
    double k_n, damping_ratio, mu, k_t, mu_r, k_r;
    const char *rolling_velocity;
    const char *arms;
} test_laws;

static inline void set_parameter(tr_scene_law *law, const tr_param_table *table, const char *key, double value) {
    for (int i = 0; i < table->n; i++)
        if (!strcmp(table->params[i].key, key)) {
            memcpy((char *)law->par + table->params[i].offset, &value, sizeof value);
            return;
        }
    fail_msg("law %s has no parameter %s", table->name, key);
}

static inline tr_scene_law law_named(const tr_law *const *laws, int n, const char *name) {
    for (int i = 0; i < n; i++)
        if (!strcmp(laws[i]->table.name, name)) return (tr_scene_law){.law = i};
    fail_msg("no law is called %s", name);
    return (tr_scene_law){0};
}

static inline tr_scene_contact contact_of(test_laws p) {
    const tr_param_catalog *catalog = tr_laws_catalog();
    tr_scene_contact c = {0};
    c.normal = law_named(tr_laws_normal, catalog->n_normal, "linear");
    c.friction = law_named(tr_laws_friction, catalog->n_friction, p.mu > 0 ? "coulomb-spring" : "none");
    c.rolling = law_named(tr_laws_rolling, catalog->n_rolling, p.mu_r > 0 ? "wang-spring" : "none");
    set_parameter(&c.normal, catalog->normal[c.normal.law], "k_n", p.k_n);
    set_parameter(&c.normal, catalog->normal[c.normal.law], "damping_ratio", p.damping_ratio);
    if (p.mu > 0) {
        set_parameter(&c.friction, catalog->friction[c.friction.law], "mu", p.mu);
        set_parameter(&c.friction, catalog->friction[c.friction.law], "k_t", p.k_t);
    }
    if (p.mu_r > 0) {
        set_parameter(&c.rolling, catalog->rolling[c.rolling.law], "mu_r", p.mu_r);
        set_parameter(&c.rolling, catalog->rolling[c.rolling.law], "k_r", p.k_r);
    }
    const char *wanted = p.rolling_velocity ? p.rolling_velocity : "wang";
    c.rolling_velocity = -1;
    for (int i = 0; i < tr_n_rolling_velocities; i++)
        if (!strcmp(tr_rolling_velocities[i].name, wanted)) c.rolling_velocity = i;
    if (c.rolling_velocity < 0) fail_msg("no rolling velocity is called %s", wanted);
    for (c.arms = 0; p.arms && strcmp(tr_arms_rows[c.arms].name, p.arms);) c.arms++;
    assert_true(c.arms < tr_n_arms);
    return c;
}

static inline void new_world_of(tr_world *world, int n, tr_shape shape) {
    tr_status st = {0};
    if (!tr_world_init(world, n, shape, &st)) fail_msg("%s", st.text);
}

static inline void new_world(tr_world *world, int n) {
    new_world_of(world, n, TR_SHAPE_DISK);
}

static inline void set_laws(tr_world *world, test_laws p, unsigned sinks) {
    tr_scene_contact contact = contact_of(p);
    tr_status st = {0};
    if (!tr_world_set_laws(world, &contact, false, sinks, &st)) fail_msg("%s", st.text);
}

/* Weight: m g on every disk. */
static inline void set_gravity(tr_world *world, double gx, double gy) {
    size_t lanes = 4 * (size_t)world->disks.n;
    free(world->disks.load);
    world->disks.load = calloc(lanes, sizeof(double));
    for (int i = 0; i < world->disks.n; i++) {
        world->disks.load[4 * i] = world->disks.mass[i] * gx;
        world->disks.load[4 * i + 1] = world->disks.mass[i] * gy;
    }
}

static inline void set_velocity(tr_world *world, int i, double vx, double vy, double w) {
    double *v = world->disks.vel + 4 * (size_t)i;
    v[0] = vx, v[1] = vy, v[2] = w;
}

static inline void forces(tr_world *world) {
    tr_status st = {0};
    if (!tr_step_forces(world, &st)) fail_msg("%s", st.text);
}

static inline void steps(tr_world *world, int n) {
    for (int k = 0; k < n; k++) forces(world), tr_step_advance(world);
}

/* Numbers of the list entry of disks (a, b), or wall a and disk b; -1: not listed. */
static inline int listed(const tr_group *g, int a, int b) {
    for (int i = 0; i < g->n; i++)
        if (g->a[i] == a && g->b[i] == b) return i;
    return -1;
}

static inline void assert_same_bits(const tr_world *p, const tr_world *q) {
    size_t bytes = 4 * (size_t)p->disks.n * sizeof(double);
    assert_int_equal(p->disks.n, q->disks.n);
    assert_int_equal(p->steps, q->steps);
    assert_memory_equal(p->disks.pos, q->disks.pos, bytes);
    assert_memory_equal(p->disks.vel, q->disks.vel, bytes);
    for (int w = 0; w < p->n_walls; w++) {
        assert_true(p->wall[w].x == q->wall[w].x && p->wall[w].y == q->wall[w].y);
        assert_true(p->wall[w].vx == q->wall[w].vx && p->wall[w].vy == q->wall[w].vy);
    }
}

/* ---- biaxial samples */

static inline tr_scene biaxial_scene(int disks, uint64_t seed, test_laws p) {
    return (tr_scene){
        .kind = TR_KIND_BIAXIAL,
        .seed = seed,
        .contact = contact_of(p),
        .step = {.safety = 0.5},
        .output = {.energy = true},
        .sample = {.disks = disks, .r_min = 0.76e-3, .r_max = 1.52e-3, .density = 2700},
        .compaction = {.pressure = 160e3, .mu = 0, .inertial_number = 1e-2, .unbalanced = 1e-4},
        .shear = {.lateral_pressure = 160e3, .inertial_number = 1e-3, .strain_end = 0.02},
    };
}

/* The laws of cases/biaxial.yaml. */
static const test_laws sand = {160e6, 0.3, 0.5, 80e6, 0.5, 80e6, "wang", NULL};

static inline void compact(tr_biaxial *b, const tr_scene *scene) {
    tr_status st = {0};
    double unbalanced;
    bool done = false;
    if (!tr_biaxial_init(b, scene, &st)) fail_msg("%s", st.text);
    while (!done)
        if (!tr_biaxial_compact(b, 200, &unbalanced, &done, &st)) fail_msg("%s", st.text);
}

static inline void begin_shear(tr_biaxial *b) {
    tr_status st = {0};
    if (!tr_biaxial_begin_shear(b, &st)) fail_msg("%s", st.text);
}

static inline void shear_forces(tr_biaxial *b) {
    tr_status st = {0};
    if (!tr_biaxial_forces(b, &st)) fail_msg("%s", st.text);
}

static inline void shear_steps(tr_biaxial *b, int n) {
    for (int k = 0; k < n; k++) shear_forces(b), tr_step_advance(&b->world);
}

#endif
