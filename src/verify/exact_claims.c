/* SPDX-License-Identifier: MIT */
/* The claims of every law of the registry: the largest violation of laws that claim it is rounding, the smallest
 * violation of the others is seen. And the cycle of power conjugacy: +du, +dth1, -du, -dth1 of a linear rolling spring
 * makes nothing if its forces are the transpose of its velocity; bagi-kuhn with moments only makes k_r R_eff (R2 -
 * R1)/(2|X21|) du dth1. */
#include "verify/exact.h"
#include "verify/exact_tile.h"

#include "base/alloc.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LEGS = 8, PARTS = 30, STEPS = LEGS * PARTS, COORDINATES = 4, MANY = 40 };
static const double DT = 1e-5, SEEN = 1e-4; /* a violation larger than rounding */

typedef struct bench {
    tr_pairs_tile a, b;
    double felt[2][STEPS][4][TR_PAIRS]; /* force on 2, torques */
} bench;

/* No spin is so slow that a sign law would stop it within a step: that stop depends on the rate. */
static tr_pair_motion on_path(const tr_pairs_tile *p, int step, int i, double speed, double W) {
    static const double w1[LEGS] = {12, -25, 30, 14, -22, -31, 17, 11}, w2[LEGS] = {-20, 9, -13, 28, -33, 15, -26, 21},
                        Vt[LEGS] = {5, -12, 20, 0.3, -9, 15, -3, 10};
    int leg = step / PARTS, part = step % PARTS + 1;
    double rate = leg % 2 ? -0.01 : 0.01, delta = 0.05 + (leg % 2 ? 0.01 : 0) + rate * part / PARTS;
    double v_n = speed * fmin(p->R1[i], p->R2[i]) * rate / (PARTS * DT);
    return (tr_pair_motion){delta, v_n, speed * Vt[leg], speed * w1[leg], speed * w2[leg], W};
}

static void walk(tr_pairs_tile *p, double speed, double W, double (*felt)[4][TR_PAIRS]) {
    for (int step = 0; step < STEPS; step++) {
        for (int i = 0; i < TR_PAIRS; i++) tr_pairs_drive(p, i, on_path(p, step, i, speed, W));
        tr_pairs_run(p, DT / speed);
        const double *now[4] = {p->tile.fx, p->tile.fy, p->tile.q1, p->tile.q2};
        for (int k = 0; k < 4; k++) memcpy(felt[step][k], now[k], sizeof felt[step][k]);
    }
}

/* Largest difference of forces or of torques, over the largest of each. */
static double difference(bench *x) {
    double most[2] = {0}, gap[2] = {0};
    for (int s = 0; s < STEPS; s++)
        for (int k = 0; k < 4; k++)
            for (int i = 0; i < TR_PAIRS; i++) {
                most[k / 2] = fmax(most[k / 2], fabs(x->felt[0][s][k][i]));
                double off = fabs(x->felt[0][s][k][i] - x->felt[1][s][k][i]);
                gap[k / 2] = off <= gap[k / 2] ? gap[k / 2] : off; /* NaN stays */
            }
    return isnan(gap[0] + gap[1]) ? NAN : fmax(gap[0] / most[0], most[1] > 0 ? gap[1] / most[1] : 0);
}

static double against(bench *x, int slot, const tr_law *law, double speed, double faster, double W) {
    tr_pairs_set(&x->a, slot, law), tr_pairs_set(&x->b, slot, law);
    walk(&x->a, speed, 0, x->felt[0]), walk(&x->b, speed * faster, W, x->felt[1]);
    return difference(x);
}
/* A law that depends on the rate may be at its bound all the way at the first speed; slower speeds show the
 * dependence. */
static double of_rate(bench *x, int slot, const tr_law *law) {
    double found = against(x, slot, law, 1, 2, 0);
    for (double speed = 0.1; speed > 1e-7 && found <= SEEN && !(tr_law_claims(law) & TR_RATE_INDEPENDENT); speed *= 0.1)
        found = against(x, slot, law, speed, 2, 0);
    return found;
}
static double of_observer(bench *x, int slot, const tr_law *law) {
    return against(x, slot, law, 1, 1, -50);
}

