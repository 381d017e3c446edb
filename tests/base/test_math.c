/* SPDX-License-Identifier: MIT */
/* The functions that are the same everywhere: against libm's of long double, and against what WebAssembly gives. */
#include "assert_close.h"
#include "math_table.h"
#include <float.h>

/* libm's own, in long double: on x86-64 it has 11 bits more than a double, so the right double is known. */
#define LIBM_ONE(f) {f##l, NULL},
#define LIBM_TWO(f) {NULL, f##l},
static const struct {
    long double (*one)(long double);
    long double (*two)(long double, long double);
} libm[] = {MATH_TABLE(LIBM_ONE, LIBM_TWO)};

enum { ROWS = sizeof math_rows / sizeof *math_rows };

/* From one double to the next is 1. */
static double doubles_apart(double a, double b) {
    int64_t place[2];
    const double two[2] = {a, b};
    memcpy(place, two, sizeof place);
    for (int i = 0; i < 2; i++)
        if (place[i] < 0) place[i] = INT64_MIN - place[i];
    if ((place[0] > 0) != (place[1] > 0)) return fabs((double)place[0]) + fabs((double)place[1]);
    return fabs((double)(place[0] - place[1]));
}

/* The right double or one beside it: musl rounds once or twice at the end. */
static void within_one_ulp_of_libm(void **state) {
    (void)state;
    const double allowed = LDBL_MANT_DIG > DBL_MANT_DIG ? 1 : 2; /* where long double is double, libm's own 1 adds */
    for (int k = 0; k < ROWS; k++) {
        tr_random r = tr_random_seed(7, 1);
        for (int i = 0; i < 200000; i++) {
            const math_row *f = &math_rows[k];
            double x = math_argument(&r, i % 5), x2 = f->one ? 0 : math_argument(&r, i / 5 % 5);
            double got = f->one ? f->one(x) : f->two(x, x2);
            double right = (double)(f->one ? libm[k].one(x) : libm[k].two(x, x2));
            if (isnan(right) ? isnan(got) : doubles_apart(got, right) <= allowed) continue;
            fail_msg("%s(%.17g, %.17g) = %.17g, libm %.17g", f->name, x, x2, got, right);
        }
    }
}

static void ends_are_exact(void **state) {
    (void)state;
    assert_true(tr_log(1) == 0 && tr_exp(0) == 1 && tr_cbrt(-27) == -3 && tr_hypot(3, -4) == 5 && tr_cos(0) == 1);
    assert_true(tr_log(0) == -INFINITY && isnan(tr_log(-1)) && tr_exp(-INFINITY) == 0 && tr_exp(710) == INFINITY);
    assert_true(tr_pow(10, 3) == 1000 && tr_pow(0, 0) == 1 && isnan(tr_pow(-8, 1. / 3)) && tr_log10(1e-5) == -5);
    assert_true(isnan(tr_asin(1.0000001)) && tr_hypot(INFINITY, NAN) == INFINITY && tr_hypot(3e300, 4e300) == 5e300);
    assert_true(signbit(tr_sin(-0.0)) && signbit(tr_log1p(-0.0)) && signbit(tr_cbrt(-0.0)) &&
                tr_log2(0x1p-1000) == -1000);
    assert_true(tr_log1p(-1) == -INFINITY && tr_expm1(-800) == -1 && tr_atan2(0, -1) == M_PI &&
                isnan(tr_tan(INFINITY)));
}

/* What clang-14 for wasm32-wasi gives with wasi-libc of 2022-05-10, run by Node 20. Other builds of the same sources
 * give the same, but for processors where musl takes fused multiply-add at compile time (aarch64). */
static void golden_the_bits_of_webassembly(void **state) {
    (void)state;
    static const uint64_t wasm[ROWS] = {
        0x086391c224bae2b2, /* log */
        0xc0a6085d689bcaa0, /* log2 */
        0x06f47a4bd4c818f0, /* log10 */
        0x2ef0444fc6f529d1, /* log1p */
        0x30f7d212db201fcc, /* exp */
        0x9a3f78d395f96f1b, /* expm1 */
        0x9cb555857c72ef32, /* sin */
        0x77dabc56a0547651, /* cos */
        0x2932ab6424f5679a, /* tan */
        0x011501c43b8e4c45, /* asin */
        0x5e0a05d40fd8cbc0, /* atan */
        0x6016b6bff23b49e6, /* cbrt */
        0xec5504901db3c7fa, /* atan2 */
        0x319972d64029e3c6, /* hypot */
        0xd3e7cdcce24a9ad9, /* pow */
    };
#ifdef __FP_FAST_FMA
    skip();
#endif
    for (int k = 0; k < ROWS; k++)
        if (math_bits(&math_rows[k], 1000000) != wasm[k]) fail_msg("%s has other bits", math_rows[k].name);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(within_one_ulp_of_libm), cmocka_unit_test(ends_are_exact),
                                       cmocka_unit_test(golden_the_bits_of_webassembly)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
