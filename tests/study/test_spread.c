/* SPDX-License-Identifier: MIT */
/* The interval about one sample covers the mean as often as it says, and is only there for cases like the measured
 * ones. */
#include "assert_close.h"
#include "base/random.h"
#include "base/student.h"
#include "laws/law.h"
#include "study/spread.h"

#include <string.h>

static double normal(tr_random *r) { /* Box and Muller */
    double u = 1 - tr_random_uniform(r);
    return sqrt(-2 * log(u)) * cos(2 * M_PI * tr_random_uniform(r));
}

/* s of a few normal seeds, then one more: 20,000 times. By Student 95 % are covered; four standard deviations of the
 * binomial count are 4 sqrt(0.95 0.05/20000) = 0.0062. A normal quantile in the place of Student's covers 0.909 of 8
 * seeds. */
static void one_sample_covers_the_mean_in_95_percent(void **state) {
    (void)state;
    enum { TRIALS = 20000 };
    tr_random r = tr_random_seed(20261129, 5);
    for (int seeds = 2; seeds <= 32; seeds *= 4) {
        int covered = 0;
        for (int trial = 0; trial < TRIALS; trial++) {
            double x[32];
            for (int i = 0; i < seeds; i++) x[i] = 3 + 0.5 * normal(&r);
            double s = tr_mean_of(x, seeds).error * sqrt(seeds);
            covered += fabs(0.5 * normal(&r)) <= tr_spread_half(s, seeds);
        }
        assert_close((double)covered / TRIALS, 0.95, 0, 0.0062);
    }
}

/* t of 1 and 2 degrees of freedom in closed form: tan(0.95 pi/2), 0.95 sqrt(2/(1 - 0.95^2)). */
static void half_width_is_students(void **state) {
    (void)state;
    assert_close(tr_spread_half(0.3, 2), 0.3 * tan(0.95 * M_PI / 2), 1e-12, 0);
    assert_close(tr_spread_half(0.3, 3), 0.3 * 0.95 * sqrt(2 / (1 - 0.95 * 0.95)), 1e-12, 0);
}

static void seeds_are_the_fewest_that_do(void **state) {
    (void)state;
    for (double half = 1e-4; half < 2; half *= 1.037) {
        double aim = tr_spread_aim(half);
        int n = tr_spread_seeds(half, aim);
        assert_true(aim <= half / 2 * (1 + 1e-12) && aim >= half / 5 * (1 - 1e-12));
        assert_true(half / sqrt(n) <= aim && half / sqrt(n - 1) > aim);
    }
}

static tr_accuracy accuracy_with(const char *case_file, const char *set) {
    const char *sets[] = {set};
    tr_scene scene;
    tr_biaxial b;
    tr_status st = {0};
    if (!tr_scene_read_file(&scene, case_file, sets, set ? 1 : 0, tr_laws_catalog(), &st)) fail_msg("%s", st.text);
    if (!tr_biaxial_init(&b, &scene, &st)) fail_msg("%s", st.text);
    tr_accuracy a = tr_spread_of(&b);
    tr_biaxial_free(&b);
    tr_scene_free(&scene);
    return a;
}

static void what_is_not_like_the_measured_case_has_no_numbers(void **state) {
    (void)state;
    static const char *const out[] = {"sample.disks=99",
                                      "sample.disks=1601",
                                      "contact.mu=0.6",
                                      "contact.mu_r=0.4",
                                      "contact.mu_r=1",
                                      "contact.k_n=200 MPa",
                                      "contact.k_t=0.6*k_n",
                                      "contact.k_r=2*k_t",
                                      "contact.damping_ratio=0.2",
                                      "contact.rolling_velocity=bagi-kuhn",
                                      "contact.rolling=conjugate-spring",
                                      "contact.friction=none",
                                      "compaction.mu=0.1",
                                      "compaction.pressure=200 kPa",
                                      "compaction.inertial_number=0.02",
                                      "compaction.unbalanced=1e-3",
                                      "shear.inertial_number=8e-4",
                                      "shear.inertial_number=4e-3",
                                      "shear.strain_end=0.1",
                                      "shear.walls=rough",
                                      "boundary=periodic",
                                      "step.safety=0.2",
                                      "output.rows=100",
                                      "sample.r_max=1.8 mm",
                                      "shear.lateral_pressure=200 kPa"};
    for (size_t i = 0; i < sizeof out / sizeof *out; i++) {
        tr_accuracy a = accuracy_with("cases/biaxial.yaml", out[i]);
        if (*a.row || !*a.not_examined) fail_msg("%s has numbers", out[i]);
    }
    static const char *const out_creep[] = {"contact.creep_roll=kuhn", "contact.E_star=2.9*k_n", "contact.k_t=0.5*k_n",
                                            "contact.k_r=k_n"};
    for (size_t i = 0; i < sizeof out_creep / sizeof *out_creep; i++) {
        tr_accuracy a = accuracy_with("cases/biaxial-creep.yaml", out_creep[i]);
        if (*a.row || !*a.not_examined) fail_msg("%s has numbers", out_creep[i]);
    }
    static const char *const in_creep[] = {NULL, "contact.mu_r=0", "sample.disks=1600"};
    for (size_t i = 0; i < sizeof in_creep / sizeof *in_creep; i++) {
        tr_accuracy a = accuracy_with("cases/biaxial-creep.yaml", in_creep[i]);
        if (!*a.row) fail_msg("%s: %s", in_creep[i], a.not_examined);
    }
    static const char *const in[] = {NULL,
                                     "seed=9",
                                     "sample.disks=100",
                                     "sample.disks=1600",
                                     "contact.mu_r=0",
                                     "contact.mu_r=0.48",
                                     "contact.rolling=none",
                                     "shear.inertial_number=2e-3",
                                     "sample.density=1000",
                                     "output.frames=0",
                                     "contact.mu=0.52"};
    for (size_t i = 0; i < sizeof in / sizeof *in; i++) {
        tr_accuracy a = accuracy_with("cases/biaxial.yaml", in[i]);
        if (!*a.row) fail_msg("%s: %s", in[i], a.not_examined);
    }
}

/* Disks that all do the same add up to a variance of 1/N. The nearest rows of 300 and 480 disks are both that of 400.
 * */
static void between_the_measured_sizes_the_interval_goes_as_one_over_root_N(void **state) {
    (void)state;
    tr_accuracy few = accuracy_with("cases/biaxial.yaml", "sample.disks=300");
    tr_accuracy many = accuracy_with("cases/biaxial.yaml", "sample.disks=480");
    for (int i = 0; i < 2; i++) assert_close(few.strength[i].half / many.strength[i].half, sqrt(480.0 / 300), 1e-12, 0);
    assert_non_null(strstr(few.row, "N = 400"));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_sample_covers_the_mean_in_95_percent),
        cmocka_unit_test(half_width_is_students),
        cmocka_unit_test(seeds_are_the_fewest_that_do),
        cmocka_unit_test(what_is_not_like_the_measured_case_has_no_numbers),
        cmocka_unit_test(between_the_measured_sizes_the_interval_goes_as_one_over_root_N),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
