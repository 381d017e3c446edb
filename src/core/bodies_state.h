/* SPDX-License-Identifier: MIT */
/* The state of a handful of bodies, and what follows from it; see bodies.h. */
#ifndef TR_BODIES_STATE_H
#define TR_BODIES_STATE_H

#include "core/world.h"

typedef struct tr_bodies {
    tr_world world;  /* do not move: see tr_world */
    double dt_bound; /* [s]; infinite if no contact can vibrate */
    int64_t steps;   /* to take until time_end */
    const tr_scene *scene;
} tr_bodies;

/* After tr_step_forces: gravity of that time [m/s^2]. */
void tr_bodies_gravity(const tr_bodies *b, double gravity[2]);

/* After tr_step_forces: velocity of disk i at the same time as its position, v = v^(n-1/2) + dt F/(2m): vx, vy, w.
 * Prescribed motions have it in vel already. */
void tr_bodies_velocity(const tr_world *world, int i, double velocity[3]);

#endif
