/* SPDX-License-Identifier: MIT */
/* A biaxial test of 100 disks. References: the criteria that the scene asks for, geometry (strain, void ratio), the
 * asked pressure, and physical ranges: a frictionless packing of disks of sizes 1:2 has a void ratio of 0.17 to 0.25
 * (random close packing 0.19 in bulk, more at walls, less with overlaps); mu = 0.5 with rolling resistance gives a sin
 * phi well above frictionless disks (0.1) and below that of a perfect crystal with cohesion (1): 0.25 to 0.8. */
#include "core/ledger.h"
#include "core/measures.h"
#include "core/worlds.h"

typedef struct outcome {
    double e0, e_end, strain_end, sin_phi_residual, sin_phi_peak, stress_2, stress_2_worst, unbalanced;
} outcome;

static outcome test_of(uint64_t seed, test_laws laws, double inertial_number) {
    tr_scene scene = biaxial_scene(100, seed, laws);
    scene.shear.strain_end = 0.15, scene.shear.inertial_number = inertial_number;
    tr_biaxial b;
    tr_biaxial_state s;
    outcome o = {0};
    compact(&b, &scene);
    tr_wall *w = b.world.wall;
    double area = 0, mass = 0;
    for (int i = 0; i < 100; i++) {
        double R = b.world.disks.pos[4 * i + 3];
        assert_true(R >= 0.76e-3 && R <= 1.52e-3);
        area += M_PI * R * R, mass += 2700 * M_PI * R * R / 100;
    }
    o.e0 = (w[TR_RIGHT_WALL].x - w[TR_LEFT_WALL].x) * (w[TR_TOP_WALL].y - w[TR_BOTTOM_WALL].y) / area - 1;
    double height0 = w[TR_TOP_WALL].y - w[TR_BOTTOM_WALL].y;

    begin_shear(&b);
    double rate = inertial_number * sqrt(160e3 / mass), residual = 0, lateral = 0;
    int rows = 0, residual_rows = 0;
    double before = 0;
    for (int64_t k = 0;; k++) {
        shear_forces(&b);
        if (k > 0 && k % 100 == 0) {
            s = tr_biaxial_read(&b);
            double height = w[TR_TOP_WALL].y - w[TR_BOTTOM_WALL].y, width = w[TR_RIGHT_WALL].x - w[TR_LEFT_WALL].x;
            /* a constant speed after the start, to the rounding of k sums */
            if (before > 2e-3) assert_close(s.strain - before, rate * 100 * b.world.dt, 1e-9, 1e-14);
            before = s.strain;
            assert_close(s.strain, 1 - height / height0, 1e-12, 1e-12);
            assert_close(s.void_ratio, height * width / area - 1, 1e-12, 0);
            assert_close(s.sin_phi, (s.stress_1 - s.stress_2) / (s.stress_1 + s.stress_2), 1e-12, 0);
            if (s.strain > 0.01) lateral += s.stress_2, rows++;
            if (s.strain > 0.10) residual += s.sin_phi, residual_rows++;
            o.sin_phi_peak = fmax(o.sin_phi_peak, s.sin_phi);
        }
        if (k == b.shear_steps) break;
        tr_step_advance(&b.world);
    }
    tr_biaxial_shape(&b, &s);
    o.strain_end = s.strain, o.e_end = s.void_ratio;
    o.stress_2 = lateral / rows, o.sin_phi_residual = residual / residual_rows;
    assert_close(o.strain_end, 0.15, 0, rate * b.world.dt);
    assert_true(o.strain_end >= 0.15 * (1 - 1e-9));
    tr_biaxial_free(&b);
    return o;
}

static void test_sand(void **state) {
    (void)state;
    double residual = 0, e0 = 0;
    for (uint64_t seed = 1; seed <= 3; seed++) {
        outcome o = test_of(seed, sand, 1e-3);
        print_message("seed %d: e0 %.4f, e %.4f, lateral %.5g Pa, sin phi peak %.3f, residual %.3f\n", (int)seed, o.e0,
                      o.e_end, o.stress_2, o.sin_phi_peak, o.sin_phi_residual);
        assert_true(o.e0 > 0.16 && o.e0 < 0.27);  /* one small sample scatters by 0.01 */
        assert_close(o.stress_2, 160e3, 0.01, 0); /* asked for */
        assert_true(o.e_end > o.e0 + 0.01);       /* a dense sample dilates (Reynolds) */
        assert_true(o.sin_phi_peak > o.sin_phi_residual);
        residual += o.sin_phi_residual / 3, e0 += o.e0 / 3;
    }
    assert_true(e0 > 0.17 && e0 < 0.25);
    assert_true(residual > 0.25 && residual < 0.8);
}

