/* SPDX-License-Identifier: MIT */
/* trundle identify: which definitions, levers and arms are behind the answers of a code, and what they break. */
#ifndef TR_STUDY_IDENTIFY_H
#define TR_STUDY_IDENTIFY_H

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

/* All of a file; table->path and table->map are given. Free the work, also after a failure. */
typedef struct tr_identify {
    tr_identify_table table;
    tr_states states;
    tr_probes probes;
    tr_questions questions;
    tr_identified found;
} tr_identify;
bool tr_identify_make(tr_identify *work, tr_status *st);
void tr_identify_free(tr_identify *work);

/* Objective, balanced and conjugate as far as it is told, and nothing unclear. */
bool tr_identify_is_good(const tr_identified *found);

#endif
