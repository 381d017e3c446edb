/* SPDX-License-Identifier: MIT */
/* Quantiles of few numbers, by hand. */
#include "assert_close.h"
#include "base/quantile.h"

/* 9 1 4 1 sorted is 1 1 4 9: the median is halfway from 1 to 4, the quartiles are a quarter and three quarters of
 * the way from the first to the last rank. */
static void of_four_numbers(void **state) {
    (void)state;
    double x[] = {9, 1, 4, 1};
    tr_sort(x, 4);
    const double sorted[] = {1, 1, 4, 9};
    for (int i = 0; i < 4; i++) assert_close(x[i], sorted[i], 0, 0);
    assert_close(tr_quantile(x, 4, 0), 1, 0, 0);
    assert_close(tr_quantile(x, 4, 0.25), 1, 0, 0);
    assert_close(tr_quantile(x, 4, 0.5), 2.5, 0, 0);
    assert_close(tr_quantile(x, 4, 0.75), 5.25, 0, 0);
    assert_close(tr_quantile(x, 4, 1), 9, 0, 0);
    assert_close(tr_quantile(x, 3, 0.5), 1, 0, 0); /* odd: the one in the middle */
}

/* Nothing is read beside the numbers. */
static void of_one_number_of_none_and_beyond_the_ends(void **state) {
    (void)state;
    double x[] = {NAN, 7, NAN, NAN};
    for (int k = -2; k < 6; k++) assert_close(tr_quantile(x + 1, 1, 0.25 * k), 7, 0, 0);
    assert_true(isnan(tr_quantile(x + 1, 0, 0.5)));
    x[1] = -3, x[2] = 7;
    assert_close(tr_quantile(x + 1, 2, -1), -3, 0, 0);
    assert_close(tr_quantile(x + 1, 2, 2), 7, 0, 0);
    tr_sort(x + 1, 0), tr_sort(x + 1, 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(of_four_numbers),
                                       cmocka_unit_test(of_one_number_of_none_and_beyond_the_ends)};
    return cmocka_run_group_tests_name("quantiles", tests, NULL, NULL);
}
