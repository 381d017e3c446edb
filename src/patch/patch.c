/* SPDX-License-Identifier: MIT */
#include "patch/patch.h"
#include "base/math.h"
#include "base/alloc.h"

#include <stdlib.h>
#include <string.h>

bool tr_patch_state_new(tr_patch_state *s, const tr_patch_pair *c, int n, tr_status *st) {
    memset(s, 0, sizeof *s);
    const double values[] = {c->R_star, c->E_star, c->d, c->mu};
    for (int i = 0; i < 4; i++)
        if (!(values[i] > 0 && isfinite(values[i])))
            return tr_status_fail(st, TR_BAD_CASE, "error: R_star, E_star, d and mu of a contact must be positive");
    if (n < 2 || n > TR_PATCH_MAX)
        return tr_status_fail(st, TR_BAD_CASE, "error: %d elements of a contact; 2 to %d", n, TR_PATCH_MAX);
    s->n = n;
    size_t m = (size_t)n;
    return (s->x = tr_alloc(m, sizeof *s->x, st)) && (s->p = tr_alloc(m, sizeof *s->p, st)) &&
           (s->tau = tr_alloc(m, sizeof *s->tau, st)) && (s->slip = tr_alloc(m, sizeof *s->slip, st)) &&
           (s->side = tr_alloc(m, sizeof *s->side, st)) &&
           (s->slip_sum = tr_alloc(m, sizeof *s->slip_sum, st)) &&
           (s->tau_before = tr_alloc(m, sizeof *s->tau_before, st));
}

void tr_patch_state_free(tr_patch_state *s) {
    free(s->x), free(s->p), free(s->tau), free(s->slip), free(s->side), free(s->slip_sum), free(s->tau_before);
}

void tr_patch_state_clear(tr_patch_state *s) {
    size_t m = (size_t)s->n;
    memset(s->x, 0, m * sizeof *s->x), memset(s->p, 0, m * sizeof *s->p), memset(s->tau, 0, m * sizeof *s->tau);
    memset(s->slip, 0, m * sizeof *s->slip), memset(s->side, 0, m * sizeof *s->side);
    s->P = s->a = s->h = s->Q = s->du = s->dissipated = 0;
}

/* int_0^X sqrt(1 - s^2) ds */
static double area(double X) {
    return 0.5 * (X * sqrt((1 - X) * (1 + X)) + tr_asin(X));
}

void tr_patch_state_grid(tr_patch_state *s, const tr_patch_pair *c, double P) {
    if (P == s->P) return;
    s->P = P, s->a = tr_patch_a(c, P), s->h = 2 * s->a / s->n;
    double p0 = tr_patch_p0(c, P), step = 2.0 / s->n;
    for (int i = 0; i < s->n; i++) {
        s->x[i] = (i + 0.5 - 0.5 * s->n) * s->h;
        s->p[i] = p0 * (area(fmin(1, (i + 1) * step - 1)) - area(i * step - 1)) / step;
    }
}

bool tr_patch_step_check(const tr_patch_step *step, const tr_patch_pair *c, tr_status *st) {
    double drive = step->by_force ? step->Q : step->du;
    if (!(step->P >= 0 && isfinite(step->P) && isfinite(step->dr) && isfinite(drive)))
        return tr_status_fail(st, TR_NUMERICAL, "error: step of a contact: P = %g, dr = %g, %s = %g", step->P, step->dr,
                              step->by_force ? "Q" : "du", drive);
    if (step->by_force && fabs(step->Q) > c->mu * step->P * (1 + 1e-12))
        return tr_status_fail(st, TR_NUMERICAL, "error: the contact slides: |Q| = %g exceeds mu P = %g", fabs(step->Q),
                              c->mu * step->P);
    return true;
}

void tr_patch_state_sums(tr_patch_state *s) {
    s->Q = s->dissipated = 0;
    for (int i = 0; i < s->n; i++) s->Q += s->h * s->tau[i], s->dissipated += s->h * s->tau[i] * s->slip[i];
}

/* Never beyond a bracket. While one end is open and all slips, steps double: after a drop of P the answer may be far
 * away. */
bool tr_patch_find_du(tr_patch_respond *respond, void *body, double Q, double scale, double stiffest, double *du,
                      tr_status *st) {
    enum { MOST = 400 };
    double low = -INFINITY, high = INFINITY, reach = 1 / stiffest, miss = 0, got, slope;
    for (int k = 0; k < MOST; k++, reach *= 2) {
        if (!respond(body, *du, &got, &slope, st)) return false;
        miss = (Q - got) / (scale + stiffest * fabs(*du));
        if (fabs(miss) <= 1e-13) return true;
        *(miss > 0 ? &low : &high) = *du;
        double next = *du + (Q - got) / slope;
        if (!(next > low && next < high)) next = isfinite(high - low) ? 0.5 * (low + high) : *du + (Q - got) * reach;
        if (next == low || next == high) break; /* neighbouring doubles */
        *du = next;
    }
    if (fabs(miss) <= 1e-12) return true;
    return tr_status_fail(st, TR_NUMERICAL, "error: no sliding found for Q = %g: off by %.1e of it", Q, fabs(miss));
}
