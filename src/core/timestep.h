/* SPDX-License-Identifier: MIT */
/* The largest stable step of the leapfrog. Source [Irons1971].
 *
 * A mode of angular frequency w and damping ratio zeta is stable for dt < (2/w)(sqrt(1+zeta^2) - zeta), the damping
 * force being taken at the half step before. For a whole sample that means dt^2 x'Kx + 2 dt x'Cx <= 4 x'Mx for every
 * motion x. K and C are sums over contacts; share the mass of each body equally among its z contacts and M is one too,
 * so it is enough that every single contact satisfies the inequality with its two parts m/z, I/z. A single
 * contact has one normal mode and two tangential ones, known in closed form:
 *
 *   normal     w2 dt^2 + 2 g dt = 4,  w2 = k s, g = c s,  s = z1/m1 + z2/m2
 *   tangential the same, w2 the larger eigenvalue of a 2 x 2 matrix, the stiffnesses of sliding and rolling coupled
 *   through
 *              the spins, and g that of their dashpots
 *
 * Only dashpots: dt < 2/g. If the tangential modes of w2 and of g differ, their sum is cautious: for one contact 0.618
 * of the exact bound or more.
 *
 * Stability here means a symmetric K. Friction of a sliding contact follows its normal force, so K is not symmetric:
 * such networks may flutter in the exact equations, at any step. The bound covers only what the step adds; trundle
 * verify sliding separates the two. In the same way, a rolling velocity that is not conjugate to its moments
 * (wang-spring with any but wang) makes some packings grow at any step; trundle verify not-conjugate counts them.
 * conjugate-spring is symmetric within one case of its rolling velocity: the bound is that of the stiffest case, and
 * does not cover switching between cases.
 *
 * Never above the exact bound; equal to it on a chain, 0.7-0.9 of it in a packing. Gershgorin's circles, the usual
 * choice, mix units of force and torque and give as little as 0.02.
 */
#ifndef TR_TIMESTEP_H
#define TR_TIMESTEP_H

#include "core/world.h"

/* Of the smaller radius: for springs that stiffen with the overlap, before contacts are known. tr_timestep_contacts
 * looks at the real overlaps and finds larger ones. */
#define TR_EXPECTED_OVERLAP 0.01

typedef struct tr_timestep_limit {
    double dt;          /* [s]; infinite if nothing touches */
    int group, contact; /* which contact sets it */
} tr_timestep_limit;

/* The bound of the contacts that touch now. */
tr_timestep_limit tr_timestep_contacts(const tr_world *world);

/* A bound for the packings of the world's disks: each disk touched by as many of the smallest disks as fit around it
 * (and no more bodies than there are). For choosing dt before the contacts are known [s]. */
double tr_timestep_worst(const tr_world *world);

/* dt is stable for all possible contacts of the disks with overlaps up to TR_LARGEST_OVERLAP, and for those of pistons:
 * contacts need no check. */
bool tr_timestep_sure(tr_world *world);

#define TR_MOST_STEPS 1e12 /* of one run; 1e6 steps take seconds for 400 disks */

/* Sets world->dt: the step given, or safety * *bound with *bound = tr_timestep_worst, or `fallback` if nothing can
 * vibrate (bound infinite). A given step above the bound is refused (TR_BAD_CASE) unless the case allows it. Call it
 * after the laws are set. */
bool tr_timestep_choose(tr_world *world, const tr_scene_step *step, double fallback, double *bound, tr_status *st);

#endif
