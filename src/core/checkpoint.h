/* SPDX-License-Identifier: MIT */
/* The state of a world during a run (base/checkpoint.h), between tr_step_advance and tr_step_forces: positions,
 * velocities, the list with its histories and pair constants, the wide list of pairs, and the places of the bodies when
 * the two were made. The finder is not kept: it gives the same pairs from any past, because each is checked in double.
 * Forces, tile and the old list are made again in each step or renewal. */
#ifndef TR_CORE_CHECKPOINT_H
#define TR_CORE_CHECKPOINT_H

#include "base/checkpoint.h"
#include "core/biaxial.h"

/* To load: into a world with the same disks and laws. Sinks are attached before. */
void tr_world_checkpoint(tr_world *world, tr_checkpoint *c);

/* To load: after tr_biaxial_init, and tr_biaxial_begin_shear if it had begun. */
void tr_biaxial_checkpoint(tr_biaxial *b, tr_checkpoint *c);

/* The packing after compaction; tr_biaxial_begin_shear gives the same bits from it. To load: after tr_biaxial_init. */
void tr_biaxial_packing(tr_biaxial *b, tr_checkpoint *c);

#endif
