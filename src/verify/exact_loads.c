/* SPDX-License-Identifier: MIT */
/* The inside of a line contact: with a changing normal force, rolling the other way, and its slip.
 * X = x/a, delta(P) = (2 P/(pi E_star)) (ln(2d/a) + 1/2).
 *
 *   oblique   Loaded from 0 with Q = l P, l < mu, nothing slips: tau = l p, the sliding is l delta(P) [Mindlin1953].
 *   released  Pushed to Q, then P falls. The edge of stick only ever goes inward, so the traction is Cattaneo's of the
 *             last P and of Q, and the sliding is mu (delta(P) - delta(P - Q/mu)).
 *   rolled    Then P grows by a millionth: nothing jumps.
 *   reversed  Carter's traction for rolling along -x, entered at x = a: that of rolling along x, mirrored. With c =
 *             sqrt(1 - q), y = X + 1 - c:
 *             tau/(mu p0) = sqrt(1 - X^2) - c sqrt(1 - (y/c)^2),   slip/|dr| = (mu a/R) sqrt(y^2 - c^2)
 *   slip      Of Cattaneo: its slope outside of the stick zone is that of the surface beside a Hertz contact of
 *             half-width k = c a, so slip = (mu/R) int_k^x sqrt(s^2 - k^2) ds. */
#include "verify/exact.h"

#include "patch/carter.h"
#include "patch/cattaneo.h"
#include "patch/half_plane.h"
#include <stdio.h>
#include <string.h>

static const tr_patch_pair pair = {.R_star = 0.012, .E_star = 3e9, .d = 0.02, .mu = 0.35};
static const double P = 2e5;

static double width(double load) {
    return sqrt(4 * load * pair.R_star / (M_PI * pair.E_star));
}

static double approach(double load) {
    return 2 * load / (M_PI * pair.E_star) * (log(2 * pair.d / width(load)) + 0.5);
}

/* Hertz's pressure, a mean over the element of width h at x. */
static double pressure(double load, double x, double h) {
    enum { POINTS = 200 };
    double sum = 0, a = width(load);
    for (int k = 0; k < POINTS; k++) {
        double X = (x + ((k + 0.5) / POINTS - 0.5) * h) / a;
        if (fabs(X) < 1) sum += 2 * load / (M_PI * a) * sqrt(1 - X * X) / POINTS;
    }
    return sum;
}

/* ---- the normal force changes */

/* Errors at the end: mean |tau - want| over mu p0, and the sliding over its right value, less 1. */
typedef struct wrong {
    double tau, du;
} wrong;

static wrong compared(const tr_patch_state *s, double du, double want_du, double scale, double less) {
    wrong w = {.du = du / want_du - 1};
    for (int i = 0; i < s->n; i++) {
        double want = scale * (pressure(s->P, s->x[i], s->h) - (less > 0 ? pressure(less, s->x[i], s->h) : 0));
        w.tau += fabs(s->tau[i] - want) / (s->n * pair.mu * 2 * s->P / (M_PI * s->a));
    }
    return w;
}

/* By steps in which a grows evenly. */
static bool oblique(int steps, wrong *w, tr_status *st) {
    const double l = 0.5 * pair.mu;
    tr_half_plane *o = tr_half_plane_new(&pair, 100, st);
    double du = 0;
    bool ok = o;
    for (int k = 1; k <= steps && ok; k++) {
        double load = P * pow((double)k / steps, 2);
        ok = tr_half_plane_step(o, &(tr_patch_step){.P = load, .by_force = true, .Q = l * load}, st);
        if (ok) du += tr_half_plane_state(o)->du;
    }
    if (ok) *w = compared(tr_half_plane_state(o), du, l * approach(P), l, 0);
    tr_half_plane_free(o);
    return ok;
}

static bool released(int steps, wrong *w, tr_status *st) {
    const double Q = -0.3 * pair.mu * P, last = 0.5 * P;
    tr_half_plane *o = tr_half_plane_new(&pair, 100, st);
    double du = 0;
    bool ok = o;
    for (int k = 0; k <= steps && ok; k++) {
        double load = P + (last - P) * k / steps;
        ok = tr_half_plane_step(o, &(tr_patch_step){.P = load, .by_force = true, .Q = Q}, st);
        if (ok) du += tr_half_plane_state(o)->du;
    }
    double inner = last - fabs(Q) / pair.mu;
    if (ok) *w = compared(tr_half_plane_state(o), du, -pair.mu * (approach(last) - approach(inner)), -pair.mu, inner);
    tr_half_plane_free(o);
    return ok;
}

