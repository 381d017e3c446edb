/* SPDX-License-Identifier: MIT */
/* Friction laws: the energy in the bed of sliders, and the part of the sliding that creep takes off.
 *
 * Energy. The traction of a pushed contact is mu (p(P) - p(P1)) where Q = mu (P - P1). Turned back from there at
 * constant P, by 2 mu (P - P2), it is mu (2 p(P2) - p(P) - p(P1)). Such sums of Hertz's pressures p do work on sums of
 * Hertz's displacements w, because the kernel along the surface is that across it. With U(P) = P^2 (Lambda + 1/4)/(pi
 * E_star), the work that presses the bodies, and P_i <= P_j:
 *
 *   (1/2) int p(P_i) w(P_j) dx = U(P_i) + P_i (delta(P_j) - delta(P_i))/2
 *
 * Creep. Of the spring of dahlberg-alfredsson k_t (u_slide - u_creep) = Q at any time. In steady rolling u_creep =
 * u_slide, of every law that creeps.
 *
 * Pairs of exact_tile.h: E_star = k_t = 2e6 Pa, mu = 0.3. */
#include "verify/exact.h"
#include "verify/exact_tile.h"

#include "base/alloc.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double E_STAR = 2e6, MU = 0.3, DT = 1e-3;

static tr_law_data data_of(tr_pairs_tile *p) {
    return (tr_law_data){.par = p->par[TR_FRICTION_SLOT],
                         .hist = p->hist_at[TR_FRICTION_SLOT],
                         .pair = p->pair_at[TR_FRICTION_SLOT],
                         .normal = p->law[TR_NORMAL_SLOT],
                         .normal_par = p->par[TR_NORMAL_SLOT],
                         .shape = p->shape};
}

/* ---- energy */

/* A line contact, d as hertz-line has it by default. */
typedef struct line {
    double R_star, d;
} line;

static double Lambda(const line *c, double P) {
    return log(2 * c->d / sqrt(4 * P * c->R_star / (M_PI * E_STAR)));
}
static double overlap(const line *c, double P) {
    return P > 0 ? 2 * P / (M_PI * E_STAR) * (Lambda(c, P) + 0.5) : 0;
}
static double pressed(const line *c, double P) {
    return P > 0 ? P * P * (Lambda(c, P) + 0.25) / (M_PI * E_STAR) : 0;
}
static double force_at(const line *c, double delta) {
    double low = 0, high = M_PI * E_STAR * c->d * c->d / c->R_star / 4; /* a = d/2 */
    for (int i = 0; i < 200; i++) {
        double P = 0.5 * (low + high);
        *(overlap(c, P) < delta ? &low : &high) = P;
    }
    return low;
}

/* Of mu^2 times the sum over all pairs of `part` share_i share_j. */
static double energy_of(const line *c, int n, const double *P, const double *share) {
    double sum = 0;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            double less = fmin(P[i], P[j]), more = fmax(P[i], P[j]);
            sum += share[i] * share[j] * (pressed(c, less) + less * (overlap(c, more) - overlap(c, less)) / 2);
        }
    return MU * MU * sum;
}

/* All pairs: pressed at first, then slid by u[i]. */
static void slide(tr_pairs_tile *p, const double *u, double dt) {
    for (int i = 0; i < TR_PAIRS; i++)
        tr_pairs_drive(p, i, (tr_pair_motion){.delta = 0.05, .Vt = dt > 0 ? u[i] / dt : 0});
    tr_pairs_run(p, dt);
}

static bool energy_row(tr_verify *v, tr_pairs_tile *p, const char *quantity, const double *want, tr_status *st) {
    tr_lane energy, bound;
    tr_law_data d = data_of(p);
    double worst = 0;
    p->law[TR_FRICTION_SLOT]->state(&p->tile, &d, energy, bound);
    for (int i = 0; i < TR_PAIRS; i++) worst = fmax(worst, fabs(energy[i] / want[i] - 1));
    return tr_verify_add(
        v,
        &(tr_verify_row){quantity, "1", 0, worst, 1e-9, "rounding of sums that cancel; pieces keep 1e-12", NAN, NULL},
        st);
}

/* Pushed until all slips, Q is at the declared bound, mu P. */
static bool bound_row(tr_verify *v, tr_pairs_tile *p, tr_status *st) {
    tr_lane energy, bound;
    tr_law_data d = data_of(p);
    double far[TR_PAIRS], worst = 0;
    for (int i = 0; i < TR_PAIRS; i++) far[i] = 1;
    slide(p, far, DT);
    p->law[TR_FRICTION_SLOT]->state(&p->tile, &d, energy, bound);
    for (int i = 0; i < TR_PAIRS; i++) {
        double off = fabs(bound[i] / (MU * p->tile.f_elastic[i]) - 1), of_force = fabs(p->tile.f_t[i] / bound[i] - 1);
        worst = fmax(worst, fmax(off, of_force));
    }
    return tr_verify_add(v,
                         &(tr_verify_row){"full slip: the bound over mu P and Q over it, less 1", "1", 0, worst, 1e-14,
                                          "rounding", NAN, NULL},
                         st);
}

