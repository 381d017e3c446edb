/* SPDX-License-Identifier: MIT */
/* How far disks have moved since a list was made, without the stretch of the whole sample: the box or the cell gives a
 * homogeneous motion, x -> scale x + offset, and only the distance of a disk from its stretched place counts. In a
 * shear of N disks those at the walls move by sqrt(N)/2 times the relative motion of neighbours: without it lists of
 * 1,000,000 disks were made every 14 steps, those of 400 every 120.
 *
 * If two disks were L apart, and each is at most m from its stretched place, their distance has shrunk by (1 - least
 * scale) L + 2 m at most. So a list that held all pairs with a gap below `skin` still holds all with a gap below `left`
 * while
 *
 *     2 m + e (2 r_max + skin) + left <= skin,     e = the largest |scale - 1|.
 *
 * Images in a cell and walls of a box are stretched like all disks, so they need no more. Any other wall, and the disks
 * beside it, have scale 1: there the sum of m and the way of the wall must not exceed the skin. */
#ifndef TR_STRETCH_H
#define TR_STRETCH_H

#include "core/world.h"

/* Of the cell or of the box; else the unit square about the origin. */
tr_extent tr_stretch_extent(const tr_world *world);

/* The place of a point of the earlier frame in the later one, and the largest |scale - 1|. */
typedef struct tr_stretch {
    double scale[2], offset[2], most;
} tr_stretch;

tr_stretch tr_stretch_of(const tr_extent *from, const tr_extent *to);

/* How far disks may move before the list with this skin can miss a pair with a gap below `left` [m]; may be
 * negative. */
double tr_stretch_reach(const tr_world *world, const tr_stretch *stretch, double skin, double left);

#endif
