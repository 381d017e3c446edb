/* SPDX-License-Identifier: MIT */
/* A disk whose motion is given is infinitely heavy in what is given: prescribed and orbit in m and I, pinned in m,
 * driven in I.
 *
 *   rebound   e = exp(-(pi - 2 q) tan q), sin q = z: damping ratio, of hertz-sphere sqrt(6/5) times that, released at
 *             force 0
 *   swing     of star-displacement-damping at constant force: omega^2 = k_r (1/I1 + 1/I2), 1/I = 0 where the spin is
 *             given; damping ratio c (1/I1 + 1/I2)/(2 omega), c = 2 nu sqrt(I_r k_r)
 *
 * and invariance: what is given does not care for the density. */
#include "core/bodies.h"
#include "core/ledger.h"
#include "core/pipeline.h"
#include "core/record.h"
#include "core/worlds.h"

static const double R = 0.01, DENSITY = 1000, K = 1e6;
static const double densities[] = {20, 2700, 1e5};

typedef struct show {
    tr_scene scene;
    tr_scene_disk disk[2];
    tr_scene_wall wall[1];
    tr_bodies b;
} show;

/* dt 0: 3e-4 of the bound, so that an impact takes 5000 steps or more. */
static void start(show *s, int disks, int walls, tr_shape shape, const tr_scene_contact *contact, double dt) {
    tr_status st = {0};
    s->scene.kind = TR_KIND_BODIES, s->scene.shape = shape, s->scene.contact = *contact;
    s->scene.step = (tr_scene_step){.safety = 3e-4, .dt = dt};
    s->scene.time_end = 1;
    s->scene.disks = s->disk, s->scene.n_disks = disks;
    s->scene.walls = s->wall, s->scene.n_walls = walls;
    for (int i = 0; i < disks; i++)
        if (s->disk[i].density == 0) s->disk[i].density = DENSITY;
    if (!tr_bodies_init(&s->b, &s->scene, &st)) fail_msg("%s", st.text);
    forces(&s->b.world);
}

static void go(show *s, int n) {
    for (int k = 0; k < n; k++) tr_bodies_advance(&s->b), forces(&s->b.world);
}

static void set_normal(tr_scene_contact *c, const char *name, double zeta) {
    const tr_param_catalog *catalog = tr_laws_catalog();
    c->normal = law_named(tr_laws_normal, catalog->n_normal, name);
    const tr_param_table *table = catalog->normal[c->normal.law];
    set_parameter(&c->normal, table, strcmp(name, "linear") ? "E_star" : "k_n", K);
    set_parameter(&c->normal, table, "damping_ratio", zeta);
}

/* ---- rebound */

/* The relative speed after over before: disk 0, free, of `mine`, falls on disk 1. */
static double rebound(const char *law, double zeta, int motion, double mine, double other) {
    const double v = 1e-3, gap = 1e-9;
    tr_scene_contact c = contact_of((test_laws){.k_n = K});
    set_normal(&c, law, zeta);
    show s = {.disk = {{.radius = R, .density = mine, .y = 2 * R + gap, .vy = -v},
                       {.radius = R, .density = other, .motion = motion, .spin = 3}}};
    tr_shape shape = strcmp(law, "hertz-sphere") ? TR_SHAPE_DISK : TR_SHAPE_SPHERE;
    start(&s, 2, 0, shape, &c, 0);
    const double *pos = s.b.world.disks.pos, *vel = s.b.world.disks.vel;
    for (int k = 0; k < 200000 && !(vel[1] - vel[5] > 0 && pos[1] - pos[5] > 2 * R); k++) go(&s, 1);
    double e = (vel[1] - vel[5]) / v;
    if (motion != TR_DRIVEN && motion != TR_FREE) assert_true(vel[5] == 0 && vel[6] == 3); /* as given */
    tr_bodies_free(&s.b);
    return e;
}

static const int given[] = {TR_PRESCRIBED, TR_ORBIT, TR_PINNED, TR_DRIVEN};

