/* SPDX-License-Identifier: MIT */
/* Observed order of convergence. */
#ifndef TR_TEST_CONVERGENCE_H
#define TR_TEST_CONVERGENCE_H

#include <math.h>

/* Least-squares slope of log(error) against log(h). */
static inline double observed_order(int n, const double *h, const double *error) {
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (int i = 0; i < n; i++) {
        double x = log(h[i]), y = log(fabs(error[i]));
        sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

#endif
