/* SPDX-License-Identifier: MIT */
/* Other integrators than the tool's own, for comparison only; each drives tr_step_forces of the core.
 *
 *   leapfrog        the tool: F at x^n and v^(n-1/2), v^(n+1/2) = v^(n-1/2) + h a^n, x^(n+1) = x^n + h v^(n+1/2)
 *   velocity Verlet v^(n+1/2) = v^n + h/2 a^n, x^(n+1) = x^n + h v^(n+1/2), F at x^(n+1) and v^(n+1/2),
 *                   v^(n+1) = v^(n+1/2) + h/2 a^(n+1). The forces see what those of leapfrog see: the same motion, to
 *                   rounding, with another reading of the velocity. [Swope1982]
 *   predicted       leapfrog, but F at x^n and v^(n-1/2) + h/2 a^(n-1), of second order at the time of x^n: right for a
 *                   dashpot, whose force is wanted now; wrong for a spring with a history, which wants the displacement of
 *                   the step, h v^(n-1/2)
 *   Forest-Ruth     three leapfrogs with the drift split, of 1.35, -1.70 and 1.35 h: fourth order [Forest1990]
 *   PEFRL           four forces a step: fourth order with small errors [Omelyan2002]
 *
 * The last two run backwards in time for a part of the step: a dashpot then gives energy and friction unslides. They are refused
 * where there is either. They keep the contact list of the start. */
#ifndef TR_INTEGRATE_H
#define TR_INTEGRATE_H

#include "core/world.h"

typedef enum tr_integrator { TR_LEAPFROG, TR_VELOCITY_VERLET, TR_PREDICTED, TR_FOREST_RUTH, TR_PEFRL } tr_integrator;

/* n steps from a world whose positions and forces are of now and whose velocities are of half a step ago, as
 * tr_bodies_init leaves it. Afterwards its forces and its velocities are of the time of its positions. */
bool tr_integrate(tr_world *world, tr_integrator method, int64_t n, tr_status *st);

/* Adds share * dt F/m to the velocities. */
void tr_integrate_kick(tr_world *world, double share);

#endif
