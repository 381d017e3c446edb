/* SPDX-License-Identifier: MIT */
/* A small random network of disks whose contacts do not open, and slip all the time or never: its exact limit of the
 * step, and the growth with the tool's leapfrog.
 *
 * The leapfrog takes damping at the half step before, M (x'' - 2x' + x) + dt C (x' - x) + dt^2 K x' = 0 for x, x', x''
 * at three instants. For an eigenvector, (z - 1)^2 m + dt c (z - 1) + dt^2 k z = 0 with m, c, k > 0: the first root to
 * leave the unit circle does so at z = -1, where 4 m = 2 dt c + dt^2 k. So it is stable if and only if
 *
 *   4 M - 2 dt C - dt^2 K   is positive definite                                                     [Irons1971]
 *
 * and the exact limit follows by bisection, each trial by Cholesky's factors: no line of core/timestep.c is in it.
 * Beyond the limit, without damping, the energy of the worst mode grows by (f + sqrt(f^2 - 1))^4 a step, f = dt/limit.
 *
 * Each disk carries a load that balances its contacts, 1e-5 R deep, and gets a velocity that moves it 1e-11 R in a
 * step: forces are those of frozen springs. The turning of the contacts under their force adds at most P/L = 1e-5 k_n.
 *
 * SLIDING. Disks turn at constant spins and the floor runs along itself, so that shape and forces stay: a contact
 * sticks if the rims run equally, and slides otherwise; so does its rolling spring. One that slides has Q = mu f_n and
 * no spring of its own: the force goes along g - mu sgn(V_s) s - mu_r sgn(V_r) r, with g, s, r the maps of the motion
 * to the gap, to sliding and to rolling, and changes only with the gap. So K and C are not symmetric, there is no
 * Cholesky, and the exact equations may grow (stability_sliding.c). */
#ifndef TR_VERIFY_STABILITY_NETWORK_H
#define TR_VERIFY_STABILITY_NETWORK_H

#include "core/world.h"

enum { TR_NETWORK_DISKS = 12, TR_NETWORK_DOF = 3 * TR_NETWORK_DISKS };

typedef struct tr_network {
    tr_world w;
    double k_n, k_t, k_r, zeta;
    double mu, mu_r;
    bool conjugate;                      /* conjugate-spring of bagi-kuhn instead of wang-spring */
    double rim[TR_NETWORK_DISKS], floor; /* speed of the rims, of the floor: -1, 0 or 1; SLIDING says of what */
    double K[TR_NETWORK_DOF][TR_NETWORK_DOF], C[TR_NETWORK_DOF][TR_NETWORK_DOF]; /* M^-1/2 K M^-1/2, and so for C */
} tr_network;

/* Network number `seed`. rolling_velocity: of wang-spring for all of them; NULL: conjugate laws, one or the other.
 * sliding: some of its contacts slide, and springs differ no more than tenfold. */
bool tr_network_throw(tr_network *net, int seed, const char *rolling_velocity, bool sliding, tr_status *st);
void tr_network_free(tr_network *net);

double tr_network_limit(const tr_network *net); /* [s], of one that does not slide */

#define TR_NETWORK_GROWN 1e3 /* of energy; near the limit a stable mode swings to 1/(1 - f^2), 50 at f = 0.99 */

/* The largest kinetic energy in so many steps, over that at the start; *a_step: growth in a step, of their second half
 * if it grows. */
double tr_network_growth(tr_network *net, double dt, int steps, double *a_step, tr_status *st);
double tr_network_linear(tr_network *net, double dt, int steps); /* the same by K and C */

#endif
