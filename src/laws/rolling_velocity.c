/* SPDX-License-Identifier: MIT */
/* "Rolling velocity" by author: all other code reads this table. The definitions answer different questions.
 * Source [Wang2015 eqs. 11, 16, 19a, 25, 26] [Kuhn2014 eq. 5].
 *
 * To add a definition, add a row. A row gives the velocity V as a formula in
 *
 *   s1, s2   how fast the contact point runs over rim 1 and rim 2, seen along t [m/s]
 *   g1       R1/(R1+R2), 1 at a wall
 *   R2, w1, w2   radius of 2 [m] and the spins [rad/s], in the frame of a wall
 *
 * and its partial derivatives dV/ds1 and dV/ds2. V must be homogeneous of degree 1: V = s1 dV/ds1 + s2 dV/ds2. If the
 * formula has cases, the derivatives are those of the present case. The derivatives give the forces of conjugate-spring
 * and the bound on the step; tests/laws/test_definitions.c compares them with finite differences.
 *
 * differs: Wang does not print model 2, only "zero when the objective velocities have different signs". So both
 * readings are here. At a wall wang gives s2 = -R2 w.
 */
#include "laws/velocity_rows.h"

#include <math.h>

#define SAME_WAY (s1 * s2 > 0)
#define FIRST_IS_SLOWER (fabs(s1) < fabs(s2))

#define IN_SCENES(X)                                                                                                   \
    X(wang, "wang", "Vr_wang", "\nwang", TR_DEFINES_OBJECTIVE, "[Wang2015 eq. 11]",                                    \
      "R1R2/(R1+R2) (w1-w2): what a pure pair of moments does work on (= luding, jiang)",                              \
      (1 - g1) * s1 + g1 * s2, 1 - g1, g1)                                                                             \
    X(bagi_kuhn, "bagi-kuhn", "Vr_bagi_kuhn", "bagi-\nkuhn", TR_DEFINES_OBJECTIVE, "[Wang2015 eqs. 16, 19a]",          \
      "(s1+s2)/2: mean flow of material through the contact (= iwashita-oda); a question of\n"                         \
      "its own: where * it is not wrong, material does flow through the contact",                                      \
      0.5 * (s1 + s2), 0.5, 0.5)                                                                                       \
    X(alonso_min, "alonso-min", "Vr_alonso_min", "alonso\nmin", TR_DEFINES_OBJECTIVE, "[Wang2015 model 2], inferred",  \
      "the slower rim, if both run the same way; else 0 (as inferred)",                                                \
      SAME_WAY ? (FIRST_IS_SLOWER ? s1 : s2) : 0, SAME_WAY && FIRST_IS_SLOWER, SAME_WAY && !FIRST_IS_SLOWER)           \
    X(alonso_mean, "alonso-mean", "Vr_alonso_mean", "alonso\nmean", TR_DEFINES_OBJECTIVE,                              \
      "[Wang2015 model 2], inferred", "the mean of both rims, if they run the same way; else 0 (as inferred)",         \
      SAME_WAY ? 0.5 * (s1 + s2) : 0, SAME_WAY ? 0.5 : 0, SAME_WAY ? 0.5 : 0)
#define ONLY_MEASURED(X)                                                                                               \
    X(tordesillas, "tordesillas", "Vr_tordesillas", "torde-\nsillas", TR_DEFINES_OBJECTIVE | TR_DEFINES_ANGLE,         \
      "[Wang2015 eq. 25]", "w1-w2: an angle, in units of U/R2", w1 - w2, (1 - g1) / (g1 * R2), 1 / R2)                 \
    X(jiang, "jiang", "Vr_jiang", NULL, TR_DEFINES_OBJECTIVE, "[Wang2015 eq. 26]", "(R2 s1+R1 s2)/(R1+R2): = wang",    \
      (1 - g1) * s1 + g1 * s2, 1 - g1, g1)                                                                             \
    X(kuhn, "kuhn", "Vroll_kuhn", NULL, TR_DEFINES_OBJECTIVE, "[Kuhn2014 eq. 5]",                                      \
      "-(s1+s2)/2: material through the contact, along t", -0.5 * (s1 + s2), -0.5, -0.5)

#define OUT v_r
/* Variables for a formula, of contact i. */
#define LANE(tile, i)                                                                                                  \
    const double s1 = (tile)->s1[i], s2 = (tile)->s2[i], g1 = (tile)->g1[i], R2 = (tile)->R2[i], w1 = (tile)->w1[i],   \
                 w2 = (tile)->w2[i];                                                                                   \
    (void)s1, (void)s2, (void)g1, (void)R2, (void)w1, (void)w2

IN_SCENES(PASSES)
ONLY_MEASURED(PASSES)

const tr_velocity_measure tr_rolling_velocities[] = {IN_SCENES(ROW) ONLY_MEASURED(ROW)};
const int tr_n_rolling_velocities = IN_SCENES(ONE);
const int tr_n_rolling_measures = sizeof tr_rolling_velocities / sizeof *tr_rolling_velocities;
const char tr_rolling_velocity_choices[] = IN_SCENES(CHOICE);
