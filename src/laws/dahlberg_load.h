/* SPDX-License-Identifier: MIT */
/* One step of the dahlberg-alfredsson friction law under a load that changes, solved exactly. */
#ifndef TR_LAWS_DAHLBERG_LOAD_H
#define TR_LAWS_DAHLBERG_LOAD_H

/* Like tr_dahlberg_exact, with a cap that is linear over the step, from M0 >= |Q| to M1. C belongs to the larger of the
 * two; F0 goes with its root. M0 = 0: the contact forms. */
double tr_dahlberg_load(double Q, double M0, double M1, double A, double C);

#endif
