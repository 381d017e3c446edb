/* SPDX-License-Identifier: MIT */
/* The bed of sliders: tangential force of an elastic contact with friction, for any order of normal and tangential
 * loading. Source: Jaeger's superposition of the theory of Cattaneo and Mindlin [Jaeger2005], in integral form.
 *
 * A contact of overlap delta is a bed of springs with a friction slider each, at 0 <= s <= delta: the one at s joined
 * when the overlap was s, has the weight P''(s) ds (and P'(0) at s = 0), P the elastic curve of the normal law, and the
 * strain e(s), |e(s)| <= mu kappa (delta - s), e(delta) = 0:
 *
 *   P = int_0^delta (delta - s) P'' ds, Q = (1/kappa) (P'(0) e(0) + int_0^delta e P'' ds) = -(1/kappa) int_0^delta e'
 *   P' ds energy = (1/2 kappa) (P'(0) e(0)^2 + int_0^delta e^2 P'' ds)
 *
 * A step from overlap delta to delta' with tangential displacement du along a straight path is exact for any size: e +=
 * du; springs that join during the step get their part du (delta' - s)/(delta' - delta), springs that leave are
 * dropped; e is clamped. e stays piecewise linear, so its breakpoints are the whole history, and both integrals are
 * sums:
 *
 *   Q = -(1/kappa) sum m (P_b - P_a),   energy = (1/kappa) sum m (m (W_b - W_a) - (P_b e_b - P_a e_a)),   W = int P ds
 *
 * over the pieces from a to b of slope m = (e_b - e_a)/(s_b - s_a), |m| <= mu kappa. Hence |Q| <= mu P; virgin loading
 * is mu (P(delta) - P(delta - u/(mu kappa))), reversals follow it at twice the scale (Masing), loops close and leave no
 * memory. kappa, the initial normal over tangential stiffness: (2 - nu)/(2(1 - nu)) of spheres, 1 of disks with the
 * logarithmic law of their line contact. A linear P makes it a spring k_n/kappa capped at mu P.
 *
 * A breakpoint that takes no part in Q (collinear, or P linear around it) is dropped. Where P grows while du/ddelta
 * varies from step to step below mu kappa, each step leaves a breakpoint: of more than `breakpoints` the one goes whose
 * removal changes Q least, which is counted. Chords of a strain inside the caps are inside, so |Q| <= mu P still holds;
 * the store may rise as well as fall, by half of e times that change. On a path of 600 such steps, sliding to and fro
 * six times, hertz-line, hertz-sphere and a quadratic P:
 *
 *   points   largest error of Q/(mu P)     largest gain of the store in a step, of mu P mu kappa delta
 *   8        0.003, 0.009, 0.03            4e-6
 *   16       0.0009, 0.005, 0.006          3e-6
 *   32       0.0001, 0.0006, 0.001         1e-6
 *
 * P is f_elastic: a dashpot carries no friction. f_n <= 0 or delta <= 0: Q = 0 and the history is cleared. P -> 0, mu =
 * 0: Q = 0.
 */
#ifndef TR_BED_H
#define TR_BED_H

#include "laws/law.h"
#include "laws/material.h"

/* History: number of points, count of those that did not fit, then s [m], e [m] and P(s) of each. P is cached, because
 * computing it is expensive: a step calls the normal law only for a new breakpoint. */
enum { TR_BED_POINTS = 16, TR_BED_HIST = 2 + 3 * TR_BED_POINTS };

/* The parameters of a law on the bed begin with these. */
typedef struct tr_bed_par {
    double mu, nu;
    int breakpoints;
} tr_bed_par;

#define TR_ROW_BREAKPOINTS(par, at)                                                                                    \
    {                                                                                                                  \
        "breakpoints", TR_COUNT, TR_DIM_NUMBER, "", "0", 0, TR_BED_POINTS, NULL, offsetof(par, at),                    \
            "of the history of a contact; where there are more, one is merged. 0: 16, as many as there is room for"    \
    }
#define TR_BED_PARAMS(par) TR_ROW_MU(par, bed.mu, 0), TR_ROW_NU(par, bed.nu), TR_ROW_BREAKPOINTS(par, bed.breakpoints)

/* One contact, taken out of the history. */
typedef struct tr_bed {
    const tr_law_data *data;
    double R1, R2, mu, kappa, cap; /* cap = mu kappa */
    int n, most, merged;                               /* most: of n */
    int kept;                                          /* so many points, the lowest, have the s and P of the history */
    double s[TR_BED_POINTS + 1], e[TR_BED_POINTS + 1]; /* s[0] = 0 <...< s[n-1] = delta, e[n-1] = 0; n = 0: fresh */
    double P[TR_BED_POINTS + 1];                       /* P(s) */
    double asked, asked_P;                             /* the last place at which the normal law was asked, P there */
} tr_bed;

/* Q of the present bed [N/m]; below[k]: the part of kappa Q from 0 to s[k]. */
double tr_bed_force(const tr_bed *bed, double *below);

/* One step to the overlap delta > 0, where the elastic force is P, with the tangential displacement du; returns Q. */
double tr_bed_advance(tr_bed *bed, double delta, double P, double du);

/* What Q would be, and dQ/ddu [Pa], of the bed as it is: by the parts below of tr_bed_force, which du does not change.
 */
double tr_bed_trial(tr_bed *bed, const double *below, double delta, double P, double du, double *slope);

/* Whether all of the bed would slip, towards +du or, side = -1, towards -du. */
static inline bool tr_bed_slips(const tr_bed *bed, double delta, double du, double side) {
    return side * ((bed->n ? bed->e[0] : 0) + du) >= bed->cap * delta; /* the caps are the steepest */
}

/* The displacement of the bed of contact i in this step: sliding less the part that rolling takes away. */
typedef double tr_bed_displacement(tr_bed *bed, const tr_tile *tile, const tr_law_data *data, int i);

/* The step, state and stiffness of a law on the bed. */
void tr_bed_step(tr_tile *tile, const tr_law_data *data, tr_bed_displacement *displacement);
void tr_bed_state(const tr_tile *tile, const tr_law_data *data, double *energy, double *bound);
tr_stiffness tr_bed_stiffness(const void *par, const tr_pair_bodies *bodies);

#endif
