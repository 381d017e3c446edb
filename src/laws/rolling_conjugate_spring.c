/* SPDX-License-Identifier: MIT */
/* Rolling spring-slider with forces that are conjugate to the scene's rolling_velocity, for any definition. Source
 * [Wang2015 eq. 28] [Luding2008].
 *
 *   T' = T + k_r V_r dt,   T = clamp(T', -mu_r f_n, +mu_r f_n),   V_r = p1 s1 + p2 s2,   p1 = dV_r/ds1, p2 = dV_r/ds2
 *
 * Forces must be the transpose of the velocity map, or closed cycles make energy. By the motion of the two bodies
 *
 *   V_r = p1 R1 w1 - p2 R2 w2 + (p1 R1 - p2 R2)/L Vt,   L = |X21|
 *
 * so T turns 1 by -p1 R1 T and 2 by +p2 R2 T and pulls 2 along t with -T (p1 R1 - p2 R2)/L, 1 with the opposite. With
 * the part s of wang's velocity and a rest of sliding,
 *
 *   V_r = s R_eff (w1 - w2) + e (s1 - s2),   s = p1 + p2, e = g1 s - p2, R_eff = R1R2/(R1+R2)
 *
 * the same forces are balanced moments -s R_eff T on 1, +s R_eff T on 2, and a force f_r = e T (R1+R2)/L that acts as
 * friction does with arms R_i L/(R1+R2), -f_r t on 2. This is what m1, m2 and f_r hold; of wang e = 0. The power is
 * -T V_r; momentum and angular momentum are kept. f_r is not bounded by mu f_n, so |f_t + f_r| may exceed it. Friction
 * may have other arms (contact.arms); f_r keeps these, and so its power.
 *
 * SWITCHING. For alonso-* p1 and p2 jump when the case changes. The step does work by the mean of the forces at its
 * two ends, (T p + T' p')/2, so T is stretched by the mean of the old and the new case: a switch then takes
 * k_r dt^2 (b^2 - a^2)/8, where a and b are the velocities by the old and the new case. With only the new case it would
 * take T (a - b) dt/2, and the sum of that does not fall with dt. If T = 0, only the new case counts. The bound on the
 * step is the smallest of all cases; it holds within a case and does not cover switching.
 *
 * History: T [N/m], p1, p2. Wall (R1 -> infinity): g1 = 1, R_eff = R2, f_r = p1 T. v -> 0: a spring, the case as it is.
 */
#include "laws/rolling_conjugate_spring.h"

#include "base/vector.h"
#include "laws/material.h"

typedef struct par {
    double mu_r, k_r;
} par;

static const tr_param params[] = {
    TR_ROW_MU_R(par, mu_r, NULL),
    TR_ROW_K_R(par, k_r),
};

enum { T_, P1, P2, N_HIST };

