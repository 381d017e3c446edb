/* SPDX-License-Identifier: MIT */
/* What follows from the forms that were found: objective, balanced, conjugate, and why not. */
#ifndef TR_STUDY_IDENTIFY_JUDGE_H
#define TR_STUDY_IDENTIFY_JUDGE_H

#include "study/identify.h"

/* Fills all of work->found but fit. */
void tr_identify_judge(tr_identify *work);

#endif
