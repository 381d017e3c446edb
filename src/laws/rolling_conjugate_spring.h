/* SPDX-License-Identifier: MIT */
/* The pass that takes the place of tr_resultant_full where a rolling law also pulls along t. */
#ifndef TR_LAWS_ROLLING_CONJUGATE_SPRING_H
#define TR_LAWS_ROLLING_CONJUGATE_SPRING_H

#include "laws/law.h"

tr_pass_run tr_resultant_rolling_force; /* with the force f_r of the law */

#endif
