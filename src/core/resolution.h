/* SPDX-License-Identifier: MIT */
/* Whether places can carry the overlaps of a scene: kind `bodies`, before the run.
 *
 * An overlap is a small difference of places, and neighbouring doubles are 2^-52 of a place apart: at 1e5 m 1.5e-11 m,
 * a thousandth of the overlap of disks of 1 um that meet with 0.2 m/s. All places that the run may reach count, by
 * velocities and by gravity along walls. The expected overlap of a pair is the largest of three: at the start, under
 * the weight of one, and in a blow with the relative velocity. If none of these is known, TR_EXPECTED_OVERLAP of the
 * smaller radius. Pairs too far apart to meet do not count.
 *
 * A velocity has the same limit: the way of a body in a step is rounded to these places, each time in the same
 * direction. */
#ifndef TR_RESOLUTION_H
#define TR_RESOLUTION_H

#include "core/biaxial.h"
#include "core/bodies_state.h"

#define TR_RESOLVED 1e-6 /* of an overlap or of the way of a step: allowed rounding */

typedef struct tr_resolution {
    int a, b;       /* as in tr_contact_id: two disks, or wall -1-a and disk b */
    double reach;   /* the largest coordinate [m] */
    double spacing; /* of doubles there [m] */
    double size;    /* of the overlap, or of the way of a step [m] */
    int more;       /* further such pairs, further such bodies */
} tr_resolution;

/* The pair with the worst rounding of its overlap, if above TR_RESOLVED. False: none is. */
bool tr_resolution_overlap(const tr_bodies *b, tr_resolution *worst);

/* The body, disk b or wall -1-b, with the worst rounding of its way. False: none is above TR_RESOLVED. */
bool tr_resolution_way(const tr_bodies *b, tr_resolution *worst);

/* Of a biaxial test: the overlap of two mean disks under the smaller pressure, in the box of the loose sample. */
bool tr_resolution_biaxial(const tr_biaxial *b, tr_resolution *found);

/* The force of the expected overlap of a pair [N/m], spheres [N]; 0: not known, or they do not meet. */
double tr_resolution_force(const tr_bodies *b, int a, int disk);

/* TR_BAD_CASE: already at the start, two bodies are so far out that double precision does not carry the largest allowed
 * overlap to 1 %. */
bool tr_resolution_check(const tr_bodies *b, tr_status *st);

#endif
