/* SPDX-License-Identifier: MIT */
/* Other integrators, only for comparison; each drives tr_step_forces of the core.
 *
 *   leapfrog        the tool: F at x^n and v^(n-1/2), v^(n+1/2) = v^(n-1/2) + h a^n, x^(n+1) = x^n + h v^(n+1/2)
 *   velocity Verlet v^(n+1/2) = v^n + h/2 a^n, x^(n+1) = x^n + h v^(n+1/2), F at x^(n+1) and v^(n+1/2),
 *                   v^(n+1) = v^(n+1/2) + h/2 a^(n+1). The forces get the same velocities as in leapfrog: the same
 *                   motion, to rounding, with velocities at another time. [Swope1982]
 *   predicted       leapfrog, but F at x^n and v^(n-1/2) + h/2 a^(n-1), of second order at the time of x^n: right for a
 *                   dashpot, which needs the present velocity; wrong for a spring with a history, which needs the
 *                   displacement of the step, h v^(n-1/2)
 *   Forest-Ruth     three leapfrogs with the drift split, of 1.35, -1.70 and 1.35 h: fourth order [Forest1990]
 *   PEFRL           four forces a step: fourth order with small errors [Omelyan2002]
 *
 * The last two run backwards in time for a part of the step: a dashpot then gives energy, and friction slides back.
 * They are refused with either. They keep the contact list of the start. */
#ifndef TR_INTEGRATE_H
#define TR_INTEGRATE_H

#include "core/world.h"

typedef enum tr_integrator { TR_LEAPFROG, TR_VELOCITY_VERLET, TR_PREDICTED, TR_FOREST_RUTH, TR_PEFRL } tr_integrator;

/* n steps from a world with present positions and forces, and velocities of half a step ago, as after tr_bodies_init.
 * Afterwards its forces and its velocities are of the time of its positions. */
bool tr_integrate(tr_world *world, tr_integrator method, int64_t n, tr_status *st);

/* Adds share * dt F/m to the velocities. */
void tr_integrate_kick(tr_world *world, double share);

#endif
