/* SPDX-License-Identifier: MIT */
/* The biaxial test in a periodic cell. References: the energy balance and the order at which its residual falls, the
 * stress that is asked for, geometry, what is refused. */
#include "core/cell.h"
#include "core/convergence.h"
#include "core/ledger.h"
#include "core/worlds.h"

static tr_scene periodic_scene(int disks, uint64_t seed, test_laws laws) {
    tr_scene scene = biaxial_scene(disks, seed, laws);
    scene.boundary = TR_PERIODIC;
    return scene;
}

/* Of a shear at dt = safety * bound; the same packing for each. Residual over work. */
static double residual(uint64_t seed, test_laws laws, double safety, tr_hold hold) {
    tr_scene scene = periodic_scene(100, seed, laws);
    tr_biaxial b;
    scene.shear.hold = hold;
    compact(&b, &scene);
    b.dt = safety * b.dt_bound;
    begin_shear(&b);
    shear_steps(&b, (int)b.shear_steps), shear_forces(&b);
    tr_energy e = tr_ledger_read(&b.world);
    assert_true(e.work > 0 && e.damped > 0 && (e.friction > 0 || laws.mu == 0));
    tr_biaxial_free(&b);
    return e.residual / e.work;
}

/* As asked of the walls, see test_ledger.c. */
static void test_energy_balance(void **state) {
    (void)state;
    assert_close(residual(1, sand, 0.5, TR_HOLD_LATERAL), 0, 0, 1e-3);
    assert_close(residual(2, sand, 0.5, TR_HOLD_MEAN), 0, 0, 1e-3);
    test_laws smooth = sand;
    smooth.mu = smooth.mu_r = 0;
    static const double safety[] = {0.4, 0.2, 0.1};
    double mean[3] = {0};
    for (int i = 0; i < 3; i++) {
        for (uint64_t seed = 1; seed <= 2; seed++)
            mean[i] += fabs(residual(seed, smooth, safety[i], TR_HOLD_LATERAL)) / 2;
        assert_close(mean[i], 0, 0, 1e-3);
    }
    double order = observed_order(3, safety, mean);
    print_message("residual/work without friction %.1e, %.1e, %.1e: order %.2f\n", mean[0], mean[1], mean[2], order);
    assert_true(order > 1.5); /* second, less what contacts lose that open and close between steps */
}

/* Compaction ends at the asked pressure on both axes; the shear strains at the asked rate and holds the stress. */
static void holds(tr_hold hold, uint64_t seed) {
    tr_scene scene = periodic_scene(100, seed, sand);
    tr_biaxial b;
    scene.shear.hold = hold, scene.shear.strain_end = 0.1;
    compact(&b, &scene);
    const double *side = b.world.cell.side, height0 = side[1];
    double area = 0, mass = 0, held = 0, square = 0;
    forces(&b.world);
    for (int axis = 0; axis < 2; axis++)
        assert_close(tr_cell_force(&b.world.cell, axis) / side[1 - axis], 160e3, 1.1e-3, 0); /* 1e-3, a step ago */
    for (int i = 0; i < 100; i++) {
        double R = b.world.disks.pos[4 * i + 3];
        area += M_PI * R * R, mass += 27 * M_PI * R * R;
    }
    begin_shear(&b);
    int rows = 0;
    double before = 0;
    for (int64_t k = 0;; k++) {
        shear_forces(&b);
        if (k > 0 && k % 100 == 0) {
            tr_biaxial_state s = tr_biaxial_read(&b);
            if (before > 2e-3) /* a constant speed after the start; k sums */
                assert_close(s.strain - before, 1e-3 * sqrt(160e3 / mass) * 100 * b.world.dt, 1e-9, 1e-14);
            before = s.strain;
            assert_close(s.strain, 1 - side[1] / height0, 1e-12, 1e-12);
            assert_close(s.void_ratio, side[0] * side[1] / area - 1, 1e-12, 0);
            double stress = hold == TR_HOLD_MEAN ? 0.5 * (s.stress_1 + s.stress_2) : s.stress_2;
            if (s.strain > 0.01) held += stress, square += (stress / 160e3 - 1) * (stress / 160e3 - 1), rows++;
        }
        if (k == b.shear_steps) break;
        tr_step_advance(&b.world);
    }
    held /= rows, square = sqrt(square / rows);
    print_message("%s stress %.5g Pa, scatter of rows %.3f\n", hold == TR_HOLD_MEAN ? "mean" : "lateral", held, square);
    assert_close(held, 160e3, 0.01, 0); /* as of walls */
    assert_true(square < 0.02);         /* of rows below 0.05, three standard deviations with room */
    tr_biaxial_free(&b);
}

static void test_servo_holds_its_stress(void **state) {
    (void)state;
    for (uint64_t seed = 1; seed <= 2; seed++) holds(TR_HOLD_LATERAL, seed), holds(TR_HOLD_MEAN, seed);
}

static void assert_refused(const tr_scene *scene, const char *why) {
    tr_biaxial b;
    tr_status st = {0};
    assert_false(tr_biaxial_init(&b, scene, &st));
    assert_int_equal(st.code, TR_BAD_CASE);
    if (!strstr(st.text, why)) fail_msg("%s", st.text);
}

static void test_what_cannot_be_is_refused(void **state) {
    (void)state;
    tr_scene scene = periodic_scene(8, 1, sand);
    assert_refused(&scene, "error: the periodic cell would be too thin");
    scene = periodic_scene(30, 1, sand), scene.shear.strain_end = 0.5;
    assert_refused(&scene, "error: the periodic cell would be too thin");
    scene = periodic_scene(100, 1, sand), scene.compaction.pressure = 0.2 * 160e6; /* overlap = 2 R p/k = 0.4 R */
    assert_refused(&scene, "error: compaction.pressure = 3.2e+07 is out of reach");
    scene = periodic_scene(100, 1, sand), scene.shear.lateral_pressure = 0.2 * 160e6;
    assert_refused(&scene, "error: shear.lateral_pressure = 3.2e+07 is out of reach");
}

/* Loose disks, thrown into the whole cell, edges included, overlap none of their images. */
static void test_throw(void **state) {
    (void)state;
    for (uint64_t seed = 1; seed <= 20; seed++) {
        tr_scene scene = periodic_scene(60, seed, sand);
        tr_biaxial b;
        tr_status st = {0};
        int near_edge = 0;
        assert_true(tr_biaxial_init(&b, &scene, &st));
        const double *pos = b.world.disks.pos, *side = b.world.cell.side;
        for (int i = 0; i < 60; i++) {
            for (int k = 0; k < 2; k++) near_edge += fabs(pos[4 * i + k] / side[k] - 0.5) > 0.5 - 1e-3 / side[k];
            for (int j = 0; j < 9 * i; j++) {
                const double *p = pos + 4 * i, *q = pos + 4 * (j / 9);
                double dx = q[0] - p[0] + (j % 3 - 1) * side[0], dy = q[1] - p[1] + (j / 3 % 3 - 1) * side[1];
                assert_true(hypot(dx, dy) >= (p[3] + q[3]) * (1 - 1e-12));
            }
        }
        assert_true(near_edge > 0); /* nearer than the mean radius */
        tr_biaxial_free(&b);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_energy_balance),
        cmocka_unit_test(test_servo_holds_its_stress),
        cmocka_unit_test(test_what_cannot_be_is_refused),
        cmocka_unit_test(test_throw),
    };
    return cmocka_run_group_tests_name("periodic", tests, NULL, NULL);
}
