/* SPDX-License-Identifier: MIT */
/* The contacts of a biaxial test, each along the path that it had there (paths.csv, study/recorder.h), through the
 * exact half-plane and through every friction law: how far is each law off, where contacts of an assembly really go?
 *
 * A life of a contact is a case of kind: contact (study/contact.h), its rows are the segments: P linear, sliding and
 * rolling at constant rates from row to row; before the first row P grows from 0. All laws take the same steps, as many
 * that none rolls further than an element h = 2a/n, slides further than a tenth of what full slip takes from rest, mu
 * delta(P), or changes a by more than h (patch/cut.h; 1000 at most, in which case only the half-plane cuts on). So the
 * path between two rows is made up, but it is one path for all of them.
 *
 * Laws: 0 exact; 1 the run's own with the run's parameters, which gives the run's Q as the rows become many; then each
 * of the registry with equivalent ones: mu, E_star, depth of the run; k_t = pi E_star/(2 Lambda), the stiffness from
 * rest of the exact contact at the mean P and radius. The last column is no law but Q as recorded, of the path in all
 * its steps. Where the run has no depth, it is that of hertz-line.
 *
 * Errors. Of force: (Q - Q_exact)/(mu P) at each row. Of energy: what the law takes from the sliding bodies over a
 * life, W = int Q du_slide, less that of the exact contact, over int mu P |du_slide|, what full slip would take. A
 * contact that opens has lost it all; W of one that touches at the end has its store in it, for law and half-plane
 * alike. Stress: sum of (f_n n - Q t)_i branch_j over all contacts at an instant; the area cancels in sin phi = (S_yy -
 * S_xx)/(S_yy + S_xx). Contacts of walls, and lives that could not be replayed, keep the Q of the run there. */
#ifndef TR_REPLAY_H
#define TR_REPLAY_H

#include "study/run.h"

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

/* Reads case.yaml, history.csv and paths.csv; every disk-disk life but those left out by `every` is replayed. The
 * result does not depend on the number of jobs. TR_INTERRUPTED; TR_BAD_CASE: no such run, one that is
 * not finished, or a paths.csv that this run cannot have written. */
bool tr_replay_run(tr_replay *r, const tr_replay_options *o, tr_run_report *report, tr_status *st);
void tr_replay_free(tr_replay *r);

/* replay.csv: each life; replay-errors.csv: their distribution; replay-stress.csv: each instant (every = 1 only). */
bool tr_replay_write(const tr_replay *r, const tr_replay_options *o, tr_run_report *report, tr_status *st);

bool tr_replay_read(tr_replay *r, const char *run, tr_status *st); /* scene, rows, lives */

#endif
