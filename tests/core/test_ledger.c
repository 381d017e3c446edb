/* SPDX-License-Identifier: MIT */
/* The energy ledger. References: the balance itself (work = change of energy + dissipation + residual, the residual
 * falling with the step); a kinetic and elastic energy summed up here from the state; dissipations that can only grow;
 * systems without friction and dashpots, which lose nothing. */
#include "core/convergence.h"
#include "core/ledger.h"
#include "core/pipeline.h"
#include "core/worlds.h"

/* A sheared sample at dt = safety * bound; the same packing for each. Residual over work. */
static double residual(uint64_t seed, test_laws laws, double safety, bool check) {
    tr_scene scene = biaxial_scene(100, seed, laws);
    tr_biaxial b;
    compact(&b, &scene);
    b.dt = safety * b.dt_bound;
    begin_shear(&b);
    tr_energy before = {0}, now = {0};
    for (int64_t k = 0;; k++) {
        shear_forces(&b);
        now = tr_ledger_read(&b.world);
        if (check) {
            /* Sums of some hundred terms of the size of the energy in contacts, each rounded. */
            double rounding = 1e-13 * (now.elastic_normal + now.work);
            assert_true(now.damped >= before.damped - rounding);
            assert_true(now.friction >= before.friction - rounding);
            assert_true(now.rolling >= before.rolling - rounding);
            before = now;
        }
        if (k == b.shear_steps) break;
        tr_step_advance(&b.world);
    }
    assert_true(now.work > 0 && now.damped > 0 && (now.friction > 0 || laws.mu == 0));
    double r = now.residual / now.work;
    tr_biaxial_free(&b);
    return r;
}

static void test_dissipation_never_falls(void **state) {
    (void)state;
    assert_close(residual(1, sand, 0.5, true), 0, 0, 1e-3);
}

static void test_residual_falls_with_the_step(void **state) {
    (void)state;
    static const double safety[] = {0.5, 0.25, 0.125};
    enum { SEEDS = 3 };
    double mean[3] = {0};
    for (int i = 0; i < 3; i++)
        for (int s = 0; s < SEEDS; s++) {
            double r = residual(1 + (uint64_t)s, sand, safety[i], false);
            assert_close(r, 0, 0, 1e-3); /* asked for at the default step */
            mean[i] += fabs(r) / SEEDS;
        }
    double order = observed_order(3, safety, mean);
    print_message("residual/work %.1e, %.1e, %.1e at safety 0.5, 0.25, 0.125: order %.2f\n", mean[0], mean[1], mean[2],
                  order);
    assert_true(order > 0.8); /* contacts open and close between steps: first order at least */
}

/* Without friction the dashpots take all the work, in collisions that start and end between steps: they must be booked
 * to second order to stay below what is asked for at the default step. */
static void test_dashpots_alone(void **state) {
    (void)state;
    test_laws smooth = sand;
    smooth.mu = smooth.mu_r = 0;
    static const double safety[] = {0.4, 0.2, 0.1};
    double mean[3];
    for (int i = 0; i < 3; i++) {
        mean[i] = fabs(residual(1, smooth, safety[i], i == 0));
        assert_close(mean[i], 0, 0, 1e-3);
    }
    double order = observed_order(3, safety, mean);
    print_message("only dashpots: residual/work %.1e, %.1e, %.1e: order %.2f\n", mean[0], mean[1], mean[2], order);
    assert_true(order > 1.5);
}

/* A jostling cluster without walls. */
static void new_cluster(tr_world *w, int n, test_laws laws) {
    tr_random r = tr_random_seed(3, 1);
    new_world(w, n);
    for (int i = 0; i < n; i++) {
        double x = 0.018 * (i % 6 - 3), y = 0.018 * (i / 6 - 3);
        tr_world_set_disk(w, i, &(tr_disk_start){x, y, 0, 0.006 + 0.004 * tr_random_uniform(&r), 1000, false});
        set_velocity(w, i, -10 * x + 0.2 * tr_random_uniform(&r), -10 * y, 40 * (tr_random_uniform(&r) - 0.3));
    }
    set_laws(w, laws, TR_SINK_LEDGER);
    w->dt = 0.2 * tr_timestep_worst(w);
}

