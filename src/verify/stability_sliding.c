/* SPDX-License-Identifier: MIT */
/* Networks with sliding contacts: growth in the exact equations, separated from growth by the step.
 *
 * Friction that follows the normal force makes K unsymmetric, and two of its eigenvalues may meet and turn complex: the
 * modes couple and swing with growing amplitude, which is flutter [Hoffmann2002]; or one turns negative, and disks are
 * drawn in. This is in x'' + C x' + K x = 0 itself, at any step. Its greatest growth is the spectral radius of e^(A h),
 * with (x, x')' = A (x, x'); that of the leapfrog is the spectral radius of its step,
 *
 *   y <- y - dt^2 K x - dt C y,   x <- x + y,   y = dt v
 *
 * both from powers of the matrices. Without damping an eigenvalue k of K swings with exp(i theta) a step, sin(theta/2)
 * = dt sqrt(k)/2, where the exact theta is dt sqrt(k): where all k are real, positive and below 4/dt^2 nothing grows,
 * so the step adds no mode of its own, and it speeds flutter up by dt^2 k/8 of itself. tests/core/test_flutter.c: one
 * disk, by the roots of a cubic. */
#include "base/alloc.h"
#include "core/timestep.h"
#include "verify/stability.h"
#include "verify/stability_network.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NETWORKS = 300, SIZE = 2 * TR_NETWORK_DOF, POWERS = 36, STEPS = 400 };
static const double TAKEN = 0.4; /* step.safety of assemblies */

/* Slower growth in a step is rounding: motions without force are double roots at 1. */
static const double SLOW = 1e-6;

typedef struct square {
    int n;
    double of[SIZE][SIZE];
} square;

static void multiply(const square *a, const square *b, square *c) {
    c->n = a->n;
    for (int i = 0; i < a->n; i++) {
        for (int j = 0; j < a->n; j++) c->of[i][j] = 0;
        for (int k = 0; k < a->n; k++)
            for (int j = 0; j < a->n; j++) c->of[i][j] += a->of[i][k] * b->of[k][j];
    }
}

static double size_of(const square *a) {
    double most = 0;
    for (int i = 0; i < a->n; i++)
        for (int j = 0; j < a->n; j++) most = fmax(most, fabs(a->of[i][j]));
    return most;
}

/* ln of the spectral radius, by squaring; a and b are used up. */
static double log_radius(square *a, square *b) {
    double sum = 0, part = 1;
    for (int p = 0; p < POWERS; p++, part /= 2) {
        double most = size_of(a);
        sum += part * log(most);
        for (int i = 0; i < a->n; i++)
            for (int j = 0; j < a->n; j++) a->of[i][j] /= most;
        multiply(a, a, b);
        square *swap = a;
        a = b, b = swap;
    }
    return sum;
}

typedef struct room {
    tr_network net;
    square a, b, c, e;
} room;

/* Growth of the leapfrog, a step. */
static double leapfrog(room *r, double dt) {
    int n = 3 * r->net.w.disks.n;
    r->a.n = 2 * n;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            double x = -dt * dt * r->net.K[i][j], y = (i == j) - dt * r->net.C[i][j];
            r->a.of[n + i][j] = x, r->a.of[n + i][n + j] = y;
            r->a.of[i][j] = (i == j) + x, r->a.of[i][n + j] = y;
        }
    return log_radius(&r->a, &r->b);
}

/* Growth of the exact equations in dt: e^(A h) by its series, h = dt/16 so that A h < 1/2, of (x, v dt/2). */
static double exact(room *r, double dt) {
    int n = 3 * r->net.w.disks.n;
    square *a = &r->a, *term = &r->b, *next = &r->c, *e = &r->e;
    a->n = term->n = e->n = 2 * n;
    for (int i = 0; i < 2 * n; i++)
        for (int j = 0; j < 2 * n; j++) a->of[i][j] = 0, term->of[i][j] = e->of[i][j] = i == j;
    for (int i = 0; i < n; i++) {
        a->of[i][n + i] = 2 / 16.0;
        for (int j = 0; j < n; j++) {
            a->of[n + i][j] = -dt * dt / 32 * r->net.K[i][j];
            a->of[n + i][n + j] = -dt / 16 * r->net.C[i][j];
        }
    }
    for (int k = 1; k < 40; k++) {
        multiply(term, a, next);
        square *swap = term;
        term = next, next = swap;
        for (int i = 0; i < 2 * n; i++)
            for (int j = 0; j < 2 * n; j++) term->of[i][j] /= k, e->of[i][j] += term->of[i][j];
    }
    return 16 * log_radius(e, next);
}

