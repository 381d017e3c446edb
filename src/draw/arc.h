/* SPDX-License-Identifier: MIT */
/* Where the arcs da and db of a contact lie: C'C'_1 and C'C'_2 of [Wang2015 Fig. 1].
 *
 * C' is the contact point now, C'_1 (C'_2) the present place of the point of rim a (b) that touched first. With s1 = R1
 * (w1 - betadot), da = int s1 dt is that point's way along rim a, counter-clockwise about the centre of a; db = -int s2
 * dt likewise. Seen from the centre of a, C' is in the direction of n, and from the centre of b in the direction of
 * -n. */
#ifndef TR_ARC_H
#define TR_ARC_H

#include "core/record.h"

/* From C', counter-clockwise positive, not wrapped [rad]. */
typedef struct tr_arc {
    double from, sweep;
} tr_arc;

/* At a wall (R1 = 0) a->sweep is 0: there the arc is straight, see tr_arc_wall. */
void tr_arc_angles(const tr_record *r, tr_arc *a, tr_arc *b);

/* C'_1 on a wall: about a centre infinitely far behind it, counter-clockwise is along -t = (-n_y, n_x). */
void tr_arc_wall(const tr_record *r, double *x, double *y);

#endif
