/* SPDX-License-Identifier: MIT */
/* Medians, quartiles and the like. */
#ifndef TR_QUANTILE_H
#define TR_QUANTILE_H

/* Ascending. No number may be NaN. */
void tr_sort(double *x, int n);

/* Of sorted numbers: the one at rank share (n - 1) from 0, linear between two; 0.5: the median. NaN where n is 0. */
double tr_quantile(const double *sorted, int n, double share);

#endif
