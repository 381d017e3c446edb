/* SPDX-License-Identifier: MIT */
/* A sink that follows chosen contacts, at any place in the list: the path that drives their laws,
 *
 *   u_slide += Vs dt,   u_roll += -(s1 + s2)/2 dt    while they touch
 *
 * with the Vs, s1, s2 and dt that the laws had, and the P that the friction law had: f_n, or its elastic part if a
 * dashpot carries no friction (laws on the bed, laws/bed.h). So kind: contact gives the same friction along this path.
 *
 * Or all contacts: then sums and state are histories of the group, which follow the contact and are in its checkpoints.
 * A life of a contact lasts from touching to opening; lives are numbered from 1 as they begin. */
#ifndef TR_CORE_PATHS_H
#define TR_CORE_PATHS_H

#include "core/world.h"

typedef struct tr_path_point {
    double u_slide, u_roll; /* [m] since the sink was attached; they do not change while the contact is open */
    double P, Q;            /* [N/m]; 0 while it is open */
} tr_path_point;

struct tr_paths {
    tr_contact_ids contacts; /* none of them most-mobilised */
    tr_path_point now[TR_MAX_CONTACT_IDS];
    bool all;
    int64_t lives, taken; /* of all: begun so far; of them read at least once */
};

/* A touching contact, and how far it has slid and rolled since the last read, or since it touched. */
typedef struct tr_path_life {
    int a, b; /* disks; a = -1-w for wall w */
    double life, R1, R2;
    double slide, roll, P, Q, f_n; /* f_n: the whole normal force */
    double x, y;                   /* branch: from the centre of a, from the foot at a wall, to the centre of b [m] */
} tr_path_life;

/* Follows paths->contacts, and all if it is set; *paths must outlive the world's laws. Call it after the laws are set.
 */
void tr_paths_attach(tr_world *world, tr_paths *paths);

/* After every tr_step_forces: the state of contact k. */
tr_path_point tr_paths_take(tr_paths *paths, int k);

/* After tr_step_forces, of all: contact i of group->n. False: it is open. */
bool tr_paths_life(tr_group *group, int i, tr_path_life *life);

#endif
