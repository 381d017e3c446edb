/* SPDX-License-Identifier: MIT */
/* Carter's and Cattaneo's solutions against what they solve: the tractions add up to Q, and the displacement that they
 * cause, by quadrature of the logarithmic kernel, is the rigid motion where the surfaces stick and falls behind it by
 * the slip where they slip. */
#include "assert_close.h"
#include "patch/carter.h"
#include "patch/cattaneo.h"
#include "patch/quadrature.h"

static const tr_patch_pair pair = {.R_star = 0.012, .E_star = 3e9, .d = 0.02, .mu = 0.35};
static const double P = 2e5;
static const double qs[] = {0.02, 0.3, -0.6, 0.9, -0.999};
enum { QS = sizeof qs / sizeof *qs };

typedef struct field {
    double q, roll; /* roll = 0: Cattaneo */
    double x;       /* where the displacement is asked */
    int end;        /* x is at the low (-1) or high (+1) end of the piece */
} field;

static double traction(double s, double from_low, double from_high, const void *with) {
    const field *f = with;
    (void)from_low, (void)from_high;
    return f->roll != 0 ? tr_carter_tau(&pair, P, f->q, f->roll, s) : tr_cattaneo_tau(&pair, P, f->q, s);
}

static double kernel(double s, double from_low, double from_high, const void *with) {
    const field *f = with;
    double distance = f->end < 0 ? from_low : f->end > 0 ? from_high : fabs(f->x - s);
    return traction(s, from_low, from_high, with) * log(pair.d / distance);
}

/* Ends of the stick zone, by the formulas of the problem, not by the code under test. */
static void stick(const field *f, double ends[2]) {
    double a = sqrt(4 * P * pair.R_star / (M_PI * pair.E_star)), c = sqrt(1 - fabs(f->q));
    ends[0] = f->roll == 0 ? -a * c : f->roll > 0 ? -a : a * (1 - 2 * c);
    ends[1] = f->roll == 0 ? a * c : f->roll > 0 ? a * (2 * c - 1) : a;
}

/* The integral over the contact, split at kinks and at x. */
static double over_contact(field f, bool displacement) {
    double a = sqrt(4 * P * pair.R_star / (M_PI * pair.E_star)), ends[2], cut[5] = {-a, 0, 0, f.x, a}, sum = 0;
    stick(&f, ends);
    cut[1] = ends[0], cut[2] = ends[1];
    for (int i = 0; i < 5; i++)
        for (int j = i + 1; j < 5; j++)
            if (cut[j] < cut[i]) {
                double keep = cut[i];
                cut[i] = cut[j], cut[j] = keep;
            }
    for (int i = 0; i < 4; i++) {
        f.end = cut[i] == f.x ? -1 : cut[i + 1] == f.x ? 1 : 0;
        sum += integral(displacement ? kernel : traction, &f, cut[i], cut[i + 1]);
    }
    return displacement ? 2 / (M_PI * pair.E_star) * sum : sum;
}

static double displacement(double q, double roll, double x) {
    return over_contact((field){.q = q, .roll = roll, .x = x}, true);
}

/* Tolerance of what follows: the quadrature is good to about 1e-13. */
static const double TIGHT = 1e-10;

static void test_tractions_add_up(void **state) {
    (void)state;
    for (int k = 0; k < QS; k++)
        for (int roll = -1; roll <= 1; roll++)
            assert_close(over_contact((field){.q = qs[k], .roll = roll}, false), qs[k] * pair.mu * P, TIGHT, 0);
}

static void test_cattaneo_sticks_and_slips(void **state) {
    (void)state;
    double a = tr_patch_a(&pair, P);
    for (int k = 0; k < QS; k++) {
        double c = sqrt(1 - fabs(qs[k])), u = tr_cattaneo_u(&pair, P, qs[k]), way = qs[k] > 0 ? 1 : -1;
        assert_close(tr_cattaneo_stick(&pair, P, qs[k]), a * c, 1e-14, 0);
        for (int i = -9; i <= 9; i++) {
            double x = 0.1 * a * i, behind = u - displacement(qs[k], 0, x);
            if (fabs(x) < a * c)
                assert_close(behind, 0, 0, TIGHT * fabs(u));
            else /* slip, of the sign of Q, at the full traction */
                assert_true(way * behind > 0);
            assert_close(tr_cattaneo_slip(&pair, P, qs[k], x), fabs(x) < a * c ? 0 : behind, 0, TIGHT * fabs(u));
            double full = pair.mu * tr_patch_p(&pair, P, x), tau = tr_cattaneo_tau(&pair, P, qs[k], x);
            assert_true(way * tau <= full * (1 + 1e-15));
            if (fabs(x) >= a * c) assert_close(tau, way * full, 1e-14, 0);
        }
    }
}

typedef struct slip_at {
    double q, roll;
} slip_at;
static double slip(double s, double from_low, double from_high, const void *with) {
    const slip_at *f = with;
    (void)from_low, (void)from_high;
    return tr_carter_slip(&pair, P, f->q, f->roll, s);
}