/* q1 + q2 + X21 x f, of the torques; without any, of the force. */
static double of_balance(bench *x, int slot, const tr_law *law) {
    double worst = 0, scale = 0, force = 0;
    tr_pairs_set(&x->a, slot, law);
    for (int step = 0; step < STEPS; step++) {
        const tr_tile *t = &x->a.tile;
        for (int i = 0; i < TR_PAIRS; i++) tr_pairs_drive(&x->a, i, on_path(&x->a, step, i, 1, 0));
        tr_pairs_run(&x->a, DT);
        for (int i = 0; i < TR_PAIRS; i++) {
            worst = fmax(worst, fabs(t->q1[i] + t->q2[i] + t->dx[i] * t->fy[i] - t->dy[i] * t->fx[i]));
            scale = fmax(scale, fabs(t->q1[i]) + fabs(t->q2[i])), force = fmax(force, hypot(t->fx[i], t->fy[i]));
        }
    }
    return worst / (scale > 0 ? scale : force);
}

/* +x, +y, -x, -y, of 2 along t, spin of 1, spin of 2, overlap: work on the bodies; turned: all that went either way. */
static void cycle(tr_pairs_tile *p, int x, int y, double ax, double ay, double *work, double *turned) {
    double delta[TR_PAIRS], before[TR_PAIRS][4] = {{0}};
    for (int i = 0; i < TR_PAIRS; i++) delta[i] = 0.05, work[i] = turned[i] = 0;
    for (int step = -1; step < 4 * MANY; step++) {
        int leg = step < 0 ? 0 : step / MANY, which = leg % 2 ? y : x;
        double rate = step < 0 ? 0 : (leg % 2 ? ay : ax) * (leg < 2 ? 1 : -1) / (MANY * DT);
        for (int i = 0; i < TR_PAIRS; i++) {
            double by[COORDINATES] = {0}, R = fmin(p->R1[i], p->R2[i]);
            by[which] = rate, delta[i] += by[3] * DT;
            tr_pairs_drive(p, i, (tr_pair_motion){delta[i], R * by[3], R * by[0], by[1], by[2], 0});
        }
        tr_pairs_run(p, step < 0 ? 0 : DT);
        const tr_tile *t = &p->tile;
        for (int i = 0; i < TR_PAIRS; i++) {
            double now[4] = {t->fx[i], t->fy[i], t->q1[i], t->q2[i]}, v[4] = {t->dvx[i], t->dvy[i], t->w1[i], t->w2[i]},
                   gain = 0;
            for (int k = 0; k < 4; k++) gain += 0.5 * (before[i][k] + now[k]) * v[k] * DT, before[i][k] = now[k];
            if (step >= 0) work[i] += gain, turned[i] += fabs(gain);
        }
    }
}

static double of_cycles(bench *x, int slot, const tr_law *law) {
    static const double amplitude[] = {0.002, 0.005, 0.05}; /* below the bounds, at some, beyond all */
    double worst = 0, work[TR_PAIRS], turned[TR_PAIRS];
    for (int c = 0; c < COORDINATES * COORDINATES; c++)
        for (int k = 0; k < 12 && c % COORDINATES != c / COORDINATES; k++) {
            double ax = amplitude[k % 3] * (k / 3 & 1 ? -1 : 1), ay = amplitude[k % 3] * (k / 3 & 2 ? -1 : 1);
            if (c % COORDINATES == 3) ax = copysign(0.03, ax);
            if (c / COORDINATES == 3) ay = copysign(0.03, ay);
            tr_pairs_set(&x->a, slot, law);
            cycle(&x->a, c % COORDINATES, c / COORDINATES, ax, ay, work, turned);
            for (int i = 0; i < TR_PAIRS; i++)
                worst = fmax(worst, work[i] / (turned[i] + 0.01)); /* works: 0.1 to 1e5 J/m */
        }
    return worst;
}

typedef double violation(bench *x, int slot, const tr_law *law);