/* Without friction a packing has hardly any strength; with it several times more. */
static void test_friction_makes_strength(void **state) {
    (void)state;
    outcome smooth = test_of(1, (test_laws){160e6, 0.3, 0, 0, 0, 0, NULL, NULL}, 2e-3);
    outcome rough = test_of(1, (test_laws){160e6, 0.3, 0.5, 80e6, 0, 0, NULL, NULL}, 2e-3);
    outcome rolling = test_of(1, sand, 2e-3);
    print_message("residual sin phi: frictionless %.3f, friction %.3f, and rolling resistance %.3f\n",
                  smooth.sin_phi_residual, rough.sin_phi_residual, rolling.sin_phi_residual);
    assert_true(smooth.sin_phi_residual < 0.2);
    assert_true(rough.sin_phi_residual > smooth.sin_phi_residual + 0.08); /* two standard deviations of a seed, 0.045 */
    assert_true(rolling.sin_phi_residual > rough.sin_phi_residual);
}

/* The state that compaction hands over: at rest, at the asked pressure, in contact with four walls. */
static void test_compaction_criterion(void **state) {
    (void)state;
    tr_scene scene = biaxial_scene(100, 4, sand);
    tr_biaxial b;
    tr_status st = {0};
    double unbalanced = 1;
    bool done = false;
    assert_true(tr_biaxial_init(&b, &scene, &st));
    for (int i = 0; i < 100; i++)
        for (int j = 0; j < i; j++) { /* thrown without overlap */
            const double *p = b.world.disks.pos + 4 * i, *q = b.world.disks.pos + 4 * j;
            assert_true(hypot(p[0] - q[0], p[1] - q[1]) >= (p[3] + q[3]) * (1 - 1e-15));
        }
    while (!done) assert_true(tr_biaxial_compact(&b, 200, &unbalanced, &done, &st));
    assert_true(unbalanced < 1e-4);
    forces(&b.world);
    double net = 0;
    for (int i = 0; i < 100; i++) net += hypot(b.world.disks.force[4 * i], b.world.disks.force[4 * i + 1]) / 100;
    assert_true(net < 1e-4 * 160e3 * 2 * 1.52e-3 * 3); /* of a contact force: less than 3 pressure * diameter */
    for (int v = 0; v < 4; v++) {
        const tr_wall *w = &b.world.wall[v];
        assert_close(-(w->fx * w->nx + w->fy * w->ny) / w->length, 160e3, 1.1e-3, 0); /* asked: 1e-3, a step ago */
    }
    for (int i = 0; i < 100; i++)
        for (int v = 0; v < 4; v++) {
            const tr_wall *w = &b.world.wall[v];
            const double *p = b.world.disks.pos + 4 * i;
            assert_true((p[0] - w->x) * w->nx + (p[1] - w->y) * w->ny > 0.9 * p[3]); /* inside */
        }
    begin_shear(&b);
    for (int k = 0; k < 2; k++) /* after a frictionless compaction the shear starts with zero histories, and at rest */
        for (int i = 0; i < b.world.group[k].n; i++)
            for (int h = 0; h < b.world.group[k].n_hist; h++) assert_true(b.world.group[k].hist[h][i] == 0);
    assert_true(b.world.wall[TR_TOP_WALL].vy == 0 && b.world.wall[TR_BOTTOM_WALL].vy == 0);
    shear_steps(&b, 1);
    assert_close(b.world.wall[TR_TOP_WALL].vy, -b.world.wall[TR_BOTTOM_WALL].vy, 0, 0);
    assert_true(b.world.wall[TR_TOP_WALL].vy < 0);
    tr_biaxial_free(&b);
}

static void test_bad_step_is_refused(void **state) {
    (void)state;
    tr_scene scene = biaxial_scene(50, 1, sand);
    tr_biaxial b;
    tr_status st = {0};
    scene.step.dt = 1;
    assert_false(tr_biaxial_init(&b, &scene, &st));
    assert_int_equal(st.code, TR_BAD_CASE);
    scene.sample.r_min = scene.sample.r_max / 1000, scene.sample.disks = 2, scene.step.dt = 0;
    st = (tr_status){0};
    assert_true(tr_biaxial_init(&b, &scene, &st)); /* two disks, one a thousand times smaller: a step all the same */
    assert_true(b.dt > 0 && b.dt <= 0.5 * b.dt_bound * (1 + 1e-15));
    tr_biaxial_free(&b);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sand),
        cmocka_unit_test(test_friction_makes_strength),
        cmocka_unit_test(test_compaction_criterion),
        cmocka_unit_test(test_bad_step_is_refused),
    };
    return cmocka_run_group_tests_name("biaxial", tests, NULL, NULL);
}
