/* SPDX-License-Identifier: MIT */
/* kuhn-creep against the closed form of its equation, steady rolling, and order of convergence on a path of all loads;
 * vu-quoc-zhang against its own closed form. */
#include "base/random.h"
#include "bed_rig.h"
#include "core/convergence.h"

static rig r;

/* mu P, F0 and a of the contact as it is now, by the printed formulas. C11 of nu = 0.15 lies between 3.40 at 0 and 4.12
 * at
 * 0.25. */
typedef struct rolling {
    double most, F0, a;
} rolling;

static const double C11 = 3.40 + 0.72 * 0.6;

static rolling now(void) {
    double P = r.tile.f_elastic[0], R = rig_R_star(&r), mu = ((tr_bed_par *)(void *)r.par)->mu;
    if (r.data.shape == TR_SHAPE_SPHERE) {
        double a = cbrt(3 * P * R / (4 * E_STAR));
        return (rolling){mu * P, 4 * mu * a / ((1 - NU) * C11 * R), a};
    }
    double a = sqrt(4 * P * R / (M_PI * E_STAR));
    return (rolling){mu * P, mu * a / R, a};
}

/* Slides and rolls in n steps at constant overlap; Q at the end over mu P. */
static double go(double slide, double roll, int n) {
    for (int i = 0; i < n; i++) rig_roll(&r, r.tile.delta[0], slide / n, roll / n);
    return r.tile.f_t[0] / now().most;
}

/* ---- constant P and creepage xi from rest. With q = 1 - y^p, al = xi/F0 - 1 the equation is
 * (1 - y) + al ln((y + al)/(1 + al)) = tau if the virgin curve is q = 1 - (1 - x)^(p/(p-1)), x = u/(mu kappa delta):
 * spheres, p = 3, tau = 4 (u_roll/a)/((2 - nu) C11); disks on a linear spring, where it is dq = k dx/(mu P), p = 2,
 * tau = k F0 u_roll/(2 mu P). */

static double transient(double al, double tau, double power) {
    double low = al < 0 ? -al : 0, high = 1; /* of y; the left side falls with y */
    for (int i = 0; i < 200; i++) {
        double y = 0.5 * (low + high);
        if (1 - y + al * log((y + al) / (1 + al)) < tau)
            high = y;
        else
            low = y;
    }
    return 1 - pow(high, power);
}

/* wall: a disk on a wall with a linear spring; else spheres of unequal radii. */
static void set_up(bool wall, double delta) {
    rig_init(&r, "kuhn-creep", wall ? "linear" : "hertz-sphere", wall ? 0 : 0.02, 0.01);
    rig_slide(&r, delta, 0);
}

static void test_transient(void **state) {
    (void)state;
    static const double creepages[] = {0.2, 0.7, 1.5, 4}, taus[] = {0.05, 0.3, 0.8};
    for (int c = 0; c < 4 * 3 * 2; c++) {
        bool wall = c % 2;
        double xi = creepages[c / 6], tau = taus[c / 2 % 3], sense = c % 4 ? 1 : -1, h[3], error[3], want = 0;
        for (int m = 0; m < 3; m++) {
            int n = 2000 << m;
            set_up(wall, DELTA * (1 + c));
            rolling is = now();
            double roll = wall ? 2 * tau * is.most / (K_N * is.F0) : tau * (2 - NU) * C11 * is.a / 4;
            want = sense * transient(xi - 1, tau, wall ? 2 : 3);
            h[m] = 1.0 / n, error[m] = fabs(go(sense * xi * is.F0 * roll, (c % 3 ? -1 : 1) * roll, n) - want);
        }
        assert_true(error[2] < 1e-9); /* asked */
        if (fabs(want) == 1) continue;
        double order = observed_order(3, h, error);
        print_message("xi/F0 %.1f, q %.6f: errors %.1e %.1e %.1e, order %.2f\n", xi, want, error[0], error[1], error[2],
                      order);
        if (error[2] > 1e-12) assert_close(order, 2, 0, 0.1); /* rounding in 8000 steps: 1e-13 */
    }
}

/* Steady rolling: xi = F(q), the fixed point of a step of any size. Kuhn's Fig. 5: equal spheres, a = 1 % of R, mu =
 * 0.5, nu = 0.15. */
