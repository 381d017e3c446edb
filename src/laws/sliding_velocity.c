/* SPDX-License-Identifier: MIT */
/* "Sliding velocity" by author: all other code reads this table. Friction uses the scene's arms; the others are for
 * comparison. Source [Wang2015 eqs. 12, 19b, 23-24, 27].
 *
 * To add a definition, add a row; rolling_velocity.c explains its entries. Here the formula may also use
 *
 *   L        |X21|, and R1 + R2 for it at a wall
 *   R1, R2, w1, w2, Vt, delta   radii, spins, velocity of 2 relative to 1 along t, overlap; at a wall R1 = w1 = 0
 *
 * A row that is not objective is not a function of s1, s2: its derivatives are those at a fixed spin of the line of
 * centres.
 *
 *   full-radius = s1 - s2 + delta betadot: for a rigid rotation w it slides by w times the overlap
 *   midpoint    arms R - delta/2, at a wall R2 - delta
 */
#include "laws/velocity_rows.h"

#define RECORDED(X)                                                                                                    \
    X(wang, "wang", "Vs_wang", "\nwang", TR_DEFINES_OBJECTIVE, "[Wang2015 eq. 12] with arms",                          \
      "his eq. 12 with the arms R |X21|/(R1+R2)", (s1 - s2) * (L / (R1 + R2)), L / (R1 + R2), -(L / (R1 + R2)))        \
    X(iwashita_oda, "iwashita-oda", "Us_iwashita_oda", "iwash.\noda", TR_DEFINES_OBJECTIVE,                            \
      "[Wang2015 eqs. 19b, 27]", "(s1-s2)/2: half of it (= jiang)", 0.5 * (s1 - s2), 0.5, -0.5)                        \
    X(alonso, "alonso", "Vs_alonso", "\nalonso", TR_DEFINES_OBJECTIVE, "[Wang2015 eqs. 23-24]",                        \
      "s1-s2: the same but for overlap", s1 - s2, 1.0, -1.0)                                                           \
    X(full_radius, "full-radius", "Vs_full_radii", "full\nradii", 0, "[Wang2015 eq. 12]",                              \
      "his eq. 12 as printed, with the radii for arms: wrong with overlap", R1 * w1 + R2 * w2 + Vt, 1.0, -1.0)
#define ONLY_MEASURED(X)                                                                                               \
    X(midpoint, "midpoint", "Vs_midpoint", NULL, TR_DEFINES_OBJECTIVE, "[Luding2008]",                        \
      "arms that end in the middle of the overlap", (R1 - lost) * w1 + (R2 - lost) * w2 + Vt,                          \
      1 - lost * (1 - g1) / (g1 * R2), lost / R2 - 1)                                                                  \
    X(jiang, "jiang", "Us_jiang", NULL, TR_DEFINES_OBJECTIVE, "[Wang2015 eq. 27]", "(s1-s2)/2: = iwashita-oda",        \
      0.5 * (s1 - s2), 0.5, -0.5)

#define OUT v_s
/* Variables for a formula, of contact i. */
#define LANE(tile, i)                                                                                                  \
    const double s1 = (tile)->s1[i], s2 = (tile)->s2[i], g1 = (tile)->g1[i], R1 = (tile)->R1[i], R2 = (tile)->R2[i],   \
                 w1 = (tile)->w1[i], w2 = (tile)->w2[i], L = tr_tile_length(tile, i),                                  \
                 Vt = (tile)->dvx[i] * (tile)->ny[i] - (tile)->dvy[i] * (tile)->nx[i],                                 \
                 lost = g1 != 1 ? 0.5 * (tile)->delta[i] : (tile)->delta[i];                                           \
    (void)s1, (void)s2, (void)g1, (void)R1, (void)R2, (void)w1, (void)w2, (void)L, (void)Vt, (void)lost

RECORDED(PASSES)
ONLY_MEASURED(PASSES)

const tr_velocity_measure tr_sliding_velocities[] = {RECORDED(ROW) ONLY_MEASURED(ROW)};
const int tr_n_sliding_velocities = RECORDED(ONE);
const int tr_n_sliding_measures = sizeof tr_sliding_velocities / sizeof *tr_sliding_velocities;
