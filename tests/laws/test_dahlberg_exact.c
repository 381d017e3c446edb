/* SPDX-License-Identifier: MIT */
/* dahlberg-alfredsson, step: exact, at constant P (test_dahlberg_load.c: where P changes), against the differential
 * equation in q integrated here (Dormand and Prince's pair of orders 5 and 4, ends of partial slip and passages through
 * q = 0 located), against closed forms, and against itself in more steps. Backward Euler against it: the error it is
 * there to show. */
#include "assert_close.h"
#include "base/random.h"
#include "core/convergence.h"
#include "laws/dahlberg_bench.h"
#include "laws/dahlberg_exact.h"
#include <stdbool.h>

static const double ROUNDING = 4e-16; /* of a few operations on numbers of size 1 */

/* ---- the differential equation: dq/dt = v - sgn(q) F(|q|) r, in units of the cap */

typedef struct rates {
    double v, r, F0; /* k_t Vs/M, k_t |v_roll|/M */
} rates;

static double slope(const rates *e, double q) {
    double size = fmin(fabs(q), 1); /* stages of a step that leaves the cap may lie above */
    return e->v - sign(q) * e->F0 * (1 - sqrt(1 - size)) * e->r;
}

static double dormand_prince(const rates *e, double q, double h, double *error) {
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
    double k[7], at = q;
    *error = 0;
    for (int i = 0; i < 7; i++) {
        at = q;
        for (int j = 0; j < i; j++) at += h * a[i][j] * k[j];
        k[i] = slope(e, at);
        *error += h * difference[i] * k[i];
    }
    *error = fabs(*error);
    return at;
}

/* q after the time; tolerance: of one step. */
static double integrate(const rates *e, double q, double time, double tolerance) {
    double h = time, error;
    while (time > 0 && slope(e, q) != 0 && !(fabs(q) == 1 && q * slope(e, q) >= 0)) {
        h = fmin(h, time);
        double next = dormand_prince(e, q, h, &error), low = 0, high = h;
        double grow = 0.9 * pow(tolerance / fmax(error, 1e-30), 0.2);
        if (error > tolerance) {
            h *= fmax(grow, 0.2);
            continue;
        }
        double edge = q * next < 0 ? 0 : sign(next);
        if (q * next < 0 || fabs(next) > 1) { /* the step ends there */
            for (int n = 0; n < 60; n++) {
                double middle = 0.5 * (low + high), there = dormand_prince(e, q, middle, &error);
                *((q < edge) == (there < edge) ? &low : &high) = middle;
            }
            time -= high, q = edge;
        } else {
            time -= h, q = next;
        }
        h *= fmin(grow, 5);
    }
    return q;
}

/* ---- a path: legs of constant sliding velocity v, rolling velocity r and load P, all over the same time */

typedef struct leg {
    double v, r, P;
} leg;

static const leg path[] = {
    {1, 8, 5e5},     {1, -20, 5e5}, {-0.6, 15, 5e5}, {0, 0, 5e5},       {0, 40, 5e5},   {2.5, 0, 9e5},
    {-0.2, 10, 4e5}, {0, 0, 4e5},   {-1.5, 3, 9e5},  {0, -25, 7e5},     {0.2, 60, 7e5}, {4, -3, 7e5},
    {0.5, 30, 3e5},  {-3, 30, 3e5}, {-3, 0, 8e5},    {0.3, -90, 2.5e5},
};
enum { LEGS = sizeof path / sizeof *path };
static const double LEG_TIME = 4e-4;

static double R_star(bool wall) {
    return wall ? 0.01 : 0.02 * 0.01 / 0.03;
}

static double F0_at(double P, double R) {
    return MU * sqrt(4 * P * R / (M_PI * E_STAR)) / R;
}

/* Q/(mu P) after each leg. Q stays where P changes, but for the new cap. */
static void by_integration(bool wall, double tolerance, double *q) {
    double Q_now = 0;
    for (int l = 0; l < LEGS; l++) {
        double P = path[l].P, M = MU * P;
        rates e = {K_T * path[l].v / M, K_T * fabs(path[l].r) / M, F0_at(P, R_star(wall))};
        q[l] = integrate(&e, fmin(fmax(Q_now / M, -1), 1), LEG_TIME, tolerance);
        Q_now = M * q[l];
    }
}

