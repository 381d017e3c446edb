/* SPDX-License-Identifier: MIT */
/* dahlberg-alfredsson, step: exact, where P changes: against the differential equation integrated here with Q cut only
 * where it is at mu P (Dormand and Prince's pair of orders 5 and 4; ends of slip and passages through Q = 0 located),
 * by hand, against coulomb-spring, and against itself in other steps. */
#include "assert_close.h"
#include "base/random.h"
#include "core/convergence.h"
#include "laws/dahlberg_bench.h"
#include "laws/dahlberg_exact.h"
#include "laws/dahlberg_load.h"
#include <stdbool.h>

/* ---- the differential equation over a step of length 1 */

/* Q' = A - sgn(Q) C sqrt(M/most)(1 - sqrt(1 - |Q|/M)), |Q| <= M */

typedef struct equation {
    double M0, M1, A, C;
} equation;

static double cap_at(const equation *e, double t) {
    return e->M0 + t * (e->M1 - e->M0);
}

static double creep_at_slip(const equation *e, double t) {
    return e->C * sqrt(cap_at(e, t) / fmax(e->M0, e->M1));
}

static double slope(const equation *e, double t, double Q) {
    double q = fmin(fabs(Q) / cap_at(e, t), 1); /* stages of a step that leaves the cap may lie above */
    return e->A - sign(Q) * creep_at_slip(e, t) * (q / (1 + sqrt(1 - q)));
}

static double dormand_prince(const equation *e, double t, double Q, double h, double *error) {
    static const double a[7][6] = {
        {0},
        {1. / 5},
        {3. / 40, 9. / 40},
        {44. / 45, -56. / 15, 32. / 9},
        {19372. / 6561, -25360. / 2187, 64448. / 6561, -212. / 729},
        {9017. / 3168, -355. / 33, 46732. / 5247, 49. / 176, -5103. / 18656},
        {35. / 384, 0, 500. / 1113, 125. / 192, -2187. / 6784, 11. / 84},
    };
    static const double difference[7] = {71. / 57600,      0,         -71. / 16695, 71. / 1920,
                                         -17253. / 339200, 22. / 525, -1. / 40};
    static const double node[7] = {0, 1. / 5, 3. / 10, 4. / 5, 8. / 9, 1, 1};
    double k[7], at = Q;
    *error = 0;
    for (int i = 0; i < 7; i++) {
        at = Q;
        for (int j = 0; j < i; j++) at += h * a[i][j] * k[j];
        k[i] = slope(e, t + node[i] * h, at);
        *error += h * difference[i] * k[i];
    }
    *error = fabs(*error);
    return at;
}

/* Which end a step has left through: 0 none, 1 the cap, 2 Q = 0. */
static int left(const equation *e, double t, double before, double Q) {
    return fabs(Q) > cap_at(e, t) ? 1 : before * Q < 0 ? 2 : 0;
}

/* Until when full slip to the side s lasts; t: not at all. What holds it falls or rises all the way. */
static double slips_until(const equation *e, double t, double s) {
    double low = t, high = 1, change = e->M1 - e->M0;
    if (s * e->A - creep_at_slip(e, t) < change) return t;
    if (s * e->A - creep_at_slip(e, 1) >= change) return 1;
    for (int n = 0; n < 60; n++) {
        double middle = 0.5 * (low + high);
        *(s * e->A - creep_at_slip(e, middle) >= change ? &low : &high) = middle;
    }
    return low;
}

static double integrate(const equation *e, double Q, double tolerance) {
    double t = 0, h = 0.01, error;
    bool at_cap = fabs(Q) >= e->M0;
    while (t < 1) {
        if (at_cap) {
            double until = slips_until(e, t, sign(Q));
            at_cap = false;
            if (until > t) t = until, Q = sign(Q) * cap_at(e, t), h = 1e-6;
            if (t >= 1) break;
        }
        h = fmin(h, 1 - t);
        double next = dormand_prince(e, t, Q, h, &error), low = 0, high = h;
        double grow = 0.9 * pow(tolerance / fmax(error, 1e-30), 0.2);
        if (error > tolerance && h > 1e-12) {
            h *= fmax(grow, 0.2);
            continue;
        }
        int how = left(e, t + h, Q, next);
        for (int n = 0; how && n < 60; n++) { /* the step ends there */
            double middle = 0.5 * (low + high), there = dormand_prince(e, t, Q, middle, &error);
            *(left(e, t + middle, Q, there) ? &high : &low) = middle;
        }
        t += fmax(high, 1e-13); /* never stands still */
        double side = sign(next);
        if (how) next = dormand_prince(e, t - high, Q, high, &error), how = left(e, t, Q, next);
        at_cap = how == 1;
        Q = how == 1 ? side * cap_at(e, t) : how == 2 ? side * 1e-300 : next;
        h = fmin(h * fmin(grow, 5), 1);
    }
    return Q;
}