static void test_steady(void **state) {
    (void)state;
    static const double inverse[] = {30, 100, 1000}, q[] = {1, 0.9936, 0.2249};
    for (int k = 0; k < 3; k++)
        for (int coarse = 0; coarse < 2; coarse++) {
            rig_init(&r, "kuhn-creep", "hertz-sphere", 0.01, 0.01);
            rig_set(r.law, r.par, "mu", 0.5);
            rig_slide(&r, 2e-6, 0);
            rolling is = now();
            assert_close(is.a, 1e-4, 1e-12, 0);
            double roll = 200 * is.a, y = fmax(0, 1 - 1 / (inverse[k] * is.F0)),
                   got = go(roll / inverse[k], roll, coarse ? 60 : 2000);
            assert_close(got, q[k], 0, 5e-5); /* as many digits as given */
            assert_close(got, 1 - y * y * y, 0, 1e-12);
        }
    static const double ratios[] = {0.05, 0.5, 0.95, 1.01};
    for (int k = 0; k < 4; k++) { /* Carter's, at a wall */
        rig_init(&r, "kuhn-creep", "hertz-line", 0, 0.01);
        rig_slide(&r, DELTA, 0);
        double y = fmax(0, 1 - ratios[k]), roll = 200 * now().a;
        assert_close(go(-ratios[k] * now().F0 * roll, roll, 1000), -(1 - y * y), 0, 1e-12);
    }
}

/* ---- everything changes: the same equation in small explicit steps, creep by the printed formulas and
 * cattaneo-mindlin for C^-1; Euler's method at two steps, extrapolated */

static double creep(double Q, double roll) {
    rolling is = now();
    double F = is.F0 * (1 - pow(1 - fabs(Q) / is.most, r.data.shape == TR_SHAPE_SPHERE ? 1.0 / 3 : 0.5));
    return copysign(F, Q) * fabs(roll);
}

typedef struct leg {
    double delta, slide, roll; /* overlap at the end over DELTA; sliding over full slip; rolling over a */
} leg;

/* The overlap grows alone, so that all breakpoints fit. */
static const leg path[] = {{0.8, 0, 0},   {0.8, 0.5, 1},  {1, 0, 0},   {1, 0.1, -1},
                           {0.6, 1, 0.5}, {0.5, -0.9, 2}, {0.9, 0, 0}, {0.6, 0.2, 4}};
enum { LEGS = sizeof path / sizeof *path, FULL_SLIP = 4 };

static const char *const curved[] = {"hertz-line", "hertz-sphere"};

static void along(const char *law, int k, int n, double *q) {
    rig_init(&r, law, curved[k], 0.02, 0.01);
    rig_slide(&r, 0.5 * DELTA, 0);
    double from = 0.5, Q = 0, unit = MU * rig_kappa(&r) * DELTA, a = k ? 2e-4 : 1e-4;
    for (int l = 0; l < LEGS; l++) {
        for (int i = 1; i <= n; i++) {
            double delta = DELTA * (from + (path[l].delta - from) * i / n), slide = path[l].slide * unit / n,
                   roll = path[l].roll * a / n;
            if (strcmp(law, "kuhn-creep"))
                Q = rig_slide(&r, delta, slide - creep(Q, roll));
            else
                Q = rig_roll(&r, delta, slide, roll);
        }
        from = path[l].delta, q[l] = Q / now().most;
    }
}

static void test_order(void **state) {
    (void)state;
    for (int k = 0; k < 2; k++) {
        double want[LEGS], finer[LEGS], got[LEGS], h[3], partial[3], full[3];
        along("cattaneo-mindlin", k, 4000, want), along("cattaneo-mindlin", k, 8000, finer);
        for (int m = 0; m < 3; m++) {
            int n = 40 << m;
            along("kuhn-creep", k, n, got);
            h[m] = 1.0 / n, partial[m] = full[m] = 0;
            for (int l = 0; l < LEGS; l++) {
                double *error = l < FULL_SLIP ? &partial[m] : &full[m];
                *error = fmax(*error, fabs(got[l] - (2 * finer[l] - want[l])));
            }
        }
        assert_close(finer[FULL_SLIP], 1, 1e-15, 0);
        assert_int_equal(rig_merged(&r), 0);
        double before = observed_order(3, h, partial), after = observed_order(3, h, full);
        print_message("%s: errors %.1e %.1e %.1e, order %.2f; after full slip %.1e %.1e %.1e, order %.2f\n", curved[k],
                      partial[0], partial[1], partial[2], before, full[0], full[1], full[2], after);
        assert_close(before, 2, 0, 0.1);
        assert_close(after, k ? 4.0 / 3 : 1.5, 0, 0.1); /* F falls from F(1) like that root of the time */
    }
}

