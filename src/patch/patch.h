/* SPDX-License-Identifier: MIT */
/* The inside of one line contact of two disks: the reference for force laws. This folder has no code in common with
 * laws/, and its numerical solutions (half_plane, brush) have none in common with its closed forms (carter, cattaneo).
 *
 * A pair, per metre of length, SI [Johnson1985 secs. 4.2, 5.6]:
 *
 *   a = sqrt(4 P R_star/(pi E_star)),   p(x) = p0 sqrt(1 - (x/a)^2),   p0 = 2 P/(pi a),   Lambda = ln(2d/a)
 *   u(x) = (2/(pi E_star)) int tau(s) ln(d/|x - s|) ds
 *
 * u: tangential displacement of the surface of 1 less that of 2, by the tractions tau. In the plane u needs d, the
 * distance where u is zero; d > a. Like materials (or Dundurs' constant zero): tau does not change p.
 *
 * Signs: du = Vs dt, the sliding of 2 against 1 along t as rigid bodies; tau and Q have the sign of accumulated
 * sliding. dr: roll of material through the contact along t (Kuhn's du_roll); dr > 0: it enters at x = -a.
 *   du = slip + [u_n(x) - u_{n-1}(x - dr)]      (stick: slip = 0, |tau| <= mu p; slip: tau = mu p of its sign)
 */
#ifndef TR_PATCH_H
#define TR_PATCH_H

#include "base/status.h"
#include "base/math.h"
#include <math.h>

typedef struct tr_patch_pair {
    double R_star; /* 1/R_star = 1/R1 + 1/R2 [m] */
    double E_star; /* 1/E_star = sum of (1 - nu^2)/E [Pa] */
    double d;      /* constant of the logarithm [m]; half_plane and cattaneo only */
    double mu;     /* > 0 */
} tr_patch_pair;

static inline double tr_patch_a(const tr_patch_pair *c, double P) {
    return sqrt(4 * P * c->R_star / (M_PI * c->E_star));
}
static inline double tr_patch_p0(const tr_patch_pair *c, double P) {
    return sqrt(P * c->E_star / (M_PI * c->R_star)); /* 2 P/(pi a), also at P = 0 */
}
/* 0 outside of the contact. */
static inline double tr_patch_p(const tr_patch_pair *c, double P, double x) {
    double a = tr_patch_a(c, P);
    return fabs(x) < a ? tr_patch_p0(c, P) * sqrt((1 - x / a) * (1 + x / a)) : 0;
}
static inline double tr_patch_Lambda(const tr_patch_pair *c, double P) {
    return tr_log(2 * c->d / tr_patch_a(c, P));
}

/* One step of a numerical solution: to the normal force P >= 0 [N/m], by the roll dr [m], with the sliding du [m] or,
 * by_force, with the tangential force Q [N/m] prescribed. P = 0 opens the contact and clears its memory. */
typedef struct tr_patch_step {
    double P, dr;
    bool by_force;
    double du, Q; /* the prescribed one; the other is not read */
} tr_patch_step;

/* The contact after a step: n equal elements, x[i] in the middle of element i. */
typedef struct tr_patch_state {
    int n;
    double P, a, h;    /* h = 2a/n */
    double *x;         /* [m] */
    double *p, *tau;   /* means over the element [Pa] */
    double *slip;      /* of the step, at x [m]; see cut.h */
    signed char *side; /* 0: it stuck; +1, -1: tau = side mu p */
    double Q, du;      /* Q = h sum tau */
    double dissipated; /* h sum tau slip [N] */
    double *slip_sum, *tau_before; /* work of cut.c, n */
} tr_patch_state;

/* Allocates the arrays; refuses a pair that is not finite and positive, and n outside 2..TR_PATCH_MAX. */
enum { TR_PATCH_MAX = 4000 };
bool tr_patch_state_new(tr_patch_state *s, const tr_patch_pair *c, int n, tr_status *st);
void tr_patch_state_free(tr_patch_state *s);
void tr_patch_state_clear(tr_patch_state *s); /* an open contact */

/* The grid and the pressure of P > 0. The mean of Hertz's pressure over an element, not its value in the middle: then
 * full slip is Q = mu P for any n. */
void tr_patch_state_grid(tr_patch_state *s, const tr_patch_pair *c, double P);

/* Refuses numbers that are not finite, P < 0 and, by force, |Q| > mu P: then the contact slides, and no du is in
 * equilibrium. */
bool tr_patch_step_check(const tr_patch_step *step, const tr_patch_pair *c, tr_status *st);

/* Q and dissipated from tau and slip. */
void tr_patch_state_sums(tr_patch_state *s);

/* The du at which a response Q(du), continuous and nowhere falling, is Q, to 1e-13 of scale + stiffest |du|, the effect
 * of rounding in du: Newton's method inside a bracket, from du. respond gives Q and its slope (0 where all slips); no
 * slope exceeds about `stiffest`, and the last call of respond is at the du that is returned. */
typedef bool tr_patch_respond(void *body, double du, double *Q, double *slope, tr_status *st);
bool tr_patch_find_du(tr_patch_respond *respond, void *body, double Q, double scale, double stiffest, double *du,
                      tr_status *st);

#endif
