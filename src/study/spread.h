/* SPDX-License-Identifier: MIT */
/* The distance between the strength of one sample and the mean of all its kind: a table of measured spreads.
 *
 * s is the standard deviation of sin phi between n seeds. For a normal quantity (x - mean)/s of one more sample x has
 * Student's distribution of n - 1 degrees of freedom, so x +- t s covers the mean in 95 % of all cases, and the mean of
 * k samples +- t s/sqrt(k). figures/spread/rule.awk tests that on 200 fresh samples.
 *
 * Between the numbers of disks that were measured s goes as 1/sqrt(N), and I takes the row that is nearest in log I.
 * All other keys must be within 10 % of the measured case. Otherwise there is no number, and `not_examined` says
 * why. */
#ifndef TR_SPREAD_H
#define TR_SPREAD_H

#include "out/summary.h"

tr_accuracy tr_spread_of(const tr_biaxial *b);

/* Half of the 95 % interval about one sample, for a deviation s between so many seeds. */
double tr_spread_half(double s, int seeds);
/* The half-width to aim at: the largest of 1, 2, 5 times a power of ten that is at most half of this one. */
double tr_spread_aim(double half);
/* How many seeds it takes. */
int tr_spread_seeds(double half, double aim);

#endif