static void test_rebound_does_not_know_the_density_of_what_is_given(void **state) {
    (void)state;
    static const double zeta[] = {0.05, 0.3}, kept[] = {0.85876, 0.45098};
    for (int z = 0; z < 2; z++)
        for (int law = 0; law < 2; law++)
            for (int m = 0; m < 4; m++)
                for (int d = 0; d < 3; d++) {
                    double q = asin((law ? sqrt(1.2) : 1) * zeta[z]), e = exp(-(M_PI - 2 * q) * tan(q));
                    if (!law) assert_close(e, kept[z], 0, 1e-5); /* five digits */
                    /* first order: the force begins with a jump and the dashpot sees a velocity half a step old; an
                     * impact takes 5000 steps or more, of which each errs by pi (zeta + 0.05) of itself as in
                     * test_impact */
                    assert_close(rebound(law ? "hertz-sphere" : "linear", zeta[z], given[m], DENSITY, densities[d]), e,
                                 0, M_PI * (zeta[z] + 0.05) / 5000);
                }
}

/* No closed form, but one fall: a free disk on one that is infinitely heavy moves as two of twice its mass do in their
 * middle. */
static void test_rebound_by_the_line_contact(void **state) {
    (void)state;
    for (int m = 0; m < 3; m++)
        for (int d = 0; d < 3; d++) {
            double e = rebound("hertz-line", 0.3, given[m], DENSITY, densities[d]);
            double twins = rebound("hertz-line", 0.3, TR_FREE, 2 * DENSITY, 2 * DENSITY);
            assert_true(e < 0.6);
            assert_close(e, twins, 1e-3,
                         0); /* steps differ, of 5000 or more in an impact: pi 0.35/5000, and twice that */
        }
}

/* ---- what has no effect has none, to the last bit, by every law that there is */

static void throw_at(show *s, int normal, int friction, int rolling, int motion, double density) {
    const tr_param_catalog *catalog = tr_laws_catalog();
    tr_shape shape = catalog->normal[normal]->demands & TR_ONLY_SPHERES ? TR_SHAPE_SPHERE : TR_SHAPE_DISK;
    tr_scene_contact c = {.normal.law = normal, .friction.law = friction, .rolling.law = rolling};
    tr_scene_law *law[] = {&c.normal, &c.friction, &c.rolling};
    const tr_param_table *table[] = {catalog->normal[normal], catalog->friction[friction], catalog->rolling[rolling]};
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < table[k]->n; i++) {
            const tr_param *p = &table[k]->params[i];
            double value = p->dim.kg ? K * pow(1e-5, p->dim.s + 2) : 0.2; /* a viscosity for steps of 2e-5 s */
            if (p->type == TR_REAL) set_parameter(law[k], table[k], p->key, value);
            if (p->type == TR_SWITCH) *(bool *)(void *)((char *)law[k]->par + p->offset) = true;
        }
    *s = (show){.disk = {{.radius = R, .x = 0.3 * R, .y = 1.94 * R, .vx = 0.2, .vy = -0.3, .spin = -4},
                         {.radius = R, .density = density, .motion = motion, .spin = 30, .orbit = 2, .orbit_x = 0.1}}};
    s->scene.gravity.y = -10, s->scene.gravity.turn = 1;
    start(s, 2, 0, shape, &c, 2e-5);
}

static void test_density_of_what_is_given_has_no_effect(void **state) {
    (void)state;
    const tr_param_catalog *catalog = tr_laws_catalog();
    for (int normal = 0; normal < catalog->n_normal; normal++)
        for (int friction = 0; friction < catalog->n_friction; friction++)
            for (int rolling = 0; rolling < catalog->n_rolling; rolling++)
                for (int m = 0; m < 2; m++) {
                    unsigned demands = catalog->normal[normal]->demands | catalog->friction[friction]->demands;
                    if (demands & TR_ONLY_DRIVER) continue;
                    if (demands & TR_ONLY_DISKS && demands & TR_ONLY_SPHERES) continue;
                    show s[2];
                    for (int k = 0; k < 2; k++) {
                        throw_at(&s[k], normal, friction, rolling, given[m], k ? 1e5 : 20);
                        go(&s[k], 100);
                    }
                    const tr_disks *p = &s[0].b.world.disks, *q = &s[1].b.world.disks;
                    assert_true(s[0].b.world.contact_updates > 50 && isfinite(p->vel[0] + p->vel[2]));
                    assert_memory_equal(p->pos, q->pos, 8 * sizeof(double));
                    assert_memory_equal(p->vel, q->vel, 8 * sizeof(double));
                    assert_memory_equal(p->force, q->force,
                                        8 * sizeof(double)); /* weight too: both centres are given */
                    assert_true(s[0].b.dt_bound == s[1].b.dt_bound);
                    tr_bodies_free(&s[0].b), tr_bodies_free(&s[1].b);
                }
}

