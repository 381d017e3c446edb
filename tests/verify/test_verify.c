/* SPDX-License-Identifier: MIT */
/* What makes a number of `trundle verify` right or wrong, what its table holds, and that every verification says what a
 * reviewer asks: source, and a mutation that it catches. The numbers themselves are checked by `trundle verify`. */
#include "assert_close.h"
#include "verify/exact.h"
#include "verify/groups.h"
#include "verify/sweep.h"
#include "verify/verify.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static bool nothing(tr_verify *v, tr_status *st) {
    (void)v, (void)st;
    return true;
}
static const tr_verification one = {"exact", "one", "what, with a comma", "a \"source\"", "a change", nothing};

static bool judged(double computed, double reference, double tolerance) {
    tr_verify v = {.now = &one};
    tr_status st = {0};
    assert_true(tr_verify_add(&v, &(tr_verify_row){"q", "m", reference, computed, tolerance, "why", NAN, NULL}, &st));
    bool ok = v.row[0].ok;
    assert_int_equal(v.n, 1);
    assert_int_equal(v.failed, !ok);
    tr_verify_free(&v);
    return ok;
}

/* Powers of two: differences are exact. */
static void test_rows(void **state) {
    (void)state;
    assert_true(judged(1.25, 1, 0.25)); /* the tolerance itself is allowed, on both sides */
    assert_true(judged(0.75, 1, 0.25));
    assert_false(judged(nextafter(1.25, 2), 1, 0.25));
    assert_false(judged(0.5, 1, 0.25));
    assert_false(judged(-1, 1, 0.25));
    assert_true(judged(0, 0, 0));
    assert_false(judged(NAN, 1, 0.25));
    assert_false(judged(1, NAN, 0.25));
    assert_false(judged(1, 1, NAN));
    assert_false(judged(INFINITY, 1, 1e300));
}

static void test_outcomes(void **state) {
    (void)state;
    tr_verify v = {.now = &one};
    tr_status st = {0};
    assert_true(tr_verify_outcome(&v, "q", "said so", true, &st));
    assert_true(tr_verify_outcome(&v, "q", "did not", false, &st));
    assert_true(v.row[0].ok && !v.row[1].ok && v.failed == 1);
    assert_true(isnan(v.row[1].row.computed) && isnan(v.row[1].row.reference));
    assert_string_equal(v.row[1].outcome, "did not");
    tr_verify_free(&v);
}

/* Many rows: they stay where they are told apart, though the array moves. Text that is too long is cut. */
static void test_many(void **state) {
    (void)state;
    tr_verify v = {.now = &one};
    tr_status st = {0};
    char name[200];
    memset(name, 'x', sizeof name), name[199] = 0;
    for (int k = 0; k < 1000; k++) {
        char unit[16];
        snprintf(unit, sizeof unit, "%d", k);
        assert_true(tr_verify_add(&v, &(tr_verify_row){name, unit, k, k + k % 2, 0.5, "", NAN, NULL}, &st));
    }
    assert_int_equal(v.n, 1000);
    assert_int_equal(v.failed, 500);
    for (int k = 0; k < 1000; k++) {
        assert_int_equal(atoi(v.row[k].unit), k);
        assert_int_equal(strlen(v.row[k].quantity), 79);
    }
    tr_verify_free(&v);
}

static void test_stop(void **state) {
    (void)state;
    volatile sig_atomic_t stop = 0;
    tr_verify v = {.now = &one, .stop = &stop};
    tr_status st = {0};
    assert_true(tr_verify_go_on(&v, &st));
    stop = 1;
    assert_false(tr_verify_go_on(&v, &st));
    assert_int_equal(st.code, TR_INTERRUPTED);
}

static void read_file(const char *path, char *text, size_t size) {
    FILE *f = fopen(path, "r");
    assert_non_null(f);
    text[fread(text, 1, size - 1, f)] = 0;
    fclose(f);
}

