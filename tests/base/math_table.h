/* SPDX-License-Identifier: MIT */
/* The functions of base/math.h in a table, and arguments for them: the same on every machine. */
#ifndef TR_MATH_TABLE_H
#define TR_MATH_TABLE_H

#include "base/math.h"
#include "base/random.h"
#include <stdint.h>
#include <string.h>

/* X(NAME) of one argument, Y(NAME) of two */
#define MATH_TABLE(X, Y)                                                                                               \
    X(log)                                                                                                             \
    X(log2) X(log10) X(log1p) X(exp) X(expm1) X(sin) X(cos) X(tan) X(asin) X(atan) X(cbrt) Y(atan2) Y(hypot) Y(pow)

typedef struct math_row {
    const char *name;
    double (*one)(double);
    double (*two)(double, double);
} math_row;

#define MATH_ONE(f) {#f, tr_##f, NULL},
#define MATH_TWO(f) {#f, NULL, tr_##f},
static const math_row math_rows[] = {MATH_TABLE(MATH_ONE, MATH_TWO)};

static uint64_t math_random(tr_random *r) {
    uint64_t high = tr_random_next(r);
    return high << 32 | tr_random_next(r);
}

/* Any bits; 0 to 1; -10 to 10; -700 to 700, where exp ends; close to 1. */
static double math_argument(tr_random *r, int k) {
    uint64_t bits = math_random(r);
    double any, unit = (double)(bits >> 11) * 0x1p-53;
    memcpy(&any, &bits, sizeof any);
    switch (k) {
    case 0:
        return any;
    case 1:
        return unit;
    case 2:
        return 10 * (2 * unit - 1);
    case 3:
        return 700 * (2 * unit - 1);
    default:
        return 1 + 0.01 * (2 * unit - 1);
    }
}

/* A number made of all bits of n results of function f. All NaN count as one. */
static uint64_t math_bits(const math_row *f, int n) {
    tr_random r = tr_random_seed(1, 1);
    uint64_t all = 0;
    for (int i = 0; i < n; i++) {
        double x = math_argument(&r, i % 5), y = f->one ? f->one(x) : f->two(x, math_argument(&r, i / 5 % 5));
        uint64_t bits = 0;
        if (y == y) memcpy(&bits, &y, sizeof bits);
        all = (all ^ bits) * 0x100000001b3u; /* FNV-1a by words; the shift takes high bits down */
        all ^= all >> 29;
    }
    return all;
}

#endif
