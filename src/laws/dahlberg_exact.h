/* SPDX-License-Identifier: MIT */
/* One step of the dahlberg-alfredsson friction law, solved exactly. */
#ifndef TR_DAHLBERG_EXACT_H
#define TR_DAHLBERG_EXACT_H

/* Q [N/m] after a step from Q, |Q| <= M, at the cap M = mu P, A = k_t du_disp and C = k_t F0 |du_roll|, all constant
 * over the step. */
double tr_dahlberg_exact(double Q, double M, double A, double C);

#endif
