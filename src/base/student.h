/* SPDX-License-Identifier: MIT */
/* A mean over samples, and the interval that contains the true mean with 95 %, by Student's t. */
#ifndef TR_STUDENT_H
#define TR_STUDENT_H

typedef struct tr_mean {
    int n;       /* samples that are numbers */
    double mean; /* NaN: no sample */
    double
        error; /* standard error s/sqrt(n), s^2 = sum (x - mean)^2/(n - 1). NaN, like the interval, with fewer than two
                * samples */
    double low, high; /* mean -+ t error */
} tr_mean;

/* Of x[0] ... x[n-1]; NaN is skipped. */
tr_mean tr_mean_of(const double *x, int n);

/* The t that |t| of so many degrees of freedom, 1 or more, exceeds with probability 0.05. */
double tr_student_95(int freedom);

/* The t that |t| stays below with this probability. */
double tr_student_t(int freedom, double probability);

#endif
