/* SPDX-License-Identifier: MIT */
/* Numbers in the text of [Kuhn2014]. */
#include "verify/exact.h"

#include <stdio.h>

/* ---- the size of contacts
 *
 * A packing of equal spheres at the pressure p, z contacts to a sphere, solid fraction phi: from the mean of force
 * times branch, P = 4 pi R^2 p/(z phi). Table 2, quartz: G = 29 GPa, nu = 0.15 (E_star = G/(1 - nu)), void ratio 0.513,
 * 1.86 contacts per sphere (z = 3.72). The table's spheres are of many sizes. */
static bool size(double pressure, double *a_over_R, double *half_overlap, tr_status *st) {
    const double R = 1e-3, z = 2 * 1.86, phi = 1 / 1.513, P = 4 * M_PI * R * R * pressure / (z * phi);
    char text[300];
    tr_contact_state end[1];
    snprintf(text, sizeof text,
             "kind: contact\nbodies: {R1: 1 mm, R2: 1 mm, E: 2*1.15*29 GPa, nu: 0.15, shape: sphere}\n"
             "laws: [{friction: cattaneo-mindlin, mu: 0.5}]\npath: [{force: %.17g, steps: 1}]\n",
             P);
    if (!tr_exact_path(text, end, 1, NULL, st)) return false;
    *a_over_R = end[0].a / R, *half_overlap = end[0].overlap / 2 / R;
    return true;
}

bool tr_exact_contact_size(tr_verify *v, tr_status *st) {
    double a, zeta, a_atm, zeta_atm;
    char said[80];
    if (!size(10e3, &a, &zeta, st) || !size(101325, &a_atm, &zeta_atm, st)) return false;
    snprintf(said, sizeof said, "%.4f: the contacts of 10 kPa, pressed harder", a_atm);
    return tr_verify_add(v,
                         &(tr_verify_row){"a/R of quartz at 10 kPa (Table 2)", "1", 0.0073, a, 0.0015,
                                          "spheres of equal size for 0.4 to 1.5 of the median", NAN, NULL},
                         st) &&
           tr_verify_add(v,
                         &(tr_verify_row){"indentation over (a/R)^2 (Table 2: 0.0054 %)", "1",
                                          0.0054e-2 / (0.0073 * 0.0073), zeta / (a * a), 0.02,
                                          "the table has two digits", NAN, NULL},
                         st) &&
           tr_verify_outcome(v, "a/R of quartz at 1 atm is below 2 %", said, a_atm < 0.02, st);
}

/* ---- steady rolling, Fig. 5: equal spheres, indentation 0.01 % of R each, so a = 1 % of R; mu = 0.5, nu = 0.15 */

static bool steady(double inverse, double *q, tr_status *st) {
    char text[400];
    tr_contact_state end[1];
    snprintf(text, sizeof text,
             "kind: contact\nbodies: {R1: 10 mm, R2: 10 mm, E: 70 GPa, nu: 0.15, shape: sphere}\n"
             "laws: [{friction: kuhn-creep, mu: 0.5, nu: 0.15, E_star: E_star}]\n"
             "path: [{overlap: 2 um, slide: 4*R_star/%.17g, roll: 4*R_star, steps: 600}]\n",
             inverse);
    *q = tr_exact_path(text, end, 1, NULL, st) ? end[0].q : NAN;
    return !st->code;
}

bool tr_exact_fig_5(tr_verify *v, tr_status *st) {
    static const double inverse[] = {30, 100, 1000}, want[] = {1, 0.9936, 0.2249};
    double q, low = 30, high = 100;
    for (int k = 0; k < 3; k++) {
        char quantity[80];
        snprintf(quantity, sizeof quantity, "steady q at 1/xi = %g (Fig. 5)", inverse[k]);
        if (!steady(inverse[k], &q, st) ||
            !tr_verify_add(v, &(tr_verify_row){quantity, "1", want[k], q, 5e-5, "four digits are given", NAN, NULL},
                           st))
            return false;
    }
    while (high - low > 0.01) {
        double middle = 0.5 * (low + high);
        if (!steady(middle, &q, st)) return false;
        *(q < 1 ? &high : &low) = middle;
    }
    return tr_verify_add(
        v,
        &(tr_verify_row){"full friction up to 1/xi (printed: above 10 it falls)", "1", 0.85 * 3.832 / (8 * 0.5 * 0.01),
                         low, 0.1, "bisection to 0.01; below full friction by y^3, seen from y = 1e-5", NAN, NULL},
        st);
}
