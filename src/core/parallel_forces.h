/* SPDX-License-Identifier: MIT */
/* The forces of a large sample, by threads. The bits are those of one thread.
 *
 * Each thread takes a share of the list: consecutive tiles. The force on a disk must be summed in the order of the
 * list. So a disk belongs to the first thread with a contact of it, which adds to the force at once. A later thread
 * keeps its parts for that disk; when all are done, they are added in the order of the list. Neighbouring disks are
 * near each other in the list (core/sample.h), so a share has few disks of another: of the 428,000 parts of the forces
 * on 100,000 disks 909 wait with two threads. The owner of each disk, and the tiles with disks of others, are found
 * once for each list. Sums over contacts are kept tile by tile and added up in their order.
 *
 * Rejected: store the results of all tiles, and let each thread add up the forces of its part of the disks in a second
 * pass (200 bytes a disk; two threads took 0.82 of the time of one, instead of 0.61). */
#ifndef TR_PARALLEL_FORCES_H
#define TR_PARALLEL_FORCES_H

#include "core/world.h"

/* Adds the forces of the contacts of disks. dt: as of a pass. */
bool tr_parallel_forces(tr_world *world, double dt, tr_status *st);

#endif
