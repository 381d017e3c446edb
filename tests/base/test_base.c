/* SPDX-License-Identifier: MIT */
/* Random numbers, allocation, status. The random numbers are those printed by the demo program of the published minimal
 * PCG32 in C (seed 42, stream 54), and a second implementation below with the state kept in two 32-bit halves. */
#include "assert_close.h"
#include "base/alloc.h"
#include "base/random.h"
#include "base/status.h"
#include <stdlib.h>
#include <string.h>

static void pcg32_gives_the_published_sequence(void **state) {
    (void)state;
    static const uint32_t published[] = {0xa15c02b7, 0x7b47f409, 0xba1d3330, 0x83d2f293, 0xbfa4784b, 0xcbed606e};
    tr_random r = tr_random_seed(42, 54);
    for (int i = 0; i < 6; i++) assert_int_equal(tr_random_next(&r), published[i]);
}

/* 64-bit product and sum from 32-bit halves; output by the text of the paper: (state ^ state >> 18) >> 27, rotated
 * right by state >> 59. */
typedef struct halves {
    uint32_t low, high;
} halves;

static halves next_state(halves s, halves increment) {
    const uint32_t ml = 0x4c957f2d, mh = 0x5851f42d; /* 6364136223846793005 = 0x5851f42d4c957f2d */
    uint64_t low = (uint64_t)s.low * ml + increment.low;
    uint32_t high = s.low * mh + s.high * ml + (uint32_t)(low >> 32) + increment.high;
    return (halves){(uint32_t)low, high};
}

static uint32_t output_of(halves s) {
    uint64_t whole = (uint64_t)s.high << 32 | s.low;
    uint32_t x = (uint32_t)((whole ^ whole >> 18) >> 27);
    for (unsigned turn = s.high >> 27; turn > 0; turn--) x = x >> 1 | x << 31;
    return x;
}

static void pcg32_agrees_with_a_second_implementation(void **state) {
    (void)state;
    static const uint64_t seeds[] = {0, 1, 42, 0xffffffffffffffffu, 0x123456789abcdef0u};
    for (int k = 0; k < 5; k++) {
        uint64_t stream = seeds[(k + 2) % 5];
        halves inc = {(uint32_t)(stream << 1 | 1), (uint32_t)((stream << 1 | 1) >> 32)},
               s = next_state((halves){0}, inc);
        uint64_t sum = ((uint64_t)s.high << 32 | s.low) + seeds[k];
        s = next_state((halves){(uint32_t)sum, (uint32_t)(sum >> 32)}, inc);
        tr_random r = tr_random_seed(seeds[k], stream);
        for (int i = 0; i < 1000; i++) {
            assert_int_equal(tr_random_next(&r), output_of(s));
            s = next_state(s, inc);
        }
    }
}

static void uniform_numbers_fill_the_interval(void **state) {
    (void)state;
    enum { N = 100000 };
    tr_random r = tr_random_seed(7, 1);
    double sum = 0, squares = 0;
    for (int i = 0; i < N; i++) {
        double u = tr_random_uniform(&r);
        assert_true(u >= 0 && u < 1);
        sum += u, squares += u * u;
    }
    /* Standard error of the mean sqrt(1/12/N) = 9e-4, of the mean square sqrt(4/45/N) = 9.4e-4; five of them. */
    assert_close(sum / N, 0.5, 0, 4.6e-3);
    assert_close(squares / N, 1.0 / 3, 0, 4.7e-3);
}

static void memory_is_zero_and_aligned(void **state) {
    (void)state;
    tr_status st = {0};
    for (size_t n = 0; n < 40; n += 13) {
        double *p = tr_alloc(n, sizeof *p, &st);
        assert_non_null(p);
        assert_int_equal((uintptr_t)p % 64, 0);
        for (size_t i = 0; i < (n ? n : 1); i++) assert_true(p[i] == 0), p[i] = 1;
        free(p);
    }
    assert_int_equal(st.code, TR_OK);
}

static void too_much_memory_is_a_status(void **state) {
    (void)state;
    static const size_t counts[] = {SIZE_MAX, SIZE_MAX / 8, SIZE_MAX / 8 + 1, SIZE_MAX / 8 - 7, (size_t)1 << 62};
    for (int k = 0; k < 5; k++) {
        tr_status st = {0};
        assert_null(tr_alloc(counts[k], 8, &st));
        assert_int_equal(st.code, TR_FILE);
        assert_non_null(strstr(st.text, "out of memory"));
    }
}

static void growing_keeps_the_old_and_clears_the_new(void **state) {
    (void)state;
    tr_status st = {0};
    int *p = NULL;
    assert_true(tr_alloc_grow(&p, 0, 3, sizeof *p, &st));
    for (int i = 0; i < 3; i++) p[i] = i + 1;
    assert_true(tr_alloc_grow(&p, 3, 100, sizeof *p, &st));
    for (int i = 0; i < 100; i++) assert_int_equal(p[i], i < 3 ? i + 1 : 0);
    int *before = p;
    assert_false(tr_alloc_grow(&p, 100, SIZE_MAX / 2, sizeof *p, &st));
    assert_ptr_equal(p, before);
    assert_int_equal(st.code, TR_FILE);
    assert_int_equal(p[2], 3);
    free(p);
}

static void the_first_failure_is_kept(void **state) {
    (void)state;
    tr_status st = {0};
    assert_false(tr_status_fail(&st, TR_NUMERICAL, "disk %d", 7));
    assert_false(tr_status_fail(&st, TR_FILE, "later"));
    assert_int_equal(st.code, TR_NUMERICAL);
    assert_string_equal(st.text, "disk 7");
    char line[2000];
    memset(line, 'x', sizeof line - 1), line[sizeof line - 1] = 0;
    tr_status other = {0};
    tr_status_fail(&other, TR_BAD_CASE, "%s", line);
    assert_int_equal(strlen(other.text), sizeof other.text - 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pcg32_gives_the_published_sequence),
        cmocka_unit_test(pcg32_agrees_with_a_second_implementation),
        cmocka_unit_test(uniform_numbers_fill_the_interval),
        cmocka_unit_test(memory_is_zero_and_aligned),
        cmocka_unit_test(too_much_memory_is_a_status),
        cmocka_unit_test(growing_keeps_the_old_and_clears_the_new),
        cmocka_unit_test(the_first_failure_is_kept),
    };
    return cmocka_run_group_tests_name("base", tests, NULL, NULL);
}
