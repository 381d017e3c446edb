/* SPDX-License-Identifier: MIT */
/* One step of the dahlberg-alfredsson friction law, solved exactly. */
#ifndef TR_DAHLBERG_EXACT_H
#define TR_DAHLBERG_EXACT_H

/* Q [N/m] after a step from Q, |Q| <= M, at the cap M = mu P, A = k_t du_disp and C = k_t F0 |du_roll|, all constant
 * over the step. */
double tr_dahlberg_exact(double Q, double M, double A, double C);

/* The same with a cap that is linear over the step, from M0 >= |Q| to M1; C is that of the larger of the two, F0 goes
 * with its root. M0 = 0: the contact forms. */
double tr_dahlberg_load(double Q, double M0, double M1, double A, double C);

#endif
