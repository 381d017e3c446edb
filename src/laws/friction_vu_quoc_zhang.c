/* SPDX-License-Identifier: MIT */
/* Friction of an elastic contact whose displacement fades while it rolls: Vu-Quoc and Zhang [VuQuoc1999], as described
 * in [Kuhn2014 sec. 2.3].
 *
 *   dQ = C^-1(du'), du' = du_disp - (2/pi) (|du_roll|/a) u, |u| <= mu kappa delta, C^-1: cattaneo-mindlin, see bed.h
 *   spheres: a = cbrt(3 P R/(4 E*)), disks: a = sqrt(4 P R/(pi E*)), 1/R = 1/R1 + 1/R2
 *
 * u is the accumulated effective displacement: the sum of du' without full slip. This is the strain e(0) of the bed, so
 * it needs no extra memory. Steady rolling at the creepage xi = du_disp/du_roll settles at u = (pi/2) xi a. Rolling
 * without sliding brings u to 0, but Q a little beyond, by Masing's rule to f(u) - 2 f(u/2), f the virgin curve. Then
 * the store grows a little without work, from energy that it lost before; no closed cycle gains
 * (tests/laws/test_claims.c). A step takes du_disp and |du_roll| at constant rates, with the P of its end:
 *
 *   du' = (du_disp/c - u) (1 - e^-c),   c = (2/pi) |du_roll|/a
 *
 * which is exact at constant P and stable for any step.
 *
 * differs: Kuhn does not say whether u is the total or the effective displacement. With the total one, steady rolling
 * never settles: the term grows without bound.
 *
 * du_roll = 0: cattaneo-mindlin, bit for bit. P -> 0: Q = 0. Wall: R = R2, material rolls with (Vt - R2 w)/2.
 */
#include "laws/creep.h"
#include "base/math.h"

static const tr_param params[] = {TR_CREEP_PARAMS(tr_creep_par)};

static double displacement(tr_bed *bed, const tr_tile *tile, const tr_law_data *data, int i) {
    const tr_creep_par *p = data->par;
    double slide = tile->v_s[i] * tile->dt, roll = tr_creep_roll(p, tile, i), u = bed->n ? bed->e[0] : 0;
    double a = tr_law_width(data->shape, tile->f_elastic[i], tr_law_R_star(bed->R1, bed->R2), p->E_star);
    double c = 2 / M_PI * roll / a, fades = -tr_expm1(-c);
    return c > 0 ? slide * (fades / c) - u * fades : slide;
}

static void step(tr_tile *tile, const tr_law_data *data) {
    tr_bed_step(tile, data, displacement);
}

const tr_law tr_friction_vu_quoc_zhang = {
    .table = {"vu-quoc-zhang", "cattaneo-mindlin whose displacement fades while the bodies roll", params,
              .n = sizeof params / sizeof *params},
    .source = "[VuQuoc1999] [Kuhn2014 sec. 2.3]",
    .formula = "dQ = C^-1(du'), du' = Vs dt - (2/pi) (|du_roll|/a) u, u = sum of du', C^-1: cattaneo-mindlin\n"
               "spheres: a = cbrt(3 P R/(4 E_star)), disks: a = sqrt(4 P R/(pi E_star)), 1/R = 1/R1 + 1/R2\n"
               "|u| <= mu kappa delta; one step is exact at constant P",
    .differs = "The paper does not say whether u is the total or the effective displacement; here it is the effective "
               "one, because then steady rolling settles.",
    .claims = TR_OBJECTIVE | TR_BALANCED | TR_ENERGY_CLOSED,
    .n_hist = TR_BED_HIST,
    .needs = TR_ELASTIC_P,
    .merged = 2,
    .slip = TR_SLIPS_AT_ENDS,
    .step = step,
    .state = tr_bed_state,
    .stiffness = tr_bed_stiffness,
};
