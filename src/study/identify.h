/* SPDX-License-Identifier: MIT */
/* trundle identify: which definitions, levers and arms are behind the answers of a code, and what they break. */
#ifndef TR_STUDY_IDENTIFY_H
#define TR_STUDY_IDENTIFY_H

#include "study/identify_judge.h"

/* Free the work, also after a failure. */
bool tr_identify_make(tr_identify *work, tr_status *st);
void tr_identify_free(tr_identify *work);

#endif
