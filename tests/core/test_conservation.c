/* SPDX-License-Identifier: MIT */
/* What no law may change: linear and angular momentum of free disks, and the sameness of physics for another observer.
 * References: conservation to rounding; a run of the same disks seen by a moving or turned observer; a packing turned
 * as a rigid body, in which nothing happens. */
#include "core/ledger.h"
#include "core/pipeline.h"
#include "core/worlds.h"

enum { SIDE = 7, N = SIDE * SIDE };

static const test_laws stiff = {1e6, 0.1, 0.5, 0.5e6, 0.3, 0.5e6, "wang", NULL};

/* A jostling cluster: a lattice of disks of radii 0.6 to 1 cm, some overlapping, that fly together and turn. */
static void new_cluster(tr_world *w, test_laws laws, unsigned sinks) {
    tr_random r = tr_random_seed(3, 1);
    new_world(w, N);
    for (int i = 0; i < N; i++) {
        double radius = 0.006 + 0.004 * tr_random_uniform(&r), x = 0.018 * (i % SIDE - 3), y = 0.018 * (i / SIDE - 3);
        tr_world_set_disk(w, i,
                          &(tr_disk_start){x + 0.001 * tr_random_uniform(&r), y + 0.001 * tr_random_uniform(&r), 0,
                                           radius, 1000, false});
        set_velocity(w, i, -10 * x - 5 * y + 0.2 * tr_random_uniform(&r), -10 * y + 5 * x,
                     40 * (tr_random_uniform(&r) - 0.3));
    }
    set_laws(w, laws, sinks);
    w->dt = 0.3 * tr_timestep_worst(w);
}

typedef struct momentum {
    double px, py, L, p_scale, L_scale;
} momentum;

static momentum momentum_of(const tr_world *w) {
    momentum m = {0};
    for (int i = 0; i < w->disks.n; i++) {
        const double *x = w->disks.pos + 4 * i, *v = w->disks.vel + 4 * i;
        double mass = w->disks.mass[i], spin = 0.5 * mass * x[3] * x[3] * v[2],
               orbit = mass * (x[0] * v[1] - x[1] * v[0]);
        m.px += mass * v[0], m.py += mass * v[1], m.L += spin + orbit;
        m.p_scale += mass * hypot(v[0], v[1]);
        m.L_scale += fabs(spin) + mass * hypot(v[0], v[1]) * hypot(x[0], x[1]);
    }
    return m;
}

static void test_momentum(void **state) {
    (void)state;
    for (int v = 0; v < tr_n_rolling_velocities; v++) {
        tr_world w;
        test_laws laws = stiff;
        laws.rolling_velocity = tr_rolling_velocities[v].name;
        laws.arms = tr_arms_rows[v % tr_n_arms].name;
        new_cluster(&w, laws, 0);
        w.dt *= 0.1; /* 10^4 steps end before the cluster has flown apart */
        momentum m0 = momentum_of(&w);
        double p_scale = m0.p_scale, L_scale = m0.L_scale;
        for (int k = 0; k < 100; k++) {
            steps(&w, 100);
            momentum m = momentum_of(&w);
            p_scale = fmax(p_scale, m.p_scale), L_scale = fmax(L_scale, m.L_scale);
            /* Each step rounds every disk's velocity and position once, and its force some six times. */
            double eps = 1.1e-16 * 8 * 100 * (k + 1);
            assert_close(m.px, m0.px, 0, eps * p_scale);
            assert_close(m.py, m0.py, 0, eps * p_scale);
            assert_close(m.L, m0.L, 0, eps * L_scale);
        }
        assert_true(w.contact_updates > 3 * w.steps); /* they did touch */
        tr_world_free(&w);
    }
}

/* A spinning pair pressed together with a large overlap: full radii as arms would create angular momentum at once. */
static void keeps_angular_momentum(const char *arms) {
    tr_world w;
    new_world(&w, 2);
    tr_world_set_disk(&w, 0, &(tr_disk_start){0, 0, 0, 0.01, 1000, false});
    tr_world_set_disk(&w, 1, &(tr_disk_start){0.013, 0, 0, 0.005, 1000, false});
    set_laws(&w, (test_laws){1e6, 0, 10, 1e6, 0, 0, NULL, arms}, 0);
    w.dt = 1e-6, w.allow_unstable = true;
    set_velocity(&w, 0, 0, 0, 100);
    w.disks.pos[4] = 0.0139; /* 0.22 of the smaller radius */
    momentum m0 = momentum_of(&w);
    forces(&w), tr_step_advance(&w); /* the first step has no history */
    for (int k = 0; k < 50; k++) steps(&w, 1);
    momentum m = momentum_of(&w);
    assert_true(fabs(w.disks.vel[6]) > 1); /* friction has acted */
    assert_close(m.L, m0.L, 1e-13, 0);     /* 50 steps of 10 roundings */
    tr_world_free(&w);
}

static void test_angular_momentum_with_overlap(void **state) {
    (void)state;
    for (int a = 0; a < tr_n_arms; a++) keeps_angular_momentum(tr_arms_rows[a].name);
}

