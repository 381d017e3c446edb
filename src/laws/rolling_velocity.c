/* SPDX-License-Identifier: MIT */
/* What "rolling velocity" means, by author. All are objective; they answer different questions.
 * Source [Wang2015 eqs. 11, 16, 19a, 26]. s1, s2: how fast the contact point runs over rim 1 and rim 2, seen along t.
 *
 *   wang         (R2 s1 + R1 s2)/(R1+R2) = R1R2/(R1+R2) (w1 - w2)
 *                conjugate to a pure pair of moments; also Luding 2008 and Jiang eq. 26
 *   bagi-kuhn    (s1 + s2)/2
 *                mean flow of material through the contact; also Iwashita-Oda eq. 19a
 *   alonso-min   sgn(s1) min(|s1|,|s2|) where s1 s2 > 0, else 0
 *                Wang's "model 2", as inferred here
 *   alonso-mean  (s1 + s2)/2 where s1 s2 > 0, else 0
 *                the other reading of it
 *
 * differs: Wang does not print model 2; "zero when the objective velocities have different signs" is all that is said,
 * so both readings are offered. At a wall g1 = R1/(R1+R2) = 1, and wang gives s2 = -R2 w.
 */
#include "base/vector.h"
#include "laws/law.h"

#include <math.h>

TR_VECTOR static void wang(tr_tile *restrict tile, const tr_law_data *data) {
    (void)data;
    for (int i = 0; i < tile->n; i++) tile->v_r[i] = (1 - tile->g1[i]) * tile->s1[i] + tile->g1[i] * tile->s2[i];
}

TR_VECTOR static void bagi_kuhn(tr_tile *restrict tile, const tr_law_data *data) {
    (void)data;
    for (int i = 0; i < tile->n; i++) tile->v_r[i] = 0.5 * (tile->s1[i] + tile->s2[i]);
}

TR_VECTOR static void alonso_min(tr_tile *restrict tile, const tr_law_data *data) {
    (void)data;
    for (int i = 0; i < tile->n; i++) {
        double s1 = tile->s1[i], s2 = tile->s2[i], smaller = fabs(s1) < fabs(s2) ? s1 : s2;
        tile->v_r[i] = s1 * s2 > 0 ? smaller : 0;
    }
}

TR_VECTOR static void alonso_mean(tr_tile *restrict tile, const tr_law_data *data) {
    (void)data;
    for (int i = 0; i < tile->n; i++) {
        double s1 = tile->s1[i], s2 = tile->s2[i];
        tile->v_r[i] = s1 * s2 > 0 ? 0.5 * (s1 + s2) : 0;
    }
}

const tr_velocity_measure tr_rolling_velocities[] = {
    {"wang", "[Wang2015 eq. 11]", wang},
    {"bagi-kuhn", "[Wang2015 eqs. 16, 19a]", bagi_kuhn},
    {"alonso-min", "[Wang2015 model 2], inferred", alonso_min},
    {"alonso-mean", "[Wang2015 model 2], inferred", alonso_mean},
};
const int tr_n_rolling_velocities = sizeof tr_rolling_velocities / sizeof *tr_rolling_velocities;
