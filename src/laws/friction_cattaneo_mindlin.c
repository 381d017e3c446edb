/* SPDX-License-Identifier: MIT */
/* Friction of an elastic contact that sticks inside and slips outside [Cattaneo1938] [Mindlin1949]: the bed of sliders,
 * see bed.h for formula, history, energy and limits.
 *
 *   virgin, constant P:   Q = mu (P(delta) - P(delta - |u|/(mu kappa))) sgn(u),   full slip at |u| = mu kappa delta
 *   in general:           Q = (1/kappa) int e dP',   |e(s)| <= mu kappa (delta - s)
 *
 * P(delta) is that of the scene's normal law. With hertz-sphere it is Mindlin's Q = mu P (1 - (1 - u/(mu kappa
 * delta))^(3/2)), with hertz-line the exact contact of cylinders. Wall: like the normal law.
 */
#include "laws/bed.h"

typedef struct par {
    tr_bed_par bed;
} par;

static const tr_param params[] = {TR_BED_PARAMS(par)};

static double displacement(tr_bed *bed, const tr_tile *tile, const tr_law_data *data, int i) {
    (void)bed, (void)data;
    return tile->v_s[i] * tile->dt;
}

static void step(tr_tile *tile, const tr_law_data *data) {
    tr_bed_step(tile, data, displacement);
}

const tr_law tr_friction_cattaneo_mindlin = {
    .table = {"cattaneo-mindlin", "elastic contact that slips from its edge, with the memory of its whole path", params,
              .n = sizeof params / sizeof *params},
    .source = "[Cattaneo1938] [Mindlin1949] [Jaeger2005]",
    .formula = "Q = (1/kappa) (P'(0) e(0) + int e(s) P''(s) ds), 0 < s < delta, P(delta) of the normal law\n"
               "e += Vs dt where the contact was, clamped to |e(s)| <= mu kappa (delta - s)\n"
               "virgin: |Q| = mu (P(delta) - P(delta - |u|/(mu kappa)))\n"
               "kappa = (2 - nu)/(2 (1 - nu)) of spheres, 1 of disks",
    .claims = TR_OBJECTIVE | TR_BALANCED | TR_ENERGY_CLOSED,
    .n_hist = TR_BED_HIST,
    .needs = TR_ELASTIC_P,
    .merged = 2,
    .slip = TR_SLIPS_AT_ENDS,
    .step = step,
    .state = tr_bed_state,
    .stiffness = tr_bed_stiffness,
};