typedef struct tally {
    int flutter, added, added_undamped, added_damped, damped, differ;
    double fastest;         /* growth over frequency of a mode at its limit */
    double sped_up, lagged; /* undamped: largest rate at TAKEN over the exact one, less 1; added at 0.99, a step */
} tally;

static bool one(room *r, tally *t, tr_status *st) {
    double bound = tr_timestep_contacts(&r->net.w).dt, a_step;
    if (isinf(bound)) return true;
    bool damped = r->net.zeta > 0;
    double rate = exact(r, bound), near = leapfrog(r, 0.99 * bound), taken = leapfrog(r, TAKEN * bound);
    t->flutter += rate > SLOW, t->damped += damped;
    t->fastest = fmax(t->fastest, rate / 2);
    t->added += rate <= SLOW && taken > SLOW;
    if (rate <= SLOW && near > SLOW) {
        *(damped ? &t->added_damped : &t->added_undamped) += 1;
        t->lagged = fmax(t->lagged, near);
    }
    if (rate > SLOW && !damped) t->sped_up = fmax(t->sped_up, taken / (TAKEN * rate) - 1);
    double tool = tr_network_growth(&r->net, TAKEN * bound, STEPS, &a_step, st);
    t->differ += !(fabs(log(tool / tr_network_linear(&r->net, TAKEN * bound, STEPS))) < 0.05);
    return st->code == TR_OK;
}

static bool say(tr_verify *v, const tally *t, tr_status *st) {
    const tr_verify_row rows[] = {
        {"stable in the exact equations, grow at 0.4 of the bound", "1", 0, t->added, 0, "the step adds no growth", NAN,
         NULL},
        {"the same at 0.99 of the bound, undamped", "1", 0, t->added_undamped, 0, "sin(theta/2) = dt sqrt(k)/2", NAN,
         NULL},
        {"undamped flutter at 0.4 of the bound over the exact one, above 1", "1", 0, t->sped_up,
         1 / sqrt(1 - TAKEN * TAKEN) - 1, "d theta/d(dt sqrt(k)) = 1/sqrt(1 - dt^2 k/4)", NAN, NULL},
        {"networks where leapfrog and its matrix differ", "1", 0, t->differ, 0,
         "ln of the energy to 0.05: contacts turn, P/L = 1e-5 k_n, over 400 steps", NAN, NULL},
    };
    char text[160];
    snprintf(text, sizeof text, "%d of %d grow (flutter), by %.2f of the highest frequency at most", t->flutter,
             NETWORKS, t->fastest);
    bool ok = tr_verify_outcome(v, "the exact equations", text, t->flutter > 0, st);
    for (size_t k = 0; ok && k < sizeof rows / sizeof *rows; k++) ok = tr_verify_add(v, &rows[k], st);
    snprintf(text, sizeof text, "%d of %d grow at 0.99 of the bound, by %.1e a step at most", t->added_damped,
             t->damped, t->lagged);
    return ok &&
           tr_verify_outcome(v, "damped, stable in the exact equations", text, 100 * t->added_damped <= t->damped, st);
}

/* Dashpots see the velocity of half a step before, which may decide at the edge of flutter: one in a hundred at most,
 * as stated before the run. */
bool tr_stability_sliding(tr_verify *v, tr_status *st) {
    room *r = tr_alloc(1, sizeof *r, st);
    tally t = {0};
    bool ok = r != NULL;
    for (int i = 0; ok && i < NETWORKS; i++) {
        ok = tr_verify_go_on(v, st) && tr_network_throw(&r->net, i + 1, NULL, true, st) && one(r, &t, st);
        tr_network_free(&r->net);
    }
    ok = ok && say(v, &t, st);
    free(r);
    return ok;
}
