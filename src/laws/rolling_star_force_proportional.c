/* SPDX-License-Identifier: MIT */
/* A moment against each body's own spin. Source [STARCCM eq. 3275], "force proportional".
 *
 *   M_p = -mu_r f_n |r_c| w_p/|w_p|
 *
 * |r_c|: arm from the centre of p to the contact point, r1 or r2. As documented it is not objective (w_p is the
 * absolute spin: disks that only turn with an observer are braked) and not balanced (each body has its own moment:
 * angular momentum is made and lost).
 *
 * A sign law chatters at w = 0. So M_p = clamp(-I_p w*_p/dt, -cap, +cap): the moment that stops the spin within this
 * step, if the cap allows it. w*_p is the spin at the end of the step with only this contact's friction torque -r_p Q:
 * I_p w*_p/dt = I_p w_p/dt - r_p Q. Each of the z possible contacts of a body stops I_p/z, so that together they do not
 * reverse the spin.
 *
 * differs: eq. 3275 is printed without the minus.
 *
 * History: M1, M2 [N], only so that reading with dt = 0 gives the moments of the step. A prescribed spin: I infinite,
 * the whole moment against it at any speed. w -> 0: a stop without chatter. Wall: no arm, no moment. No energy is
 * stored.
 */
#include "base/vector.h"
#include "laws/law.h"
#include "laws/material.h"

#include <math.h>

typedef struct par {
    double mu_r;
} par;

static const tr_param params[] = {
    TR_ROW_MU_R(par, mu_r, "0.001"),
};

/* Parts of the inertias [kg m], and 1 if friction changes the spin. A prescribed spin is not stopped: the body counts
 * as very heavy, but not infinitely, because at rest it has no moment. */
static void pair(const void *par_, const tr_pair_bodies *bodies, double *constants) {
    (void)par_;
    bool given1 = bodies->on_path || isinf(bodies->I1), given2 = bodies->on_path || isinf(bodies->I2);
    constants[0] = given1 ? 1e200 : bodies->I1 / (bodies->z1 > 1 ? bodies->z1 : 1);
    constants[1] = given2 ? 1e200 : bodies->I2 / (bodies->z2 > 1 ? bodies->z2 : 1);
    constants[2] = given1 ? 0 : 1;
    constants[3] = given2 ? 0 : 1;
}

TR_VECTOR static void step(tr_tile *restrict tile, const tr_law_data *restrict data) {
    const par *p = data->par;
    const double mu_r = p->mu_r, dt = tile->dt, per_dt = dt > 0 ? 1 / dt : 0, keep = dt > 0 ? 0 : 1;
    const double *restrict I1 = data->pair[0] + tile->first, *restrict I2 = data->pair[1] + tile->first;
    const double *restrict share1 = data->pair[2] + tile->first, *restrict share2 = data->pair[3] + tile->first;
    double *restrict M1 = data->hist[0] + tile->first, *restrict M2 = data->hist[1] + tile->first;
    for (int i = 0; i < tile->n; i++) {
        double r1 = tile->r1[i], r2 = tile->r2[i], cap1 = mu_r * tile->f_n[i] * fabs(r1),
               cap2 = mu_r * tile->f_n[i] * r2;
        double a = keep * M1[i] - per_dt * (I1[i] * tile->w1[i] - share1[i] * dt * (r1 * tile->f_t[i]));
        double b = keep * M2[i] - per_dt * (I2[i] * tile->w2[i] - share2[i] * dt * (r2 * tile->f_t[i]));
        a = a > cap1 ? cap1 : a;
        a = a < -cap1 ? -cap1 : a;
        b = b > cap2 ? cap2 : b;
        b = b < -cap2 ? -cap2 : b;
        M1[i] = a, M2[i] = b;
        tile->m1[i] = a, tile->m2[i] = b;
    }
}

static void state(const tr_tile *tile, const tr_law_data *data, double *energy, double *bound) {
    const par *p = data->par;
    for (int i = 0; i < tile->n; i++) {
        energy[i] = 0;
        double r1 = fabs(tile->r1[i]); /* below 0 of a ring */
        bound[i] = p->mu_r * tile->f_n[i] * (r1 > tile->r2[i] ? r1 : tile->r2[i]);
    }
}

static tr_stiffness stiffness(const void *par_, const tr_pair_bodies *bodies) {
    (void)par_, (void)bodies;
    return (tr_stiffness){0};
}

const tr_law tr_rolling_star_force_proportional = {
    .table = {"star-force-proportional", "moment mu_r f_n times the arm, against each body's own spin", params,
              .n = sizeof params / sizeof *params},
    .source = "[STARCCM eq. 3275]",
    .formula = "M_p = -mu_r f_n |r_c| w_p/|w_p| on each body p, |r_c| its arm to the contact point\n"
               "at w_p = 0 the moment that stops the spin within the step",
    .differs = "Eq. 3275 is printed without the minus. Neither objective nor balanced, as documented by its source.",
    .claims = TR_ENERGY_CLOSED,
    .needs = TR_NEEDS_Z,
    .n_hist = 2,
    .n_pair = 4,
    .pair = pair,
    .step = step,
    .state = state,
    .stiffness = stiffness,
};
