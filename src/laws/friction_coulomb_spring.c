/* SPDX-License-Identifier: MIT */
/* Coulomb friction behind a tangential spring. Source [Cundall1979].
 *
 *   Q' = Q + k_t Vs dt,   f_t = Q = clamp(Q', -mu f_n, +mu f_n)
 *
 * History: Q [N/m]. The clamped value is stored, so a spring that slides keeps the stretch it can hold; no force, no
 * history. Friction on body 2 is -Q t. v -> 0: a spring. mu = 0: nothing.
 */
#include "base/vector.h"
#include "laws/law.h"
#include "laws/material.h"

typedef struct par {
    double mu, k_t;
} par;

static const tr_param params[] = {
    TR_ROW_MU(par, mu, 0),
    TR_ROW_K_T(par, k_t),
};

TR_VECTOR static void step(tr_tile *restrict tile, const tr_law_data *restrict data) {
    const par *p = data->par;
    const double mu = p->mu, k_dt = p->k_t * tile->dt;
    double *restrict Q = data->hist[0] + tile->first;
    for (int i = 0; i < tile->n; i++) {
        double bound = mu * tile->f_n[i], trial = Q[i] + k_dt * tile->v_s[i];
        trial = trial > bound ? bound : trial;
        trial = trial < -bound ? -bound : trial;
        Q[i] = trial;
        tile->f_t[i] = trial;
    }
}

TR_VECTOR static void state(const tr_tile *restrict tile, const tr_law_data *restrict data, double *restrict energy,
                            double *restrict bound) {
    const par *p = data->par;
    const double half_per_k = 0.5 / p->k_t, mu = p->mu;
    for (int i = 0; i < tile->n; i++) {
        energy[i] = tile->f_t[i] * tile->f_t[i] * half_per_k;
        bound[i] = mu * tile->f_n[i];
    }
}

static tr_stiffness stiffness(const void *par_, const tr_pair_bodies *bodies) {
    const par *p = par_;
    (void)bodies;
    return (tr_stiffness){.k = p->mu > 0 ? p->k_t : 0};
}

const tr_law tr_friction_coulomb_spring = {
    .table = {"coulomb-spring", "tangential spring capped at mu f_n", params, .n = sizeof params / sizeof *params},
    .source = "[Cundall1979]",
    .formula = "Q <- Q + k_t Vs dt, clamped to |Q| <= mu f_n; force on body 2: -Q t",
    .claims = TR_OBJECTIVE | TR_BALANCED | TR_ENERGY_CLOSED,
    .n_hist = 1,
    .step = step,
    .state = state,
    .stiffness = stiffness,
};
