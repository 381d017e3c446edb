/* SPDX-License-Identifier: MIT */
/* Gather and scatter: between the bodies, each in one place, and a tile, whose lanes have contacts side by side. */
#ifndef TR_TILE_H
#define TR_TILE_H

#include "core/world.h"

/* Contacts of the group from `first`, one tile: their relative motion and the input of kinematics. */
void tr_tile_gather(const tr_world *world, const tr_group *group, tr_tile *tile, int first, double dt);

/* The forces on disks before any contact: their loads. */
void tr_tile_begin(const tr_disks *disks);

/* Adds resultants to the forces of disks and walls. */
void tr_tile_scatter(const tr_tile *tile, const tr_group *group, tr_world *world);

#endif
