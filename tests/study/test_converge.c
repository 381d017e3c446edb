/* SPDX-License-Identifier: MIT */
/* What a ladder of settings says of an error, on sequences whose limit is known: the order that they were made with,
 * an error that holds, and no answer where there is none. Of samples: intervals that cover as often as they say, by
 * 2000 trials. */
#include "assert_close.h"
#include "base/random.h"
#include "base/student.h"
#include "core/bodies.h"
#include "laws/law.h"
#include "study/converge_ladder.h"
#include "verify/integrate.h"

#include <string.h>

enum { TRIALS = 2000 };

static double normal(tr_random *r) { /* Box and Muller */
    double u = 1 - tr_random_uniform(r);
    return sqrt(-2 * log(u)) * cos(2 * M_PI * tr_random_uniform(r));
}

/* 2 + h^p + 0.3 h^(p+1), h = 1/4, 1/8, ...; the second level is that of the case. The next term moves p by less than
 * 0.3 h. */
static void order_and_limit_of_a_smooth_error_are_found(void **state) {
    (void)state;
    for (int p = 1; p <= 4; p++) {
        double v[7], h = 0.25;
        for (int k = 0; k < 7; k++, h /= 2) v[k] = 2 + pow(h, p) + 0.3 * pow(h, p + 1);
        tr_ladder l = tr_ladder_of(v, 7, 1, 2, 2);
        assert_int_equal(l.verdict, TR_VERDICT_ORDER);
        assert_close(l.order, p, 0, 0.05);
        assert_true(fabs(l.limit - 2) <= l.unsure);
        assert_true(l.half >= fabs(v[1] - 2));
        assert_close(l.half, fabs(v[1] - 2), 0.05, 0);
    }
}

/* Four levels have only two orders. */
static void fewer_than_three_orders_are_no_order(void **state) {
    (void)state;
    const double v[] = {2.4, 2.2, 2.1, 2.05};
    tr_ladder l = tr_ladder_of(v, 4, 1, 2, 2);
    assert_int_equal(l.verdict, TR_VERDICT_OPEN);
    assert_true(isnan(l.half) && isnan(l.order) && isnan(l.limit));
    assert_close(l.seen, 0.15, 1e-12, 0);
}

/* Orders 1, 2, 1: three that do not agree. */
static void orders_that_differ_are_no_order(void **state) {
    (void)state;
    const double v[] = {8, 4, 2, 1.5, 1.25};
    tr_ladder l = tr_ladder_of(v, 5, 1, 2, 1);
    assert_int_not_equal(l.verdict, TR_VERDICT_ORDER);
    assert_true(isnan(l.order));
}

/* A drift that does not end, a jump, a logarithm: no number for any of them, of however many levels. */
static void what_does_not_converge_has_no_error(void **state) {
    (void)state;
    double drift[10], jump[10], slow[10];
    for (int k = 0; k < 10; k++) drift[k] = k, jump[k] = k < 3 ? 1 : 3, slow[k] = log(k + 1);
    const double *all[] = {drift, jump, slow};
    for (int i = 0; i < 3; i++)
        for (int n = 5; n <= 10; n++) {
            tr_ladder l = tr_ladder_of(all[i], n, 1, 2, 1);
            assert_int_equal(l.verdict, TR_VERDICT_OPEN);
            assert_true(isnan(l.half));
        }
}

static void what_does_not_change_is_exact(void **state) {
    (void)state;
    const double same[] = {3, 3, 3, 3}, rounded[] = {3, 3 + 1e-13, 3 - 2e-13, 3};
    tr_ladder l = tr_ladder_of(same, 4, 1, 2, 3);
    assert_int_equal(l.verdict, TR_VERDICT_EXACT);
    assert_close(l.half, 0, 0, 0);
    l = tr_ladder_of(rounded, 4, 1, 2, 3);
    assert_int_equal(l.verdict, TR_VERDICT_EXACT);
    assert_true(l.half > 0 && l.half < 1e-11);
}

