/* SPDX-License-Identifier: MIT */
/* Steady rolling of a line contact. Source [Carter1926], as [Johnson1985 sec. 8.3].
 *
 *   xi = du/|dr| = F0 (1 - c),   c = sqrt(1 - |q|),   q = Q/(mu P),   F0 = mu a/R_star,   of the sign of Q
 *   tau/(mu p0) = sqrt(1 - X^2) - c sqrt(1 - ((X + 1 - c)/c)^2) where it sticks, mu p where it slips,   X = x/a
 *   sticks from the entering edge: -1 <= X <= 2c - 1 for dr > 0
 *   slip/|dr| = (mu/R_star) sqrt((x + a - ac)^2 - (ac)^2) where it slips
 *
 * `roll` is a number of the sign of dr; dr < 0 mirrors x. q, xi, tau and slip are signed alike. No difference of nearly
 * equal numbers is taken: the relative accuracy holds to q -> 0.
 *
 * Limits: q -> 0: xi = F0 q/2; |q| = 1: all slips, xi = F0 is the smallest creepage for it (more adds to the slip).
 * differs: [Kuhn2014 eq. 9, text] says that creepage goes to infinity at q = 1 (for the similar law of spheres); it is
 * F0.
 */
#ifndef TR_PATCH_CARTER_H
#define TR_PATCH_CARTER_H

#include "patch/patch.h"

/* Ranges: P > 0, |q| <= 1 (else NaN), any xi and x (tau and slip are 0 outside of the contact). */
double tr_carter_creepage(const tr_patch_pair *c, double P, double q);
double tr_carter_q(const tr_patch_pair *c, double P, double xi);
double tr_carter_tau(const tr_patch_pair *c, double P, double q, double roll, double x);       /* [Pa] */
double tr_carter_slip(const tr_patch_pair *c, double P, double q, double roll, double x);      /* per unit roll */
void tr_carter_stick(const tr_patch_pair *c, double P, double q, double roll, double zone[2]); /* from, to [m] */

#endif
