/* SPDX-License-Identifier: MIT */
/* Bodies that were meant to touch and are tangent: kind `bodies`, before the run.
 *
 * Radii 20 and 10 mm at a distance of 30 mm have a gap that is 0 to rounding. If nothing presses them together, they
 * touch in one step and not in the next, with tiny forces. Under a weight they start with a fall. There is no note for
 * bodies that approach each other or part, and for bodies that nothing turns, presses or moves: nothing is lost
 * there. */
#ifndef TR_TANGENT_H
#define TR_TANGENT_H

#include "core/bodies.h"

typedef struct tr_tangent {
    int a, b;       /* as in tr_contact_id: two disks, or wall -1-a and disk b */
    double gap;     /* [m]; below 0: an overlap of rounding */
    double overlap; /* the overlap for the weight or, without a weight, TR_TINY_OVERLAP of the smaller radius [m] */
    double force;   /* that the law gives there [N/m] */
    bool weight;    /* the weight of a free disk presses them */
    int moved;      /* the disk to move, */
    double x, y;    /* and its place for that overlap [m] */
    int more;       /* further such pairs */
} tr_tangent;

#define TR_TINY_OVERLAP 1e-4 /* of the smaller radius; as shipped cases have it */

/* The first such pair; false: none. */
bool tr_tangent_find(const tr_bodies *b, tr_tangent *found);

#endif