/* An empty cell where there is no number, quotes where a text needs them. */
static void test_table(void **state) {
    (void)state;
    char dir[] = "/tmp/test_verify_XXXXXX", path[64], text[1000];
    assert_non_null(mkdtemp(dir));
    tr_verify v = {.now = &one};
    tr_status st = {0};
    assert_true(tr_verify_add(&v, &(tr_verify_row){"q, r", "m/s", 2, 1.5, 0.25, "half", 2, NULL}, &st));
    assert_true(tr_verify_outcome(&v, "w", "in words", true, &st));
    v.row[0].seconds = v.row[1].seconds = 0.5;
    if (!tr_verify_write(&v, dir, &st)) fail_msg("%s", st.text);
    snprintf(path, sizeof path, "%s/verify.csv", dir);
    read_file(path, text, sizeof text);
    assert_string_equal(
        text,
        "group,case,quantity,unit,source,reference,computed,error,tolerance,order,seconds,verdict,outcome,reason\n"
        "exact,one,\"q, r\",m/s,\"a \"\"source\"\"\",2,1.5,-0.5,0.25,2,0.5,FAILED,,half\n"
        "exact,one,w,,\"a \"\"source\"\"\",,,,,,0.5,ok,in words,\n");
    remove(path), rmdir(dir);
    tr_verify_free(&v);
}

static void test_registry(void **state) {
    (void)state;
    int exact = 0;
    for (int i = 0; tr_verification_at(i); i++) {
        const tr_verification *v = tr_verification_at(i);
        assert_true(*v->name && *v->what && *v->source && v->run);
        if (!*v->mutation) fail_msg("%s names no mutation", v->name);
        exact += !strcmp(v->group, "exact");
        for (int k = 0; k < i; k++)
            if (!strcmp(v->name, tr_verification_at(k)->name) || !strcmp(v->name, v->group))
                fail_msg("the name %s stands twice", v->name);
    }
    assert_true(exact > 20);
}

static int runs; /* of the sweep below */

/* An error of 0.01 step^2, and a time. */
static bool square(void *context, int method, int k, tr_sweep_result *result, tr_status *st) {
    (void)context, (void)method, (void)st;
    double step = 1.0 / (1 << k);
    *result = (tr_sweep_result){step, 0.01 * step * step, 1e-3};
    runs++;
    return true;
}

/* In brief a sweep measures each point once, and has the same rows. */
static void test_sweep_in_brief(void **state) {
    (void)state;
    static const tr_sweep_method method = {"square", 2, 1e-9, "rounding"};
    const tr_sweep sweep = {"step", &method, 1, 5, 7, 0, 2, 0.01 / 16 * 1.001, "exact", square, NULL};
    for (int brief = 0; brief < 2; brief++) {
        tr_verify v = {.now = &one, .brief = brief};
        tr_status st = {0};
        runs = 0;
        assert_true(tr_sweep_add(&v, &sweep, &st));
        assert_int_equal(runs, brief ? 5 : 35);
        assert_int_equal(v.n, 2);
        assert_int_equal(v.n_points, 5);
        assert_int_equal(v.failed, 0);
        assert_close(v.row[0].row.computed, 0.01 / 16, 1e-15, 0);
        assert_close(v.row[1].row.computed, 2, 1e-12, 0);
        tr_verify_free(&v);
    }
}

/* Beside the rows there is nothing to be read. */
static void test_a_law_without_a_row_is_reported(void **state) {
    (void)state;
    static const struct {
        const char *law;
        int number;
    } rows[] = {{"none", 0}, {"spring", 1}};
    const tr_verification named[] = {{.name = "on-slope-none"},
                                     {.name = "on-slope-spring"},
                                     {.name = "on-slope-"},
                                     {.name = "on-slope-sprin"},
                                     {.name = "none"},
                                     {.name = "on-"},
                                     {.name = "on-slope-springs"}};
    for (int k = 0; k < 7; k++) {
        tr_verify v = {.now = &named[k]};
        tr_status st = {0};
        const void *row = tr_exact_find(&v, "on-slope-", rows, 2, sizeof *rows, &st);
        assert_ptr_equal(row, k < 2 ? &rows[k] : NULL);
        assert_int_equal(st.code, k < 2 ? TR_OK : TR_BAD_CASE);
        if (k >= 2) assert_non_null(strstr(st.text, named[k].name));
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_law_without_a_row_is_reported),

        cmocka_unit_test(test_rows),
        cmocka_unit_test(test_outcomes),
        cmocka_unit_test(test_many),
        cmocka_unit_test(test_stop),
        cmocka_unit_test(test_table),
        cmocka_unit_test(test_registry),
        cmocka_unit_test(test_sweep_in_brief),
    };
    return cmocka_run_group_tests_name("verify", tests, NULL, NULL);
}