/* Steps in which P falls and grows while the contact rolls and slides: all within mu P, to full slip, out of it as P
 * grows, kept at it by a P that falls, off it against the sliding, through 0, from P = 0. */
static void test_against_integration(void **state) {
    (void)state;
    tr_random r = tr_random_seed(31, 1);
    double worst = 0, moved = 0;
    int full = 0, released = 0, partial = 0, turned = 0;
    for (int n = 0; n < 240; n++) {
        double most = n % 2 ? 1 : 0.1 + 0.9 * tr_random_uniform(&r);
        equation e = {n % 2 ? tr_random_uniform(&r) : most, 1, 0, pow(10, 3 * tr_random_uniform(&r) - 2)};
        e.M1 = n % 2 ? 1 : most * tr_random_uniform(&r);
        e.A = (n % 3 ? 1.5 * e.C : 1) * 2 * (tr_random_uniform(&r) - 0.5);
        if (n % 6 == 5) e.A = sign(e.A) * (e.C * (0.2 + 0.8 * tr_random_uniform(&r)) + e.M1 - e.M0);
        double Q = e.M0 * (2 * tr_random_uniform(&r) - 1), size = fmax(e.M0, e.M1);
        if (n % 5 < 2) Q = n % 5 ? e.M0 : -e.M0;
        double want = integrate(&e, Q, 1e-14), coarse = integrate(&e, Q, 3e-13);
        double got = tr_dahlberg_load(Q, e.M0, e.M1, e.A, e.C);
        worst = fmax(worst, fabs(got - want) / size), moved = fmax(moved, fabs(coarse - want) / size);
        bool ends = fabs(got) >= e.M1 * (1 - 1e-12), began = fabs(Q) == e.M0;
        full += ends && !began, released += began && !ends, partial += !ends && !began, turned += got * Q < 0;
    }
    print_message("%.1e from the integration, which moves by %.1e with 30 times its tolerance\n", worst, moved);
    assert_true(full > 20 && released > 20 && partial > 20 && turned > 20);
    assert_true(worst < 1e-11); /* the integration's: of its steps to 1e-14, and their ends at the edge of slip */
}

/* Q ends 0.16 % below the cap, at which coarse substeps all see it: no such end may pass for settled. */
static void test_just_short_of_full_slip(void **state) {
    (void)state;
    for (double more = -0.01; more < 0.01; more += 0.0005) {
        equation e = {0.312, 0.6257, -1.029 * (1 + more), 0.64};
        double want = integrate(&e, 0.1654, 1e-14), got = tr_dahlberg_load(0.1654, e.M0, e.M1, e.A, e.C);
        assert_close(got, want, 0, 1e-11);
        if (more < -0.002) assert_true(got > -e.M1 && got < -0.99 * e.M1);
    }
}

/* One step or many along a straight path is the same: nothing of its length is in the answer. */
static void test_any_number_of_steps(void **state) {
    (void)state;
    tr_random r = tr_random_seed(32, 1);
    double worst = 0;
    for (int n = 0; n < 200; n++) {
        double M0 = n % 10 ? tr_random_uniform(&r) : 0, M1 = n % 7 ? tr_random_uniform(&r) : 0;
        double C = pow(10, 4 * tr_random_uniform(&r) - 2), A = (n % 2 ? C : 1) * 3 * (tr_random_uniform(&r) - 0.5);
        double Q = n % 3 ? M0 * (2 * tr_random_uniform(&r) - 1) : n % 2 ? M0 : -M0, most = fmax(M0, M1);
        double one = tr_dahlberg_load(Q, M0, M1, A, C), other = tr_dahlberg_load(-Q, M0, M1, -A, C);
        assert_true(other == -one && fabs(one) <= M1);
        for (int cut = 2; cut < 12; cut += 5) {
            double s = Q;
            for (int k = 0; k < cut; k++) {
                double a = M0 + (M1 - M0) * k / cut, b = M0 + (M1 - M0) * (k + 1) / cut;
                s = tr_dahlberg_load(s, a, b, A / cut, C / cut * sqrt(fmax(a, b) / most));
            }
            worst = fmax(worst, fabs(s - one) / most);
        }
    }
    print_message("one step, two and seven: %.1e\n", worst);
    assert_true(worst < 1e-11); /* 1e-13 for each of some tens of pieces of a step */
}

/* By hand: Q = 1.5 mu P above the cap to be, slid back by 0.6 mu P, is at 0.9, not 0.4. With little rolling nearly so:
 * what creep takes is at most C. At full slip under a P that falls Q is mu P, and without sliding a Q below the cap
 * stays. */
