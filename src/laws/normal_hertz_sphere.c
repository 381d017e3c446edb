/* SPDX-License-Identifier: MIT */
/* Contact of spheres, with a dashpot that follows the stiffness. Source [Johnson1985 sec. 4.2].
 *
 *   f_elastic = P = (4/3) E_star sqrt(R) delta^(3/2),   1/R = 1/R1 + 1/R2,   k = dP/ddelta = 2 E_star sqrt(R delta)
 *   f_n = max(0, P + c v_n),   c = 2 damping_ratio sqrt(k m_eff)
 *
 * c goes with delta^(1/4), which makes the restitution the same for every speed [Tsuji1992]: with s = delta^(5/4) for
 * delta, the path v(s) of an impact is that of a linear spring and dashpot of damping ratio sin q = sqrt(6/5)
 * damping_ratio, hence e = exp(-(pi - 2 q) tan q). Contact radius a = sqrt(R delta).
 *
 * delta <= 0: nothing. The force ends when f_n reaches 0, not when delta does.
 */
#include "base/vector.h"
#include "base/math.h"
#include "laws/law.h"
#include "laws/material.h"

#include <math.h>

typedef struct par {
    double E_star, damping_ratio;
} par;

static const tr_param params[] = {
    TR_ROW_E_STAR(par, E_star),
    TR_ROW_DAMPING_RATIO(par, damping_ratio),
};

static void pair(const void *par_, const tr_pair_bodies *bodies, double *constants) {
    const par *p = par_;
    constants[0] = 2 * p->E_star * sqrt(tr_law_R_star(bodies->R1, bodies->R2)); /* k = this sqrt(delta) */
    constants[1] = 2 * p->damping_ratio * sqrt(tr_law_m_eff(bodies));           /* c = this sqrt(k) */
}

TR_VECTOR static void step(tr_tile *restrict tile, const tr_law_data *restrict data) {
    const double *restrict strength = data->pair[0] + tile->first, *restrict damp = data->pair[1] + tile->first;
    for (int i = 0; i < tile->n; i++) {
        double delta = tile->delta[i] > 0 ? tile->delta[i] : 0, k = strength[i] * sqrt(delta);
        double elastic = 2.0 / 3.0 * k * delta, force = elastic + damp[i] * sqrt(k) * tile->v_n[i];
        tile->f_elastic[i] = elastic;
        tile->f_n[i] = force > 0 ? force : 0;
    }
}

static void state(const tr_tile *tile, const tr_law_data *data, double *energy, double *bound) {
    (void)data, (void)bound;
    for (int i = 0; i < tile->n; i++) energy[i] = tile->delta[i] > 0 ? 0.4 * tile->f_elastic[i] * tile->delta[i] : 0;
}

static tr_elastic elastic(const void *par_, double R1, double R2, double delta) {
    const par *p = par_;
    double k = 2 * p->E_star * sqrt(tr_law_R_star(R1, R2) * delta), force = 2.0 / 3.0 * k * delta;
    return (tr_elastic){force, 0.4 * force * delta, k};
}

static double overlap(const void *par_, double R1, double R2, double force) {
    const par *p = par_;
    double x = tr_cbrt(0.75 * force / (p->E_star * sqrt(tr_law_R_star(R1, R2))));
    return x * x;
}

static double slope(const void *par_, double delta, double P) {
    (void)par_;
    return 1.5 * P / delta;
}

static tr_stiffness stiffness(const void *par_, const tr_pair_bodies *b) {
    const par *p = par_;
    double k = elastic(par_, b->R1, b->R2, b->delta).stiffness;
    return (tr_stiffness){.k = k, .c = 2 * p->damping_ratio * sqrt(k * tr_law_m_eff(b))};
}

const tr_law tr_normal_hertz_sphere = {
    .table = {"hertz-sphere", "Hertz contact of spheres and dashpot, no attraction", params,
              .n = sizeof params / sizeof *params, .demands = TR_ONLY_SPHERES | TR_NEEDS_TIME},
    .source = "[Johnson1985] [Tsuji1992]",
    .formula = "f_n = max(0, P + c v_n), P = (4/3) E_star sqrt(R) delta^(3/2), 1/R = 1/R1 + 1/R2\n"
               "c = 2 damping_ratio sqrt(k m_eff), k = dP/ddelta, m_eff = m1 m2/(m1 + m2)",
    .differs = "The force of the dashpot never pulls: a contact ends when f_n reaches 0, not when the overlap does.",
    .claims = TR_OBJECTIVE | TR_BALANCED | TR_ENERGY_CLOSED,
    .n_pair = 2,
    .pair = pair,
    .step = step,
    .state = state,
    .stiffness = stiffness,
    .elastic = elastic,
    .overlap = overlap,
    .slope = slope,
};