/* A level that failed has no value: what lies behind it does not count, and without a finer level there is no
 * answer. */
static void levels_behind_a_failure_do_not_count(void **state) {
    (void)state;
    const double v[] = {NAN, 2.2, 2.1, NAN, 7, 8}, alone[] = {2.4, 2.2, NAN};
    tr_ladder l = tr_ladder_of(v, 6, 1, 2, 2);
    assert_int_equal(l.verdict, TR_VERDICT_OPEN);
    assert_close(l.seen, 0.1, 1e-12, 0);
    assert_int_equal(tr_ladder_of(alone, 3, 1, 2, 2).verdict, TR_VERDICT_NONE);
}

/* h^p times a random number from -1 to 1: kinks between two steps. Where a ladder gives an error it must be none too
 * small, in 95 % of the trials; and it gives an order, which is none, in few. */
static void error_of_scattered_values_holds(void **state) {
    (void)state;
    tr_random r = tr_random_seed(20261129, 7);
    for (double p = 0.5; p <= 2; p *= 2) {
        for (int n = 5; n <= 10; n++) {
            int held = 0, given = 0, orders = 0;
            for (int trial = 0; trial < TRIALS; trial++) {
                double v[10], h = 0.1;
                for (int k = 0; k < n; k++, h /= 2) v[k] = 1 + pow(h, p) * (2 * tr_random_uniform(&r) - 1);
                tr_ladder l = tr_ladder_of(v, n, 1, 2, 1);
                if (isnan(l.half)) continue;
                given++, held += fabs(v[1] - 1) <= l.half && fabs(l.limit - 1) <= l.unsure;
                orders += l.verdict == TR_VERDICT_ORDER;
            }
            assert_true(held >= 0.95 * given);
            assert_true(orders < 0.01 * TRIALS);
            assert_true(p < 1 || given > 0.7 * TRIALS);
        }
    }
}

static const char oblique[] =
    "kind: bodies\ntime_end: 3 ms\n"
    "contact: {k_n: 1 MPa, damping_ratio: 0, friction: coulomb-spring, mu: 100, k_t: 0.2*k_n, rolling: none}\n"
    "disks:\n"
    "  - {radius: 10 mm, density: 1000, x: 0, y: 0, vx: 10 um/s, vy: -3 um/s}\n"
    "  - {radius: 10 mm, density: 1000, x: 20.000002 mm, y: 0, vx: -10 um/s, vy: 3 um/s}\n";

static double spin_after(const char *gap, double safety) {
    char set[2][64];
    const char *const sets[] = {set[0], set[1]};
    tr_status st = {0};
    tr_scene scene;
    tr_bodies b;
    snprintf(set[0], sizeof set[0], "disks.1.x=%s mm", gap);
    snprintf(set[1], sizeof set[1], "step.safety=%.17g", safety);
    assert_true(
        tr_scene_read(&scene, &(tr_scene_source){"case", oblique, strlen(oblique), sets, 2}, tr_laws_catalog(), &st));
    assert_true(tr_bodies_init(&b, &scene, &st));
    assert_true(tr_integrate(&b.world, TR_LEAPFROG, b.steps, &st));
    double spin = b.world.disks.vel[2];
    tr_bodies_free(&b);
    tr_scene_free(&scene);
    return spin;
}

/* Two disks that stick rebound with Vs cos(pi sqrt(3 k_t/k_n)), I = m R^2/2: R w = 2/3 (Vs0 - Vs)/2 of each. Where
 * the contact begins is different in each of 60 cases, and with it the error of the step. The reported error must
 * hold the true one. */
static void error_of_oblique_impacts_holds(void **state) {
    (void)state;
    enum { CASES = 60, LEVELS = 9 };
    double exact = 2. / 3 * (1 - cos(M_PI * sqrt(0.6))) * 3e-6 / 0.01;
    int held = 0, given = 0;
    for (int i = 0; i < CASES; i++) {
        char gap[32];
        double v[LEVELS];
        snprintf(gap, sizeof gap, "%.7f", 20.000002 + 1e-7 * i);
        for (int k = 0; k < LEVELS; k++) v[k] = spin_after(gap, 0.2 * pow(2, -k));
        tr_ladder l = tr_ladder_of(v, LEVELS, 1, 2, exact);
        if (isnan(l.half)) continue;
        given++, held += fabs(v[1] - exact) <= l.half && fabs(l.limit - exact) <= l.unsure;
    }
    assert_true(given >= 0.9 * CASES);
    assert_true(held >= 0.95 * given);
}

