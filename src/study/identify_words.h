/* SPDX-License-Identifier: MIT */
/* What was identified, as text and as a table. */
#ifndef TR_STUDY_IDENTIFY_WORDS_H
#define TR_STUDY_IDENTIFY_WORDS_H

#include "study/identify_judge.h"

void tr_identify_print(FILE *out, const tr_identify *work); /* the verdict and its reasons first */
void tr_identify_write(FILE *out, const tr_identify *work); /* CSV: one line for each answer, then the verdicts */

#endif
