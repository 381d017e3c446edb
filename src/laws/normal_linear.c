/* SPDX-License-Identifier: MIT */
/* Linear spring and dashpot along the line of centres, without attraction. Source [Cundall1979].
 *
 *   f_elastic = k_n delta,   f_n = max(0, k_n delta + c v_n),   c = 2 zeta sqrt(k_n m_eff),   m_eff = m1 m2/(m1+m2)
 *
 * delta <= 0: nothing. The force ends when f_n reaches 0, not when delta does: the spring never pulls.
 */
#include "base/vector.h"
#include "laws/law.h"
#include "laws/material.h"

#include <math.h>

typedef struct par {
    double k_n, damping_ratio;
} par;

static const tr_param params[] = {
    {"k_n", TR_REAL, TR_DIM_STIFFNESS, "Pa|N/m", NULL, 1e-3, 1e15, NULL, offsetof(par, k_n), "normal stiffness"},
    TR_ROW_DAMPING_RATIO(par, damping_ratio),
};

static double dashpot(const par *p, const tr_pair_bodies *b) {
    return 2 * p->damping_ratio * sqrt(p->k_n * tr_law_m_eff(b));
}

static void pair(const void *par_, const tr_pair_bodies *bodies, double *constants) {
    constants[0] = dashpot(par_, bodies);
}

TR_VECTOR static void step(tr_tile *restrict tile, const tr_law_data *restrict data) {
    const par *p = data->par;
    const double k = p->k_n, *restrict c = data->pair[0] + tile->first;
    for (int i = 0; i < tile->n; i++) {
        double delta = tile->delta[i], elastic = delta > 0 ? k * delta : 0, force = elastic + c[i] * tile->v_n[i];
        force = force > 0 ? force : 0;
        tile->f_elastic[i] = elastic;
        tile->f_n[i] = delta > 0 ? force : 0;
    }
}

TR_VECTOR static void state(const tr_tile *restrict tile, const tr_law_data *restrict data, double *restrict energy,
                            double *restrict bound) {
    const par *p = data->par;
    (void)bound;
    for (int i = 0; i < tile->n; i++) energy[i] = tile->f_elastic[i] * tile->f_elastic[i] / (2 * p->k_n);
}

static tr_stiffness stiffness(const void *par_, const tr_pair_bodies *bodies) {
    const par *p = par_;
    return (tr_stiffness){.k = p->k_n, .c = dashpot(p, bodies)};
}

static tr_elastic elastic(const void *par_, double R1, double R2, double delta) {
    const par *p = par_;
    (void)R1, (void)R2;
    return (tr_elastic){p->k_n * delta, p->k_n * delta * delta / 2, p->k_n};
}

static double overlap(const void *par_, double R1, double R2, double force) {
    const par *p = par_;
    (void)R1, (void)R2;
    return force / p->k_n;
}

static double slope(const void *par_, double delta, double P) {
    const par *p = par_;
    (void)delta, (void)P;
    return p->k_n;
}

const tr_law tr_normal_linear = {
    .table = {"linear", "linear spring and dashpot, no attraction", params, .n = sizeof params / sizeof *params,
              .demands = TR_NEEDS_TIME},
    .source = "[Cundall1979]",
    .formula = "f_n = max(0, k_n delta + c v_n), c = 2 damping_ratio sqrt(k_n m_eff), m_eff = m1 m2/(m1 + m2)",
    .differs = "The force of the dashpot never pulls: a contact ends when f_n reaches 0, not when the overlap does.",
    .claims = TR_OBJECTIVE | TR_BALANCED | TR_ENERGY_CLOSED,
    .n_pair = 1,
    .pair = pair,
    .step = step,
    .state = state,
    .stiffness = stiffness,
    .elastic = elastic,
    .overlap = overlap,
    .slope = slope,
};
