/* SPDX-License-Identifier: MIT */
/* Every step of the half-plane obeys the law of friction, on random paths of everything. The displacements are computed
 * here by quadrature of the kernel, from the tractions and the grid before and after: no influence number of the code
 * under test is used. The numerical tolerance, 1e-12 of the largest displacement or traction, is the promise of
 * half_plane.h. */
#include "assert_close.h"
#include "base/random.h"
#include "patch/half_plane.h"
#include "patch/quadrature.h"
#include <string.h>

enum { N = 30 };
static const tr_patch_pair pair = {.R_star = 0.012, .E_star = 3e9, .d = 0.02, .mu = 0.35};

static double log_kernel(double s, double from_low, double from_high, const void *with) {
    (void)s, (void)from_high;
    return log(*(const double *)with / from_low);
}

/* u at x: tau constant over N elements of [-a, a]; int ln(d/|x - s|) ds always from x outward. */
static double displacement(const double *tau, double a, double x) {
    double sum = 0, h = 2 * a / N;
    for (int j = 0; j < N; j++) {
        double low = -a + j * h - x, high = low + h; /* seen from x */
        double far = integral(log_kernel, &pair.d, 0, fabs(high)), near = integral(log_kernel, &pair.d, 0, fabs(low));
        sum += tau[j] * ((high < 0 ? -far : far) - (low < 0 ? -near : near));
    }
    return 2 / (M_PI * pair.E_star) * sum;
}

static double hertz(double s, double from_low, double from_high, const void *with) {
    double a = *(const double *)with;
    (void)from_low, (void)from_high;
    return sqrt(fmax(0, (a - s) * (a + s)));
}

typedef struct count {
    int stick, forward, backward, partial, full;
} count;

static void check_law(const tr_patch_state *s, const tr_patch_step *k, const double *tau_before, double a_before,
                      count *seen) {
    double a = sqrt(4 * k->P * pair.R_star / (M_PI * pair.E_star)), h = 2 * a / N, p0 = 2 * k->P / (M_PI * a);
    double b[N], b_max = 0, Q = 0, work = 0;
    int slipping = 0;
    assert_close(s->a, a, 1e-15, 0);
    assert_true(s->P == k->P);
    for (int i = 0; i < N; i++) {
        double x = -a + (i + 0.5) * h;
        b[i] = s->du + (a_before > 0 ? displacement(tau_before, a_before, x - k->dr) : 0);
        b_max = fmax(b_max, fabs(b[i]));
    }
    for (int i = 0; i < N; i++) {
        double x = -a + (i + 0.5) * h, mean = p0 / (a * h) * integral(hertz, &a, x - 0.5 * h, x + 0.5 * h);
        double full = pair.mu * mean, slip = b[i] - displacement(s->tau, a, x);
        assert_close(s->x[i], x, 0, 1e-15 * a);
        assert_close(s->p[i], mean, 0, 1e-8 * p0); /* hertz() is rounded at |s| = a, by the root of rounding */
        full = pair.mu * s->p[i];
        assert_close(s->slip[i], slip, 0, 1e-12 * b_max);
        assert_true(fabs(s->tau[i]) <= full + 1e-12 * pair.mu * p0);
        if (s->side[i])
            assert_true(s->tau[i] == s->side[i] * full && s->tau[i] * slip >= -1e-12 * full * b_max);
        else
            assert_true(s->slip[i] == 0);
        Q += h * s->tau[i], work += h * s->tau[i] * s->slip[i];
        seen->stick += !s->side[i], seen->forward += s->side[i] > 0, seen->backward += s->side[i] < 0;
        slipping += s->side[i] != 0;
    }
    seen->partial += slipping > 0 && slipping < N, seen->full += slipping == N;
    assert_close(s->Q, Q, 0, 1e-13 * pair.mu * k->P);
    assert_close(s->dissipated, work, 1e-12, 1e-12 * pair.mu * k->P * b_max);
    assert_true(s->dissipated >= -1e-12 * pair.mu * k->P * b_max);
    if (k->by_force)
        assert_close(s->Q, k->Q, 0, 1e-12 * pair.mu * k->P);
    else
        assert_true(s->du == k->du);
}

static void test_every_step_obeys(void **state) {
    (void)state;
    tr_status st = {0};
    tr_random r = tr_random_seed(3, 1);
    tr_half_plane *o = tr_half_plane_new(&pair, N, &st);
    assert_non_null(o);
    const tr_patch_state *s = tr_half_plane_state(o);
    double tau[N] = {0}, P = 2e5;
    count seen = {0};
    for (int n = 0; n < 300; n++) {
        double a_before = s->a, scale = 2 * pair.mu * P / (M_PI * pair.E_star), kind = tr_random_uniform(&r);
        memcpy(tau, s->tau, sizeof tau);
        if (kind < 0.3) P = 2e5 * pow(10, 2 * tr_random_uniform(&r) - 1.5);
        if (kind > 0.97) P = 0;
        double a = tr_patch_a(&pair, P), v = 2 * tr_random_uniform(&r) - 1, w = 2 * tr_random_uniform(&r) - 1;
        tr_patch_step k = {.P = P, .by_force = n % 2, .Q = pair.mu * P * v, .du = 4 * scale * v * v * v};
        if (n % 7 == 0) k.Q = copysign(pair.mu * P, v);
        if (n % 5) k.dr = n % 3 ? a * w * fabs(w) : 6 * a * w * w * w; /* also across the whole contact */
        if (n % 11 == 0) k.dr = 2 * a / N;
        assert_true(tr_half_plane_step(o, &k, &st));
        if (P > 0)
            check_law(s, &k, tau, a_before, &seen);
        else
            for (int i = 0; i < N; i++) assert_true(s->tau[i] == 0 && s->Q == 0 && s->a == 0);
        if (P == 0) P = 1e5;
    }
    tr_half_plane_free(o);
    /* the paths went everywhere */
    assert_true(seen.stick > 500 && seen.forward > 500 && seen.backward > 500 && seen.partial > 100 && seen.full > 20);
}

