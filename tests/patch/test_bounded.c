/* SPDX-License-Identifier: MIT */
/* The quadratic problem with matrices that no contact has: random autocovariances, for which whole blocks of guesses
 * cycle. The conditions that single out the answer are checked with products formed here. */
#include "assert_close.h"
#include "base/random.h"
#include "patch/bounded.h"

enum { MOST = 40 };

static void test_random_problems(void **state) {
    (void)state;
    tr_random r = tr_random_seed(12, 1);
    int stick = 0, slip = 0;
    for (int problem = 0; problem < 4000; problem++) {
        int n = 2 + (int)(tr_random_uniform(&r) * (MOST - 1));
        double column[MOST] = {0.05}, bound[MOST], b[MOST], t[MOST], s[MOST], t_max = 0, b_max = 0;
        signed char side[MOST] = {0};
        for (int wave = 0; wave < 3; wave++) {
            double weight = tr_random_uniform(&r), angle = M_PI * tr_random_uniform(&r);
            for (int k = 0; k < n; k++) column[k] += weight * cos(angle * k);
        }
        for (int i = 0; i < n; i++) {
            bound[i] = 0.1 + tr_random_uniform(&r), b[i] = 4 * tr_random_uniform(&r) - 2;
            side[i] = (signed char)(3 * tr_random_uniform(&r) - 1); /* any first guess */
            t_max = fmax(t_max, bound[i]), b_max = fmax(b_max, fabs(b[i]));
        }
        tr_status st = {0};
        tr_bounded o;
        assert_true(tr_bounded_new(&o, n, &st) && tr_bounded_matrix(&o, column, &st));
        if (!tr_bounded_solve(&o, bound, b, side, t, s, &st)) fail_msg("problem %d, n = %d: %s", problem, n, st.text);
        for (int i = 0; i < n; i++) {
            double want = b[i];
            for (int j = 0; j < n; j++) want -= column[i < j ? j - i : i - j] * t[j];
            assert_close(s[i], want, 0, 2e-12 * b_max);
            assert_true(fabs(t[i]) <= bound[i] + 1e-12 * t_max);
            if (side[i])
                assert_true(t[i] == side[i] * bound[i] && side[i] * s[i] >= -1e-12 * b_max);
            else
                assert_true(s[i] == 0);
            stick += !side[i], slip += !!side[i];
        }
        /* the slope against a difference: b higher by a little, the sets the same */
        double sum = 0, more = 0, dt[MOST], ds[MOST], step = 1e-6;
        for (int i = 0; i < n; i++) sum += t[i], b[i] += step;
        double slope = tr_bounded_slope(&o, dt, ds);
        signed char again[MOST];
        for (int i = 0; i < n; i++) again[i] = side[i];
        assert_true(tr_bounded_solve(&o, bound, b, again, t, s, &st));
        bool same = true;
        for (int i = 0; i < n; i++) more += t[i], same &= again[i] == side[i];
        if (same) assert_close((more - sum) / step, slope, 1e-6, 1e-6);
        tr_bounded_free(&o);
    }
    assert_true(stick > 10000 && slip > 10000);
}

static void test_not_positive_definite(void **state) {
    (void)state;
    static const double columns[][3] = {{1, 2, 0}, {0, 0, 0}, {1, 0.9, 0}};
    for (int k = 0; k < 3; k++) {
        tr_status st = {0};
        tr_bounded o;
        assert_true(tr_bounded_new(&o, 3, &st));
        assert_false(tr_bounded_matrix(&o, columns[k], &st));
        assert_int_equal(st.code, TR_NUMERICAL);
        tr_bounded_free(&o);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random_problems),
        cmocka_unit_test(test_not_positive_definite),
    };
    return cmocka_run_group_tests_name("bounded", tests, NULL, NULL);
}