/* ---- the dashpot of star-displacement-damping */

static const double R1 = 0.02, R2 = 0.01, LAP = 1e-6, THETA = 0.05, MU_R = 0.1;

static tr_scene_contact damped(double nu) {
    tr_scene_contact c = contact_of((test_laws){.k_n = K});
    const tr_param_catalog *catalog = tr_laws_catalog();
    c.rolling = law_named(tr_laws_rolling, catalog->n_rolling, "star-displacement-damping");
    const tr_param_table *t = catalog->rolling[c.rolling.law];
    set_parameter(&c.rolling, t, "mu_r", MU_R);
    set_parameter(&c.rolling, t, "theta_max", THETA);
    set_parameter(&c.rolling, t, "damping_factor", nu);
    set_parameter(&c.rolling, t, "damping_multiplier", 1);
    for (int i = 0; i < t->n; i++)
        if (!strcmp(t->params[i].key, "damping")) *(bool *)(void *)((char *)c.rolling.par + t->params[i].offset) = true;
    return c;
}

typedef struct rolling_pair {
    const char *what;
    int one, two; /* motions; one -1: a wall */
    bool stands;  /* the centres keep their distance */
} rolling_pair;

static const rolling_pair pairs[] = {
    {"wall and pinned", -1, TR_PINNED, true},
    {"prescribed and pinned", TR_PRESCRIBED, TR_PINNED, true},
    {"two pinned", TR_PINNED, TR_PINNED, true},
    {"two prescribed", TR_PRESCRIBED, TR_PRESCRIBED, true},
    {"prescribed and orbit", TR_PRESCRIBED, TR_ORBIT, true},
    {"wall and prescribed", -1, TR_PRESCRIBED, true},
    {"two driven", TR_DRIVEN, TR_DRIVEN, false},
    {"driven and prescribed", TR_DRIVEN, TR_PRESCRIBED, false},
    {"wall and driven", -1, TR_DRIVEN, false},
};

/* What the pair is by the closed form. */
typedef struct swing {
    double k_r, per_I, I_r, omega, ratio; /* ratio 0: no dashpot */
} swing;

static swing swing_of(const rolling_pair *p, double nu) {
    double R_eff = p->one < 0 ? R2 : R1 * R2 / (R1 + R2), I1 = DENSITY * M_PI * pow(R1, 4) / 2, sum = 0;
    if (p->one == TR_PINNED) sum += 1 / I1;
    if (p->two == TR_PINNED) sum += 1 / (DENSITY * M_PI * pow(R2, 4) / 2);
    swing s = {.k_r = MU_R * 2 * R_eff * K * LAP / THETA, .per_I = sum, .I_r = sum > 0 ? 1 / sum : 0};
    s.omega = sqrt(s.k_r * sum), s.ratio = sum > 0 ? nu * sqrt(s.I_r * sum) : 0;
    return s;
}

static void place_pair(show *s, const rolling_pair *p, double nu, double spin, double dt) {
    tr_scene_contact c = damped(nu);
    bool wall = p->one < 0;
    tr_scene_disk two = {.radius = R2, .x = (wall ? R2 : R1 + R2) - LAP, .motion = p->two, .spin = -spin};
    *s = (show){.disk = {{.radius = R1, .motion = wall ? 0 : p->one}, two}, .wall = {{.nx = 1}}};
    if (wall) s->disk[0] = two;
    start(s, wall ? 1 : 2, wall, TR_SHAPE_DISK, &c, dt);
}

