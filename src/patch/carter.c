/* SPDX-License-Identifier: MIT */
#include "patch/carter.h"

static double F0(const tr_patch_pair *c, double P) {
    return c->mu * tr_patch_a(c, P) / c->R_star;
}

/* X = x/a counted from the entering edge */
static double inward(const tr_patch_pair *c, double P, double roll, double x) {
    double X = x / tr_patch_a(c, P);
    return roll < 0 ? -X : X;
}

double tr_carter_creepage(const tr_patch_pair *c, double P, double q) {
    return F0(c, P) * q / (1 + sqrt(1 - fabs(q)));
}

double tr_carter_q(const tr_patch_pair *c, double P, double xi) {
    double w = xi / F0(c, P);
    return fabs(w) < 1 ? w * (2 - fabs(w)) : copysign(1, w);
}

/* The difference of the two roots, sqrt((1 - X)(1 + X)) - sqrt((2k - 1 - X)(1 + X)) with k = sqrt(1 - |q|), without
 * cancellation: over their sum, 1 - k = |q|/(1 + k). */
double tr_carter_tau(const tr_patch_pair *c, double P, double q, double roll, double x) {
    double X = inward(c, P, roll, x), k = sqrt(1 - fabs(q)), full = c->mu * tr_patch_p0(c, P);
    if (!(fabs(X) < 1)) return 0;
    if (X > 2 * k - 1) return copysign(full * sqrt((1 - X) * (1 + X)), q);
    return full * sqrt(1 + X) * 2 * q / ((1 + k) * (sqrt(1 - X) + sqrt(2 * k - 1 - X)));
}

double tr_carter_slip(const tr_patch_pair *c, double P, double q, double roll, double x) {
    double X = inward(c, P, roll, x), k = sqrt(1 - fabs(q));
    if (!(fabs(X) < 1) || X <= 2 * k - 1) return 0;
    return copysign(F0(c, P) * sqrt((X + 1) * (X + 1 - 2 * k)), q);
}

void tr_carter_stick(const tr_patch_pair *c, double P, double q, double roll, double zone[2]) {
    double a = tr_patch_a(c, P), inner = a * (2 * sqrt(1 - fabs(q)) - 1);
    zone[0] = roll < 0 ? -inner : -a, zone[1] = roll < 0 ? a : inner;
}