static bool is_exact; /* backward Euler cuts after its step only */
static void choose(bool exact) {
    set("step", is_exact = exact);
}

/* P changes at rest: then Q is cut where it is above the cap. */
static void press(double P) {
    tile.dt = 0;
    for (int i = 0; i < TR_TILE; i++) tile.f_n[i] = P, tile.v_s[i] = tile.s1[i] = tile.s2[i] = 0;
    run();
}

/* One step of the law. Lane 17 is read; the rims move at r -+ 0.4, on average r. */
static double one_step(double P, double v, double r, double dt) {
    if (is_exact && P_before[17] != P) press(P);
    tile.dt = dt;
    for (int i = 0; i < TR_TILE; i++) tile.f_n[i] = P, tile.v_s[i] = v, tile.s1[i] = r - 0.4, tile.s2[i] = r + 0.4;
    run();
    assert_true(tile.f_t[17] == Q[17]);
    return tile.f_t[17] / (MU * P);
}

static void by_law(bool wall, bool exact, int n, double *q) {
    set_up(wall ? 0 : 0.02, 0.01);
    choose(exact);
    for (int l = 0; l < LEGS; l++)
        for (int s = 0; s < n; s++) q[l] = one_step(path[l].P, path[l].v, path[l].r, LEG_TIME / n);
}

static double distance(const double *q, const double *p) {
    double most = 0;
    for (int l = 0; l < LEGS; l++) most = fmax(most, fabs(q[l] - p[l]));
    return most;
}

static void test_path(void **state) {
    (void)state;
    static const int cuts[] = {1, 3, 10, 100, 1000};
    for (int wall = 0; wall < 2; wall++) {
        double want[LEGS], coarse[LEGS], one[LEGS], q[LEGS], off = 0, spread = 0;
        /* steps of half the size have 1/32 of the error */
        by_integration(wall, 3.2e-14, coarse), by_integration(wall, 1e-15, want);
        assert_true(distance(coarse, want) < 1e-11);
        by_law(wall, true, 1, one);
        for (int c = 0; c < 5; c++) {
            by_law(wall, true, cuts[c], q);
            off = fmax(off, distance(q, want)), spread = fmax(spread, distance(q, one));
        }
        print_message("exact%s: %.1e from the integration, which moves by %.1e as its steps halve; %.1e between 1 and "
                      "1000 steps a leg\n",
                      wall ? " at a wall" : "", off, distance(coarse, want), spread);
        assert_true(off < 1e-9);
        assert_true(spread < 1e-12); /* 1000 steps, each of a rounding */
        int partial = 0, full = 0, negative = 0;
        for (int l = 0; l < LEGS; l++)
            partial += fabs(want[l]) < 0.99, full += fabs(want[l]) == 1, negative += want[l] < 0;
        assert_true(partial > 5 && full > 2 && negative > 2 && negative < LEGS - 2);
    }
}

/* Backward Euler on the same path. The legs where P falls are in it: Q above the present cap, and slid back. */
static void test_backward_euler(void **state) {
    (void)state;
    double want[LEGS], q[LEGS], h[5], error[5];
    by_law(false, true, 1, want);
    print_message("backward Euler: step, as a share of a leg, and largest error of Q/(mu P)\n");
    for (int m = 0; m < 5; m++) {
        h[m] = 0.01 / (1 << (2 * m));
        by_law(false, false, 100 << (2 * m), q);
        error[m] = distance(q, want);
        print_message("  %.2e  %.2e\n", h[m], error[m]);
    }
    double order = observed_order(5, h, error);
    assert_true(error[4] < 1e-3 && order > 0.9 && order < 1.1);
    for (int n = 1; n < 10; n++) { /* however long the steps */
        by_law(false, false, n, q);
        for (int l = 0; l < LEGS; l++) assert_true(fabs(q[l]) <= 1);
    }
}

