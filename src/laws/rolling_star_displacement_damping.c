/* SPDX-License-Identifier: MIT */
/* A torsional spring-slider whose stiffness follows the normal force, and a viscous moment. Source [STARCCM eqs.
 * 3277-3278], "displacement damping".
 *
 *   M_k <- M_k - k_r w_rel dt, clamped to |M_k| <= k_r theta_max,   k_r = mu_r R_eq f_n/theta_max,   w_rel = w1 - w2
 *   M_d = -damping_factor C w_rel, times damping_multiplier where |M_k| is at its bound,   C = 2 sqrt(I_r k_r)
 *   1/I_r = 1/(I1 + m1 R1^2) + 1/(I2 + m2 R2^2)
 *   M1 = M_k + M_d (M_d only with damping: yes),   M2 = -M1
 *
 * k_r theta_max = mu_r R_eq f_n. When f_n falls the clamped M_k is stored; but a spring loaded at a high f_n and
 * unloaded at a lower one is softer on its way back and gives more than it took: the law is not energy-closed. The
 * ledger counts the change of M_k^2/(2 k_r) as rolling, where it appears as negative dissipation.
 *
 * differs: eq. 3277's bound has lost its <=, eq. 3278 a symbol; its second branch, |M_k| above the bound, cannot be
 * reached after the clamp and is read as "at the bound". C lacks the square root in print. R_eq: see
 * rolling_star_constant_torque.c. The page gives no default for damping factor and multiplier; we chose off, 0.3 and 1.
 *
 * A prescribed motion is infinite mass. A body that cannot move about the contact point has no part in I_r: a disk with
 * a prescribed centre keeps I, because it still turns; a disk with a prescribed spin leaves the sum; if none is left, C
 * = 0.
 *
 * History: M_k [N]. f_n -> 0: k_r = 0, no moment. Wall: I_r = I2 + m2 R2^2 and R_eq = 2 R2 or R2.
 */
#include "base/vector.h"
#include "laws/law.h"
#include "laws/material.h"

#include <math.h>
#include <stdbool.h>

typedef struct par {
    double mu_r, theta_max, damping_factor, damping_multiplier;
    int R_eq;
    bool damping;
} par;

static const tr_param params[] = {
    TR_ROW_MU_R(par, mu_r, "0.1"),
    {"theta_max", TR_REAL, TR_DIM_NUMBER, "rad", "0.035", 1e-9, 10, NULL, offsetof(par, theta_max),
     "largest angular displacement before rolling"},
    TR_ROW_R_EQ(par, R_eq),
    {"damping", TR_SWITCH, TR_DIM_NUMBER, "", "no", 0, 0, NULL, offsetof(par, damping), "viscous moment"},
    {"damping_factor", TR_REAL, TR_DIM_NUMBER, "1", "0.3", 0, 10, NULL, offsetof(par, damping_factor),
     "viscous moment, as a fraction of critical"},
    {"damping_multiplier", TR_REAL, TR_DIM_NUMBER, "1", "1", 0, 1, NULL, offsetof(par, damping_multiplier),
     "fraction of the viscous moment that stays while the spring is at its bound"},
};

static double about_contact(double I, double m, double R) {
    return isinf(m) ? I : I + m * R * R;
}

/* I_r [kg m] about the contact point. */
static double inertia(const tr_pair_bodies *b) {
    return tr_law_reduced(about_contact(b->I1, b->m1, b->R1), about_contact(b->I2, b->m2, b->R2));
}

static void pair(const void *par_, const tr_pair_bodies *bodies, double *constants) {
    (void)par_;
    constants[0] = inertia(bodies);
}

TR_VECTOR static void step(tr_tile *restrict tile, const tr_law_data *restrict data) {
    const par *p = data->par;
    const double strength = p->mu_r * (p->R_eq ? 1 : 2), per_theta = 1 / p->theta_max, dt = tile->dt;
    const double damp = p->damping ? 2 * p->damping_factor : 0, full = damp * p->damping_multiplier;
    const double *restrict R2 = tile->R2, *restrict g1 = tile->g1, *restrict I_r = data->pair[0] + tile->first;
    double *restrict M_k = data->hist[0] + tile->first;
    for (int i = 0; i < tile->n; i++) {
        double cap = strength * tile->f_n[i] * (g1[i] * R2[i]), k_r = cap * per_theta, w = tile->w1[i] - tile->w2[i];
        double spring = M_k[i] - k_r * w * dt;
        spring = spring > cap ? cap : spring;
        spring = spring < -cap ? -cap : spring;
        double moment = spring - (fabs(spring) < cap ? damp : full) * sqrt(I_r[i] * k_r) * w;
        M_k[i] = spring;
        tile->m1[i] = moment, tile->m2[i] = -moment;
    }
}

/* The bound is that of the spring plus the part of the dashpot. */
static void state(const tr_tile *tile, const tr_law_data *data, double *energy, double *bound) {
    const par *p = data->par;
    for (int i = 0; i < tile->n; i++) {
        double cap = p->mu_r * (p->R_eq ? 1 : 2) * tile->f_n[i] * (tile->g1[i] * tile->R2[i]);
        double M_k = data->hist[0][tile->first + i];
        energy[i] = cap > 0 ? M_k * M_k / (2 * cap) * p->theta_max : 0;
        bound[i] = cap + fabs(tile->m1[i] - M_k);
    }
}

static tr_stiffness stiffness(const void *par_, const tr_pair_bodies *bodies) {
    const par *p = par_;
    double R_eff = tr_law_R_star(bodies->R1, bodies->R2);
    double k = p->mu_r * (p->R_eq ? 1 : 2) * R_eff * bodies->f_n / p->theta_max;
    double c = p->damping ? 2 * p->damping_factor * sqrt(inertia(bodies) * k) : 0;
    return (tr_stiffness){.k = k, .c = c, .lever1 = 1, .lever2 = 1};
}

const tr_law tr_rolling_star_displacement_damping = {
    .table = {"star-displacement-damping", "torsional spring to mu_r R_eq f_n, stiffness following f_n, and dashpot",
              params, .n = sizeof params / sizeof *params, .demands = TR_NEEDS_TIME | TR_NEEDS_DENSITY,
              .demands_if = "damping"},
    .source = "[STARCCM eqs. 3277-3278]",
    .formula = "M_k <- M_k - k_r w_rel dt, |M_k| <= k_r theta_max, k_r = mu_r R_eq f_n/theta_max, w_rel = w1 - w2\n"
               "M_d = -damping_factor C w_rel (damping_multiplier times that at the bound), C = 2 sqrt(I_r k_r)\n"
               "1/I_r = 1/(I1 + m1 R1^2) + 1/(I2 + m2 R2^2); M1 = M_k + M_d, M2 = -M1\n"
               "prescribed centre: only I; prescribed spin: no term; without terms: M_d = 0",
    .differs =
        "Eq. 3277's bound has lost its <=, eq. 3278 a symbol, C its root; the second branch of eq. 3278 cannot be "
        "reached after the clamp and is read as \"at the bound\". R_eq is ambiguous: both readings are choices. "
        "The page gives no defaults for the damping. With damping: yes the law is rate-dependent.",
    .claims = TR_OBJECTIVE | TR_BALANCED,
    .n_hist = 1,
    .n_pair = 1,
    .pair = pair,
    .step = step,
    .state = state,
    .stiffness = stiffness,
};
