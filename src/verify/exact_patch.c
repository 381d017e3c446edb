/* SPDX-License-Identifier: MIT */
/* The inside of a line contact: the half-plane against Cattaneo and Carter, the way between them [Kalker1971], the
 * brush against its closed form: rolling from rest at constant creepage, material at x has been stretched by xi min(L,
 * x + a), so tau = min(mu p, k_w xi min(L, x + a)). */
#include "verify/exact.h"

#include "patch/brush.h"
#include "patch/carter.h"
#include "patch/cattaneo.h"
#include "patch/half_plane.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const tr_patch_pair pair = {.R_star = 0.012, .E_star = 3e9, .d = 0.02, .mu = 0.35};
static const double P = 2e5, q[] = {0.3, 0.6, 0.9};

static bool force(tr_half_plane *o, double share, double dr, tr_status *st) {
    return tr_half_plane_step(o, &(tr_patch_step){.P = P, .dr = dr, .by_force = true, .Q = share * pair.mu * P}, st);
}
static bool slide(tr_half_plane *o, double du, double dr, tr_status *st) {
    return tr_half_plane_step(o, &(tr_patch_step){.P = P, .dr = dr, .du = du}, st);
}

/* Largest difference from Cattaneo's traction, a mean over each element, farther than three elements from the ends of
 * stick, where its root is too steep for an element; over mu p0. */
static double off_cattaneo(const tr_patch_state *s, double share) {
    enum { POINTS = 200 };
    double most = 0, c = sqrt(1 - share), full = pair.mu * tr_patch_p0(&pair, P);
    for (int i = 0; i < s->n; i++) {
        double want = 0;
        if (fabs(fabs(s->x[i]) - c * s->a) < 3 * s->h) continue;
        for (int k = 0; k < POINTS; k++)
            want += tr_cattaneo_tau(&pair, P, share, s->x[i] + ((k + 0.5) / POINTS - 0.5) * s->h) / POINTS;
        most = fmax(most, fabs(s->tau[i] - want) / full);
    }
    return most;
}

bool tr_exact_patch_cattaneo(tr_verify *v, tr_status *st) {
    double u[3][3];
    for (int m = 0; m < 3; m++) {
        tr_half_plane *o = tr_half_plane_new(&pair, 50 << m, st);
        bool ok = o != NULL;
        for (int k = 0; ok && k < 3; k++) {
            char quantity[80];
            ok = tr_half_plane_step(o, &(tr_patch_step){.P = 0}, st) && force(o, q[k], 0, st);
            if (!ok) break;
            u[m][k] = tr_half_plane_state(o)->du;
            if (m < 2) continue;
            double want = tr_cattaneo_u(&pair, P, q[k]);
            snprintf(quantity, sizeof quantity, "traction, largest error, q = %g", q[k]);
            ok = tr_verify_add(v,
                               &(tr_verify_row){quantity, "1", 0, off_cattaneo(tr_half_plane_state(o), q[k]), 1e-3,
                                                "asked: 1e-3 mu p0 at N = 200", NAN, NULL},
                               st);
            snprintf(quantity, sizeof quantity, "sliding, q = %g", q[k]);
            ok = ok && tr_verify_add(v,
                                     &(tr_verify_row){quantity, "m", want, u[2][k], 1e-4 * want,
                                                      "(1/200)^1.5, times where in an element stick ends", NAN, NULL},
                                     st);
        }
        tr_half_plane_free(o);
        if (!ok) return false;
    }
    double error[2] = {0};
    for (int m = 0; m < 2; m++)
        for (int k = 0; k < 3; k++) error[m] += fabs(u[2 * m][k] / tr_cattaneo_u(&pair, P, q[k]) - 1) / 3;
    return tr_verify_add(v,
                         &(tr_verify_row){"sliding, mean relative error", "1", 0, error[1], 1e-4, "(1/200)^1.5",
                                          log2(error[0] / error[1]) / 2, NULL},
                         st);
}

/* Rolled at Carter's creepage by 12 times 2a: Q/(mu P), and the mean error of the traction, over mu p0. */
static bool rolled(int n, double share, double *got, double *off, tr_status *st) {
    double h = 2 * tr_patch_a(&pair, P) / n, xi = tr_carter_creepage(&pair, P, share);
    tr_half_plane *o = tr_half_plane_new(&pair, n, st);
    bool ok = o != NULL;
    for (int i = 0; ok && i < 12 * n; i++) ok = slide(o, xi * h, h, st);
    const tr_patch_state *s = ok ? tr_half_plane_state(o) : NULL;
    if (ok) *got = s->Q / (pair.mu * P), *off = 0;
    for (int i = 0; ok && i < n; i++)
        *off += fabs(s->tau[i] - tr_carter_tau(&pair, P, share, 1, s->x[i])) / (n * pair.mu * tr_patch_p0(&pair, P));
    tr_half_plane_free(o);
    return ok;
}

