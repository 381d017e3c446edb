/* SPDX-License-Identifier: MIT */
/* Rolling spring-slider. Source [Wang2015 eq. 28] [Luding2008].
 *
 *   T' = T + k_r V_r dt,   T = clamp(T', -mu_r f_n, +mu_r f_n)
 *   M1 = -R_eff T,   M2 = +R_eff T,   R_eff = R1 R2/(R1+R2)
 *
 * T is a quasi-force [N/m] (history); the two bodies feel opposite moments and no force. V_r: the scene's rolling
 * velocity. With wang the power is -T V_r exactly. With the other definitions it is not: driven around a closed cycle
 * of sliding and rolling, bagi-kuhn makes or loses energy; the ledger counts made energy separately from the net.
 *
 * differs: eq. 28 compares a torque with a force and stops incrementing at the bound, which locks; here the trial value
 * is clamped. The lever is not printed by Wang; R_eff makes T conjugate to V_r. At a wall R_eff = R2.
 */
#include "base/vector.h"
#include "laws/law.h"
#include "laws/material.h"

typedef struct par {
    double mu_r, k_r;
} par;

static const tr_param params[] = {
    TR_ROW_MU_R(par, mu_r, NULL),
    TR_ROW_K_R(par, k_r),
};

TR_VECTOR static void step(tr_tile *restrict tile, const tr_law_data *restrict data) {
    const par *p = data->par;
    const double mu_r = p->mu_r, k_dt = p->k_r * tile->dt;
    const double *restrict R2 = tile->R2, *restrict g1 = tile->g1;
    double *restrict T = data->hist[0] + tile->first;
    for (int i = 0; i < tile->n; i++) {
        double bound = mu_r * tile->f_n[i], trial = T[i] + k_dt * tile->v_r[i], R_eff = g1[i] * R2[i];
        trial = trial > bound ? bound : trial;
        trial = trial < -bound ? -bound : trial;
        T[i] = trial;
        tile->m1[i] = -R_eff * trial;
        tile->m2[i] = R_eff * trial;
    }
}

TR_VECTOR static void state(const tr_tile *restrict tile, const tr_law_data *restrict data, double *restrict energy,
                            double *restrict bound) {
    const par *p = data->par;
    const double *restrict T = data->hist[0] + tile->first, half_per_k = 0.5 / p->k_r, mu_r = p->mu_r;
    for (int i = 0; i < tile->n; i++) {
        energy[i] = T[i] * T[i] * half_per_k;
        bound[i] = mu_r * tile->f_n[i] * tile->g1[i] * tile->R2[i];
    }
}

static tr_stiffness stiffness(const void *par_, const tr_pair_bodies *bodies) {
    const par *p = par_;
    double R_eff = tr_law_R_star(bodies->R1, bodies->R2);
    return (tr_stiffness){.k = p->mu_r > 0 ? p->k_r : 0, .lever1 = R_eff, .lever2 = R_eff};
}

const tr_law tr_rolling_wang_spring = {
    .table = {"wang-spring", "rolling spring capped at mu_r f_n, lever R_eff", params,
              .n = sizeof params / sizeof *params},
    .source = "[Wang2015 eq. 28] [Luding2008]",
    .formula = "T <- T + k_r V_r dt, clamped to |T| <= mu_r f_n\n"
               "moments -R_eff T on 1, +R_eff T on 2; R_eff = R1 R2/(R1 + R2), R2 at a wall",
    .differs =
        "Eq. 28 compares a torque with a force and stops incrementing at the bound, which locks; here the trial "
        "value is clamped. The lever is not printed; R_eff makes T conjugate to rolling_velocity: wang, for which "
        "the claim on energy is made.",
    .claims = TR_OBJECTIVE | TR_BALANCED | TR_ENERGY_CLOSED,
    .n_hist = 1,
    .needs = TR_NEEDS_V_R,
    .step = step,
    .state = state,
    .stiffness = stiffness,
};
