/* SPDX-License-Identifier: MIT */
/* bagi-kuhn-conjugate: its forces against the first form of the law (written out here), its power against -T V_r, the
 * closed cycle in which the pure pair of moments makes energy, the wall as the limit of a large disk, and the law in a
 * world: momentum, angular momentum, ledger, stability bound. */
#include "core/convergence.h"
#include "core/ledger.h"
#include "core/worlds.h"

static const double K_R = 2e6, MU_R = 0.3;

typedef struct single {
    double R1, R2, nx, ny, L;
    double Vt, w1, w2, f_n;
} single;

typedef struct answer {
    double fx, fy, q1, q2, T, V_r, dvx, dvy;
} answer;

static const tr_law *law(void) {
    return tr_laws_rolling[law_named(tr_laws_rolling, tr_laws_catalog()->n_rolling, "bagi-kuhn-conjugate").law];
}

/* One step from the history T0 on; R1 = 0: a wall, where 2 has Vt and w2. */
static answer one_step(single p, double T0, double dt) {
    static tr_tile t;
    double par[TR_LAW_PAR] = {0}, g1 = p.R1 > 0 ? p.R1 / (p.R1 + p.R2) : 1, T = T0;
    tr_scene_law chosen = {0};
    set_parameter(&chosen, &law()->table, "mu_r", MU_R), set_parameter(&chosen, &law()->table, "k_r", K_R);
    memcpy(par, chosen.par, sizeof par);
    memset(&t, 0, sizeof t);
    t.n = 1, t.dt = dt, t.R1 = &p.R1, t.R2 = &p.R2, t.g1 = &g1;
    t.dvx[0] = p.Vt * p.ny, t.dvy[0] = -p.Vt * p.nx, t.w1[0] = p.w1, t.w2[0] = p.w2;
    if (p.R1 > 0) {
        t.dx[0] = p.L * p.nx, t.dy[0] = p.L * p.ny;
        tr_kinematics_pair(&t, NULL);
    } else {
        t.nx[0] = p.nx, t.ny[0] = p.ny, t.dx[0] = p.L;
        tr_kinematics_wall(&t, NULL);
    }
    t.f_n[0] = p.f_n;
    tr_law_data data = {.par = par, .hist = (double *[]){&T}};
    law()->step(&t, &data);
    tr_resultant_rolling_force(&t, NULL);
    for (int v = 0; v < tr_n_rolling_velocities; v++)
        if (!strcmp(tr_rolling_velocities[v].name, "bagi-kuhn")) tr_rolling_velocities[v].step(&t, NULL);
    return (answer){t.fx[0] - p.f_n * p.nx, t.fy[0] - p.f_n * p.ny, t.q1[0], t.q2[0], T, t.v_r[0], t.dvx[0], t.dvy[0]};
}

static single random_pair(tr_random *r) {
    double angle = 2 * M_PI * tr_random_uniform(r), R1 = pow(10, tr_random_uniform(r)),
           R2 = pow(10, tr_random_uniform(r));
    return (single){.R1 = R1,
                    .R2 = R2,
                    .nx = cos(angle),
                    .ny = sin(angle),
                    .L = R1 + R2 - 0.2 * tr_random_uniform(r),
                    .Vt = tr_random_uniform(r) - 0.5,
                    .w1 = tr_random_uniform(r) - 0.5,
                    .w2 = tr_random_uniform(r) - 0.5,
                    .f_n = 1e5 * tr_random_uniform(r)};
}

static void test_forces_and_power(void **state) {
    (void)state;
    tr_random r = tr_random_seed(4, 1);
    int capped = 0;
    for (int k = 0; k < 10000; k++) {
        single p = random_pair(&r);
        answer a = one_step(p, 1e3 * (tr_random_uniform(&r) - 0.5), 0.02);
        double along = a.T * (p.R2 - p.R1) / (2 * p.L), scale = fabs(a.T) * 10;
        /* t = (ny, -nx) */
        assert_close(a.fx, along * p.ny, 0, 1e-14 * scale + 1e-10);
        assert_close(a.fy, -along * p.nx, 0, 1e-14 * scale + 1e-10); /* f_n n is taken off: 1e5 rounded */
        assert_close(a.q1, -p.R1 * a.T / 2, 0, 1e-14 * scale);
        assert_close(a.q2, p.R2 * a.T / 2, 0, 1e-14 * scale);
        double power = a.fx * a.dvx + a.fy * a.dvy + a.q1 * p.w1 + a.q2 * p.w2;
        assert_close(power, -a.T * a.V_r, 0, 1e-13 * scale + 1e-10);
        assert_true(fabs(a.T) <= MU_R * p.f_n);
        capped += fabs(a.T) == MU_R * p.f_n;
    }
    assert_true(capped > 1000 && capped < 9000);
}

