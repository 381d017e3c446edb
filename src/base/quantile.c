/* SPDX-License-Identifier: MIT */
#include "base/quantile.h"

#include <math.h>
#include <stdlib.h>

static int ascending(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

void tr_sort(double *x, int n) {
    if (n > 1) qsort(x, (size_t)n, sizeof *x, ascending);
}

double tr_quantile(const double *sorted, int n, double share) {
    if (n < 1) return NAN;
    double at = fmin(fmax(share, 0), 1) * (n - 1);
    int k = (int)at;
    return k < n - 1 ? sorted[k] + (at - k) * (sorted[k + 1] - sorted[k]) : sorted[n - 1];
}