bool tr_exact_patch_carter(tr_verify *v, tr_status *st) {
    for (int k = 0; k < 3; k++) {
        char quantity[80];
        double q_n[2], off[2];
        snprintf(quantity, sizeof quantity, "steady Q/(mu P) at the creepage of %g", q[k]);
        if (!tr_verify_go_on(v, st) || !rolled(50, q[k], &q_n[0], &off[0], st) ||
            !rolled(100, q[k], &q_n[1], &off[1], st) ||
            !tr_verify_add(v,
                           &(tr_verify_row){quantity, "1", q[k], q_n[1], 6e-3,
                                            "first order: stick ends up to an element off, N = 100",
                                            log2((q_n[0] - q[k]) / (q_n[1] - q[k])), NULL},
                           st))
            return false;
        snprintf(quantity, sizeof quantity, "its traction, mean error, q = %g", q[k]);
        if (!tr_verify_add(v,
                           &(tr_verify_row){quantity, "1", 0, off[1], 6e-3,
                                            "first order: stick ends up to an element off, N = 100",
                                            log2(off[0] / off[1]), NULL},
                           st))
            return false;
    }
    return true;
}

/* L1 distance from the steady state (of the same grid, after 10a) left at a roll of 2a, over that at the start. */
static bool distance(double share, double *left, tr_status *st) {
    enum { N = 200 };
    double begin[N], middle[N], first = 0, now = 0;
    tr_half_plane *o = tr_half_plane_new(&pair, N, st);
    if (!o) return false;
    const tr_patch_state *s = tr_half_plane_state(o);
    bool ok = force(o, share, 0, st);
    if (ok) memcpy(begin, s->tau, sizeof begin);
    for (int i = 0; ok && i < 5 * N; i++) {
        ok = force(o, share, s->h, st);
        if (i == N - 1) memcpy(middle, s->tau, sizeof middle);
    }
    for (int i = 0; ok && i < N; i++) first += fabs(begin[i] - s->tau[i]), now += fabs(middle[i] - s->tau[i]);
    *left = now / first;
    tr_half_plane_free(o);
    return ok;
}

bool tr_exact_patch_kalker(tr_verify *v, tr_status *st) {
    static const double want[] = {0.06, 0.03};
    double left;
    for (int k = 0; k < 3; k++) {
        char quantity[80], said[80];
        if (!tr_verify_go_on(v, st) || !distance(q[k], &left, st)) return false;
        snprintf(quantity, sizeof quantity, "left of the way at 2a, q = %g%s", q[k], k < 2 ? "" : ", below 0.3 %");
        snprintf(said, sizeof said, "%.3f %%", 100 * left);
        if (k < 2
                ? !tr_verify_add(
                      v, &(tr_verify_row){quantity, "1", want[k], left, 0.005, "the digits that are known", NAN, NULL},
                      st)
                : !tr_verify_outcome(v, quantity, said, left < 0.003, st))
            return false;
    }
    return true;
}

/* Of the closed form, lengths over a: k_w xi a/(mu p0) = (pi/2) xi/F0. */
static double brush_q(double ratio, double L) {
    enum { POINTS = 200000 };
    double sum = 0;
    for (int i = 0; i < POINTS; i++) {
        double X = 2 * (i + 0.5) / POINTS - 1;
        sum += fmin(sqrt(1 - X * X), 0.5 * M_PI * ratio * fmin(L, 1 + X)) * 2 / POINTS;
    }
    return sum / (0.5 * M_PI);
}

bool tr_exact_patch_brush(tr_verify *v, tr_status *st) {
    static const double ratio[] = {0.3, 1, 3}, length[] = {0.5, 2};
    const double a = tr_patch_a(&pair, P), F0 = pair.mu * a / pair.R_star;
    for (int c = 0; c < 6; c++) {
        enum { N = 400 };
        double dr = 2 * a / N, want = brush_q(ratio[c / 2], length[c % 2]);
        tr_brush *o = tr_brush_new(&pair, N, 0, st);
        bool ok = o != NULL;
        for (int i = 0; ok && i < (int)lround(length[c % 2] / 2 * N); i++)
            ok = tr_brush_step(o, &(tr_patch_step){.P = P, .dr = dr, .du = ratio[c / 2] * F0 * dr}, st);
        double got = ok ? tr_brush_state(o)->Q / (pair.mu * P) : NAN;
        tr_brush_free(o);
        if (!ok) return false;
        char quantity[80];
        snprintf(quantity, sizeof quantity, "brush, Q/(mu P), creepage %g F0, roll %g a", ratio[c / 2], length[c % 2]);
        if (!tr_verify_add(v,
                           &(tr_verify_row){quantity, "1", want, got, 1e-4,
                                            "(1/400)^2 at the kinks of tau and at the edges", NAN, NULL},
                           st))
            return false;
    }
    return true;
}