/* Rolled on by 4a, then P grows by a millionth and nothing moves: the change of the traction, mean over mu p0. */
static bool held(double *off, tr_status *st) {
    enum { N = 100 };
    const double a = width(P), h = 2 * a / N, xi = 0.4 * pair.mu * a / pair.R_star;
    double before[N];
    tr_half_plane *o = tr_half_plane_new(&pair, N, st);
    bool ok = o;
    for (int i = 0; ok && i < 2 * N; i++)
        ok = tr_half_plane_step(o, &(tr_patch_step){.P = P, .dr = h, .du = xi * h}, st);
    const tr_patch_state *s = ok ? tr_half_plane_state(o) : NULL;
    if (ok) memcpy(before, s->tau, sizeof before);
    ok = ok && tr_half_plane_step(o, &(tr_patch_step){.P = P * (1 + 1e-6)}, st);
    *off = 0;
    for (int i = 0; ok && i < N; i++) *off += fabs(s->tau[i] - before[i]) / (N * pair.mu * 2 * P / (M_PI * a));
    tr_half_plane_free(o);
    return ok;
}

bool tr_exact_patch_loads(tr_verify *v, tr_status *st) {
    static const char reason[] = "first order: edges move on by an element in a step, N = 100";
    wrong w[2];
    double off;
    for (int k = 0; k < 2; k++)
        if (!tr_verify_go_on(v, st) || !oblique(50 << k, &w[k], st)) return false;
    if (!tr_verify_add(v,
                       &(tr_verify_row){"oblique: traction, mean error", "1", 0, w[1].tau, 0.01, reason,
                                        log2(w[0].tau / w[1].tau), NULL},
                       st) ||
        !tr_verify_add(v,
                       &(tr_verify_row){"oblique: sliding, relative error", "1", 0, w[1].du, 0.01, reason,
                                        log2(w[0].du / w[1].du), NULL},
                       st))
        return false;
    for (int k = 0; k < 2; k++)
        if (!tr_verify_go_on(v, st) || !released(50 << k, &w[k], st)) return false;
    return tr_verify_add(
               v, &(tr_verify_row){"P falls: traction, mean error", "1", 0, w[1].tau, 0.01, reason, NAN, NULL}, st) &&
           tr_verify_add(
               v, &(tr_verify_row){"P falls: sliding, relative error", "1", 0, w[1].du, 0.01, reason, NAN, NULL}, st) &&
           held(&off, st) &&
           tr_verify_add(v,
                         &(tr_verify_row){"rolled, then P grows by 1e-6: traction changes by", "1", 0, off, 1e-4,
                                          "1e-6 times the number of elements", NAN, NULL},
                         st);
}

/* ---- Carter, rolling the other way */

/* Of mu p0, and slip over |dr|, X from the entering edge at -1. */
static double carter_tau(double q, double X) {
    double c = sqrt(1 - q), y = (X + 1 - c) / c;
    return sqrt(1 - X * X) - (fabs(y) < 1 ? c * sqrt(1 - y * y) : 0);
}
static double carter_slip(double q, double X) {
    double c = sqrt(1 - q), y = X + 1 - c;
    return X > 2 * c - 1 ? pair.mu / pair.R_star * sqrt(y * y - c * c) * width(P) : 0;
}

/* The closed forms of src/patch at 199 places. */
static bool reversed_forms(tr_verify *v, double q, tr_status *st) {
    double tau = 0, slip = 0, zone[2], a = width(P), p0 = 2 * P / (M_PI * a), unit = pair.mu / pair.R_star * a;
    for (int i = -99; i < 100; i++) {
        double X = i / 100.0;
        tau = fmax(tau, fabs(tr_carter_tau(&pair, P, q, -2, X * a) / (pair.mu * p0) - carter_tau(q, -X)));
        slip = fmax(slip, fabs(tr_carter_slip(&pair, P, q, -2, X * a) - carter_slip(q, -X)) / unit);
    }
    tr_carter_stick(&pair, P, q, -2, zone);
    double off = fmax(fabs(zone[0] / a - (1 - 2 * sqrt(1 - q))), fabs(zone[1] / a - 1));
    static const char rounding[] = "rounding, under a root";
    return tr_verify_add(v,
                         &(tr_verify_row){"closed form reversed: traction, largest error", "1", 0, tau, 1e-12, rounding,
                                          NAN, NULL},
                         st) &&
           tr_verify_add(
               v,
               &(tr_verify_row){"closed form reversed: slip, largest error", "1", 0, slip, 1e-7, rounding, NAN, NULL},
               st) &&
           tr_verify_add(v,
                         &(tr_verify_row){"closed form reversed: ends of stick, over a", "1", 0, off, 1e-12, "rounding",
                                          NAN, NULL},
                         st);
}

