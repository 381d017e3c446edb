/* SPDX-License-Identifier: MIT */
/* The best form for the answers to a question, those that are the same, those that fit as well, and the motion
 * that would tell them apart. */
#ifndef TR_STUDY_IDENTIFY_FIT_H
#define TR_STUDY_IDENTIFY_FIT_H

#include "study/identify_questions.h"

/* Random motions on which forms are compared: whatever agrees on all of them is the same. The first n/2 as a resting
 * observer sees them, the others the same as a moving and turning one does. */
typedef struct tr_probes {
    tr_states states;
    int n;
    double fit; /* greatest relative error of an answer that is explained */
} tr_probes;
bool tr_probes_make(tr_probes *p, bool pairs, bool walls, tr_status *st);
void tr_probes_free(tr_probes *p);

enum { TR_MOST_SAME = 4, TR_MOST_TIES = 4 };
typedef struct tr_fit {
    const tr_question *question;
    bool fits;    /* the error is small enough for an explanation */
    tr_form best; /* with the factor */
    double error; /* greatest, relative to the greatest answer; of lengths to each */
    bool has_runner;
    tr_form runner; /* the best of those that are not the same as best */
    double runner_error;
    int n_same, n_ties;
    tr_form same[TR_MOST_SAME]; /* other words for best */
    tr_form tie[TR_MOST_TIES];  /* others that fit as well: which of them it is cannot be told */
    int apart;                  /* the probe that tells best from tie[0] */
    bool objective;             /* best is, on the probes */
    /* two rows that show one motion to two observers, and differ; line[0] is 0: none */
    long line[2];
    double differs; /* by so much of the greatest answer */
    int pairs;      /* rows that show a motion of another row, to another observer or the same */
} tr_fit;

bool tr_fit_question(tr_fit *fit, const tr_question *q, const tr_identify_table *table, const tr_states *states,
                     const tr_probes *probes, tr_status *st);

/* Relative difference of two forms on the probes with or without a wall: greatest, and the probe where it is. */
double tr_fit_difference(const tr_form *a, const tr_form *b, bool wall, const tr_probes *probes, int *where);

#endif
