/* SPDX-License-Identifier: MIT */
/* A handful of disks and walls, with weight and given motions: kind `bodies`. No servo and no ledger are built for it.
 */
#ifndef TR_BODIES_H
#define TR_BODIES_H

#include "core/world.h"

typedef struct tr_bodies {
    tr_world world;  /* do not move: see tr_world */
    double dt_bound; /* [s]; infinite if every motion is prescribed */
    int64_t steps;   /* to take until time_end */
} tr_bodies;

/* Velocities of the scene are those of time 0: the half step back that leapfrog wants is taken here, so that positions
 * are of second order. Keeps the arcs da, db. A given dt above the bound is refused (TR_BAD_CASE) unless the scene
 * allows it. */
bool tr_bodies_init(tr_bodies *b, const tr_scene *scene, tr_status *st);
void tr_bodies_free(tr_bodies *b);

/* After tr_step_forces: velocity of disk i at the same time as its position, v = v^(n-1/2) + dt F/(2m): vx, vy, w. */
void tr_bodies_velocity(const tr_world *world, int i, double velocity[3]);

#endif
