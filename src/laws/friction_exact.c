/* SPDX-License-Identifier: MIT */
/* The exact contact among the laws: no formula for Q, but the tractions inside, solved by patch/half_plane.c. Only the
 * driver of kind: contact has it, to overlay it with the laws that are in assemblies; laws/ does not see patch/. */
#include "laws/law.h"

typedef struct par {
    double mu, E_star, depth;
    int elements;
} par;

static const tr_param params[] = {
    {"mu", TR_REAL, TR_DIM_NUMBER, "1", NULL, 1e-9, 100, NULL, offsetof(par, mu), "friction coefficient"},
    {"E_star", TR_REAL, TR_DIM_MODULUS, "Pa", NULL, 1e-3, 1e15, NULL, offsetof(par, E_star),
     "contact modulus, 1/E_star = sum of (1 - nu^2)/E of the two"},
    {"depth", TR_REAL, TR_DIM_LENGTH, "m", "0", 0, 1e6, NULL, offsetof(par, depth),
     "d of the tangential displacement; 0: that of the disks, 2 sqrt(R1 R2)/e"},
    {"elements", TR_COUNT, TR_DIM_NUMBER, "", "200", 3, 4000, NULL, offsetof(par, elements),
     "elements across the contact"},
};

const tr_law tr_friction_exact = {
    .table = {"exact", "the half-plane: tractions inside the contact, solved at each step", params,
              .n = sizeof params / sizeof *params, .demands = TR_ONLY_DISKS | TR_ONLY_DRIVER},
    .source = "[Kalker1971]",
    .formula = "du_disp = slip + u_n(x) - u_{n-1}(x - du_roll), |tau| <= mu p(x), Q = int tau dx\n"
               "u(x) = (2/(pi E_star)) int tau(s) ln(d/|x - s|) ds, p of Hertz, elements of constant tau",
    .claims = TR_OBJECTIVE | TR_BALANCED | TR_ENERGY_CLOSED,
    .needs = TR_SOLVED_BY_PATCH,
};
