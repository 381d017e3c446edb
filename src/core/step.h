/* SPDX-License-Identifier: MIT */
/* One time step: the method in reading order. */
#ifndef TR_STEP_H
#define TR_STEP_H

#include "core/world.h"

/* Forces on disks and walls at the present positions: renews the list when it is stale, then runs the pipelines.
 * Histories advance by dt, except at the first call after the laws were set. Fails with TR_NUMERICAL (see contacts.h);
 * the state stays readable. */
bool tr_step_forces(tr_world *world, tr_status *st);

/* Kick and drift: v += dt F/m, x += dt v, for disks and pistons. The forces on disks are then 0: they are valid from
 * tr_step_forces to here. */
void tr_step_advance(tr_world *world);

/* Runs the pipeline of a group over all tiles; after each tile, done(context, group, tile). For sinks that read only
 * sometimes: with dt = 0 a second walk changes no history and gives the same forces. */
void tr_step_walk(tr_world *world, tr_group *group, double dt, void (*done)(void *, tr_group *, tr_tile *),
                  void *context);

#endif