/* ---- closed forms */

/* Creepage xi < F0 comes to rest at Carter's q = 1 - (1 - xi/F0)^2, from below and from above, in one step of any great
 * length; there it stays however short the steps. Above F0 full slip. */
static void test_carter(void **state) {
    (void)state;
    static const double ratios[] = {0.05, 0.3, 0.9, 0.999, 1.2};
    double P = 4e5, M = MU * P, F0 = F0_at(P, R_star(false));
    for (int k = 0; k < 5; k++)
        for (int side = -1; side <= 1; side += 2)
            for (double start = -1; start <= 1; start += 0.25) {
                set_up(0.02, 0.01);
                choose(true);
                double x = ratios[k], want = side * (x < 1 ? 1 - (1 - x) * (1 - x) : 1);
                Q[17] = start * M;
                double v = side * x * F0 * 2;
                assert_close(one_step(P, v, side * start < 0 ? -2 : 2, 1e3), want, 1e-14, 0);
                for (int s = 0; s < 500; s++) assert_close(one_step(P, v, 2, 1e-9), want, 1e-13, 0);
            }
}

/* alpha = 0 is z = z0 - tau, to full slip at tau = z0; alpha near 0 is near it, no digit lost. */
static void test_creepage_of_full_slip(void **state) {
    (void)state;
    for (double q = 0; q < 1; q += 0.09)
        for (double tau = 1e-12; tau < 10; tau *= 3) {
            double z = fmax(sqrt(1 - q) - tau, 0);
            for (double near = -1e-14; near < 2e-14; near += 1e-14)
                assert_close(tr_dahlberg_exact(q, 1, 2 * tau * (1 + near), 2 * tau), 1 - z * z, 0, 1e-13);
        }
}

/* Full slip at tau = z0 + alpha ln(alpha/(z0 + alpha)), tau = k_t F0 |du_roll|/(2 mu P). */
static void test_time_to_full_slip(void **state) {
    (void)state;
    for (double alpha = 0.01; alpha < 20; alpha *= 1.7)
        for (double q = 0; q < 1; q += 0.19) {
            double z = sqrt(1 - q), tau = z + alpha * log(alpha / (z + alpha));
            double P = 4e5, M = MU * P, F0 = F0_at(P, R_star(false)), L = 2 * M * tau / (K_T * F0),
                   v = (1 + alpha) * F0;
            set_up(0.02, 0.01);
            choose(true);
            Q[17] = q * M;
            assert_true(one_step(P, v, 1, L * (1 + 1e-9)) == 1);
            for (double before = 1e-4; before > 1e-13; before *= 1e-4) {
                Q[17] = q * M;
                /* There dq/dtau = 2 (z + alpha) and z^2 = 2 alpha times what is left of tau. 1e-14: a rounding of
                 * tau. */
                double left = before * tau, rtol = 2 * sqrt(2 * left / alpha);
                assert_close(1 - one_step(P, v, 1, L * (1 - before)), 2 * alpha * left, rtol, 1e-14 * (1 + alpha));
            }
        }
}

/* The implicit solution, and that of sliding against q, by long double logarithms: steps where these keep their
 * digits. */
static void test_implicit_solution(void **state) {
    (void)state;
    tr_random random = tr_random_seed(8, 1);
    int with = 0, against = 0, through = 0;
    for (int n = 0; n < 20000; n++) {
        double q0 = tr_random_uniform(&random), B = pow(10, 3 * tr_random_uniform(&random) - 2);
        double A = B * 4 * (tr_random_uniform(&random) - 0.5), q = tr_dahlberg_exact(q0, 1, A, B);
        long double z0 = sqrtl(1 - q0), tau = B / 2, alpha = fabsl((long double)A) / B - 1, beta = alpha + 2;
        if (A < 0) {
            long double to_0 = -(1 - z0) - beta * logl((beta - 1) / (beta - z0));
            if (q > 0) {
                long double z = sqrtl(1 - q), off = -(z - z0) - beta * logl((beta - z) / (beta - z0)) - tau;
                /* dtau/dz = z/(beta - z), dq = -2 z dz */
                assert_close((double)(2 * (beta - z) * off), 0, 0, 2 * ROUNDING);
                assert_true(tau < to_0 * (1 + 1e-12L));
                against++;
                continue;
            }
            tau -= to_0, z0 = 1, q = -q, through++;
        }
        long double z = sqrtl(1 - q), off = z0 - z + alpha * logl((z + alpha) / (z0 + alpha)) - tau;
        if (fabsl(z + alpha) < 1e-12L) continue; /* at rest */
        if (q < 1) {
            assert_close((double)(2 * (z + alpha) * off), 0, 0, 2 * ROUNDING);
        } else {
            assert_true(off < 1e-12L && alpha > -1e-12L);
        }
        with++;
    }
    assert_true(with > 5000 && against > 1000 && through > 2000);
}

