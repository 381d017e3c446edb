/* SPDX-License-Identifier: MIT */
/* Friction that rolling relaxes: a capped tangential spring less the creep of a rolling line contact. Source
 * [Dahlberg2009], as [Kuhn2014 eq. 11]; creep function [Carter1926].
 *
 *   dQ = k_t (du_disp - sgn(Q) F(|Q|/(mu P)) |du_roll|),   |Q| <= mu P
 *   F(q) = F0 (1 - sqrt(1 - q)),   F0 = mu a/R,   a = sqrt(4 P R/(pi E*)),   1/R = 1/R1 + 1/R2
 *
 * du_disp = Vs dt, P = f_n, a from the present P. du_roll: Kuhn's mean flow of material (s1 + s2)/2 dt, or V_r dt of
 * Wang.
 *
 * step: backward-euler, the default, in closed form. With M = mu P, A = Q + k_t du_disp and C = k_t F0 |du_roll| the
 * unknown is |Q| = M w (2 - w), w = 1 - sqrt(1 - q) in [0, 1], of the sign of A:
 *
 *   M w (2 - w) + C w = |A|   =>   w = 2 |A|/(2 M + C + sqrt(C^2 + 4 M (M + C - |A|)))   while |A| < M + C, else w = 1
 *
 * Inside the cap and stable for any step. Q of the step before enters unchanged, even above the present cap: only this
 * step caps.
 *
 * step: exact, the solution of the differential equation over a step of any length, with P linear: the reference for
 * the other. In closed form if P is constant (dahlberg_exact.c), to 1e-12 of mu P if it changes (dahlberg_load.c). It
 * iterates, so it is for kind: contact only. Q is cut only at the cap.
 *
 * differs: eq. 11 as printed has no signs (wrong where Q < 0 or rolling turns back) and is 0/0 at du_disp = 0.
 *
 * History: Q [N/m]; for exact also P at the end of the step before. du_roll = 0: coulomb-spring, bit for bit. P -> 0:
 * a = 0 and Q = 0.
 * Wall: R = R2, material rolls with (Vt - R2 w)/2. Energy Q^2/2 k_t; creep dissipates |Q| F |du_roll|.
 */
#include "base/vector.h"
#include "laws/dahlberg_exact.h"
#include "laws/dahlberg_load.h"
#include "laws/law.h"
#include "laws/material.h"

#include <math.h>

typedef struct par {
    double mu, k_t, E_star;
    int creep_roll, step;
} par;

static const tr_param params[] = {
    TR_ROW_MU(par, mu, 0),
    TR_ROW_K_T(par, k_t),
    TR_ROW_E_STAR(par, E_star),
    TR_ROW_CREEP_ROLL(par, creep_roll),
    {"step", TR_CHOICE, TR_DIM_NUMBER, "", "backward-euler", 0, 0, "backward-euler|exact", offsetof(par, step),
     "how a step is solved: backward-euler, of first order; exact, for kind: contact only"},
};

/* C of a tile, without the factor that differs between contacts. */
typedef struct creep {
    double factor; /* C = factor sqrt(P/R) |v_roll| */
    double wang;   /* v_roll has s2 with the weight 1/2 for kuhn, g1 for wang */
} creep;

static creep creep_of(const par *p, double dt) {
    return (creep){p->mu * (p->k_t * dt) * sqrt(4 / (M_PI * p->E_star)), p->creep_roll ? 1 : 0};
}

static inline double creep_at(creep c, const tr_tile *tile, int i, double P) {
    double weight = 0.5 + c.wang * (tile->g1[i] - 0.5);
    double v_roll = (1 - weight) * tile->s1[i] + weight * tile->s2[i];
    return c.factor * sqrt(P / (tile->g1[i] * tile->R2[i])) * fabs(v_roll);
}

TR_VECTOR static void backward_euler(tr_tile *restrict tile, const par *restrict p, double *restrict Q) {
    const double mu = p->mu, k_dt = p->k_t * tile->dt;
    const creep c = creep_of(p, tile->dt);
    for (int i = 0; i < tile->n; i++) {
        double M = mu * tile->f_n[i], C = creep_at(c, tile, i, tile->f_n[i]);
        double A = Q[i] + k_dt * tile->v_s[i], room = M + C - fabs(A);
        double inside = room > 0 ? room : 0, below = 2 * M + C + sqrt(C * C + 4 * M * inside);
        double w = 2 * fabs(A) / (below > 0 ? below : 1), partial = C > 0 ? M * (w * (2 - w)) : fabs(A);
        double size = room > 0 ? partial : M;
        size = A < 0 ? -size : size;
        Q[i] = size;
        tile->f_t[i] = size;
    }
}

static void exact(tr_tile *tile, const par *p, double *Q, double *P_before) {
    const creep c = creep_of(p, tile->dt);
    for (int i = 0; i < tile->n; i++) {
        double P0 = P_before[i], P1 = tile->f_n[i], A = p->k_t * tile->dt * tile->v_s[i];
        tile->f_t[i] = Q[i] = tr_dahlberg_load(Q[i], p->mu * P0, p->mu * P1, A, creep_at(c, tile, i, fmax(P0, P1)));
        P_before[i] = P1;
    }
}

static void step(tr_tile *tile, const tr_law_data *data) {
    const par *p = data->par;
    double *Q = data->hist[0] + tile->first;
    if (p->step)
        exact(tile, p, Q, data->hist[1] + tile->first);
    else
        backward_euler(tile, p, Q);
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

static void crept(const tr_tile *tile, const tr_law_data *data, double *u) {
    const par *p = data->par;
    const creep c = creep_of(p, tile->dt);
    for (int i = 0; i < tile->n; i++) {
        double P = tile->f_n[i], q = P > 0 ? fmin(1, fabs(tile->f_t[i]) / (p->mu * P)) : 0;
        u[i] = copysign((1 - sqrt(1 - q)) * creep_at(c, tile, i, P) / p->k_t, tile->f_t[i]);
    }
}

static tr_stiffness stiffness(const void *par_, const tr_pair_bodies *bodies) {
    const par *p = par_;
    (void)bodies;
    return (tr_stiffness){.k = p->mu > 0 ? p->k_t : 0};
}

const tr_law tr_friction_dahlberg_alfredsson = {
    .table = {"dahlberg-alfredsson", "capped spring that creeps while the bodies roll", params,
              .n = sizeof params / sizeof *params, .demands = TR_ONLY_DISKS, .driver_choice = "exact"},
    .source = "[Dahlberg2009] [Kuhn2014 eq. 11] [Carter1926]",
    .formula = "dQ = k_t (Vs dt - sgn(Q) F(|Q|/(mu P)) |du_roll|), |Q| <= mu P, P = f_n\n"
               "F(q) = (mu a/R) (1 - sqrt(1 - q)), a = sqrt(4 P R/(pi E_star)), 1/R = 1/R1 + 1/R2\n"
               "step: backward-euler in closed form, or the exact solution, P linear and rates constant over the step",
    .differs = "Eq. 11 is printed without signs (wrong where Q < 0 or rolling turns back) and is 0/0 where nothing "
               "slides.",
    .claims = TR_OBJECTIVE | TR_BALANCED | TR_ENERGY_CLOSED,
    .n_hist = 1, /* and one more for exact */
    .slip = TR_SLIPS_TRAILING,
    .step = step,
    .state = state,
    .creep = crept,
    .stiffness = stiffness,
};
