/* SPDX-License-Identifier: MIT */
/* What follows from the forms that were found: objective, balanced, conjugate, and why not. */
#ifndef TR_STUDY_IDENTIFY_JUDGE_H
#define TR_STUDY_IDENTIFY_JUDGE_H

#include "study/identify_fit.h"

/* What may be wrong, in the order in which it is told. */
enum { TR_MOST_FINDINGS = 24, TR_FINDING_WORDS = 420 };
typedef enum tr_answer { TR_NOT_TOLD, TR_YES, TR_NO } tr_answer;

typedef struct tr_identified {
    tr_fit fit[TR_QUESTIONS]; /* question NULL: not asked */
    tr_answer objective, balanced, conjugate;
    bool unclear; /* an answer is none of the tables, or more than one explains it */
    int n_reasons, n_notes;
    char reason[TR_MOST_FINDINGS][TR_FINDING_WORDS], note[TR_MOST_FINDINGS][TR_FINDING_WORDS];
} tr_identified;

/* All of a file; table->path and table->map are given. */
typedef struct tr_identify {
    tr_identify_table table;
    tr_states states;
    tr_probes probes;
    tr_questions questions;
    tr_identified found;
} tr_identify;

/* Fills all of work->found but fit. */
void tr_identify_judge(tr_identify *work);

/* Objective, balanced and conjugate as far as it is told, and nothing unclear. */
bool tr_identify_is_good(const tr_identified *found);

#endif