/* (x, y) -> (-y, x): products and sums of two commute, so every number is the same but for its place and sign. */
static void test_quarter_turn(void **state) {
    (void)state;
    tr_world w, q;
    new_cluster(&w, stiff, 0), new_cluster(&q, stiff, 0);
    for (int i = 0; i < N; i++) {
        double *x = q.disks.pos + 4 * i, *v = q.disks.vel + 4 * i;
        double x0 = x[0], v0 = v[0];
        x[0] = -x[1], x[1] = x0, v[0] = -v[1], v[1] = v0;
    }
    for (int k = 0; k < 20; k++) {
        steps(&w, 500), steps(&q, 500);
        for (int i = 0; i < N; i++) {
            const double *x = w.disks.pos + 4 * i, *y = q.disks.pos + 4 * i, *v = w.disks.vel + 4 * i,
                         *u = q.disks.vel + 4 * i;
            assert_true(y[0] == -x[1] && y[1] == x[0] && y[2] == x[2]);
            assert_true(u[0] == -v[1] && u[1] == v[0] && u[2] == v[2]);
        }
    }
    tr_world_free(&w), tr_world_free(&q);
}

/* An observer that moves with (3, -2) m/s. Positions round at his distance, 1e-16 m, velocities at his speed, and each
 * collision between disks may magnify that tenfold: the run ends after a few of them, and 1e-11 m leaves some factors
 * of ten. */
static void test_moving_observer(void **state) {
    (void)state;
    tr_world w, q;
    new_cluster(&w, stiff, 0), new_cluster(&q, stiff, 0);
    for (int i = 0; i < N; i++) q.disks.vel[4 * i] += 3, q.disks.vel[4 * i + 1] -= 2;
    int n = 1000;
    steps(&w, n), steps(&q, n);
    assert_true(w.contact_updates > 2 * n);
    double t = n * w.dt;
    for (int i = 0; i < N; i++) {
        const double *x = w.disks.pos + 4 * i, *y = q.disks.pos + 4 * i, *v = w.disks.vel + 4 * i,
                     *u = q.disks.vel + 4 * i;
        assert_close(y[0] - 3 * t, x[0], 0, 1e-10 * 0.1);
        assert_close(y[1] + 2 * t, x[1], 0, 1e-10 * 0.1);
        assert_close(u[0] - 3, v[0], 0, 1e-9);
        assert_close(u[1] + 2, v[1], 0, 1e-9);
        assert_close(u[2], v[2], 0, 1e-9 / 0.006);
    }
    tr_world_free(&w), tr_world_free(&q);
}

/* A lattice of overlapping disks of two sizes is carried round twice as a rigid body. No spring may be stretched and
 * nothing dissipated: with full radii as arms each contact would slide by 4 pi overlap. */
static void rigid_rotation_dissipates_nothing(const char *arms) {
    enum { M = 25, STEPS = 20000 };
    tr_world w;
    new_world(&w, M);
    double x[M], y[M];
    for (int i = 0; i < M; i++) {
        double radius = i % 2 ? 0.006 : 0.01;
        x[i] = 0.016 * (i % 5) * 0.97, y[i] = 0.016 * (i / 5) * 0.97;
        tr_world_set_disk(&w, i, &(tr_disk_start){x[i], y[i], 0, radius, 1000, false});
    }
    test_laws laws = stiff;
    laws.rolling_velocity = "bagi-kuhn", laws.arms = arms;
    set_laws(&w, laws, TR_SINK_LEDGER);
    w.dt = 1e-6;
    double W = 4 * M_PI / (STEPS * w.dt);
    for (int k = 0; k <= STEPS; k++) {
        double c = cos(W * k * w.dt), s = sin(W * k * w.dt);
        for (int i = 0; i < M; i++) {
            double *p = w.disks.pos + 4 * i;
            p[0] = c * x[i] - s * y[i], p[1] = s * x[i] + c * y[i], p[2] = W * k * w.dt;
            set_velocity(&w, i, -W * p[1], W * p[0], W);
        }
        forces(&w);
        if (k == 0) tr_ledger_begin(&w);
        w.steps++;
        w.stale = k % 50 == 0; /* as tr_step_advance would say, which would move the disks */
    }
    const tr_group *g = &w.group[0];
    double largest_Q = 0, largest_T = 0, normal = 0;
    for (int i = 0; i < g->n; i++) {
        largest_Q = fmax(largest_Q, fabs(g->hist[g->laws[TR_FRICTION].hist][i]));
        largest_T = fmax(largest_T, fabs(g->hist[g->laws[TR_ROLLING].hist][i]));
    }
    for (int i = 0; i < 4 * M; i++) normal = fmax(normal, fabs(w.disks.force[i]));
    assert_true(g->n >= 40 && w.contact_updates / STEPS >= 40 && normal > 100);
    /* STEPS roundings of velocities of 100 m/s times k_t dt. */
    double rounding = STEPS * 1e-16 * W * 0.2 * stiff.k_t * w.dt;
    assert_close(largest_Q, 0, 0, 10 * rounding);
    assert_close(largest_T, 0, 0, 10 * rounding);
    tr_energy e = tr_ledger_read(&w);
    double loading = 10 * rounding * 4 * M_PI * 0.01 * g->n; /* that force over the way round a rim */
    assert_close(e.friction, 0, 0, loading);
    assert_close(e.rolling, 0, 0, loading);
    assert_close(e.damped, 0, 0, loading);
    tr_world_free(&w);
}

static void test_rigid_rotation_dissipates_nothing(void **state) {
    (void)state;
    for (int a = 0; a < tr_n_arms; a++) rigid_rotation_dissipates_nothing(tr_arms_rows[a].name);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_momentum),
        cmocka_unit_test(test_angular_momentum_with_overlap),
        cmocka_unit_test(test_quarter_turn),
        cmocka_unit_test(test_moving_observer),
        cmocka_unit_test(test_rigid_rotation_dissipates_nothing),
    };
    return cmocka_run_group_tests_name("conservation", tests, NULL, NULL);
}