static tr_record record_of(show *s) {
    tr_record *all = NULL, r;
    int room = 0;
    tr_status st = {0};
    assert_int_equal(tr_record_all(&s->b.world, &all, &room, &st), 1);
    r = all[0];
    free(all);
    return r;
}

static void test_damped_swing_of_what_may_turn(void **state) {
    (void)state;
    static const double factor[] = {0.1, 0.5};
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++)
        for (int f = 0; f < 2 && pairs[i].stands; f++) {
            swing w = swing_of(&pairs[i], factor[f]);
            double dt = w.per_I > 0 ? 1e-3 / w.omega : 1e-6, spin = w.per_I > 0 ? 0.3 * THETA * w.omega : 2;
            show s;
            place_pair(&s, &pairs[i], factor[f], spin, dt);
            int last = s.b.world.disks.n - 1;
            double d = w.omega * sqrt(1 - w.ratio * w.ratio), start_at = 0.5 * dt; /* the first step has no spring */
            for (int k = 1; k < 8000; k++) {
                go(&s, 1);
                double t = k * dt - start_at, turned = spin * t, now = 1;
                double relative = s.b.world.disks.vel[4 * last + 2] - (last ? s.b.world.disks.vel[2] : 0);
                if (w.per_I > 0) now = exp(-w.ratio * w.omega * t) * (cos(d * t) - w.ratio * w.omega / d * sin(d * t));
                /* spins are half a step old, and the dashpot sees them so: two of 1000 steps in a radian, as in
                 * test_star */
                assert_close(-relative / spin, now, 0, 4e-3 * (1 + 2 * w.ratio));
                if (w.per_I > 0) continue;
                /* nothing turns freely: the moment is that of the spring alone, up to its bound; a step more or less */
                assert_close(record_of(&s).m1, -fmin(w.k_r * turned, w.k_r * THETA), 0, w.k_r * spin * dt);
            }
            tr_bodies_free(&s.b);
        }
}

/* I_r, the moment of a step by hand, and what the bound on the step is told. */
static void test_dashpot_where_nothing_finite_is_left(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        swing w = swing_of(&pairs[i], 0.4);
        show s;
        place_pair(&s, &pairs[i], 0.4, 1, 1e-7);
        const tr_world *world = &s.b.world;
        const tr_group *g = &world->group[pairs[i].one < 0];
        const tr_group_law *slot = &g->laws[TR_ROLLING];
        tr_pair_bodies bodies = tr_world_pair(world, g, 0, pairs[i].one < 0 ? 0 : 1);
        bodies.f_n = K * LAP;
        tr_stiffness k = slot->law->stiffness(slot->par, &bodies);
        print_message("%s: I_r = %.3g kg m\n", pairs[i].what, g->pair[slot->pair][0]);
        /* the overlap has lost digits to 1 - 2e-16/1e-4 */
        assert_close(g->pair[slot->pair][0], w.I_r, 1e-14, 0);
        assert_close(k.k, w.k_r, 1e-12, 0);
        assert_close(k.c, 0.4 * 2 * sqrt(w.I_r * w.k_r), 1e-12, 0);
        tr_timestep_limit limit = tr_timestep_contacts(world);
        if (pairs[i].stands && w.per_I == 0) assert_true(isinf(limit.dt));
        if (pairs[i].stands && w.per_I > 0)
            assert_close(limit.dt, 2 / w.omega * (sqrt(1 + w.ratio * w.ratio) - w.ratio), 1e-9, 0);
        go(&s, 3);
        assert_true(isfinite(record_of(&s).m1) && isfinite(world->disks.vel[2]));
        tr_bodies_free(&s.b);
    }
}

/* A free disk is braked by the whole of its own inertia about the contact point, I + m R^2 = 3 I, and by no more,
 * whatever it rolls on. */
