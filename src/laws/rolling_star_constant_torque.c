/* SPDX-License-Identifier: MIT */
/* A constant moment against the relative spin. Source [STARCCM eq. 3276], "constant torque".
 *
 *   M1 = -mu_r R_eq f_n w_rel/|w_rel|,   M2 = -M1,   w_rel = w1 - w2
 *   moment limiter (off unless chosen): |M| <= limiter_factor min(I1 |w1|, I2 |w2|)/dt, walls skipped
 *
 * A sign law chatters at w_rel = 0. So M1 = clamp(-I_red w*_rel/dt, -cap, +cap), 1/I_red = 1/I1 + 1/I2: the moment that
 * stops the relative spin within this step, if the cap allows it. w* is the spin at the end of the step with only this
 * contact's friction torque, w*_1 = w1 - dt r1 Q/I1 and w*_2 = w2 - dt r2 Q/I2. Several contacts of one body do not
 * know each other, and together would reverse its spin again and again. So each stops only I/z of a body with z
 * contacts: I_red w_rel becomes w_rel/(z1/I1 + z2/I2).
 *
 * differs: R_eq, "the harmonic mean of the radii", is 2 R1R2/(R1+R2) literally and R1R2/(R1+R2) in common use: a
 * choice. The limiter's "angular momentum" is read as a moment, "the lesser of the two rotations" as the lesser of I
 * |w|. With the limiter the law is neither rate-independent nor objective, and a disk beside one at rest feels nothing.
 *
 * History: M1 [N], only so that reading with dt = 0 gives the moments of the step. w_rel -> 0: a stop without chatter.
 * Wall: I1 infinite, R_eq = 2 R2 or R2. A prescribed spin: I infinite, skipped by the limiter. No energy is
 * stored.
 */
#include "base/vector.h"
#include "laws/law.h"
#include "laws/material.h"

#include <math.h>
#include <stdbool.h>

typedef struct par {
    double mu_r, limiter_factor;
    int R_eq;
    bool limiter;
} par;

static const tr_param params[] = {
    TR_ROW_MU_R(par, mu_r, "0.1"),
    TR_ROW_R_EQ(par, R_eq),
    {"limiter", TR_SWITCH, TR_DIM_NUMBER, "", "no", 0, 0, NULL, offsetof(par, limiter), "moment limiter"},
    {"limiter_factor", TR_REAL, TR_DIM_NUMBER, "1", "0.08", 0, 1, NULL, offsetof(par, limiter_factor),
     "fraction of the moment that stops the smaller rotation in one step"},
};

/* 1/I of both [1/(kg m)]; 0 if the spin is prescribed, as for a wall. If both are, no spin is stopped: they count as
 * infinitely heavy, and friction (factor 0) does not change their spins. */
static void pair(const void *par_, const tr_pair_bodies *bodies, double *constants) {
    (void)par_;
    bool both = bodies->on_path || (isinf(bodies->I1) && isinf(bodies->I2));
    constants[0] = both ? 1e-200 : 1 / bodies->I1;
    constants[1] = both ? 1e-200 : 1 / bodies->I2;
    constants[2] = both ? 0 : 1;
    int z1 = bodies->z1 > 1 ? bodies->z1 : 1, z2 = bodies->z2 > 1 ? bodies->z2 : 1;
    constants[3] = (constants[0] + constants[1]) / (z1 * constants[0] + z2 * constants[1]);
}

TR_VECTOR static void step(tr_tile *restrict tile, const tr_law_data *restrict data) {
    const par *p = data->par;
    const double dt = tile->dt, per_dt = dt > 0 ? 1 / dt : 0, keep = dt > 0 ? 0 : 1, huge = 1e300;
    const double strength = p->mu_r * (p->R_eq ? 1 : 2); /* cap = strength f_n R1R2/(R1+R2) */
    const double limited = p->limiter ? p->limiter_factor * per_dt : 0, unlimited = p->limiter && dt > 0 ? 0 : huge;
    const double *restrict R2 = tile->R2, *restrict g1 = tile->g1;
    const double *restrict J1 = data->pair[0] + tile->first, *restrict J2 = data->pair[1] + tile->first;
    const double *restrict share = data->pair[2] + tile->first, *restrict part = data->pair[3] + tile->first;
    double *restrict M = data->hist[0] + tile->first;
    for (int i = 0; i < tile->n; i++) {
        double w1 = tile->w1[i], w2 = tile->w2[i], cap = strength * tile->f_n[i] * (g1[i] * R2[i]);
        double turn = part[i] * (w1 - w2) - share[i] * dt * (tile->r1[i] * J1[i] - tile->r2[i] * J2[i]) * tile->f_t[i];
        double L1 = J1[i] > 0 ? fabs(w1) / J1[i] : huge, L2 = J2[i] > 0 ? fabs(w2) / J2[i] : huge;
        double limit = limited * (L1 < L2 ? L1 : L2) + unlimited, trial = keep * M[i] - per_dt * turn / (J1[i] + J2[i]);
        cap = cap < limit ? cap : limit;
        trial = trial > cap ? cap : trial;
        trial = trial < -cap ? -cap : trial;
        M[i] = trial;
        tile->m1[i] = trial, tile->m2[i] = -trial;
    }
}

static void state(const tr_tile *tile, const tr_law_data *data, double *energy, double *bound) {
    const par *p = data->par;
    for (int i = 0; i < tile->n; i++) {
        energy[i] = 0;
        bound[i] = p->mu_r * (p->R_eq ? 1 : 2) * tile->f_n[i] * (tile->g1[i] * tile->R2[i]);
    }
}

static tr_stiffness stiffness(const void *par_, const tr_pair_bodies *bodies) {
    (void)par_, (void)bodies;
    return (tr_stiffness){0};
}

const tr_law tr_rolling_star_constant_torque = {
    .table = {"star-constant-torque", "moment mu_r R_eq f_n against the relative spin", params,
              .n = sizeof params / sizeof *params},
    .source = "[STARCCM eq. 3276]",
    .formula = "M1 = -mu_r R_eq f_n w_rel/|w_rel|, M2 = -M1, w_rel = w1 - w2; at w_rel = 0: stopped within the step\n"
               "limiter: |M| <= limiter_factor min(I1 |w1|, I2 |w2|)/dt, walls skipped",
    .differs =
        "The \"harmonic mean\" R_eq is ambiguous: both readings are choices. The limiter's \"angular momentum\" is "
        "read as a moment and \"the lesser of the two rotations\" as the lesser of I |w|; it is off unless chosen, "
        "and with it the law is neither rate-independent nor objective.",
    .claims = TR_OBJECTIVE | TR_BALANCED | TR_ENERGY_CLOSED,
    .needs = TR_NEEDS_Z,
    .n_hist = 1,
    .n_pair = 4,
    .pair = pair,
    .step = step,
    .state = state,
    .stiffness = stiffness,
};
