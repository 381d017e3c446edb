/* SPDX-License-Identifier: MIT */
/* What "sliding velocity" means, by author. Friction uses Wang's; the others are to compare. Source [Wang2015 eqs. 12,
 * 19b, 23-24].
 *
 *   wang          Vs = r1 w1 + r2 w2 + Vt = (s1 - s2) |X21|/(R1+R2)   velocity of 2 relative to 1 at the contact point
 *   iwashita-oda  (da + db)/2 per unit time = (s1 - s2)/2             half of it; also Jiang eq. 27
 *   alonso        s1 - s2                                             = Vs where there is no overlap
 *   full-radius   R1 w1 + R2 w2 + Vt                                  eq. 12 as printed: not objective where there is
 *                 overlap, for a rigid rotation w then slides by w times the overlap
 *
 * |X21| = r1 + r2. At a wall R1 = r1 = 0, the factor is 1 and full-radius is wang.
 */
#include "base/vector.h"
#include "laws/law.h"

TR_VECTOR static void wang(tr_tile *restrict tile, const tr_law_data *data) {
    (void)data;
    for (int i = 0; i < tile->n; i++) {
        double ratio = (tile->r1[i] + tile->r2[i]) / (tile->R1[i] + tile->R2[i]);
        tile->v_s[i] = (tile->s1[i] - tile->s2[i]) * ratio;
    }
}

TR_VECTOR static void iwashita_oda(tr_tile *restrict tile, const tr_law_data *data) {
    (void)data;
    for (int i = 0; i < tile->n; i++) tile->v_s[i] = 0.5 * (tile->s1[i] - tile->s2[i]);
}

TR_VECTOR static void alonso(tr_tile *restrict tile, const tr_law_data *data) {
    (void)data;
    for (int i = 0; i < tile->n; i++) tile->v_s[i] = tile->s1[i] - tile->s2[i];
}

TR_VECTOR static void full_radius(tr_tile *restrict tile, const tr_law_data *data) {
    (void)data;
    for (int i = 0; i < tile->n; i++) {
        double Vt = tile->dvx[i] * tile->ny[i] - tile->dvy[i] * tile->nx[i];
        tile->v_s[i] = tile->R1[i] * tile->w1[i] + tile->R2[i] * tile->w2[i] + Vt;
    }
}

const tr_velocity_measure tr_sliding_velocities[] = {
    {"wang", "[Wang2015 eq. 12] with arms", wang},
    {"iwashita-oda", "[Wang2015 eqs. 19b, 27]", iwashita_oda},
    {"alonso", "[Wang2015 eqs. 23-24]", alonso},
    {"full-radius", "[Wang2015 eq. 12]", full_radius},
};
const int tr_n_sliding_velocities = sizeof tr_sliding_velocities / sizeof *tr_sliding_velocities;
