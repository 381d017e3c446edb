/* SPDX-License-Identifier: MIT */
/* All three codes have V_r of wang in the rolling spring. LAMMPS, LIGGGHTS: M = k R_eff^2 (w1 - w2) t, |M| <= mu
 * F_n R_eff. YADE: M = k_s alpha R1 R2 (w1 - w2) t, |M| <= eta F_n min(R1, R2). Here: M = k_r R_eff^2 (w1 - w2) t,
 * |M| <= mu_r F_n R_eff. */
#include "study/counterparts.h"

#include <math.h>
#include <string.h>

static double one(double R1, double R2) {
    (void)R1, (void)R2;
    return 1;
}
static double product_by_reduced(double R1, double R2) { /* R1R2/R_eff^2 */
    return (R1 + R2) * (R1 + R2) / (R1 * R2);
}
static double smaller_by_reduced(double R1, double R2) { /* min/R_eff */
    return fmin(R1, R2) * (R1 + R2) / (R1 * R2);
}

#define LAMMPS                                                                                                         \
    "LAMMPS 29Sep2021, pair_style granular, pair_coeff hooke k_n 0 tangential linear_history k_t 0 xmu rolling sds "   \
    "k_roll 0 mu_roll damping velocity"
#define LIGGGHTS                                                                                                       \
    "LIGGGHTS-PUBLIC 3.8.0, pair_style gran model hooke/stiffness tangential history rolling_friction epsd2"
#define YADE "YADE 2023.02a, CohFrictMat, Law2_ScGeom6D_CohFrictPhys_CohesionMoment"

const tr_counterpart tr_counterparts[] = {
    {"lammps", "wang-spring", LAMMPS, {{"k_r", "k_roll", one}, {"mu_r", "mu_roll", one}}, NULL},
    {"lammps",
     "coulomb-spring",
     LAMMPS,
     {{"k_t", "k_t", one}, {"mu", "xmu (by its manual)", one}},
     "Sliding goes by full radii, torques by R_i - overlap/2: a rigid rotation w slides by overlap*w, and the power of "
     "friction is not -F_t V_s. Neither `arms` gives that here."},
    {"liggghts",
     "wang-spring",
     LIGGGHTS,
     {{"k_r", "kt", one}, {"mu_r", "coefficientRollingFriction", one}},
     "The rolling stiffness is that of the tangential spring and has no key of its own: give k_r: k_t here."},
    {"liggghts",
     "coulomb-spring",
     LIGGGHTS,
     {{"k_t", "kt", one}, {"mu", "coefficientFriction (by its manual)", one}},
     "The arms are R_i - overlap/2: give arms: midpoint here."},
    {"yade",
     "wang-spring",
     YADE,
     {{"k_r", "alphaKr k_s", product_by_reduced}, {"mu_r", "etaRoll", smaller_by_reduced}},
     "No one material gives the law to bodies of unequal radii: the factors follow R1/R2."},
    {"yade",
     "coulomb-spring",
     YADE,
     {{"k_t", "k_s", one}, {"mu", "tan(frictionAngle) (by its manual)", one}},
     "Sliding is V_s (R1+R2)/|X21| with arms R_i |X21|/(R1+R2), torques have R_i - overlap/2. With "
     "avoidGranularRatcheting=False both have R_i - overlap/2: that is arms: midpoint here."},
};
const int tr_n_counterparts = sizeof tr_counterparts / sizeof *tr_counterparts;

const tr_counterpart *tr_counterpart_of(const char *code, const char *law) {
    if (!strcmp(law, "conjugate-spring")) law = "wang-spring"; /* the same with rolling_velocity: wang */
    for (int k = 0; k < tr_n_counterparts; k++)
        if (!strcmp(tr_counterparts[k].code, code) && !strcmp(tr_counterparts[k].law, law)) return &tr_counterparts[k];
    return NULL;
}

bool tr_counterpart_is_plain(const tr_counterpart_key *key) {
    return key->factor == one;
}