/* The wall: the limit of a large disk 1, and in itself the same power. */
static void test_wall_is_the_limit(void **state) {
    (void)state;
    tr_random r = tr_random_seed(5, 1);
    for (int k = 0; k < 1000; k++) {
        single p = random_pair(&r), big = p;
        p.f_n = big.f_n = 1e9;
        p.R1 = 0, p.w1 = 0, p.L = 0.95 * p.R2;
        big.R1 = 1e7, big.w1 = 0, big.L = big.R1 + big.R2 - 0.05 * big.R2;
        answer a = one_step(p, 0, 0.02), b = one_step(big, 0, 0.02);
        double scale = fabs(a.T) + K_R * 0.02 * 0.5; /* R2/R1 is 1e-6 at most */
        assert_close(b.T, a.T, 0, 2e-6 * scale);
        assert_close(a.V_r, (p.Vt - p.R2 * p.w2) / 2, 1e-14, 1e-15);
        assert_close(a.q2, p.R2 * a.T / 2, 1e-13, 1e-12);
        assert_close(a.q2, b.q2, 0, 4e-6 * scale * p.R2);
        double along = -a.T / 2, power = along * p.Vt + a.q2 * p.w2;
        assert_close(a.fx, along * p.ny, 0, 1e-6);
        assert_close(a.fy, -along * p.nx, 0, 1e-6);
        assert_close(power, -a.T * a.V_r, 0, 1e-12 * scale);
    }
}

/* +du, +dth1, -du, -dth1 below the cap: a pair of moments alone makes k_r R_eff (R2 - R1)/(2L) du dth1. */
static void test_closed_cycle(void **state) {
    (void)state;
    const double du = 1e-3, dth = 2e-3;
    for (int sense = -1; sense <= 1; sense += 2) {
        single p = {.R1 = 1, .R2 = 3, .nx = 0.6, .ny = 0.8, .L = 3.95, .f_n = 1e9};
        double T = 0, work = 0, pure = 0, R_eff = 0.75, before[4] = {0};
        for (int k = 0; k < 400; k++) {
            p.Vt = sense * du / 100 * ((k / 100 == 0) - (k / 100 == 2)),
            p.w1 = dth / 100 * ((k / 100 == 1) - (k / 100 == 3));
            answer a = one_step(p, T, 1);
            double now[4] = {a.fx, a.fy, a.q1, a.q2}, v[4] = {a.dvx, a.dvy, p.w1, p.w2};
            for (int i = 0; i < 4; i++) work += 0.5 * (before[i] + now[i]) * v[i], before[i] = now[i];
            pure += 0.5 * -R_eff * (T + a.T) * p.w1;
            T = a.T;
        }
        double made = sense * K_R * R_eff * (3 - 1) / (2 * 3.95) * du * dth, scale = K_R * dth * dth;
        assert_close(pure, made, 0, 1e-12 * scale);
        assert_close(work, 0, 0, 1e-9 * scale); /* f_n = 1e9 is taken off the force */
        assert_close(T, 0, 0, 1e-12 * K_R * dth);
    }
}

/* ---- in a world */

static void set_conjugate(tr_world *w, double mu, double k_r, unsigned sinks) {
    tr_scene_contact c = contact_of((test_laws){.k_n = 1e6, .damping_ratio = 0.1, .mu = mu, .k_t = 0.5e6});
    c.rolling = law_named(tr_laws_rolling, tr_laws_catalog()->n_rolling, "bagi-kuhn-conjugate");
    set_parameter(&c.rolling, &law()->table, "mu_r", MU_R), set_parameter(&c.rolling, &law()->table, "k_r", k_r);
    tr_status st = {0};
    if (!tr_world_set_laws(w, &c, false, sinks, &st)) fail_msg("%s", st.text);
}

enum { SIDE = 5, N = SIDE * SIDE };

/* Disks of two sizes that fly together and turn; on a floor they fall. */
static void new_cluster(tr_world *w, bool floor, double mu) {
    tr_random r = tr_random_seed(3, 1);
    new_world(w, N);
    for (int i = 0; i < N; i++) {
        double x = 0.018 * (i % SIDE - 2), y = 0.018 * (i / SIDE - 2);
        tr_world_set_disk(w, i, x + 0.001 * tr_random_uniform(&r), y + 0.05 + 0.001 * tr_random_uniform(&r), 0,
                          i % 2 ? 0.01 : 0.006, 1000, false);
        set_velocity(w, i, -10 * x - 5 * y, -10 * y + 5 * x, 40 * (tr_random_uniform(&r) - 0.3));
    }
    if (floor) {
        w->wall[0] = (tr_wall){.nx = -0.6, .ny = 0.8}, w->n_walls = 1;
        w->wall[0].y = -0.02;
    }
    set_conjugate(w, mu, 0.5e6, TR_SINK_LEDGER);
    w->dt = 0.3 * tr_timestep_worst(w);
}