/* Energies from the state alone: kinetic at the time of the positions, springs by their overlaps. */
static double energy_of(const tr_world *w, double k_n) {
    double e = 0;
    for (int i = 0; i < w->disks.n; i++) {
        const double *v = w->disks.vel + 4 * i, *f = w->disks.force + 4 * i, *p = w->disks.pos + 4 * i;
        double m = w->disks.mass[i], I = 0.5 * m * p[3] * p[3];
        e += 0.5 * m * (v[0] * (v[0] + w->dt * f[0] / m) + v[1] * (v[1] + w->dt * f[1] / m));
        e += 0.5 * I * v[2] * (v[2] + w->dt * f[2] / I);
        for (int j = 0; j < i; j++) {
            const double *q = w->disks.pos + 4 * j;
            double delta = p[3] + q[3] - hypot(p[0] - q[0], p[1] - q[1]);
            if (delta > 0) e += 0.5 * k_n * delta * delta;
        }
    }
    return e;
}

static void test_nothing_to_lose(void **state) {
    (void)state;
    tr_world w;
    new_cluster(&w, 36, (test_laws){.k_n = 1e6});
    forces(&w), tr_ledger_begin(&w);
    double e0 = energy_of(&w, 1e6);
    int64_t touched = 0;
    for (int k = 0; k < 5000; k++) {
        tr_step_advance(&w), forces(&w), tr_ledger_walls(&w);
        tr_energy e = tr_ledger_read(&w);
        assert_true(e.damped == 0 && e.friction == 0 && e.rolling == 0 && e.work == 0 && e.elastic_friction == 0);
        double now = energy_of(&w, 1e6);
        assert_close(e.kinetic + e.elastic_normal, now, 1e-12, 0); /* 100 terms */
        assert_close(e.residual, e0 - now, 0, 1e-12 * e0);
        assert_close(now, e0, 0.01, 0); /* leapfrog swings by (w dt)^2/8 of the energy in contacts */
        touched += e.elastic_normal > 0;
    }
    assert_true(touched > 100);
    tr_world_free(&w);
}

/* All laws, no dashpot: what friction and rolling dissipate is missing in the energies. */
static void test_balance_of_free_disks(void **state) {
    (void)state;
    double error[3], h[3];
    for (int i = 0; i < 3; i++) {
        tr_world w;
        new_cluster(&w, 36, (test_laws){1e6, 0.2, 0.5, 0.5e6, 0.3, 0.5e6, "wang", NULL});
        w.dt /= 1 << i, h[i] = w.dt;
        forces(&w), tr_ledger_begin(&w);
        tr_energy before = tr_ledger_read(&w), e = before;
        double e0 = before.kinetic + before.elastic_normal;
        for (int k = 0; k < 4000 << i; k++) {
            tr_step_advance(&w), forces(&w), tr_ledger_walls(&w);
            e = tr_ledger_read(&w);
            assert_true(e.damped >= before.damped - 1e-14 * e0);
            assert_true(e.friction >= before.friction - 1e-14 * e0);
            assert_true(e.rolling >= before.rolling - 1e-14 * e0);
            before = e;
        }
        double now = e.kinetic + e.elastic_normal + e.elastic_friction + e.elastic_rolling;
        assert_close(e0 - now - e.damped - e.friction - e.rolling, e.residual, 0, 1e-12 * e0);
        assert_true(e.damped > 0.01 * e0 && e.friction > 0.01 * e0 && e.rolling > 1e-3 * e0);
        error[i] = fabs(e.residual) / e0;
        tr_world_free(&w);
    }
    print_message("free disks: residual/start %.1e %.1e %.1e, order %.2f\n", error[0], error[1], error[2],
                  observed_order(3, h, error));
    assert_true(error[2] < 2e-3 && error[2] < error[0]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_dissipation_never_falls), cmocka_unit_test(test_residual_falls_with_the_step),
        cmocka_unit_test(test_dashpots_alone),          cmocka_unit_test(test_nothing_to_lose),
        cmocka_unit_test(test_balance_of_free_disks),
    };
    return cmocka_run_group_tests_name("ledger", tests, NULL, NULL);
}
