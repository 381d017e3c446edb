/* SPDX-License-Identifier: MIT */
#include "patch/cattaneo.h"
#include "base/math.h"

double tr_cattaneo_stick(const tr_patch_pair *c, double P, double q) {
    return tr_patch_a(c, P) * sqrt(1 - fabs(q));
}

/* The difference of the roots as a quotient by their sum: no cancellation for small q. */
double tr_cattaneo_tau(const tr_patch_pair *c, double P, double q, double x) {
    double X = x / tr_patch_a(c, P), full = c->mu * tr_patch_p0(c, P), inside = 1 - fabs(q) - X * X;
    if (!(fabs(X) < 1)) return 0;
    double root = sqrt((1 - X) * (1 + X));
    return inside > 0 ? full * q / (root + sqrt(inside)) : copysign(full * root, q);
}

/* u over 2 mu P/(pi E_star), q >= 0; (1 - q) ln(1 - q) is 0 at q = 1 */
static double reduced(double Lambda, double q) {
    return q * (Lambda + 0.5) + (q < 1 ? 0.5 * (1 - q) * tr_log1p(-q) : 0);
}

double tr_cattaneo_u(const tr_patch_pair *c, double P, double q) {
    double scale = 2 * c->mu * P / (M_PI * c->E_star);
    return copysign(scale * reduced(tr_patch_Lambda(c, P), fabs(q)), q);
}

/* Newton's method on a convex curve that rises with slope Lambda at 0, from the right of the root: monotone. */
double tr_cattaneo_q(const tr_patch_pair *c, double P, double u) {
    double Lambda = tr_patch_Lambda(c, P), v = fabs(u) * M_PI * c->E_star / (2 * c->mu * P);
    if (v >= Lambda + 0.5) return copysign(1, u);
    double q = fmin(v / Lambda, 1 - 0x1p-53), before;
    do {
        before = q;
        q -= (reduced(Lambda, q) - v) / (Lambda - 0.5 * tr_log1p(-q));
    } while (q < before && q > 0);
    return copysign(q, u);
}

double tr_cattaneo_slip(const tr_patch_pair *c, double P, double q, double x) {
    double a = tr_patch_a(c, P), k = tr_cattaneo_stick(c, P, q), r = fabs(x);
    if (r <= k || r > a) return 0;
    double root = sqrt((r - k) * (r + k)), area = k > 0 ? r * root - k * k * tr_log((r + root) / k) : r * r;
    return copysign(c->mu * tr_patch_p0(c, P) / (c->E_star * a) * area, q);
}
