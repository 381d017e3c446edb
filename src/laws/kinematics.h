/* SPDX-License-Identifier: MIT */
/* The passes that every scene has; they use no data. */
#ifndef TR_LAWS_KINEMATICS_H
#define TR_LAWS_KINEMATICS_H

#include "laws/law.h"

tr_pass_run tr_kinematics_pair;   /* two disks */
tr_pass_run tr_kinematics_wall;   /* body 1 is a plane: gather writes nx, ny, and the distance of the centre into dx */
tr_pass_run tr_resultant_central; /* normal force alone: no torque */
tr_pass_run tr_resultant_full;

#endif
