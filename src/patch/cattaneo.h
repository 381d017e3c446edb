/* SPDX-License-Identifier: MIT */
/* Tangential loading of a line contact from rest at constant P, without rolling. Source [Johnson1985 sec. 7.2]
 * (Cattaneo, Mindlin); displacement with the logarithm of patch.h.
 *
 *   tau/(mu p0) = sqrt(1 - X^2) - c sqrt(1 - (X/c)^2) where it sticks, |X| <= c = sqrt(1 - |q|); mu p where it slips
 *   u = (2 mu P/(pi E_star)) (q (Lambda + 1/2) + (1/2)(1 - q) ln(1 - q)),   q = Q/(mu P);   odd in q
 *
 *   slip since rest = (2 mu p0/(E_star a)) int_{ca}^{|x|} sqrt(r^2 - (ca)^2) dr where it slips
 *
 * Limits: q -> 0: Q = (pi E_star/(2 Lambda)) u; |q| = 1: all slips, from |u| = (2 mu P/(pi E_star)) (Lambda + 1/2).
 */
#ifndef TR_PATCH_CATTANEO_H
#define TR_PATCH_CATTANEO_H

#include "patch/patch.h"

/* Ranges: P > 0, a(P) < d, |q| <= 1 (else NaN), any u and x (tau is 0 outside of the contact). */
double tr_cattaneo_tau(const tr_patch_pair *c, double P, double q, double x);
double tr_cattaneo_stick(const tr_patch_pair *c, double P, double q); /* half-width of the stick zone [m] */
double tr_cattaneo_u(const tr_patch_pair *c, double P, double q);     /* sliding since rest [m] */
double tr_cattaneo_q(const tr_patch_pair *c, double P, double u);
double tr_cattaneo_slip(const tr_patch_pair *c, double P, double q, double x); /* since rest, until |q| = 1 [m] */

#endif