/* ---- any step */

/* Rolling alone never turns Q over, whatever the step and though P changes (k % 5 = 3, 4). It wears Q off at constant
 * P; a falling P may raise it, by taking away sliders that were pushed back. Without work the store does not grow, but
 * where breakpoints did not fit. In the end nothing is left. */
static void test_rolling_alone(void **state) {
    (void)state;
    tr_random random = tr_random_seed(9, 1);
    for (int k = 0; k < 300; k++) {
        rig_init(&r, "kuhn-creep", curved[k % 2], k % 3 ? 0.02 : 0, 0.01);
        double side = k % 4 < 2 ? 1 : -1, full = MU * rig_kappa(&r) * DELTA;
        rig_slide(&r, DELTA, 0), rig_slide(&r, DELTA, side * 1.2 * full * tr_random_uniform(&random));
        double size = pow(10, 10 * tr_random_uniform(&random) - 4), delta = DELTA, unit = now().most;
        for (int i = 0; i < 100; i++) {
            double before = side * r.tile.f_t[0], store = rig_energy(&r), share = tr_random_uniform(&random);
            int merged = rig_merged(&r);
            if (k % 5 == 3) delta = DELTA * (0.2 + share);
            if (k % 5 == 4) delta *= 0.9 + 0.1 * share;
            double Q = side * rig_roll(&r, delta, 0, (i % 2 ? 1 : -1) * size * now().a);
            bool fits = rig_merged(&r) == merged;
            /* dropped points, 1e-12 each */
            assert_true(Q >= -1e-11 * unit && (k % 5 > 2 || Q <= before + 1e-11 * unit));
            assert_true(rig_energy(&r) <= store + (fits ? 1e-11 : 1e-5) * unit * full);
        }
        if (size > 10) assert_true(fabs(r.tile.f_t[0]) < 1e-3 * now().most);
    }
}

/* No rolling: cattaneo-mindlin, bit for bit, history and all. */
static void test_without_rolling(void **state) {
    (void)state;
    static rig base;
    for (int law = 0; law < 2; law++)
        for (int k = 0; k < 2; k++) {
            tr_random random = tr_random_seed(2, 1);
            rig_init(&r, law ? "vu-quoc-zhang" : "kuhn-creep", curved[k], 0.02, 0.01);
            rig_init(&base, "cattaneo-mindlin", curved[k], 0.02, 0.01);
            for (int i = 0; i < 3000; i++) {
                double delta = DELTA * (tr_random_uniform(&random) - 0.05),
                       u = 3e-6 * (tr_random_uniform(&random) - 0.5);
                assert_true(rig_slide(&r, delta, u) == rig_slide(&base, delta, u));
                assert_memory_equal(r.hist, base.hist, sizeof r.hist);
            }
        }
}

/* Any steps: finite, inside the cap, unchanged by a look (rig_roll). */
static void test_any_input(void **state) {
    (void)state;
    tr_random random = tr_random_seed(3, 1);
    int partial = 0;
    for (int law = 0; law < 2; law++)
        for (int k = 0; k < 2; k++) {
            rig_init(&r, law ? "vu-quoc-zhang" : "kuhn-creep", curved[k], 0.02, 0.01);
            for (int i = 0; i < 10000; i++) {
                double x = tr_random_uniform(&random), u = tr_random_uniform(&random) - 0.5;
                double delta = x < 0.1 ? -1 : x < 0.2 ? pow(10, -300 * tr_random_uniform(&random)) * DELTA : DELTA * x;
                double Q = rig_roll(&r, delta, u * pow(10, -5 - 15 * tr_random_uniform(&random)),
                                    pow(10, 300 * tr_random_uniform(&random) - 250));
                assert_true(delta > 0 || (Q == 0 && rig_points(&r) == 0));
                partial += Q != 0 && fabs(Q) < 0.99 * MU * r.tile.f_elastic[0];
            }
            rig_set(r.law, r.par, "mu", 0);
            assert_true(rig_roll(&r, DELTA, 1e-6, 1e-3) == 0);
        }
    assert_true(partial > 1000);
}