bool tr_exact_bed_energy(tr_verify *v, tr_status *st) {
    static const double none[TR_PAIRS] = {0}, part = 0.6, back = 0.8; /* P1, P2 over P */
    tr_pairs_tile *p = tr_alloc(1, sizeof *p, st);
    double u[2][TR_PAIRS], want[2][TR_PAIRS];
    if (!p) return false;
    tr_pairs_set(p, TR_FRICTION_SLOT, &tr_friction_cattaneo_mindlin);
    for (int i = 0; i < TR_PAIRS; i++) {
        double R1 = p->R1[i], R2 = p->R2[i], delta = 0.05 * fmin(R1, R2);
        line c = {R1 * R2 / (R1 + R2), 2 * sqrt(R1 * R2) / M_E};
        double P = force_at(&c, delta), P1 = part * P, P2 = back * P;
        u[0][i] = MU * (delta - overlap(&c, P1)), u[1][i] = -2 * MU * (delta - overlap(&c, P2));
        want[0][i] = energy_of(&c, 2, (double[]){P, P1}, (double[]){1, -1});
        want[1][i] = energy_of(&c, 3, (double[]){P, P1, P2}, (double[]){-1, -1, 2});
    }
    slide(p, none, 0), slide(p, u[0], DT);
    bool ok = energy_row(v, p, "pushed from rest, largest error over the energy", want[0], st);
    slide(p, u[1], DT);
    ok = ok && energy_row(v, p, "turned back, the same", want[1], st) && bound_row(v, p, st);
    free(p);
    return ok;
}

/* ---- creep */

/* Rolls on with a creepage below F(1) of every pair: after each step the sums of sliding and of the part that creep
 * takes off. */
static void roll(tr_pairs_tile *p, int steps, double way, double *slid, double *crept) {
    const double v = 1;
    tr_lane u;
    for (int i = 0; i < TR_PAIRS; i++) slid[i] = crept[i] = 0;
    for (int k = 0; k < steps; k++) {
        for (int i = 0; i < TR_PAIRS; i++) {
            double R1 = p->R1[i], R2 = p->R2[i], s = way * 0.02 * v; /* w1, w2 for s1 = v + s/2, s2 = v - s/2 */
            tr_pairs_drive(p, i, (tr_pair_motion){.delta = 0.05, .w1 = (v + s / 2) / R1, .w2 = -(v - s / 2) / R2});
        }
        tr_pairs_run(p, DT);
        tr_law_data d = data_of(p);
        p->law[TR_FRICTION_SLOT]->creep(&p->tile, &d, u);
        for (int i = 0; i < TR_PAIRS; i++) slid[i] += p->tile.v_s[i] * DT, crept[i] += u[i];
    }
}

static bool spring_row(tr_verify *v, tr_pairs_tile *p, double way, tr_status *st) {
    double slid[TR_PAIRS], crept[TR_PAIRS], worst = 0;
    tr_pairs_set(p, TR_FRICTION_SLOT, &tr_friction_dahlberg_alfredsson);
    roll(p, 100, way, slid, crept);
    for (int i = 0; i < TR_PAIRS; i++) worst = fmax(worst, fabs(E_STAR * (slid[i] - crept[i]) / p->tile.f_t[i] - 1));
    return tr_verify_add(
        v,
        &(tr_verify_row){way > 0 ? "spring: k_t (slide - creep)/Q - 1, Q > 0" : "spring: the same, Q < 0", "1", 0,
                         worst, 1e-11, "rounding of 100 sums", NAN, NULL},
        st);
}

static bool steady_row(tr_verify *v, tr_pairs_tile *p, const tr_law *law, tr_status *st) {
    double slid[TR_PAIRS], crept[TR_PAIRS], worst = 0;
    char quantity[80];
    tr_pairs_set(p, TR_FRICTION_SLOT, law);
    roll(p, 20000, -1, slid, crept), roll(p, 1, -1, slid, crept);
    for (int i = 0; i < TR_PAIRS; i++) worst = fmax(worst, fabs(crept[i] / slid[i] - 1));
    snprintf(quantity, sizeof quantity, "steady: creep/slide - 1, %s", law->table.name);
    return tr_verify_add(
        v, &(tr_verify_row){quantity, "1", 0, worst, 1e-9, "the transient falls by e in an a or two, of 40", NAN, NULL},
        st);
}

bool tr_exact_creep_books(tr_verify *v, tr_status *st) {
    tr_pairs_tile *p = tr_alloc(1, sizeof *p, st);
    bool ok = p && spring_row(v, p, 1, st) && spring_row(v, p, -1, st);
    for (const tr_law *const *law = tr_laws_friction; ok && law < tr_laws_friction + tr_laws_catalog()->n_friction;
         law++)
        if ((*law)->creep) ok = steady_row(v, p, *law, st);
    free(p);
    return ok;
}
