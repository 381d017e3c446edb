/* SPDX-License-Identifier: MIT */
/* How far disks have moved since a list was made, less what the whole sample has been stretched: the box or the cell gives a
 * homogeneous motion, x -> scale x + offset, and what counts is how far a disk is from where that leads. In a shear of N disks those at
 * the walls move by sqrt(N)/2 times the relative motion of neighbours: without it lists of 1,000,000 disks were made every
 * 14 steps, those of 400 every 120.
 *
 * Of two disks that were L apart, each no further than m from where the stretch leads, the distance has shrunk by (1 - least scale) L +
 * 2 m at most. So a list that held all pairs with a gap below `skin` still holds all with a gap below `left` while
 *
 *     2 m + e (2 r_max + skin) + left <= skin,     e = the largest |scale - 1|.
 *
 * Images in a cell are stretched as all is, walls of a box too: nothing more is to be said of them. Any other wall, and the disks
 * beside it, have scale 1: there m and the way of the wall must not exceed the skin together. */
#ifndef TR_STRETCH_H
#define TR_STRETCH_H

#include "core/world.h"

/* Of the cell, of the box; else of nothing: the unit square about the origin. */
tr_extent tr_stretch_extent(const tr_world *world);

/* Where a point of the earlier frame is in the later one, and the largest |scale - 1|. */
typedef struct tr_stretch {
    double scale[2], offset[2], most;
} tr_stretch;

tr_stretch tr_stretch_of(const tr_extent *from, const tr_extent *to);

/* Of what disks may move before the list with this skin has lost a pair with a gap below `left` [m]; may be negative. */
double tr_stretch_reach(const tr_world *world, const tr_stretch *stretch, double skin, double left);

#endif