static void test_dashpot_of_a_free_disk_on_a_given_one(void **state) {
    (void)state;
    for (int m = 0; m < 4; m++)
        for (int d = 0; d < 3; d++) {
            tr_scene_contact c = damped(0.4);
            show s = {.disk = {{.radius = R1, .density = densities[d], .motion = given[m]},
                               {.radius = R2, .x = R1 + R2 - LAP}}};
            start(&s, 2, 0, TR_SHAPE_DISK, &c, 1e-7);
            const tr_group *g = &s.b.world.group[0];
            double I1 = densities[d] * M_PI * pow(R1, 4) / 2, I2 = DENSITY * M_PI * pow(R2, 4) / 2;
            double I_r = given[m] == TR_PINNED ? 1 / (1 / I1 + 1 / (3 * I2)) : 3 * I2; /* a pinned one turns too */
            assert_close(g->pair[g->laws[TR_ROLLING].pair][0], I_r, 1e-14, 0);
            tr_bodies_free(&s.b);
        }
}

/* ---- sign laws, and the ledger */

/* The moment against a spin that is given is the whole one, however slow the spin and light the disk; a free partner at
 * rest is stopped by what friction gives it and stays. */
static void test_moment_against_a_given_spin(void **state) {
    (void)state;
    const tr_param_catalog *catalog = tr_laws_catalog();
    for (int d = 0; d < 3; d++) {
        tr_scene_contact c = contact_of((test_laws){.k_n = K});
        c.rolling = law_named(tr_laws_rolling, catalog->n_rolling, "star-force-proportional");
        set_parameter(&c.rolling, catalog->rolling[c.rolling.law], "mu_r", MU_R);
        show s = {.disk = {{.radius = R1, .density = densities[d], .motion = TR_PRESCRIBED, .spin = 1e-12},
                           {.radius = R2, .x = R1 + R2 - LAP, .motion = TR_PINNED}}};
        start(&s, 2, 0, TR_SHAPE_DISK, &c, 1e-3);
        go(&s, 2);
        double r1 = R1 * (1 - LAP / (R1 + R2));
        /* the overlap is what is left of 0.03: 4e-12 of it */
        assert_close(record_of(&s).m1, -MU_R * K * LAP * r1, 1e-11, 0);
        assert_true(record_of(&s).m2 == 0 && s.b.world.disks.vel[6] == 0);
        tr_bodies_free(&s.b);
    }
}

/* What a free disk loses to a given one at rest is what the dashpot takes: 1 - e^2 of its energy. */
static void test_ledger_beside_a_given_disk(void **state) {
    (void)state;
    for (int d = 0; d < 3; d++) {
        tr_world w;
        new_world(&w, 2);
        tr_world_set_disk(&w, 0, &(tr_disk_start){0, 0, 0, R, densities[d], true});
        tr_world_set_disk(&w, 1, &(tr_disk_start){2 * R + 1e-9, 0, 0, R, DENSITY, false});
        set_laws(&w, (test_laws){.k_n = K, .damping_ratio = 0.3}, TR_SINK_LEDGER);
        w.dt = 3e-4 * tr_timestep_worst(&w);
        set_velocity(&w, 1, -1e-3, 0, 0);
        forces(&w), tr_ledger_begin(&w);
        double first = 0.5 * w.disks.mass[1] * 1e-6;
        while (!(w.disks.vel[4] > 0 && w.disks.pos[4] > 2 * R)) tr_step_advance(&w), forces(&w);
        tr_energy e = tr_ledger_read(&w);
        assert_close(e.damped / first, 1 - 0.45098 * 0.45098, 0, 2 * M_PI * 0.35 / 5000); /* twice that of e */
        assert_close(e.kinetic / first, 0.45098 * 0.45098, 0, 2 * M_PI * 0.35 / 5000);
        assert_close(e.residual / first, 0, 0, 2 * M_PI * 0.35 / 5000);
        tr_world_free(&w);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_rebound_does_not_know_the_density_of_what_is_given),
        cmocka_unit_test(test_rebound_by_the_line_contact),
        cmocka_unit_test(test_density_of_what_is_given_has_no_effect),
        cmocka_unit_test(test_damped_swing_of_what_may_turn),
        cmocka_unit_test(test_dashpot_where_nothing_finite_is_left),
        cmocka_unit_test(test_dashpot_of_a_free_disk_on_a_given_one),
        cmocka_unit_test(test_moment_against_a_given_spin),
        cmocka_unit_test(test_ledger_beside_a_given_disk),
    };
    return cmocka_run_group_tests_name("given motion", tests, NULL, NULL);
}
