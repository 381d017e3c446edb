/* SPDX-License-Identifier: MIT */
/* The energy ledger, a sink with its own pass: it shows where the work of the walls goes.
 *
 *   start + work = kinetic + elastic (normal, friction, rolling) + dissipated (damped, friction, rolling) + residual
 *
 * Leapfrog does its work by the trapezoid: with K^n = 1/2 m v^(n-1/2) v^(n+1/2) the gain of K over a step is exactly
 * the mean of the forces at its two ends times the displacement. So every work here is 1/2 (force before + force now)
 * times displacement, and the law gives the stored energy. Dissipation of a mechanism = work - change of store, per
 * contact and step:
 *
 *   normal    elastic part: a potential, its work is its change of store.
 *             dashpot: 1/2 (F_D before + F_D now) v_n dt, F_D = f_n - f_elastic; where the velocity has just turned,
 *             the part of F_D before would be negative, of third order in dt, and is left out
 *   friction  1/2 (Q0 + Q) Vs dt - (E - E before), Q0 = Q before, cut to the present bound
 *   rolling   -1/2 ((M0 + M) . w) dt - (E - E before), M0 likewise
 *
 * With Q before the cut, dissipation could fall below zero when a bound drops; cut, it never does for a spring-slider
 * driven by its conjugate velocity (algebra in ledger.c).
 *
 * MADE. A law whose forces are not conjugate to its velocity (wang-spring with bagi-kuhn or alonso-*), or whose
 * stiffness changes under it (star-displacement-damping), makes energy here and takes it there. Besides the net, the
 * ledger has the energy that each mechanism made: the sum over contacts and steps of the negative parts of its
 * dissipation, with a plus sign. It can be large even if the net is small. Rounding is negative half of the time, by
 * 1e-16 of the energy in the spring of a contact: over 1e5 steps 1e-11 of all springs. A law that stops a spin within
 * the step (two of STAR's) makes energy that falls with the step.
 *
 * The residual is the loss by the time step; it falls with dt.
 */
#ifndef TR_LEDGER_H
#define TR_LEDGER_H

#include "core/world.h"

/* Columns of history.csv [J/m|J]: a new one is a row here and its line in ledger.c. */
#define TR_ENERGIES(ROW)                                                                                               \
    ROW(work) /* of the walls on the disks since the ledger began */                                                   \
    ROW(kinetic)                                                                                                       \
    ROW(elastic_normal)                                                                                                \
    ROW(elastic_friction)                                                                                              \
    ROW(elastic_rolling)                                                                                               \
    ROW(damped) /* this and the two below: dissipated since then, net */                                               \
    ROW(friction)                                                                                                      \
    ROW(rolling)                                                                                                       \
    ROW(residual)

#define TR_ENERGY_FIELD(name) double name;
typedef struct tr_energy {
    TR_ENERGIES(TR_ENERGY_FIELD)
    double made[TR_N_LAW_KINDS]; /* by the normal, friction, rolling law since then, >= 0 [N] */
} tr_energy;

void tr_ledger_attach(tr_group *group, tr_ledger *ledger);

/* After tr_step_forces: starts the accounts at the present state. */
void tr_ledger_begin(tr_world *world);

/* After every tr_step_forces that follows: adds the work of the walls over the last step. */
void tr_ledger_walls(tr_world *world);

/* After tr_step_forces (and tr_ledger_walls). */
tr_energy tr_ledger_read(const tr_world *world);

#endif
