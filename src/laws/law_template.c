/* SPDX-License-Identifier: MIT */
/* The start for a new law. It is built and tested, but it is not in the registry: no scene can choose it.
 *
 * Copy this file to KIND_NAME.c (normal_, friction_ or rolling_). At its end rename tr_law_template to tr_KIND_NAME and
 * delete the line `extern`. Add KIND_NAME to the list of its kind in laws.c. Then replace each part, also this comment:
 * formula, limits, differences from the source, history. src/README.md says which tests to run.
 *
 * Rolling spring and dashpot. Source [Luding2008].
 *
 *   S <- S + k_r V_r dt, clamped to |S| <= mu_r f_n          spring [N/m]
 *   T  = S + c V_r,      clamped to |T| <= mu_r f_n          c = 2 rolling_damping sqrt(k_r I)/R_eff
 *   M1 = -R_eff T,   M2 = +R_eff T                           R_eff = R1 R2/(R1 + R2),   1/I = 1/I1 + 1/I2
 *
 * Two disks that roll on each other below the bound swing like a mass on a damped spring: V_r' = -R_eff^2 T/I, so
 * rolling_damping is the fraction of critical damping. T lies between S and S + c V_r: the dashpot never drives.
 *
 * Limits. rolling_damping = 0: the bits of wang-spring. Slow rolling: the spring. Fast: mu_r f_n. f_n -> 0: no moment.
 * Wall (R1 -> infinity): R_eff = R2, I = I2. Both spins prescribed: no dashpot.
 *
 * differs: if the sum is at its bound, the source sets the spring to the bound less c V_r; here S has its own clamp.
 *
 * History: S [N/m].
 */
#include "base/vector.h"
#include "laws/law.h"
#include "laws/material.h"

#include <math.h>

/* The parameters, SI. A double for TR_REAL, an int for TR_CHOICE and TR_COUNT, a bool for TR_SWITCH. */
typedef struct par {
    double mu_r, k_r, rolling_damping;
} par;

/* One row for each of them: key, type, dimension, unit (disks|spheres), default as a scene would say it (NULL: a scene
 * must give it), least, greatest, choices, place, meaning. Scenes, the resolved case and `trundle laws` read the rows.
 * If other laws have the same quantity, take their key: then a scene gives it once. */
static const tr_param params[] = {
    TR_ROW_MU_R(par, mu_r, NULL),
    TR_ROW_K_R(par, k_r),
    {"rolling_damping", TR_REAL, TR_DIM_NUMBER, "1", "0.3", 0, 10, NULL, offsetof(par, rolling_damping),
     "rolling dashpot, as a fraction of critical damping of the pair"},
};

enum { SPRING, N_HIST };  /* numbers that a contact keeps from step to step; all 0 when it forms */
enum { DASHPOT, N_PAIR }; /* numbers that follow from the two bodies; made when the contact is listed */

static double dashpot(const par *p, const tr_pair_bodies *b) {
    return 2 * p->rolling_damping * sqrt(p->k_r * tr_law_reduced(b->I1, b->I2)) / tr_law_R_star(b->R1, b->R2);
}

static void pair(const void *par_, const tr_pair_bodies *bodies, double *constants) {
    constants[DASHPOT] = dashpot(par_, bodies);
}

/* One loop without branches and calls, so that it becomes vector code. It reads and writes the lanes of tr_tile, see
 * law.h. With dt = 0 it must change no history: pictures and records ask for the forces in this way. If f_n = 0, forces
 * and history become 0. */
TR_VECTOR static void step(tr_tile *restrict tile, const tr_law_data *restrict data) {
    const par *p = data->par;
    const double mu_r = p->mu_r, k_dt = p->k_r * tile->dt;
    const double *restrict R2 = tile->R2, *restrict g1 = tile->g1, *restrict c = data->pair[DASHPOT] + tile->first;
    double *restrict S = data->hist[SPRING] + tile->first;
    for (int i = 0; i < tile->n; i++) {
        double bound = mu_r * tile->f_n[i], spring = S[i] + k_dt * tile->v_r[i], R_eff = g1[i] * R2[i];
        spring = spring > bound ? bound : spring;
        spring = spring < -bound ? -bound : spring;
        double T = spring + c[i] * tile->v_r[i];
        T = T > bound ? bound : T;
        T = T < -bound ? -bound : T;
        S[i] = spring;
        tile->m1[i] = -R_eff * T;
        tile->m2[i] = R_eff * T;
    }
}

/* For the energy ledger and the pictures: energy in the contact [N], and the bound on |m1| and |m2| [N]; for a friction
 * law the bound on |f_t| [N/m]. */
TR_VECTOR static void state(const tr_tile *restrict tile, const tr_law_data *restrict data, double *restrict energy,
                            double *restrict bound) {
    const par *p = data->par;
    const double *restrict S = data->hist[SPRING] + tile->first, half_per_k = 0.5 / p->k_r, mu_r = p->mu_r;
    for (int i = 0; i < tile->n; i++) {
        energy[i] = S[i] * S[i] * half_per_k;
        bound[i] = mu_r * tile->f_n[i] * tile->g1[i] * tile->R2[i];
    }
}

/* For the time step: the largest stiffness and damping, in the coordinate of the law. Here V_r = R_eff (w1 - w2). */
static tr_stiffness stiffness(const void *par_, const tr_pair_bodies *bodies) {
    const par *p = par_;
    double R_eff = tr_law_R_star(bodies->R1, bodies->R2);
    bool acts = p->mu_r > 0;
    return (tr_stiffness){
        .k = acts ? p->k_r : 0, .c = acts ? dashpot(p, bodies) : 0, .lever1 = R_eff, .lever2 = R_eff};
}

extern const tr_law tr_law_template; /* laws.c declares those of the registry; this line goes */

const tr_law tr_law_template = {
    .table = {"template", "rolling spring and dashpot, capped at mu_r f_n, lever R_eff", params,
              .n = sizeof params / sizeof *params,
              /* It depends on the rate and on the inertia of the bodies; a prescribed path must give both. */
              .demands = TR_NEEDS_TIME | TR_NEEDS_DENSITY},
    .source = "[Luding2008]",
    .formula = "S <- S + k_r V_r dt, clamped to |S| <= mu_r f_n\n"
               "T = S + c V_r, clamped to |T| <= mu_r f_n, c = 2 rolling_damping sqrt(k_r I)/R_eff, 1/I = 1/I1 + 1/I2\n"
               "moments -R_eff T on 1, +R_eff T on 2; R_eff = R1 R2/(R1 + R2), R2 at a wall",
    .differs = "Where the sum is at its bound the source sets the spring to the bound less c V_r; here S is clamped by "
               "itself.",
    /* A test shows that each claim holds, and that it fails for laws that do not make it. Without TR_NEEDS_TIME above,
     * the law also claims to be rate-independent. */
    .claims = TR_OBJECTIVE | TR_BALANCED | TR_ENERGY_CLOSED,
    .n_hist = N_HIST,
    .n_pair = N_PAIR,
    .needs = TR_NEEDS_V_R, /* passes that must run before this one */
    .pair = pair,
    .step = step,
    .state = state,
    .stiffness = stiffness,
};
