/* SPDX-License-Identifier: MIT */
/* The passes that take the place of tr_resultant_full where a rolling law also pulls along t. */
#ifndef TR_LAWS_ROLLING_CONJUGATE_SPRING_H
#define TR_LAWS_ROLLING_CONJUGATE_SPRING_H

#include "laws/law.h"

tr_pass_run tr_resultant_rolling_force; /* with the force f_r of the law */
tr_pass_run tr_resultant_rolling_apart; /* the same where the scene's arms are not those of f_r */

#endif