/* Rolling alone: ln w - w falls by tau, w = 1 - sqrt(1 - q). It ends at 0 and never goes through. */
static void test_relaxation(void **state) {
    (void)state;
    for (double side = -1; side <= 1; side += 2)
        for (double q = 1; q > 1e-30; q *= 0.1)
            for (double B = 1e-12; B < 2e12; B *= 7) {
                double got = side * tr_dahlberg_exact(side * q, 1, 0, B), w = q / (1 + sqrt(1 - q));
                double v = got / (1 + sqrt(1 - got)), slack = 2 * ROUNDING * (1 + B); /* of ln q */
                assert_true(got >= 0 && got <= q);
                if (B > 2000) assert_true(got == 0);
                if (got > 1e-290) assert_close(log(w / v) - (w - v), B / 2, 0, slack);
            }
}

/* ---- any input */

/* Steps over 24 decades of length, of any creepage: finite, inside the cap, on the way from Q to the steady state and
 * not beyond; the same in three unequal steps; odd in Q and du_disp. */
static void test_random_steps(void **state) {
    (void)state;
    tr_random random = tr_random_seed(7, 1);
    int partial = 0, reversed = 0;
    double worst = 0;
    for (int n = 0; n < 100000; n++) {
        double u = tr_random_uniform(&random), P = pow(10, 24 * tr_random_uniform(&random) - 12);
        double B = u < 0.1 ? 0 : pow(10, 24 * tr_random_uniform(&random) - 12), sized = u < 0.1 ? 1 : B;
        double A = sized * pow(10, 12 * tr_random_uniform(&random) - 6), start = 2.4 * tr_random_uniform(&random) - 1.2;
        if (n % 3 == 0) A = sized * 2 * tr_random_uniform(&random);
        if (n % 11 == 0) A = 0;
        if (n % 13 == 0) A = B;
        if (n % 17 == 0) B = 1e-320; /* not even a whole double */
        if (n % 7 == 0) start = n % 2 ? 1 : 1 - pow(10, -16 * tr_random_uniform(&random));
        if (n % 5 < 2) A = -A;
        double after = tr_dahlberg_exact(start * P, P, A * P, B * P), q = after / P;
        double q0 = fmin(fmax(start, -1), 1), x = B > 0 ? fmin(fabs(A) / B, 1) : 1;
        double steady = A == 0 && B == 0 ? q0 : sign(A) * x * (2 - x);
        assert_true(isfinite(after) && fabs(after) <= P);
        assert_true(q >= fmin(q0, steady) - ROUNDING && q <= fmax(q0, steady) + ROUNDING);
        assert_true(tr_dahlberg_exact(-start * P, P, -A * P, B * P) == -after);
        double s = start;
        for (int k = 0; k < 3; k++) {
            double part = k == 1 ? 0.7 : 0.15;
            s = tr_dahlberg_exact(s, 1, A * part, B * part);
        }
        worst = fmax(worst, fabs(s - q));
        partial += fabs(q) < 1 && fabs(q - q0) > 1e-6, reversed += q * q0 < 0;
    }
    print_message("one step and three: %.1e\n", worst);
    assert_true(worst < 1e-14); /* the roundings of four steps, none magnified: neighbours come nearer */
    assert_true(partial > 20000 && reversed > 10000);
}

