/* SPDX-License-Identifier: MIT */
/* The differential equation of dahlberg-alfredsson, solved over one step in which P and the rates are constant. Source
 * [Dahlberg2009], as [Kuhn2014 eq. 11]. Let M = mu P, q = |Q|/M, A = k_t du_disp/M with the sign that drives q up, and
 * B = C/M = k_t F0 |du_roll|/M. Time runs from 0 to 1 over the step:
 *
 *   dq/dtime = A - B w,   w = 1 - z,   z = sqrt(1 - q),   so   2 z dw/dtime = A - B w
 *
 * By quadrature, from z0 and with alpha = A/B - 1, which is |xi|/F0 - 1:
 *
 *   (z0 - z) + alpha ln((z + alpha)/(z0 + alpha)) = tau,   tau = B/2 = k_t F0 |du_roll|/(2 mu P)
 *
 * (with P = pi E* a^2/(4 R) and F0 = mu a/R also tau = (2/pi) (k_t/E*) |du_roll|/a). It is useless for numbers: digits
 * cancel for B << A, for alpha -> 0, and when q falls far. Instead take the time s of dtime = 2 z ds, in which w and z
 * are exponentials:
 *
 *   w = w0 e^(-B s) + A s1,   z = z0 e^(-B s) + (B - A) s1,   time = 2 z0 s1 + 2 (B - A) s2
 *   s1 = int_0^s e^(-B r) dr,   s2 = int_0^s s1(r) dr
 *
 * and solve time(s) = 1. Its slope is 2 z, and w only rises or only falls, so time(s) bends one way and Newton's method
 * is monotone: up from s = 0 if q rises, down from an upper bound if q falls. (There B > A; as s2 >= s^2/(2 + B s) the
 * step is over before s = B/(2 (B - A)) + 1/sqrt(B - A).) Rounding ends it. No bracket is needed.
 *
 * The step has a second part if w reaches 1 (full slip, which lasts while A >= B) or 0 (slid against: the rest of the
 * step begins at Q = 0 with the other sign). Without sliding q only decays. Without rolling Q is the capped spring.
 */
#include "laws/dahlberg_exact.h"
#include "base/math.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>

enum { MANY = 100 }; /* steps of Newton's method: usually 3, 40 if the step ends just before full slip */

typedef struct stage {
    double w, z, A, B; /* w and z at its start */
} stage;

static double s1(double B, double s) {
    return -tr_expm1(-B * s) / B;
}

/* By its series if the closed form would cancel: 1 - y/3 (1 - y/4 (1 - ...)), to 1e-17 at y = 1. */
static double s2(double B, double s) {
    double y = B * s, series = 1;
    if (y > 1) return (s - s1(B, s)) / B;
    for (int k = 18; k > 2; k--) series = 1 - y / k * series;
    return s * s / 2 * series;
}

static double w_at(const stage *g, double s) {
    return g->w * tr_exp(-g->B * s) + g->A * s1(g->B, s);
}

static double z_at(const stage *g, double s) {
    return g->z * tr_exp(-g->B * s) + (g->B - g->A) * s1(g->B, s);
}

static double time_at(const stage *g, double s) {
    return 2 * g->z * s1(g->B, s) + 2 * (g->B - g->A) * s2(g->B, s);
}

/* s at time 1. */
static double s_of_step(const stage *g) {
    bool rises = g->A > g->B * g->w;
    double more = g->B - g->A, s = rises ? 0 : g->B / (2 * more) + 1 / sqrt(more);
    for (int n = 0; n < MANY; n++) {
        double next = s + (1 - time_at(g, s)) / (2 * z_at(g, s));
        if (rises ? !(next > s) : !(next < s)) break;
        s = next;
    }
    return s;
}

double tr_dahlberg_exact(double Q, double M, double A, double C) {
    const double none = DBL_EPSILON / 4; /* creep below rounding, B w <= B q */
    double cut = fmin(fmax(Q, -M), M), sign = cut < 0 ? -1 : 1, q = fabs(cut) / M, B = C / M;
    if (M == 0 || C <= none * M) return fmin(fmax(cut + A, -M), M);
    A = sign * A / M;
    /* On the way to full slip q gains at least |A| - B. Hence |A| < B + 2 below. */
    if (fabs(A) - B >= 1 - (A < 0 ? -q : q)) return A < 0 ? -sign * M : sign * M;
    double z = sqrt(1 - q), w = q / (1 + z), end = INFINITY;
    if (A > B) end = tr_log1p(B * z / (A - B)) / B; /* w = 1; for A = B there s and Newton's method go to infinity */
    if (A < 0) end = tr_log1p(B * w / -A) / B;      /* w = 0 */
    stage g = {w, z, A, B};
    double used = time_at(&g, end); /* inf or NaN without an end */
    if (used <= 1 && A > 0) return sign * M;
    if (used <= 1) return -sign * M * tr_dahlberg_exact(0, 1, -A * (1 - used), B * (1 - used));
    w = w_at(&g, s_of_step(&g));
    return sign * M * (w * (2 - w));
}
