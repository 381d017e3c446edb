/* SPDX-License-Identifier: MIT */
/* The state of a world in the midst of its way (base/checkpoint.h), between tr_step_advance and tr_step_forces: positions,
 * velocities, the list with its histories and pair constants, the wide list of pairs, and where the bodies were when the two
 * were made. Of the finder nothing is kept: it gives the same pairs from any past, for each is checked in double. Forces,
 * tile and the old list are made anew in each step or renewal. */
#ifndef TR_CORE_CHECKPOINT_H
#define TR_CORE_CHECKPOINT_H

#include "base/checkpoint.h"
#include "core/biaxial.h"

/* To load: into a world with the same disks and laws. Sinks are attached before. */
void tr_world_checkpoint(tr_world *world, tr_checkpoint *c);

/* To load: after tr_biaxial_init, and tr_biaxial_begin_shear if it had begun. */
void tr_biaxial_checkpoint(tr_biaxial *b, tr_checkpoint *c);

/* The packing that compaction has made, from which tr_biaxial_begin_shear gives the same bits. To load: after tr_biaxial_init. */
void tr_biaxial_packing(tr_biaxial *b, tr_checkpoint *c);

#endif
