/* SPDX-License-Identifier: MIT */
/* Input and results of a replay; see replay.h. */
#ifndef TR_REPLAY_DATA_H
#define TR_REPLAY_DATA_H

#include "study/report.h"

enum { TR_REPLAY_EXACT, TR_REPLAY_OWN, TR_REPLAY_LAWS = 12 }; /* at most, with the recorded Q */

typedef struct tr_replay_row {
    int life, instant; /* numbers in the file; then life: index of its tr_replay_life */
    int a, b;
    long line; /* in the file */
    double time, R1, R2, slide, roll, P, Q, f_n, x, y;
} tr_replay_row;

typedef struct tr_replay_life {
    int first, n;                /* rows */
    bool done;                   /* replayed */
    double rolled;               /* int |du_roll|/a */
    double full;                 /* int mu P |du_slide| [N] */
    double work[TR_REPLAY_LAWS]; /* int Q du_slide [N] */
} tr_replay_life;

typedef struct tr_replay {
    tr_scene scene, contact; /* of the run; of one contact: its laws and a pair that each life replaces */
    double mu, E_star, depth, k_t;
    double rate, start;    /* of strain [1/s]; time until it is reached [s], see START in core/biaxial.h */
    int n_laws, n_columns; /* of tr_contact; n_laws + 1 with the recorded Q */
    const char *name[TR_REPLAY_LAWS];
    tr_replay_row *row; /* sorted by life */
    tr_replay_life *life;
    int n_rows, n_lives, n_instants;
    double *Q;      /* n_columns of each row [N/m] */
    double *rolled; /* of each row: int |du_roll|/a since the contact formed */
} tr_replay;

typedef struct tr_replay_options {
    const char *run, *dir; /* a finished run; where the tables go */
    int jobs, elements;
    int every; /* 1: all; K: lives 0, K, 2K, ... and no stress */
    const volatile sig_atomic_t *stop;
    void (*progress)(void *context, const char *stage, double fraction);
    void *context;
} tr_replay_options;

#endif
