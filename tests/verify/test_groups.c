/* SPDX-License-Identifier: MIT */
/* Every verification of the groups `precision` (in brief) and `stability` is a test by its name: one that is red
 * cannot pass. Those of the group `exact` are run by tests/system/test_verify.sh. References and tolerances are in
 * src/verify/. */
#include "assert_close.h"
#include "verify/groups.h"
#include "verify/verify.h"
#include <string.h>

static void run(void **state) {
    tr_status st = {0};
    tr_verify v = {.brief = true};
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
    enum { MOST = 64 };
    struct CMUnitTest tests[MOST] = {cmocka_unit_test(test_failures_are_counted)};
    int n = 1, others = 0;
    for (int i = 0; tr_verification_at(i) && n < MOST; i++) {
        const tr_verification *which = tr_verification_at(i);
        if (strcmp(which->group, "exact") == 0)
            others++;
        else
            tests[n++] = (struct CMUnitTest){which->name, run, NULL, NULL, (void *)which};
    }
    if (tr_verification_at(n - 1 + others)) return 1; /* MOST is too small */
    return _cmocka_run_group_tests("verifications", tests, (size_t)n, NULL, NULL);
}
