/* SPDX-License-Identifier: MIT */
/* Whether places can carry the overlaps of a scene: kind `bodies`, before the run.
 *
 * An overlap is a small difference of places, and neighbouring doubles are 2^-52 of a place apart: at 1e5 m 1.5e-11 m,
 * a thousandth of the overlap of disks of 1 um that meet with 0.2 m/s. Places count as far as the run may lead, by
 * velocities and by gravity along walls. The overlap to expect of a pair is the largest of that at the start, that
 * under the weight of one, and that of a blow with the relative velocity; where none of these is known,
 * TR_EXPECTED_OVERLAP of the smaller radius. Pairs too far apart to meet do not count.
 *
 * A velocity has the same limit: what it moves a body in a step is rounded to these places, each time alike. */
#ifndef TR_RESOLUTION_H
#define TR_RESOLUTION_H

#include "core/biaxial.h"
#include "core/bodies_state.h"

#define TR_RESOLVED 1e-6 /* of an overlap, of the way of a step: what rounding may take */

typedef struct tr_resolution {
    int a, b;       /* as in tr_scene_pick: two disks, or wall -1-a and disk b */
    double reach;   /* the largest coordinate [m] */
    double spacing; /* of doubles there [m] */
    double size;    /* of the overlap, or of the way of a step [m] */
    int more;       /* further such pairs, further such bodies */
} tr_resolution;

/* The pair whose overlap is carried worst, if it is not to TR_RESOLVED. False: all are. */
bool tr_resolution_overlap(const tr_bodies *b, tr_resolution *worst);

/* The body, disk b or wall -1-b, whose velocity moves it worst. False: all are moved to TR_RESOLVED. */
bool tr_resolution_way(const tr_bodies *b, tr_resolution *worst);

/* Of a biaxial test: the overlap of two mean disks under the smaller pressure, in a box as large as it was thrown. */
bool tr_resolution_biaxial(const tr_biaxial *b, tr_resolution *found);

/* The force of the overlap to expect of a pair [N/m], spheres [N]; 0: nothing tells it, or they do not meet. */
double tr_resolution_force(const tr_bodies *b, int a, int disk);

/* TR_BAD_CASE: at the start already, two bodies are so far out that the largest overlap a contact may have is not
 * carried to 1 %. */
bool tr_resolution_check(const tr_bodies *b, tr_status *st);

#endif