/* Large problems, sudden changes: the solver ends by itself or reports; it always ends. */
static void test_sudden_changes_at_any_size(void **state) {
    (void)state;
    static const int sizes[] = {2, 3, 10, 401, 1000};
    tr_random r = tr_random_seed(9, 1);
    for (int m = 0; m < 5; m++) {
        tr_status st = {0};
        int n = sizes[m];
        tr_half_plane *o = tr_half_plane_new(&pair, n, &st);
        const tr_patch_state *s = tr_half_plane_state(o);
        for (int j = 0; j < (n > 300 ? 8 : 400); j++) {
            double P = 1e5 * (0.1 + tr_random_uniform(&r)), v = 2 * tr_random_uniform(&r) - 1;
            tr_patch_step k = {
                .P = P, .dr = 1e-3 * v * v * v, .by_force = j % 2, .Q = -pair.mu * P * v, .du = 1e-4 * v};
            if (!tr_half_plane_step(o, &k, &st)) fail_msg("n = %d, step %d: %s", n, j, st.text);
            for (int i = 0; i < n; i++)
                assert_true(fabs(s->tau[i]) <= pair.mu * s->p[i] + 1e-12 * pair.mu * tr_patch_p0(&pair, P) &&
                            s->side[i] * s->slip[i] >= -1e-12 * 1e-4);
        }
        tr_half_plane_free(o);
    }
}

/* The force falls by orders of magnitude in one step, out of rest or of sliding: u_{n-1} is then large against all that
 * the contact can hold, and so is rounding. */
static void test_load_falls(void **state) {
    (void)state;
    tr_status st = {0};
    tr_half_plane *o = tr_half_plane_new(&pair, N, &st);
    double P = 2e5;
    for (double fall = 1e-1; fall > 1e-9; fall *= 0.1)
        for (double q = -0.999; q < 1; q += 0.333) {
            double k = M_PI * pair.E_star; /* more than any stiffness */
            tr_patch_step high = {.P = P, .by_force = true, .Q = 0.9 * pair.mu * P};
            tr_patch_step low = {.P = fall * P, .by_force = true, .Q = q * fall * pair.mu * P};
            if (!tr_half_plane_step(o, &high, &st) || !tr_half_plane_step(o, &low, &st)) fail_msg("%s", st.text);
            const tr_patch_state *s = tr_half_plane_state(o);
            assert_close(s->Q, low.Q, 0, 1e-12 * (pair.mu * fall * P + k * fabs(s->du)));
        }
    tr_half_plane_free(o);
}

static void test_refusals(void **state) {
    (void)state;
    tr_status st = {0};
    tr_patch_pair bad = pair;
    bad.d = NAN;
    assert_null(tr_half_plane_new(&bad, N, &st));
    assert_int_equal(st.code, TR_BAD_CASE);
    st.code = TR_OK;
    assert_null(tr_half_plane_new(&pair, 1, &st));
    st.code = TR_OK;
    tr_half_plane *o = tr_half_plane_new(&pair, N, &st);
    double P = 2e5, deep = M_PI * pair.E_star * pair.d * pair.d / (4 * pair.R_star); /* a = d */
    const tr_patch_step steps[] = {{.P = P, .by_force = true, .Q = -1.001 * pair.mu * P},
                                   {.P = 0, .by_force = true, .Q = 1},
                                   {.P = -1},
                                   {.P = P, .du = NAN},
                                   {.P = P, .dr = INFINITY},
                                   {.P = deep * 1.001}};
    static const char *const says[] = {"slides", "slides", "P =", "du = nan", "dr = inf", "reaches d"};
    for (int i = 0; i < 6; i++) {
        st.code = TR_OK;
        assert_true(tr_half_plane_step(o, &(tr_patch_step){.P = P, .du = 1e-6}, &st));
        assert_true(tr_half_plane_state(o)->Q > 0);
        assert_false(tr_half_plane_step(o, &steps[i], &st));
        assert_int_equal(st.code, TR_NUMERICAL);
        if (!strstr(st.text, says[i])) fail_msg("no `%s` in: %s", says[i], st.text);
        assert_true(tr_half_plane_state(o)->Q == 0 && tr_half_plane_state(o)->a == 0);
    }
    tr_half_plane_free(o);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_step_obeys),
        cmocka_unit_test(test_sudden_changes_at_any_size),
        cmocka_unit_test(test_load_falls),
        cmocka_unit_test(test_refusals),
    };
    return cmocka_run_group_tests_name("half-plane, law of friction", tests, NULL, NULL);
}
