/* SPDX-License-Identifier: MIT */
/* The differential equation of dahlberg-alfredsson over one step in which P is linear and the rates are constant. Let
 * M = mu P be the cap, q = Q/M, and primes derivatives by the time of the step, 0 to 1:
 *
 *   Q' = A - sgn(q) C sqrt(M/M_most) w,   w = 1 - sqrt(1 - |q|),   |Q| <= M
 *
 * Q is cut only at the cap: full slip to the side s lasts while s A - C sqrt(M/M_most) >= M'. There is no
 * closed form. In q the change of M is one more drive, M q' = A - q M' - sgn(q) C sqrt(M/M_most) w. A substep takes M
 * in its middle and q M' at the mean of q before and after,
 *
 *   q_1 = Phi(q_0; (A - M' (q_0 + q_1)/2)/M, C/sqrt(M M_most)),
 *
 * Phi the closed form at constant P (dahlberg_exact.h), which knows full slip, its end and the way through Q = 0. q_1
 * is the only root, because Phi rises with its drive, at most as fast. Without rolling that is Q_1 = Q_0 + A, cut to
 * M_1: the spring.
 *
 * Substeps are symmetric in time, so their error has even powers of their length only: Romberg's table of 1, 2, 4, ...
 * substeps, and halves of the step if it does not settle to 1e-13 of M_most. Pieces end where full slip ends, at s A -
 * C sqrt(M/M_most) = M'; around other kinks they become short. Full slip at the end of a piece is certain only if it
 * began before the last substep. Errors of Q do not grow. For a step that rolls very far only the end counts: earlier
 * motion fades as exp(-C/2) or faster. */
#include "laws/dahlberg_load.h"

#include "laws/dahlberg_exact.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>

enum { LEVELS = 5, PIECES = 2000 }; /* of Romberg's table; at this limit its last value is taken */

static const double SETTLED = 1e-13, HOPELESS = 1e-8, FORGOTTEN = 100; /* exp(-50) */

/* All over M_most; C at M_most. */
typedef struct load {
    double M0, M1, A, C;
    int left; /* pieces */
} load;

static double cap(const load *l, double time) {
    return l->M0 + time * (l->M1 - l->M0);
}

typedef struct substep {
    double q, drive, turn, creep;
} substep;

static double excess(const substep *s, double end) {
    return tr_dahlberg_exact(s->q, 1, s->drive - s->turn * (s->q + end), s->creep) - end;
}

/* Its excess falls from -1 to 1: secants, and halves if these leave the bracket. */
static double end_of(const substep *s) {
    double low = -1, high = 1, x = 1, f = excess(s, 1), next = s->q;
    if (f >= 0) return 1;
    if (excess(s, -1) <= 0) return -1;
    for (int n = 0; n < 100; n++) {
        double before = x, f_before = f;
        x = next > low && next < high ? next : 0.5 * (low + high);
        f = excess(s, x);
        *(f > 0 ? &low : &high) = x;
        next = x - f * (x - before) / (f - f_before);
        if (fabs(f) <= DBL_EPSILON / 4 || high - low <= DBL_EPSILON / 4 || next == x) break;
    }
    return x;
}

/* Also whether full slip began before the last of n substeps, if it ends in full slip. */
static double march(const load *l, double q, double from, double length, int n, bool *sure) {
    double before = q;
    for (int i = 0; i < n; i++) {
        before = q;
        double h = length / n, M0 = cap(l, from + i * h), M1 = cap(l, from + (i + 1) * h), M = 0.5 * (M0 + M1);
        substep s = {q, h * l->A / M, 0.5 * h * (l->M1 - l->M0) / M, h * l->C / sqrt(M)};
        q = end_of(&s);
    }
    *sure = fabs(q) < 1 || before == q;
    return q;
}

static double advance(load *l, double q, double from, double length) {
    double row[LEVELS], last = 0;
    bool sure, was_sure = false;
    for (int k = 0; k < LEVELS; k++, was_sure = sure) {
        double now = march(l, q, from, length, 1 << k, &sure), power = 1;
        for (int j = 0; j < k; j++) {
            double finer = now + (now - row[j]) / ((power *= 4) - 1);
            row[j] = now, now = finer;
        }
        row[k] = now;
        double off = fabs(now - last) * cap(l, from + length);
        if (k > 1 && off <= SETTLED && sure && was_sure) return fmin(fmax(now, -1), 1);
        if (k > 1 && off > HOPELESS) break;
        last = now;
    }
    if (l->left-- <= 0) return fmin(fmax(row[0], -1), 1);
    q = advance(l, q, from, length / 2);
    return advance(l, q, from + length / 2, length / 2);
}

/* The time when full slip to the side of s ends, or would start to last; else 1. */
static double turning_point(const load *l, double s) {
    double change = l->M1 - l->M0, root = (s * l->A - change) / l->C;
    double time = root > 0 ? (root * root - l->M0) / change : 1;
    return time > 0 && time < 1 ? time : 1;
}

double tr_dahlberg_load(double Q, double M0, double M1, double A, double C) {
    const double most = fmax(M0, M1), none = DBL_EPSILON / 4; /* creep below rounding */
    if (M0 == M1) return tr_dahlberg_exact(Q, M1, A, C);
    if (M1 == 0 || C <= none * most) return fmin(fmax(Q + A, -M1), M1);
    const double side = (Q != 0 ? Q : A) < 0 ? -1 : 1; /* so that it is odd to the last bit */
    load l = {M0 / most, M1 / most, fmin(fmax(side * A / most, -1e300), 1e300), fmin(C / most, 1e300), PIECES};
    double q = fmin(M0 > 0 ? side * Q / M0 : l.A, 1); /* of a contact that forms A t/(M' t) */
    if (l.C > FORGOTTEN) {
        double part = FORGOTTEN / l.C;
        bool any;
        q = march(&l, q, 0, 1 - part, 1, &any);
        l.M0 = cap(&l, 1 - part), l.A *= part, l.C = FORGOTTEN;
    }
    double one = turning_point(&l, 1), two = turning_point(&l, -1), first = fmin(one, two), second = fmax(one, two);
    if (first > 0) q = advance(&l, q, 0, first);
    if (second > first) q = advance(&l, q, first, second - first);
    if (second < 1) q = advance(&l, q, second, 1 - second);
    return side * q * M1;
}
