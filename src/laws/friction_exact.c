/* SPDX-License-Identifier: MIT */
/* The exact contact among the laws: no formula for Q, but the tractions inside, solved by patch/half_plane.c. Only the
 * driver of kind: contact has it, to compare it with the laws of assemblies; laws/ does not see patch/. */
#include "laws/law.h"
#include "laws/material.h"

typedef struct par {
    double mu, E_star, depth;
    int elements;
} par;

static const tr_param params[] = {
    TR_ROW_MU(par, mu, 1e-9),
    TR_ROW_E_STAR(par, E_star),
    TR_ROW_DEPTH(par, depth),
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
