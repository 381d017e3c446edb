/* SPDX-License-Identifier: MIT */
/* A few disks and walls, with weight and prescribed motions: kind `bodies`. It has no servo and no ledger.
 */
#ifndef TR_BODIES_H
#define TR_BODIES_H

#include "core/bodies_state.h"

/* Velocities of the scene are those of time 0. The half step back for leapfrog is taken here, so that positions are of
 * second order. Prescribed motions take none: 1/m or 1/I is 0. Keeps the arcs da, db. A given dt above the bound is
 * refused (TR_BAD_CASE) unless the scene allows it. The scene must outlive *b. */
bool tr_bodies_init(tr_bodies *b, const tr_scene *scene, tr_status *st);
void tr_bodies_free(tr_bodies *b);

/* tr_step_advance with the motions that a scene prescribes over time: centres on orbits, gravity that turns. A centre
 * on an orbit goes along the chord of the step to its place, to rounding at any time. Then its velocity is set to that
 * of the new instant, half a step ahead of the free disks': two orbits that turn as one body at the rate W then do not
 * slide and do not approach; with the chords V_s = |X21| W (W dt)^2/6 and v_n = |X21| W (W dt)/2. */
void tr_bodies_advance(tr_bodies *b);

#endif