/* Steady: slip per unit roll = du/dr - u'(x). In integrals, from the entering edge: |dx| xi - way (u(x) - u(x0)). */
static void test_carter_sticks_and_slips(void **state) {
    (void)state;
    double a = tr_patch_a(&pair, P);
    for (int k = 0; k < QS; k++)
        for (int roll = -1; roll <= 1; roll += 2) {
            double q = qs[k], xi = tr_carter_creepage(&pair, P, q), ends[2], zone[2];
            stick(&(field){.q = q, .roll = roll}, ends);
            tr_carter_stick(&pair, P, q, roll, zone);
            for (int e = 0; e < 2; e++) assert_close(zone[e], ends[e], 1e-14, 1e-14 * a);
            double entry = -roll * a * (1 - 1e-6), u0 = displacement(q, roll, entry);
            double inner = roll > 0 ? ends[1] : ends[0], scale = fabs(displacement(q, roll, 0));
            for (int i = -9; i <= 9; i++) {
                double x = 0.1 * a * i, lag = xi * fabs(x - entry) - (displacement(q, roll, x) - u0), want = 0;
                if (roll * (x - inner) > 0) want = integral(slip, &(slip_at){q, roll}, fmin(x, inner), fmax(x, inner));
                assert_close(lag, want, TIGHT, TIGHT * scale);
                double full = pair.mu * tr_patch_p(&pair, P, x), tau = tr_carter_tau(&pair, P, q, roll, x);
                if (roll * (x - inner) > 0) assert_close(tau, q > 0 ? full : -full, 1e-14, 0);
                assert_true(fabs(tau) <= full * (1 + 1e-15) && tau * q > 0);
            }
        }
}

static void test_small_and_full(void **state) {
    (void)state;
    double a = tr_patch_a(&pair, P), F0 = pair.mu * a / pair.R_star, full = 2 * pair.mu * P / (M_PI * a);
    for (double q = 1e-15; q < 1; q *= 7) {
        long double c = sqrtl(1 - (long double)q), X = -0.3L, root = sqrtl(1 - X * X);
        /* long double has 64 bits: relative 1e-19/q in a difference of size q */
        double loose = 1e-14 + 2e-19 / q;
        assert_close(tr_carter_creepage(&pair, P, q), (double)(F0 * (1 - c)), loose, 0);
        assert_close(tr_carter_q(&pair, P, tr_carter_creepage(&pair, P, q)), q, 1e-14, 0);
        assert_close(tr_cattaneo_q(&pair, P, tr_cattaneo_u(&pair, P, q)), q, 1e-14, 0);
        assert_close(tr_carter_q(&pair, P, -tr_carter_creepage(&pair, P, q)), -q, 1e-14, 0);
        assert_close(tr_cattaneo_q(&pair, P, tr_cattaneo_u(&pair, P, -q)), -q, 1e-14, 0);
        if (X < 2 * c - 1)
            assert_close(tr_carter_tau(&pair, P, q, 1, (double)X * a),
                         (double)(full * (root - sqrtl(c * c - (X + 1 - c) * (X + 1 - c)))), loose, 0);
        if (fabsl(X) < c)
            assert_close(tr_cattaneo_tau(&pair, P, q, (double)X * a), (double)(full * (root - sqrtl(c * c - X * X))),
                         loose, 0);
    }
    double Lambda = log(2 * pair.d / a), u_full = 2 * pair.mu * P / (M_PI * pair.E_star) * (Lambda + 0.5);
    assert_close(tr_carter_creepage(&pair, P, 1), F0, 1e-15, 0);
    assert_close(tr_cattaneo_u(&pair, P, -1), -u_full, 1e-14, 0);
    assert_true(tr_carter_q(&pair, P, 1.5 * F0) == 1 && tr_carter_q(&pair, P, -F0) == -1);
    assert_true(tr_cattaneo_q(&pair, P, 2 * u_full) == 1 && tr_cattaneo_q(&pair, P, 0) == 0);
    assert_close(tr_cattaneo_q(&pair, P, 1e-9 * u_full),
                 1e-9 * u_full * M_PI * pair.E_star / (2 * Lambda) / (pair.mu * P), 1e-8, 0);
    assert_true(tr_carter_tau(&pair, P, 0.5, 1, 1.001 * a) == 0 && tr_cattaneo_tau(&pair, P, 0.5, -a) == 0);
}

/* The two-dimensional example that the program CONTACT publishes: mu = 0.3, a = 1 mm, R = 500 mm, Q = 0.64 mu P rolls
 * at a creepage of 0.00024. */
static void test_published_example(void **state) {
    (void)state;
    tr_patch_pair c = {.R_star = 0.5, .E_star = 1e11, .d = 1, .mu = 0.3};
    double load = M_PI * c.E_star * 1e-6 / (4 * c.R_star); /* a = 1 mm */
    assert_close(tr_carter_creepage(&c, load, 0.64), 0.00024, 1e-14, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_tractions_add_up),        cmocka_unit_test(test_cattaneo_sticks_and_slips),
        cmocka_unit_test(test_carter_sticks_and_slips), cmocka_unit_test(test_small_and_full),
        cmocka_unit_test(test_published_example),
    };
    return cmocka_run_group_tests_name("closed forms", tests, NULL, NULL);
}
