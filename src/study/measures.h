/* SPDX-License-Identifier: MIT */
/* Every rolling and sliding measure of one motion of two bodies at a contact: of rows of a CSV file, and of the card of
 * the pure motions. Numbers that a pass of laws/ computes come from that pass, run over tiles as in an assembly.
 *
 * A measure needs no overlap: any distance of the centres above 0 is enough.
 *
 * A ring around body 2 is body 1 with R1 = -(its inner radius); n then points from x2 to x1.
 *
 * A wall is body 1 with R1 = INFINITY: the plane through x1 (the foot of the perpendicular from the disk) with its
 * normal towards x2. It may move (v1, of its material at x1) and turn (w1). All numbers are then as seen from the wall,
 * except beta_dot, which is the spin of its normal, w1; lambda_dot, alpha1_dot and alpha2_dot are the limits for R1 ->
 * inf: 0, 0 and w2 - w1. */
#ifndef TR_STUDY_MEASURES_H
#define TR_STUDY_MEASURES_H

#include "base/status.h"
#include <stddef.h>
#include <stdio.h>

/* One motion; the names are the columns of the file. Radii and centres [m], velocities [m/s], spins [rad/s]. */
typedef struct tr_motion {
    double R1, R2, x1x, x1y, x2x, x2y, v1x, v1y, v2x, v2y, w1, w2;
} tr_motion;

/* Its measures, per unit time. n = X21/|X21|, in a ring -X21/|X21|, t = n x k. Velocities [m/s]; beta_dot, lambda_dot,
 * alpha1_dot, alpha2_dot and angles [rad/s]. */
enum { TR_MOST_DEFINITIONS = 24, TR_MOST_ARMS = 8 };
typedef struct tr_motion_measures {
    double beta_dot; /* spin of the line of centres */
    double Vt;       /* (v2 - v1).t */
    double da, db;   /* arcs [Wang2015 eq. 17]: da = s1, db = -s2 */
    double s1, s2;   /* objective velocities [Wang2015 eqs. 23-24, t reversed] */
    double rolling[TR_MOST_DEFINITIONS], sliding[TR_MOST_DEFINITIONS]; /* by the rows of tr_rolling_velocities and of
                                                                          tr_sliding_velocities */
    double lambda_dot, alpha1_dot, alpha2_dot; /* pure sliding and pure rolling parts [Wang2015 eq. 8] */
    struct {
        double r1, r2; /* arms of the torques of friction [m] */
        double power;  /* of a unit force of friction with them, Vt + r1 w1 + r2 w2 [m/s]: that of Vs, if conjugate */
    } arms[TR_MOST_ARMS]; /* by the rows of tr_arms_rows */
} tr_motion_measures;

/* A column of the file and its double in the struct. */
typedef struct tr_measures_column {
    const char *name;
    size_t offset;
} tr_measures_column;

enum { TR_MOTION_COLUMNS = 12, TR_CASE_LABEL = 256 };
extern const tr_measures_column tr_motion_columns[TR_MOTION_COLUMNS];
int tr_measures_columns(void);                   /* number of columns, with those of every definition */
tr_measures_column tr_measures_column_of(int k); /* column k from 0 */
double tr_measures_of_column(const tr_motion_measures *measures, const char *name); /* NAN: no such name */

/* The sliding velocity by the row of tr_sliding_velocities of this name, which must be there. */
double tr_measures_sliding_of(const tr_motion_measures *measures, const char *name);

/* measures[i] of motion[i], i < n. Motions must be finite (but for R1), radii and distances above 0. TR_FILE when
 * memory is short. */
bool tr_measures_motions(const tr_motion *motion, int n, tr_motion_measures *measures, tr_status *st);

/* A row as CSV, 17 significant digits: case, motion, measures; arms: those of every row of the table too. */
void tr_measures_write_header(FILE *out, bool arms);
void tr_measures_write(FILE *out, const char *label, const tr_motion *motion, const tr_motion_measures *measures,
                       bool arms);

/* Reads the table at path and writes it with its measures to out; columns in any order, others than `case` and those of
 * tr_motion are left out of the result. Rows stream: memory does not grow with the file. On failure (TR_BAD_CASE with
 * "path:line: error: ...", or TR_FILE) rows may have been written. */
bool tr_measures_csv(const char *path, bool arms, FILE *out, tr_status *st);

/* ---- the card: pure motions [Wang2015 eqs. 1-6, 14-15] */

typedef struct tr_card_motion {
    const char *name; /* "PR + RBR", "floor: rolling" */
    char label[48];   /* the row's `case` in CSV */
    tr_motion motion;
    double Vr, Vs; /* by the definition of the motion [m/s] */
} tr_card_motion;

enum { TR_CARD_MOTIONS = 42 }; /* of each two in a row: as a resting, and as a moving and turning observer sees it */
#define TR_CARD_R2 0.01        /* radius of disk 2 [m] */
#define TR_CARD_U 0.01         /* speed of each motion [m/s] */
void tr_measures_card(tr_card_motion card[TR_CARD_MOTIONS]);

#endif
