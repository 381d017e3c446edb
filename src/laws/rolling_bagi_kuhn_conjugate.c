/* SPDX-License-Identifier: MIT */
/* Rolling spring-slider on the mean flow of material, (s1 + s2)/2, with the forces that are conjugate to it. Source
 * [Wang2015 eqs. 16, 19a, 28]; velocity as in [Kuhn2014 eq. 5].
 *
 *   T' = T + k_r V_r dt,   T = clamp(T', -mu_r f_n, +mu_r f_n),   V_r = (s1 + s2)/2
 *
 * Forces must be the transpose of the velocity map, or closed cycles make energy. By the motion of the two bodies
 *
 *   V_r = R1 w1/2 - R2 w2/2 + (R1 - R2)/(2L) Vt = R_eff (w1 - w2) + (R1 - R2)/(2L) Vs,   L = |X21|, R_eff =
 * R1R2/(R1+R2)
 *
 * so T turns 1 by -R1 T/2 and 2 by +R2 T/2 and pulls 2 along t with +T (R2 - R1)/(2L), 1 with the opposite. The second
 * form says the same with balanced moments: -R_eff T on 1, +R_eff T on 2, and a force f_r = T (R1 - R2)/(2L) that acts
 * at the contact point as friction does, -f_r t on 2. This is what m1, m2 and f_r hold. Power is -T V_r; momentum and
 * angular momentum are kept. f_r is not bounded by mu f_n.
 *
 * differs: the sources give this velocity to a pure pair of moments, which is not conjugate to it where radii differ.
 *
 * History: T [N/m]. Wall (R1 -> infinity): V_r = (Vt - R2 w2)/2, f_r = T/2, moment R2 T on 2. v -> 0: a spring.
 */
#include "base/vector.h"
#include "laws/law.h"

typedef struct par {
    double mu_r, k_r;
} par;

static const tr_param params[] = {
    {"mu_r", TR_REAL, TR_DIM_NUMBER, "1", NULL, 0, 100, NULL, offsetof(par, mu_r), "coefficient of rolling resistance"},
    {"k_r", TR_REAL, TR_DIM_STIFFNESS, "Pa|N/m", "k_t", 1e-3, 1e15, NULL, offsetof(par, k_r), "rolling stiffness"},
};

/* (R1 - R2)/(2L) = (g1 - 1/2) R2/r2, also at a wall, where g1 = 1 and r2 = R2. */
TR_VECTOR static void step(tr_tile *restrict tile, const tr_law_data *restrict data) {
    const par *p = data->par;
    const double mu_r = p->mu_r, k_dt = p->k_r * tile->dt;
    const double *restrict R2 = tile->R2, *restrict g1 = tile->g1;
    double *restrict T = data->hist[0] + tile->first;
    for (int i = 0; i < tile->n; i++) {
        double bound = mu_r * tile->f_n[i], trial = T[i] + k_dt * (0.5 * (tile->s1[i] + tile->s2[i]));
        double R_eff = g1[i] * R2[i];
        trial = trial > bound ? bound : trial;
        trial = trial < -bound ? -bound : trial;
        T[i] = trial;
        tile->m1[i] = -R_eff * trial;
        tile->m2[i] = R_eff * trial;
        tile->f_r[i] = (g1[i] - 0.5) * (R2[i] / tile->r2[i]) * trial;
    }
}

TR_VECTOR void tr_resultant_rolling_force(tr_tile *restrict tile, const tr_law_data *data) {
    (void)data;
    for (int i = 0; i < tile->n; i++) {
        double along = tile->f_t[i] + tile->f_r[i];
        tile->fx[i] = tile->f_n[i] * tile->nx[i] - along * tile->ny[i];
        tile->fy[i] = tile->f_n[i] * tile->ny[i] + along * tile->nx[i];
        tile->q1[i] = tile->m1[i] - tile->r1[i] * along;
        tile->q2[i] = tile->m2[i] - tile->r2[i] * along;
    }
}

TR_VECTOR static void state(const tr_tile *restrict tile, const tr_law_data *restrict data, double *restrict energy,
                            double *restrict bound) {
    const par *p = data->par;
    const double *restrict T = data->hist[0] + tile->first, half_per_k = 0.5 / p->k_r, mu_r = p->mu_r;
    for (int i = 0; i < tile->n; i++) {
        energy[i] = T[i] * T[i] * half_per_k;
        bound[i] = mu_r * tile->f_n[i] * (tile->g1[i] * tile->R2[i]);
    }
}

static tr_stiffness stiffness(const void *par_, const tr_pair_bodies *bodies) {
    const par *p = par_;
    double R1 = bodies->R1, R2 = bodies->R2, L = R1 + R2 - bodies->delta;
    return (tr_stiffness){
        .k = p->mu_r > 0 ? p->k_r : 0, .lever1 = R1 / 2, .lever2 = R2 / 2, .along = R1 > 0 ? (R1 - R2) / (2 * L) : 0.5};
}

const tr_law tr_rolling_bagi_kuhn_conjugate = {
    .table = {"bagi-kuhn-conjugate", "rolling spring on (s1 + s2)/2 with the force and moments conjugate to it", params,
              .n = sizeof params / sizeof *params},
    .source = "[Wang2015 eqs. 16, 19a, 28] [Kuhn2014 eq. 5]",
    .formula = "T <- T + k_r V_r dt, clamped to |T| <= mu_r f_n, V_r = (s1 + s2)/2 whatever rolling_velocity is\n"
               "in all: moments -R1 T/2 on 1, +R2 T/2 on 2, force T (R2 - R1)/(2 |X21|) t on 2, the opposite on 1",
    .differs =
        "The sources give this velocity to a pure pair of moments, which makes energy in closed cycles where the "
        "radii differ; the force along t is what was missing.",
    .claims = TR_RATE_INDEPENDENT | TR_OBJECTIVE | TR_BALANCED | TR_ENERGY_CLOSED,
    .n_hist = 1,
    .needs = TR_GIVES_F_R,
    .step = step,
    .state = state,
    .stiffness = stiffness,
};