TR_VECTOR static void step(tr_tile *restrict tile, const tr_law_data *restrict data) {
    const par *p = data->par;
    const double mu_r = p->mu_r, k_dt = p->k_r * tile->dt;
    const double *restrict R1 = tile->R1, *restrict R2 = tile->R2, *restrict g1 = tile->g1;
    double *restrict T = data->hist[T_] + tile->first, *restrict old1 = data->hist[P1] + tile->first,
                     *restrict old2 = data->hist[P2] + tile->first;
    for (int i = 0; i < tile->n; i++) {
        double new1 = tile->p1[i], new2 = tile->p2[i];
        double mean1 = T[i] != 0 ? 0.5 * (old1[i] + new1) : new1, mean2 = T[i] != 0 ? 0.5 * (old2[i] + new2) : new2;
        double bound = mu_r * tile->f_n[i], trial = T[i] + k_dt * (mean1 * tile->s1[i] + mean2 * tile->s2[i]);
        trial = trial > bound ? bound : trial;
        trial = trial < -bound ? -bound : trial;
        double share = new1 + new2, moment = g1[i] * R2[i] * share * trial;
        double per_L = (R1[i] + R2[i]) / tr_tile_length(tile, i);
        T[i] = trial, old1[i] = bound > 0 ? new1 : 0, old2[i] = bound > 0 ? new2 : 0;
        tile->m1[i] = -moment;
        tile->m2[i] = moment;
        tile->f_r[i] = (g1[i] * share - new2) * per_L * trial;
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

TR_VECTOR void tr_resultant_rolling_apart(tr_tile *restrict tile, const tr_law_data *data) {
    (void)data;
    for (int i = 0; i < tile->n; i++) {
        double along = tile->f_t[i] + tile->f_r[i], L = tr_tile_length(tile, i), shared1 = tile->g1[i] * L;
        shared1 = tile->g1[i] != 1 ? shared1 : 0;
        tile->fx[i] = tile->f_n[i] * tile->nx[i] - along * tile->ny[i];
        tile->fy[i] = tile->f_n[i] * tile->ny[i] + along * tile->nx[i];
        tile->q1[i] = tile->m1[i] - tile->r1[i] * tile->f_t[i] - shared1 * tile->f_r[i];
        tile->q2[i] = tile->m2[i] - tile->r2[i] * tile->f_t[i] - (L - shared1) * tile->f_r[i];
    }
}

/* The bound is that of share 1, which every definition has that rolls at all. */
TR_VECTOR static void state(const tr_tile *restrict tile, const tr_law_data *restrict data, double *restrict energy,
                            double *restrict bound) {
    const par *p = data->par;
    const double *restrict T = data->hist[T_] + tile->first, half_per_k = 0.5 / p->k_r, mu_r = p->mu_r;
    for (int i = 0; i < tile->n; i++) {
        energy[i] = T[i] * T[i] * half_per_k;
        bound[i] = mu_r * tile->f_n[i] * tile->g1[i] * tile->R2[i];
    }
}

/* As part and rest, so that wang has the bits of wang-spring. */
static tr_stiffness stiffness(const void *par_, const tr_pair_bodies *b) {
    const par *p = par_;
    const double R1 = b->R1, R2 = b->R2, g1 = R1 != 0 ? R1 / (R1 + R2) : 1, share = b->p1 + b->p2,
                 e = g1 * share - b->p2;
    const double R_eff = tr_law_R_star(R1, R2);
    return (tr_stiffness){.k = p->mu_r > 0 ? p->k_r : 0,
                          .lever1 = share * R_eff + e * R1,
                          .lever2 = share * R_eff - e * R2,
                          .along = R1 != 0 ? e * (R1 + R2) / (R1 + R2 - b->delta) : e};
}

const tr_law tr_rolling_conjugate_spring = {
    .table = {"conjugate-spring", "rolling spring with the force and moments conjugate to any rolling_velocity", params,
              .n = sizeof params / sizeof *params},
    .source = "[Wang2015 eq. 28] [Luding2008]",
    .formula = "T <- T + k_r V_r dt, clamped to |T| <= mu_r f_n; V_r = p1 s1 + p2 s2 by rolling_velocity\n"
               "total: moments -p1 R1 T on 1, +p2 R2 T on 2, force -T (p1 R1 - p2 R2)/|X21| t on 2, the opposite on 1\n"
               "if the case of alonso-* changes in a step, p1 and p2 of V_r are the mean of both cases",
    .differs =
        "The sources give every velocity to a pure pair of moments, which makes energy in closed cycles unless it is "
        "wang; the force along t is what was missing. It has no bound of its own: |f_t + f_r| may exceed mu f_n. The "
        "bound on the step takes the case of rolling_velocity that allows least and does not cover switching between "
        "cases.",
    .claims = TR_OBJECTIVE | TR_BALANCED | TR_ENERGY_CLOSED,
    .n_hist = N_HIST,
    .needs = TR_NEEDS_V_R | TR_NEEDS_PARTIALS | TR_GIVES_F_R,
    .step = step,
    .state = state,
    .stiffness = stiffness,
};