static bool claim(tr_verify *v, bench *x, unsigned flag, const char *name, violation *of, tr_status *st) {
    const tr_param_catalog *c = tr_laws_catalog();
    const tr_law *const *laws[] = {tr_laws_normal, tr_laws_friction, tr_laws_rolling};
    const int n[] = {c->n_normal, c->n_friction, c->n_rolling};
    double most = 0;
    int claimed = 0, seen = 0, denied = 0;
    char quantity[80], said[80];
    for (int slot = 0; slot < 3; slot++)
        for (int i = 0; i < n[slot]; i++) {
            const tr_law *law = laws[slot][i];
            if (!law->step || law->needs & TR_SOLVED_BY_PATCH) continue;
            double found = of(x, slot, law);
            if (tr_law_claims(law) & flag)
                claimed++, most = found <= most ? most : found; /* NaN stays */
            else
                denied++, seen += found > SEEN;
            if (!tr_verify_go_on(v, st)) return false;
        }
    snprintf(quantity, sizeof quantity, "largest violation, %d laws %s", claimed, name);
    if (!tr_verify_add(
            v, &(tr_verify_row){quantity, "1", 0, most, 1e-9, "rounding, relative to the forces or works", NAN, NULL},
            st))
        return false;
    snprintf(quantity, sizeof quantity, "the others are not %s", name);
    snprintf(said, sizeof said, "shown by %d of %d (violation above 1e-4)", seen, denied);
    return tr_verify_outcome(v, quantity, said, seen == denied && denied > 0, st);
}

bool tr_exact_claims(tr_verify *v, tr_status *st) {
    bench *x = tr_alloc(1, sizeof *x, st);
    bool ok = x && claim(v, x, TR_RATE_INDEPENDENT, "rate-independent", of_rate, st) &&
              claim(v, x, TR_OBJECTIVE, "objective", of_observer, st) &&
              claim(v, x, TR_BALANCED, "balanced", of_balance, st) &&
              claim(v, x, TR_ENERGY_CLOSED, "energy-closed", of_cycles, st);
    free(x);
    return ok;
}

/* ---- the cycle */

bool tr_exact_cycle(tr_verify *v, tr_status *st) {
    static const struct {
        const char *quantity;
        const tr_law *law;
        const char *velocity;
        double sense, made;
    } cycles[] = {{"wang-spring, velocity wang", &tr_rolling_wang_spring, "wang", 1, 0},
                  {"wang-spring, velocity bagi-kuhn", &tr_rolling_wang_spring, "bagi-kuhn", 1, 1},
                  {"the same, run backwards", &tr_rolling_wang_spring, "bagi-kuhn", -1, -1},
                  {"conjugate-spring, velocity bagi-kuhn", &tr_rolling_conjugate_spring, "bagi-kuhn", 1, 0}};
    tr_pairs_tile *p = tr_alloc(1, sizeof *p, st);
    bool ok = p != NULL;
    for (int k = 0; ok && k < 4; k++) {
        double work[TR_PAIRS], turned[TR_PAIRS], got = cycles[k].made;
        const double amount = 1e-3, k_r = 2e6;
        tr_pairs_set(p, TR_ROLLING_SLOT, cycles[k].law);
        p->rolling_velocity = cycles[k].velocity;
        cycle(p, 0, 1, cycles[k].sense * amount, amount, work, turned);
        for (int i = 2; i < TR_PAIRS; i++) { /* the first two are of equal radii */
            double R1 = p->R1[i], R2 = p->R2[i], R = fmin(R1, R2), L = R1 + R2 - 0.05 * R;
            double unit = k_r * R1 * R2 / (R1 + R2) * (R2 - R1) / (2 * L) * R * amount * amount;
            if (fabs(work[i] / unit - cycles[k].made) >= fabs(got - cycles[k].made)) got = work[i] / unit;
        }
        char quantity[80];
        snprintf(quantity, sizeof quantity, "%s", cycles[k].quantity);
        ok = tr_verify_add(
            v, &(tr_verify_row){quantity, "1", cycles[k].made, got, 1e-9, "rounding of works that cancel", NAN, NULL},
            st);
    }
    free(p);
    return ok;
}
