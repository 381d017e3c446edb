/* SPDX-License-Identifier: MIT */
/* The forces of a large sample, by threads. The bits are those of one thread.
 *
 * Each thread takes a share of the list, tiles in a row. The force on a disk must be summed in the order of the list, so a disk
 * belongs to the first thread that has a contact of it: this one adds to the force at once. What a later thread has for that disk
 * it keeps, and when all are done it is added in the order of the list. Disks near each other stand near each other in
 * the list (core/sample.h), so that a share has few disks of another: of the 428,000 parts of
 * the forces on 100,000 disks 909 wait where two threads share them. Who owns a disk, and which tiles have disks of others, is found out
 * once for each list. Sums over contacts are kept tile by tile and added up in their order.
 *
 * Rejected: to store what all tiles give, and let each thread add up the forces of its share of the disks in a second pass over it
 * (200 bytes a disk; two threads took 0.82 of the time of one, in place of 0.61). */
#ifndef TR_SHARES_H
#define TR_SHARES_H

#include "core/world.h"

/* Adds the forces of the contacts of disks. dt: as of a pass. */
bool tr_shares_forces(tr_world *world, double dt, tr_status *st);

#endif
