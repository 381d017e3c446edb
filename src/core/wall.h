/* SPDX-License-Identifier: MIT */
/* Where a wall and a disk touch.
 *
 * A wall without ends is the edge of a half-plane: disks are on the side of its normal. A wall with ends is a thin
 * plate from u = from to u = to, u along t = n x k from (x, y). Disks may be on both sides of it, and at its ends,
 * which are corners: the nearest point gives the normal. A corner is a point, a body of radius 0. There the disk keeps
 * the normal law of the face (of the same stiffness, so that its force is continuous), its arm is the distance, and
 * what a law scales by R_eff = 0 is gone: there is no rolling moment.
 *
 * JOINTS. Where walls meet, one disk touches one of them: the corner of a wall is not felt where it lies on another
 * wall whose face the disk is over; of two corners in one place the wall with the lower number has it. A joint of two
 * walls in line is passed without a bump. A contact is of a wall and a disk, so histories begin anew behind a joint.
 *
 * A BELT moves its surface along the contact's own t: forward on the face, backward on the back, around the ends. */
#ifndef TR_WALL_H
#define TR_WALL_H

#include "core/world.h"

typedef struct tr_wall_touch {
    double distance; /* of the disk's centre from the nearest point [m]; below 0 behind a wall without ends */
    double nx, ny;   /* from there to the centre */
    bool corner;     /* it is an end */
} tr_wall_touch;

/* pos: of a disk, x and y first. */
tr_wall_touch tr_wall_nearest(const tr_wall *wall, const double *pos);

/* The disk touches another wall where the corner of wall w is that it is nearest to. */
bool tr_wall_taken(const tr_world *world, int w, const double *pos);

/* Distance from the whole plane [m]. */
static inline double tr_wall_height(const tr_wall *wall, const double *pos) {
    return (pos[0] - wall->x) * wall->nx + (pos[1] - wall->y) * wall->ny;
}

static inline double tr_wall_distance(const tr_wall *wall, const double *pos) {
    return wall->ends ? tr_wall_nearest(wall, pos).distance : tr_wall_height(wall, pos);
}

#endif
