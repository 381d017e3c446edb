/* SPDX-License-Identifier: MIT */
/* Rolling spring-slider with Wang's moments, by any rolling_velocity, that never returns more than it took. A control
 * for the question what of a definition's effect comes from the energy that it makes. Source [Wang2015 eq. 28], made
 * passive here.
 *
 *   T' = T + k_r u dt,   T = clamp(T', -mu_r f_n, +mu_r f_n),   M1 = -R_eff T,   M2 = +R_eff T
 *   u: of V_r and W the one that loads less or unloads more: the smaller of V_r sgn T and W sgn T, times sgn T
 *   from T = 0: the one nearer to 0, if both have one sign; else 0
 *   V_r: the scene's rolling_velocity;   W = R_eff (w1 - w2), on which a pair of moments does work
 *   R_eff = R1 R2/(R1+R2), at a wall R2
 *
 * The two bodies put T W into the contact per second, and the store T^2/(2 k_r) grows by T u per second. T u <= T W
 * always, so no path makes energy, whatever V_r is. Where V_r and W have different signs (only there s1 and s2 can
 * oppose each other) the spring unloads: as in model 2 there is no resistance to such a motion. A step in which T
 * changes its sign unloads to 0, and loads for what is left of the step. With wang u = V_r = W, so it has the bits of
 * wang-spring.
 *
 * History: T [N/m], a quasi-force. Wall: R_eff = R2. v -> 0: a spring. mu_r = 0: nothing.
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

static inline double smaller(double a, double b) {
    return a < b ? a : b;
}

/* Of two speeds the one nearer to 0, if both have one sign; else 0. */
static inline double lesser(double V, double W) {
    double size = smaller(fabs(V), fabs(W));
    return V > 0 && W > 0 ? size : V < 0 && W < 0 ? -size : 0;
}

TR_VECTOR static void step(tr_tile *restrict tile, const tr_law_data *restrict data) {
    const par *p = data->par;
    const double mu_r = p->mu_r, k_dt = p->k_r * tile->dt;
    const double *restrict R2 = tile->R2, *restrict g1 = tile->g1;
    double *restrict T = data->hist[0] + tile->first;
    for (int i = 0; i < tile->n; i++) {
        double V = tile->v_r[i], W = (1 - g1[i]) * tile->s1[i] + g1[i] * tile->s2[i], loads = lesser(V, W);
        double u = T[i] > 0 ? smaller(V, W) : T[i] < 0 ? -smaller(-V, -W) : loads;
        double bound = mu_r * tile->f_n[i], trial = T[i] + k_dt * u, R_eff = g1[i] * R2[i];
        trial = trial * T[i] < 0 ? trial * (loads / u) : trial; /* what is left of the step after T = 0 */
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

/* Where it loads, it loads by W at most, on which its moments do work. */
static tr_stiffness stiffness(const void *par_, const tr_pair_bodies *bodies) {
    const par *p = par_;
    double R_eff = tr_law_R_star(bodies->R1, bodies->R2);
    return (tr_stiffness){.k = p->mu_r > 0 ? p->k_r : 0, .lever1 = R_eff, .lever2 = R_eff};
}

const tr_law tr_rolling_passive_spring = {
    .table = {"passive-spring", "rolling spring with wang-spring's moments by any rolling_velocity, and no energy made",
              params, .n = sizeof params / sizeof *params},
    .source = "[Wang2015 eq. 28]",
    .formula = "T <- T + k_r u dt, clamped to |T| <= mu_r f_n; u is of V_r and W = R_eff (w1 - w2)\n"
               "the one that loads less or unloads more; from T = 0 the lesser, if both have one sign, else 0\n"
               "moments -R_eff T on 1, +R_eff T on 2; R_eff = R1 R2/(R1 + R2), R2 at a wall",
    .differs =
        "The paper gives these moments to every rolling velocity, which makes energy unless it is wang. Here the "
        "spring follows V_r only as far as the work of the moments allows.",
    .claims = TR_OBJECTIVE | TR_BALANCED | TR_ENERGY_CLOSED,
    .n_hist = 1,
    .needs = TR_NEEDS_V_R,
    .step = step,
    .state = state,
    .stiffness = stiffness,
};