/* ---- samples ---- */

static void assert_covers(int covered) { /* 95 % intervals */
    assert_in_range(covered, 0.93 * TRIALS, 0.97 * TRIALS);
}

static void intervals_of_samples_cover_in_95_percent(void **state) {
    (void)state;
    for (int seeds = 4; seeds <= 16; seeds *= 2) {
        tr_random r = tr_random_seed(20261129, (uint64_t)seeds);
        int mean = 0, one = 0;
        for (int trial = 0; trial < TRIALS; trial++) {
            double x[16];
            for (int s = 0; s < seeds; s++) x[s] = 0.7 + 0.02 * normal(&r);
            tr_sample_error e = tr_sample_error_of(x, seeds);
            mean += fabs(e.mean - 0.7) <= e.half;
            one += fabs(x[0] - 0.7) <= e.one_half;
        }
        assert_covers(mean), assert_covers(one);
    }
}

/* Samples that differ by 1, a setting that moves all by 0.01 and each by a noise of 0.005. */
static void paired_differences_are_resolved_below_the_noise_of_samples(void **state) {
    (void)state;
    enum { SEEDS = 8 };
    tr_random r = tr_random_seed(20261129, 1);
    int covered = 0, unpaired = 0;
    for (int trial = 0; trial < TRIALS; trial++) {
        double v[2 * SEEDS];
        for (int s = 0; s < SEEDS; s++) {
            v[s] = normal(&r);
            v[SEEDS + s] = v[s] + 0.01 + 0.005 * normal(&r);
        }
        tr_ladder l = tr_ladder_of_samples(v, 2, SEEDS, SEEDS, 0, 2, true);
        covered += fabs(l.seen - 0.01) <= l.seen_half;
        unpaired += tr_ladder_of_samples(v, 2, SEEDS, SEEDS, 0, 2, false).verdict == TR_VERDICT_OPEN;
    }
    assert_covers(covered);
    assert_int_equal(unpaired, 0);
}

/* Nothing changes but by noise: 5 % of the trials see a change all the same, and then there is no number. Else the
 * bound holds 0. */
static void noise_is_called_noise(void **state) {
    (void)state;
    enum { SEEDS = 8 };
    tr_random r = tr_random_seed(20261129, 2);
    int noise = 0;
    for (int trial = 0; trial < TRIALS; trial++) {
        double v[2 * SEEDS];
        for (int i = 0; i < 2 * SEEDS; i++) v[i] = 0.7 + 0.01 * normal(&r);
        tr_ladder l = tr_ladder_of_samples(v, 2, SEEDS, SEEDS, 0, 2, true);
        noise += l.verdict == TR_VERDICT_NOISE;
        assert_true(l.verdict == TR_VERDICT_NOISE ? l.half > 0 : l.verdict == TR_VERDICT_OPEN && isnan(l.half));
    }
    assert_covers(noise);
}

/* 0.7 + 0.1 h with a noise of a hundredth of the smallest difference: the order is seen, and the error holds. */
static void order_of_samples_is_seen_above_the_noise(void **state) {
    (void)state;
    enum { SEEDS = 8, LEVELS = 5 };
    tr_random r = tr_random_seed(20261129, 3);
    int held = 0;
    for (int trial = 0; trial < TRIALS; trial++) {
        double v[LEVELS * SEEDS], sample[SEEDS], mean = 0;
        for (int s = 0; s < SEEDS; s++) sample[s] = normal(&r), mean += sample[s] / SEEDS;
        for (int k = 0; k < LEVELS; k++)
            for (int s = 0; s < SEEDS; s++) v[k * SEEDS + s] = sample[s] + 0.1 * pow(2, -k) + 5e-5 * normal(&r);
        tr_ladder l = tr_ladder_of_samples(v, LEVELS, SEEDS, SEEDS, 1, 2, true);
        assert_int_equal(l.verdict, TR_VERDICT_ORDER);
        assert_close(l.order, 1, 0, 0.1);
        held += l.half >= 0.05 && fabs(l.limit - mean) <= l.unsure;
    }
    assert_true(held >= 0.95 * TRIALS);
}

