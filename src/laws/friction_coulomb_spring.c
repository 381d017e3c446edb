/* SPDX-License-Identifier: MIT */
/* Coulomb friction behind a tangential spring, with an optional dashpot beside the spring. Source [Cundall1979].
 *
 *   Q' = clamp(Q + k_t Vs dt, -mu f_n, +mu f_n),   f_t = clamp(Q' + c Vs, -mu f_n, +mu f_n)
 *   Q = Q' less what was above the bound, at least 0 of it;   c = 2 tangential_damping_ratio sqrt(k_t m_eff)
 *
 * History: Q [N/m], the force of the spring. The clamped value is stored, so a spring that slides keeps the stretch it
 * can hold; no force, no history. Friction on body 2 is -f_t t. Without the dashpot (the default) f_t = Q. v -> 0: a
 * spring. mu = 0: nothing.
 *
 * THE DASHPOT IS INSIDE OF THE BOUND. Where spring and dashpot together would exceed mu f_n, the spring gives way, so
 * that both together are mu f_n [Luding2008]. It gives way to 0 and no further: a fast dashpot that stretched the
 * spring the other way would store energy that nothing has spent. What is left of the dashpot then has the sign of Vs
 * and at most c Vs, so it only takes energy, at any speed.
 */
#include "base/vector.h"
#include "laws/law.h"
#include "laws/material.h"

typedef struct par {
    double mu, k_t, damping;
} par;

static const tr_param params[] = {
    TR_ROW_MU(par, mu, 0),
    TR_ROW_K_T(par, k_t),
    {"tangential_damping_ratio", TR_REAL, TR_DIM_NUMBER, "1", "0", 0, 10, NULL, offsetof(par, damping),
     "tangential dashpot, as a share of critical damping of the pair, sqrt(4 k_t m_eff); 0: none"},
};

enum { DASHPOT, N_PAIR };

static double dashpot(const par *p, const tr_pair_bodies *b) {
    return 2 * p->damping * sqrt(p->k_t * tr_law_m_eff(b));
}

static void pair(const void *par_, const tr_pair_bodies *bodies, double *constants) {
    constants[DASHPOT] = dashpot(par_, bodies);
}

static inline double clamp(double x, double least, double most) {
    x = x > most ? most : x;
    return x < least ? least : x;
}

/* The spring's force at the end of the step. */
static inline double stretched(double Q, double k_du, double bound) {
    return clamp(Q + k_du, -bound, bound);
}

TR_VECTOR static void spring(tr_tile *restrict tile, const tr_law_data *restrict data) {
    const par *p = data->par;
    const double mu = p->mu, k_dt = p->k_t * tile->dt;
    double *restrict Q = data->hist[0] + tile->first;
    for (int i = 0; i < tile->n; i++) {
        double bound = mu * tile->f_n[i], trial = stretched(Q[i], k_dt * tile->v_s[i], bound);
        Q[i] = trial;
        tile->f_t[i] = trial;
    }
}

TR_VECTOR static void spring_and_dashpot(tr_tile *restrict tile, const tr_law_data *restrict data) {
    const par *p = data->par;
    const double mu = p->mu, k_dt = p->k_t * tile->dt;
    const double *restrict c = data->pair[DASHPOT] + tile->first;
    double *restrict Q = data->hist[0] + tile->first;
    for (int i = 0; i < tile->n; i++) {
        double bound = mu * tile->f_n[i], trial = stretched(Q[i], k_dt * tile->v_s[i], bound);
        double both = trial + c[i] * tile->v_s[i], f_t = clamp(both, -bound, bound);
        Q[i] = clamp(trial - (both - f_t), trial < 0 ? trial : 0, trial > 0 ? trial : 0);
        tile->f_t[i] = f_t;
    }
}

static void step(tr_tile *tile, const tr_law_data *data) {
    const par *p = data->par;
    (p->damping > 0 ? spring_and_dashpot : spring)(tile, data);
}

TR_VECTOR static void state(const tr_tile *restrict tile, const tr_law_data *restrict data, double *restrict energy,
                            double *restrict bound) {
    const par *p = data->par;
    const double half_per_k = 0.5 / p->k_t, mu = p->mu, *restrict Q = data->hist[0] + tile->first;
    for (int i = 0; i < tile->n; i++) {
        energy[i] = Q[i] * Q[i] * half_per_k;
        bound[i] = mu * tile->f_n[i];
    }
}

static tr_stiffness stiffness(const void *par_, const tr_pair_bodies *bodies) {
    const par *p = par_;
    return p->mu > 0 ? (tr_stiffness){.k = p->k_t, .c = dashpot(p, bodies)} : (tr_stiffness){0};
}

const tr_law tr_friction_coulomb_spring = {
    .table = {"coulomb-spring", "tangential spring capped at mu f_n, with an optional dashpot", params,
              .n = sizeof params / sizeof *params, .demands = TR_NEEDS_TIME | TR_NEEDS_DENSITY,
              .demands_if = "tangential_damping_ratio"},
    .source = "[Cundall1979]",
    .formula = "Q <- Q + k_t Vs dt, clamped to |Q| <= mu f_n; force on body 2: -Q t\n"
               "with tangential_damping_ratio: force -(Q + c Vs) t, clamped to mu f_n as a whole, c = 2 ratio sqrt(k_t "
               "m_eff);\n"
               "where it is clamped, the spring Q gives way, at most to 0",
    .claims = TR_OBJECTIVE | TR_BALANCED | TR_ENERGY_CLOSED,
    .n_hist = 1,
    .n_pair = N_PAIR,
    .pair = pair,
    .step = step,
    .state = state,
    .stiffness = stiffness,
};