bool tr_exact_patch_reversed(tr_verify *v, tr_status *st) {
    enum { N = 100 };
    const double q = 0.6, a = width(P), dr = -2 * a / N, xi = pair.mu * a / pair.R_star * (1 - sqrt(1 - q));
    static const char reason[] = "first order: stick ends up to an element off, N = 100";
    double tau = 0, slip = 0, Q = NAN;
    tr_half_plane *o = tr_half_plane_new(&pair, N, st);
    bool ok = o;
    for (int i = 0; ok && i < 12 * N; i++)
        ok = tr_half_plane_step(o, &(tr_patch_step){.P = P, .dr = dr, .du = xi * fabs(dr)}, st);
    const tr_patch_state *s = ok ? tr_half_plane_state(o) : NULL;
    for (int i = 0; ok && i < N; i++) {
        tau += fabs(s->tau[i] / (pair.mu * 2 * P / (M_PI * a)) - carter_tau(q, -s->x[i] / a)) / N;
        slip += fabs(s->slip[i] / fabs(dr) - carter_slip(q, -s->x[i] / a)) / (N * pair.mu / pair.R_star * a);
    }
    if (ok) Q = s->Q / (pair.mu * P);
    tr_half_plane_free(o);
    return ok &&
           tr_verify_add(v, &(tr_verify_row){"rolling along -x: Q/(mu P)", "1", q, Q, 6e-3, reason, NAN, NULL}, st) &&
           tr_verify_add(v, &(tr_verify_row){"its traction, mean error", "1", 0, tau, 6e-3, reason, NAN, NULL}, st) &&
           tr_verify_add(v, &(tr_verify_row){"its slip, mean error", "1", 0, slip, 1e-2, reason, NAN, NULL}, st) &&
           reversed_forms(v, q, st);
}

/* ---- how far Cattaneo's contact slips */

/* s = k cosh y: k^2 int sinh^2 y dy, by the middles of many pieces. */
static double cattaneo_slip(double q, double x) {
    enum { POINTS = 20000 };
    double k = width(P) * sqrt(1 - q), sum = 0;
    if (x <= k) return 0;
    double most = acosh(x / k);
    for (int i = 0; i < POINTS; i++) sum += pow(sinh((i + 0.5) * most / POINTS), 2) * most / POINTS;
    return pair.mu / pair.R_star * k * k * sum;
}

bool tr_exact_patch_slip(tr_verify *v, tr_status *st) {
    enum { N = 200 };
    static const double qs[] = {0.3, 0.9};
    for (int c = 0; c < 2; c++) {
        double q = qs[c], a = width(P), edge = cattaneo_slip(q, a), most = 0, numbers = 0;
        for (int i = 1; i <= 20; i++)
            most = fmax(most, fabs(tr_cattaneo_slip(&pair, P, -q, -0.05 * i * a) + cattaneo_slip(q, 0.05 * i * a)));
        tr_half_plane *o = tr_half_plane_new(&pair, N, st);
        bool ok = o && tr_half_plane_step(o, &(tr_patch_step){.P = P, .by_force = true, .Q = q * pair.mu * P}, st);
        const tr_patch_state *s = ok ? tr_half_plane_state(o) : NULL;
        for (int i = 0; ok && i < N; i++) numbers = fmax(numbers, fabs(s->slip[i] - cattaneo_slip(q, fabs(s->x[i]))));
        tr_half_plane_free(o);
        char quantity[2][80];
        snprintf(quantity[0], 80, "closed form, largest error over slip at edge, q = %g", q);
        snprintf(quantity[1], 80, "half-plane, largest error over slip at edge, q = %g", q);
        if (!ok ||
            !tr_verify_add(v,
                           &(tr_verify_row){quantity[0], "1", 0, most / edge, 1e-7,
                                            "20000 middles of pieces: 1/20000^2", NAN, NULL},
                           st) ||
            !tr_verify_add(v,
                           &(tr_verify_row){quantity[1], "1", 0, numbers / edge, 0.02,
                                            "stick ends up to an element off, its pressure is a mean over it, N = 200",
                                            NAN, NULL},
                           st))
            return false;
    }
    return true;
}