/* One of eight has collapsed. It is told, and stays in the mean. Normal samples: 1 % of the trials, by Student's t;
 * 2 % are four deviations of that count more. */
static void an_outlier_is_told_and_kept(void **state) {
    (void)state;
    double x[] = {0.70, 0.71, 0.69, 0.72, 0.30, 0.70, 0.71, 0.69};
    tr_sample_error e = tr_sample_error_of(x, 8);
    assert_int_equal(e.outlier, 4);
    assert_true(e.off > 6);
    assert_close(e.mean, 5.22 / 8, 1e-12, 0);
    tr_random r = tr_random_seed(20261129, 4);
    int told = 0;
    for (int trial = 0; trial < TRIALS; trial++) {
        for (int s = 0; s < 8; s++) x[s] = normal(&r);
        told += tr_sample_error_of(x, 8).outlier >= 0;
    }
    assert_true(told <= 0.02 * TRIALS);
}

/* t s/sqrt(n) <= half of n seeds, and not of one fewer. */
static void seeds_for_a_half_width_are_the_fewest(void **state) {
    (void)state;
    for (double half = 0.004; half < 0.04; half *= 1.7) {
        int n = tr_sample_seeds_for(0.02, half);
        assert_true(tr_student_95(n - 1) * 0.02 / sqrt(n) <= half);
        assert_true(n == 2 || tr_student_95(n - 2) * 0.02 / sqrt(n - 1) > half);
    }
}

/* Student's test of two samples of so many seeds sees the difference in 80 % of the trials, by simulation: sqrt(0.8
 * 0.2/2000) is 0.9 %, and one seed more or less of 7 is 4 %. */
static void power_is_80_percent(void **state) {
    (void)state;
    tr_random r = tr_random_seed(20261129, 6);
    for (double difference = 0.8; difference < 2; difference *= 1.5) {
        int n = tr_sample_seeds_to_see(1, difference), seen = 0;
        for (int trial = 0; trial < TRIALS; trial++) {
            double x[64], y[64];
            for (int i = 0; i < n; i++) x[i] = normal(&r), y[i] = difference + normal(&r);
            tr_mean p = tr_mean_of(x, n), q = tr_mean_of(y, n);
            seen += fabs(q.mean - p.mean) > tr_student_95(2 * n - 2) * hypot(p.error, q.error);
        }
        assert_close((double)seen / TRIALS, 0.8, 0, 0.05);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(order_and_limit_of_a_smooth_error_are_found),
        cmocka_unit_test(fewer_than_three_orders_are_no_order),
        cmocka_unit_test(orders_that_differ_are_no_order),
        cmocka_unit_test(what_does_not_converge_has_no_error),
        cmocka_unit_test(what_does_not_change_is_exact),
        cmocka_unit_test(levels_behind_a_failure_do_not_count),
        cmocka_unit_test(error_of_scattered_values_holds),
        cmocka_unit_test(error_of_oblique_impacts_holds),
        cmocka_unit_test(intervals_of_samples_cover_in_95_percent),
        cmocka_unit_test(paired_differences_are_resolved_below_the_noise_of_samples),
        cmocka_unit_test(noise_is_called_noise),
        cmocka_unit_test(order_of_samples_is_seen_above_the_noise),
        cmocka_unit_test(an_outlier_is_told_and_kept),
        cmocka_unit_test(seeds_for_a_half_width_are_the_fewest),
        cmocka_unit_test(power_is_80_percent),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
