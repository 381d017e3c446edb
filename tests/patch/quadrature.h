/* SPDX-License-Identifier: MIT */
/* Tanh-sinh quadrature: to rounding also where the integrand has a root or a logarithm at an end. */
#ifndef TR_TEST_QUADRATURE_H
#define TR_TEST_QUADRATURE_H

#include <math.h>

/* f(s, distance of s from low, from high, with); the distances are exact near their ends, where s itself is rounded. */
typedef double integrand(double s, double from_low, double from_high, const void *with);

static inline double integral(integrand *f, const void *with, double low, double high) {
    enum { HALF = 64 };
    static double near[HALF + 1], weight[HALF + 1]; /* 1 - |node| on [-1, 1]; of the node and its mirror */
    double half = 0.5 * (high - low), sum = 0, step = 1.0 / 16;
    for (int k = 0; k <= HALF && !(weight[0] > 0 && k == 0); k++) {
        double g = 0.5 * M_PI * sinh(k * step);
        near[k] = 1 / (exp(g) * cosh(g)), weight[k] = step * 0.5 * M_PI * cosh(k * step) / (cosh(g) * cosh(g));
    }
    if (!(half > 0)) return 0;
    for (int k = 0; k <= HALF && near[k] > 1e-290; k++) {
        double small = half * near[k], large = half * (2 - near[k]);
        sum += weight[k] * f(high - small, large, small, with);
        if (k > 0) sum += weight[k] * f(low + small, small, large, with);
    }
    return half * sum;
}

#endif
