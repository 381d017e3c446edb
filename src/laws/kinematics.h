/* SPDX-License-Identifier: MIT */
/* The passes that every scene has; they use no data. */
#ifndef TR_LAWS_KINEMATICS_H
#define TR_LAWS_KINEMATICS_H

#include "laws/law.h"

/* tests/laws/test_arms.c shows each claim to hold, and to fail where it is not made. */
typedef enum tr_arms_claims {
    TR_ARMS_OBJECTIVE = 1, /* a rigid rotation does not slide */
    TR_ARMS_BALANCED = 2,  /* the arms of the torques add up to |X21|: friction keeps angular momentum */
    TR_ARMS_CONJUGATE = 4, /* the power of friction is -Q Vs */
} tr_arms_claims;

/* Arms from the centres to the contact point: a row of kinematics.c. Some codes have others in the velocity than in the
 * torque. */
typedef struct tr_arms {
    const char *name;    /* as contact.arms takes it */
    const char *sliding; /* the row of tr_sliding_velocities that is their sliding velocity */
    const char *source, *formula;
    unsigned claims;          /* tr_arms_claims */
    tr_pass_run *arms;        /* after kinematics: writes the arms of the torques into r1, r2 */
    /* The kinematics of a scene with them: of two disks; of a disk in a ring, R1 < 0; of a disk at a wall; the same
     * where the wall has ends, and g1 = 0 at one of them, a point. */
    tr_pass_run *pair, *ring, *wall, *edge;
} tr_arms;

/* The first tr_n_arms may stand in scenes; `trundle measures` has all. */
extern const tr_arms tr_arms_rows[];
extern const int tr_n_arms, tr_n_arms_measured;

tr_pass_run tr_kinematics_pair;   /* two disks, shared arms */
tr_pass_run tr_kinematics_ring;   /* body 1 is a ring around body 2: R1 < 0; shared arms */
tr_pass_run tr_kinematics_wall;   /* body 1 is a plane: gather writes nx, ny, and the distance of the centre into dx */
tr_pass_run tr_resultant_central; /* only normal forces: no torque */
tr_pass_run tr_resultant_full;

#endif
