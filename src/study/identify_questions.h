/* SPDX-License-Identifier: MIT */
/* From the cells of the table to numbers that a definition can explain. */
#ifndef TR_STUDY_IDENTIFY_QUESTIONS_H
#define TR_STUDY_IDENTIFY_QUESTIONS_H

#include "study/identify_forms.h"
#include "study/identify_read.h"

enum {
    TR_ASK_V_R,
    TR_ASK_M1,
    TR_ASK_M2,
    TR_ASK_CAP1,
    TR_ASK_CAP2,
    TR_ASK_V_S,
    TR_ASK_F_T,
    TR_ASK_ARM1,
    TR_ASK_ARM2,
    TR_ASKS,
    TR_QUESTIONS = 2 * TR_ASKS /* of two disks, then of a disk at a wall: codes treat walls in their own ways */
};

typedef struct tr_question {
    char name[20]; /* of its line in the report */
    bool wall;
    int cell; /* its column, for messages */
    tr_family family;
    double sign;      /* of an answer by the signs of the house */
    bool moment;      /* velocity times lever */
    bool length;      /* an arm or a cap: errors are relative, row by row */
    int n, *row;      /* rows of the table that answer it; owned */
    double *y, scale; /* what they answer; owned. Greatest |y| */
} tr_question;

typedef struct tr_questions {
    tr_question of[TR_QUESTIONS];
    /* Rows with both moments, in turn: greatest |M1 + M2|, greatest |M1| or |M2| of them, and its line */
    double sum, moment;
    long sum_line;
} tr_questions;

/* Free it, also after a failure. TR_BAD_CASE with "path:line: error: ...". */
bool tr_questions_make(tr_questions *q, const tr_identify_table *table, tr_status *st);
void tr_questions_free(tr_questions *q);

#endif
