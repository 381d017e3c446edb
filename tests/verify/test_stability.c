/* SPDX-License-Identifier: MIT */
/* The quick part of `trundle verify stability`: every case ends as it was said to end before it ran. The references are in
 * src/verify/stability_*.c; here each verification is a test by its name. Left to the command: what takes seconds. */
#include "assert_close.h"
#include "verify/verify.h"
#include <string.h>

static void run(void **state) {
    tr_status st = {0};
    tr_verify v = {0};
    const tr_verification *which = *state;
    if (!tr_verify_run(&v, which, &st)) fail_msg("%s", st.text);
    assert_true(v.n > 0);
    for (int i = 0; i < v.n; i++) {
        const tr_verified *r = &v.row[i];
        if (!r->ok)
            print_error("%s: %.9g, reference %.9g, allowed %.1e %s\n", r->quantity, r->row.computed, r->row.reference,
                        r->row.tolerance, r->outcome);
    }
    int failed = v.failed;
    tr_verify_free(&v);
    assert_int_equal(failed, 0);
}

/* A number that is wrong, a NaN, and an end other than it was said: each is counted. */
static void test_failures_are_counted(void **state) {
    (void)state;
    tr_status st = {0};
    tr_verify v = {.now = &tr_verify_stability[0]};
    const double wrong[] = {1.2, NAN};
    for (int k = 0; k < 2; k++)
        assert_true(tr_verify_add(
            &v, &(tr_verify_row){"a", "1", .reference = 1, .computed = wrong[k], .tolerance = 0.1, .reason = ""}, &st));
    assert_true(tr_verify_outcome(&v, "b", "ran to its end", false, &st));
    assert_int_equal(v.failed, 3);
    assert_int_equal(st.code, TR_OK);
    tr_verify_free(&v);
}

int main(void) {
    enum { MOST = 32 };
    static const char *const slow[] = {"hardness", "not-conjugate"};
    struct CMUnitTest tests[MOST] = {cmocka_unit_test(test_failures_are_counted)};
    int n = 1;
    for (int i = 0; i < tr_n_verify_stability && n < MOST; i++) {
        const tr_verification *which = &tr_verify_stability[i];
        bool quick = true;
        for (int k = 0; k < 2; k++) quick = quick && strcmp(which->name, slow[k]) != 0;
        if (quick) tests[n++] = (struct CMUnitTest){which->name, run, NULL, NULL, (void *)which};
    }
    return _cmocka_run_group_tests("stability", tests, (size_t)n, NULL, NULL);
}