static void test_momentum(void **state) {
    (void)state;
    tr_world w;
    double m[2][3] = {{0}}, scale[2] = {0};
    new_cluster(&w, false, 0.5);
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < N; i++) {
            const double *x = w.disks.pos + 4 * i, *v = w.disks.vel + 4 * i, mass = w.disks.mass[i];
            m[k][0] += mass * v[0], m[k][1] += mass * v[1];
            m[k][2] += mass * (0.5 * x[3] * x[3] * v[2] + x[0] * v[1] - x[1] * v[0]);
            scale[0] += mass * hypot(v[0], v[1]), scale[1] += mass * hypot(v[0], v[1]) * 0.1;
        }
        if (k == 0) steps(&w, 3000);
    }
    assert_true(w.contact_updates > 2000);
    for (int i = 0; i < 3; i++) assert_close(m[1][i], m[0][i], 0, 3000 * 1e-15 * scale[i == 2]);
    tr_world_free(&w);
}

/* Work = change + dissipation + residual, dissipation never falling, residual falling with the step. */
static void test_ledger(void **state) {
    (void)state;
    for (int floor = 0; floor < 2; floor++) {
        double h[3], residual[3];
        for (int k = 0; k < 3; k++) {
            tr_world w;
            new_cluster(&w, floor, 0.5);
            w.dt /= 1 << (2 * k);
            int n = 1500 << (2 * k);
            double before = 0;
            forces(&w), tr_ledger_begin(&w);
            double start = w.ledger->start;
            for (int i = 0; i < n; i++) {
                tr_step_advance(&w), forces(&w), tr_ledger_walls(&w);
                if (i % 16) continue;
                double now = tr_ledger_read(&w).rolling;
                assert_true(now >= before - 1e-12 * start);
                before = now;
            }
            tr_energy e = tr_ledger_read(&w);
            assert_true(e.rolling > 0.001 * start);
            h[k] = w.dt, residual[k] = e.residual / start;
            tr_world_free(&w);
        }
        print_message("%s: residual/energy %.1e, %.1e, %.1e, order %.2f\n", floor ? "on a wall" : "free", residual[0],
                      residual[1], residual[2], observed_order(3, h, residual));
        assert_close(residual[2], 0, 0, 1e-3);
        assert_true(observed_order(3, h, residual) > 0.8);
    }
}

/* A pair and a disk on a wall, swinging along t and in their spins: stable below the bound, unstable just above. */
static bool grows(double R1, double k_t, double share) {
    tr_world w;
    double R2 = 0.01;
    new_world(&w, R1 > 0 ? 2 : 1);
    int last = R1 > 0;
    if (R1 > 0) tr_world_set_disk(&w, 0, 0, 0, 0, R1, 1000, false);
    tr_world_set_disk(&w, last, 0, R1 + R2 - 1e-5, 0, R2, 1000, false);
    if (R1 == 0) w.wall[0] = (tr_wall){.ny = 1}, w.n_walls = 1;
    tr_scene_contact c = contact_of((test_laws){.k_n = 1e3, .mu = k_t > 0 ? 100 : 0, .k_t = k_t});
    c.rolling = law_named(tr_laws_rolling, tr_laws_catalog()->n_rolling, "bagi-kuhn-conjugate");
    set_parameter(&c.rolling, &law()->table, "mu_r", 100), set_parameter(&c.rolling, &law()->table, "k_r", 1e7);
    tr_status st = {0};
    if (!tr_world_set_laws(&w, &c, false, 0, &st)) fail_msg("%s", st.text);
    w.dt = 1, w.allow_unstable = true;
    forces(&w);
    w.fresh = true;
    double bound = tr_timestep_contacts(&w).dt;
    w.dt = share * bound;
    set_velocity(&w, last, 1e-9, 0, -3e-7);
    double largest = 0;
    for (int k = 0; k < 400; k++)
        steps(&w, 1), largest = fmax(largest, fabs(w.disks.vel[4 * last]) + R2 * fabs(w.disks.vel[4 * last + 2]));
    tr_world_free(&w);
    return largest > 1e-7;
}

static void test_stability_bound(void **state) {
    (void)state;
    static const double radii[] = {0, 0.01, 0.02, 0.1};
    for (int k = 0; k < 4; k++) {
        for (double k_t = 0; k_t <= 1e7; k_t += 1e7) {
            assert_false(grows(radii[k], k_t, 0.99));
            assert_true(grows(radii[k], k_t, radii[k] > 0 ? 1.05 : 1.02)); /* pairs: L is taken at its least */
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_forces_and_power), cmocka_unit_test(test_wall_is_the_limit),
        cmocka_unit_test(test_closed_cycle),     cmocka_unit_test(test_momentum),
        cmocka_unit_test(test_ledger),           cmocka_unit_test(test_stability_bound),
    };
    return cmocka_run_group_tests_name("conjugate", tests, NULL, NULL);
}