static void test_by_hand(void **state) {
    (void)state;
    for (double s = -1; s <= 1; s += 2) {
        assert_close(tr_dahlberg_load(s * 1.5, 1.5, 1, -s * 0.6, 0), s * 0.9, 1e-15, 0);
        for (double C = 1e-20; C < 0.1; C *= 10) {
            double Q = s * tr_dahlberg_load(s * 1.5, 1.5, 1, -s * 0.6, C);
            assert_true(Q <= 0.9 + 1e-15 && Q >= 0.9 - C - 1e-15);
        }
        for (double C = 1e-6; C < 0.4; C *= 3) {
            assert_true(tr_dahlberg_load(s * 1.5, 1.5, 1, 0, C) == s); /* C < 0.5, by which the cap falls */
            assert_true(tr_dahlberg_load(s * 1.5, 1.5, 1, s * 0.3, C) == s);
        }
        assert_true(tr_dahlberg_load(s * 0.5, 1.5, 1, 0, 0) == s * 0.5);
        assert_true(tr_dahlberg_load(s, 1, 0, s, 1) == 0 && tr_dahlberg_load(0, 0, 1, s * 7, 2) == s);
        assert_true(tr_dahlberg_load(0, 0, 0, s, 1) == 0 && tr_dahlberg_load(0, 0, 1, 0, 1) == 0);
    }
    /* Of a long roll the end counts: Carter's q at the P of the end, which P near the end reaches within 1/C. */
    for (double ratio = 0.1; ratio < 0.8; ratio += 0.2)
        for (double C = 1e4; C < 1e13; C *= 1e3)
            assert_close(tr_dahlberg_load(0.1, 1.5, 1, ratio * C * sqrt(1 / 1.5), C), ratio * (2 - ratio), 0, 10 / C);
}

/* Without rolling: coulomb-spring, bit for bit, whatever P does. */
static void test_without_rolling(void **state) {
    (void)state;
    set_up(0.02, 0.01);
    set("step", 1);
    tr_random random = tr_random_seed(5, 1);
    double spring = 0;
    for (int s = 0; s < 2000; s++) {
        double v = 4 * tr_random_uniform(&random) - 2, dt = 1e-4, P = 1e5 * (1 + tr_random_uniform(&random));
        for (int i = 0; i < TR_TILE; i++) tile.f_n[i] = P, tile.v_s[i] = v, tile.s1[i] = tile.s2[i] = 0, tile.dt = dt;
        run();
        spring = fmin(fmax(spring + K_T * dt * v, -MU * P), MU * P);
        assert_true(tile.f_t[9] == spring);
    }
}

/* P that is no straight line: what is left is that of P between the steps, of second order. */
static void test_order_where_P_bends(void **state) {
    (void)state;
    enum { PARTS = 20, LEVELS = 5 };
    double end[LEVELS][PARTS], h[LEVELS - 1], error[LEVELS - 1];
    for (int m = 0; m < LEVELS; m++) {
        int n = m < LEVELS - 1 ? 2 << m : 1024;
        set_up(0.02, 0.01);
        set("step", 1);
        tile.n = 1;
        double part = 1e-4, P0 = 4e5;
        for (int s = 0; s <= PARTS * n; s++) {
            double t = (double)s / n, dt = s ? part / n : 0, leg = floor((t - 1e-9) / 5); /* five parts */
            tile.dt = dt;
            tile.f_n[0] = P0 * (1 + 0.5 * sin(0.9 * t));
            tile.v_s[0] = (fmod(leg, 2) ? -1.2 : 1) * 3, tile.s1[0] = tile.s2[0] = fmod(leg, 3) ? 10 : -30;
            run();
            if (s && s % n == 0) end[m][s / n - 1] = tile.f_t[0] / (MU * P0);
        }
    }
    for (int m = 0; m < LEVELS - 1; m++) {
        h[m] = 1.0 / (2 << m), error[m] = 0;
        for (int k = 0; k < PARTS; k++) error[m] = fmax(error[m], fabs(end[m][k] - end[LEVELS - 1][k]));
    }
    double order = observed_order(LEVELS - 1, h, error);
    print_message("P bends: errors %.1e, %.1e, %.1e, %.1e, order %.2f\n", error[0], error[1], error[2], error[3],
                  order);
    assert_true(order > 1.8 && order < 2.3 && error[3] < 1e-3);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_against_integration), cmocka_unit_test(test_just_short_of_full_slip),
        cmocka_unit_test(test_any_number_of_steps), cmocka_unit_test(test_by_hand),
        cmocka_unit_test(test_without_rolling),     cmocka_unit_test(test_order_where_P_bends),
    };
    return cmocka_run_group_tests_name("dahlberg_load", tests, NULL, NULL);
}