/* Through the law: no load, no friction, and numbers of any size; a look of no time changes nothing. */
static void test_inside_the_cap_for_any_input(void **state) {
    (void)state;
    tr_random random = tr_random_seed(6, 1);
    set_up(0.02, 0.01);
    choose(true);
    for (int step = 0; step < 60; step++) {
        tile.dt = pow(10, -9 + 12 * tr_random_uniform(&random));
        for (int i = 0; i < TR_TILE; i++) {
            double u = tr_random_uniform(&random);
            tile.f_n[i] = u < 0.1 ? 0 : pow(10, -300 + 320 * u);
            tile.v_s[i] = (tr_random_uniform(&random) - 0.5) * pow(10, 30 * tr_random_uniform(&random) - 20);
            tile.s1[i] = tile.s2[i] =
                (tr_random_uniform(&random) - 0.5) * pow(10, 30 * tr_random_uniform(&random) - 20);
        }
        run();
        for (int i = 0; i < TR_TILE; i++)
            assert_true(isfinite(Q[i]) && fabs(Q[i]) <= MU * tile.f_n[i] && tile.f_t[i] == Q[i]);
        double before[TR_TILE];
        memcpy(before, Q, sizeof Q);
        tile.dt = 0;
        run();
        for (int i = 0; i < TR_TILE; i++) assert_true(Q[i] == before[i] && tile.f_t[i] == Q[i]);
    }
    set("mu", 0), tile.dt = 1e-5;
    run();
    for (int i = 0; i < TR_TILE; i++) assert_true(Q[i] == 0);
    assert_true(tr_dahlberg_exact(1, 0, 1, 1) == 0);
    for (double side = -1; side <= 1; side += 2) /* A/M is infinite */
        assert_true(tr_dahlberg_exact(5e-301, 1e-300, side * 1e20, 1e-200) == side * 1e-300);
}

/* ---- only kind: contact may choose it */

static bool reads(const char *text, tr_status *st) {
    tr_scene scene;
    bool ok = tr_scene_read(&scene, &(tr_scene_source){"a.yaml", text, strlen(text), NULL, 0}, tr_laws_catalog(), st);
    if (ok) tr_scene_free(&scene);
    return ok;
}

#define CHOICE "friction: dahlberg-alfredsson, mu: 0.3, step: "
static void test_who_may_choose_it(void **state) {
    (void)state;
    static const char biaxial[] =
        "kind: biaxial\nsample: {r_min: 1 mm, r_max: 2 mm}\n"
        "contact: {k_n: 1 MPa, E_star: 1 GPa, rolling: none, " CHOICE "%s}\ncompaction: {pressure: 1 kPa}\n";
    static const char contact[] = "kind: contact\nbodies: {R1: 10 mm, R2: 10 mm, E: 70 GPa, nu: 0.3}\n"
                                  "laws: [{" CHOICE "%s, k_t: E_star}]\npath: [{force: 1 kN/m}]\n";
    for (int exact = 0; exact < 2; exact++)
        for (int driver = 0; driver < 2; driver++) {
            char text[400];
            tr_status st = {0};
            snprintf(text, sizeof text, driver ? contact : biaxial, exact ? "exact" : "backward-euler");
            assert_true(reads(text, &st) == (driver || !exact));
            if (exact && !driver)
                assert_non_null(
                    strstr(st.text, "`step: exact` of the law dahlberg-alfredsson is for `kind: contact` only"));
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_path),
        cmocka_unit_test(test_backward_euler),
        cmocka_unit_test(test_carter),
        cmocka_unit_test(test_creepage_of_full_slip),
        cmocka_unit_test(test_time_to_full_slip),
        cmocka_unit_test(test_implicit_solution),
        cmocka_unit_test(test_relaxation),
        cmocka_unit_test(test_random_steps),
        cmocka_unit_test(test_inside_the_cap_for_any_input),
        cmocka_unit_test(test_who_may_choose_it),
    };
    return cmocka_run_group_tests_name("dahlberg_exact", tests, NULL, NULL);
}