/* kuhn and wang differ where bodies of unequal size slide: material rolls with (s1 + s2)/2 or (R2 s1 + R1 s2)/(R1 +
 * R2). */
static void test_creep_roll(void **state) {
    (void)state;
    double got[3];
    for (int choice = 0; choice < 3; choice++) { /* the third: kuhn, at Wang's mean */
        rig_init(&r, "kuhn-creep", "hertz-sphere", 0.02, 0.01);
        rig_slide(&r, DELTA, 0), rig_slide(&r, DELTA, 1e-6);
        rig_set(r.law, r.par, "creep_roll", choice == 1);
        r.tile.s1[0] = 3e-5, r.tile.s2[0] = 1.5e-5, r.tile.v_s[0] = 0;
        if (choice == 2) r.tile.s1[0] = r.tile.s2[0] = (0.01 * 3e-5 + 0.02 * 1.5e-5) / 0.03;
        r.law->step(&r.tile, &r.data);
        got[choice] = r.tile.f_t[0];
    }
    assert_close(got[1], got[2], 1e-14, 0);
    assert_true(got[0] < 0.999 * got[1]);
}

/* ---- vu-quoc-zhang: at constant P, u = (pi/2) xi a (1 - exp(-(2/pi) u_roll/a)), and Q is Mindlin's of u */

static void test_vu_quoc_zhang(void **state) {
    (void)state;
    static const double distances[] = {0.1, 1, 5, 1000};
    for (int k = 0; k < 4; k++)
        for (int n = 1; n <= 100; n *= 10) {
            rig_init(&r, "vu-quoc-zhang", "hertz-sphere", 0.02, 0.01);
            rig_slide(&r, DELTA, 0);
            double a = now().a, roll = distances[k] * a, full = MU * rig_kappa(&r) * DELTA, xi = 0.3 * full / a;
            double u = M_PI / 2 * xi * a * -expm1(-2 / M_PI * distances[k]), y = 1 - u / full;
            assert_close(go(-xi * roll, roll, n), -(1 - y * sqrt(y)), 1e-12, 0);
            /* Rolling alone then brings u back to 0, and Q by Masing's rule to f(u) - 2 f(u/2) on the other side. */
            double half = 1 - 0.5 * u / full;
            assert_close(go(0, 1000 * a, n), -(1 - y * sqrt(y)) + 2 * (1 - half * sqrt(half)), 0, 1e-11);
        }
}

/* u is the strain of the oldest slider, wherever the others are: after oblique loading rolling alone takes it back by u
 * (1 - exp(-(2/pi) u_roll/a)), as cattaneo-mindlin slides back by as much. */
static void test_fading_after_oblique_loading(void **state) {
    (void)state;
    for (int k = 0; k < 2; k++) {
        double full = MU * DELTA, q[2];
        for (int law = 0; law < 2; law++) {
            rig_init(&r, law ? "vu-quoc-zhang" : "cattaneo-mindlin", curved[k], 0.02, 0.01);
            for (int i = 1; i <= 10; i++) rig_slide(&r, DELTA * i / 10, 0.05 * full);
            rig_slide(&r, DELTA, 0.2 * full);
            for (int i = 0; i < 4 && law; i++) rig_roll(&r, DELTA, 0, 0.2 * now().a);
            if (!law) rig_slide(&r, DELTA, 0.7 * full * expm1(-2 / M_PI * 0.8));
            q[law] = r.tile.f_t[0] / now().most;
        }
        assert_close(q[1], q[0], 0, 1e-11); /* 14 steps of dropped points, 1e-12 */
        assert_true(q[0] > 0.05);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_transient),
        cmocka_unit_test(test_steady),
        cmocka_unit_test(test_order),
        cmocka_unit_test(test_rolling_alone),
        cmocka_unit_test(test_without_rolling),
        cmocka_unit_test(test_any_input),
        cmocka_unit_test(test_creep_roll),
        cmocka_unit_test(test_vu_quoc_zhang),
        cmocka_unit_test(test_fading_after_oblique_loading),
    };
    return cmocka_run_group_tests_name("kuhn_creep", tests, NULL, NULL);
}
