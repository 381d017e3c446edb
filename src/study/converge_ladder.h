/* SPDX-License-Identifier: MIT */
/* What a number does along a ladder of settings, each finer than the one before, and what that says of its error.
 *
 * Without a sample (kinds bodies, contact, patch) a number has one value v_k at level k, and h_k = h_0/r^k:
 *
 *   exact      it does not change but for rounding
 *   order      differences of one sign whose ratio is r^p: three of these observed p, from five levels, agree to 0.3.
 *              Then v = v_k + (v_k - v_{k-1})/(r^p - 1) [Richardson1911]; its own error is how far it moved with the
 *              last level
 *   scattered  a kink falls where it falls between two steps. The largest change from level k to the next two, D_k,
 *              falls as r^(-q k), q 0.6 or more. An envelope A r^(-s k) lies above all of them; s is q but at most
 *              0.75, or q/3 where that is more. Three times the envelope bounds what is left at the finest level
 *   open       none of these: not converged within the range. There is no number
 *
 * With a sample a level has a value of each seed, and what counts is the difference from the case's own level, seed
 * by seed where both have the same sample. Its mean has an interval by Student's t:
 *
 *   order      the same, where three differences of neighbours are each outside of their noise and two observed p agree
 *   noise      no difference of a finer level is outside of its noise; the error is at most the widest end of these
 *              intervals
 *   open       else
 */
#ifndef TR_STUDY_CONVERGE_LADDER_H
#define TR_STUDY_CONVERGE_LADDER_H

#include <stdbool.h>

enum { TR_LADDER_LEVELS = 12 };

typedef enum tr_verdict {
    TR_VERDICT_NONE, /* no finer level was run */
    TR_VERDICT_EXACT,
    TR_VERDICT_ORDER,
    TR_VERDICT_SCATTERED,
    TR_VERDICT_NOISE,
    TR_VERDICT_OPEN
} tr_verdict;

typedef struct tr_ladder {
    tr_verdict verdict;
    double limit;     /* where it goes with finer settings; NaN: not known */
    double unsure;    /* of the limit */
    double order;     /* observed; NaN: none is seen */
    double half;      /* the value at the case's own level is within this of the limit; NaN: not known */
    double seen;      /* largest change from the own level to a finer one */
    double seen_half; /* half of its 95 % interval; 0 without a sample */
} tr_ladder;

/* value: n levels from coarse to fine, NaN where there is none; own: the level of the case; r: the ratio of two levels.
 * scale: the size of the number, by which rounding is judged. */
tr_ladder tr_ladder_of(const double *value, int n, int own, double r, double scale);

/* The same of samples: value[k*stride + s] of level k and seed s. paired: a seed has the same sample at all levels. */
tr_ladder tr_ladder_of_samples(const double *value, int n, int stride, int seeds, int own, double r, bool paired);

/* What one sample is good to. */
typedef struct tr_sample_error {
    int seeds;         /* that have a value */
    double mean, half; /* over all seeds, and half of its 95 % interval */
    double deviation;  /* of one sample from the mean of all, by the others than the first [s] */
    double one_half;   /* the mean of all samples of its kind is within this of the first one, with 95 % */
    int outlier;       /* index of a seed that lies far off the others; -1: none */
    double off;        /* how far from the mean of the others, in standard errors of that distance */
} tr_sample_error;

/* x: of each seed, that of the case first; NaN where there is none. */
tr_sample_error tr_sample_error_of(const double *x, int seeds);

/* How many seeds the mean needs for a half-width. */
int tr_sample_seeds_for(double deviation, double half);

/* How many seeds of each of two cases show a difference with a power of 80 %, by a test of 5 %. */
int tr_sample_seeds_to_see(double deviation, double difference);

#endif
