/* SPDX-License-Identifier: MIT */
/* The card that any code can run: pure motions of two bodies that overlap, each with the springs to use. A code places
 * the bodies, keeps their places, gives them the velocities for the time, and adds its forces and moments to the table;
 * `trundle identify` reads it then. */
#ifndef TR_STUDY_CARD_H
#define TR_STUDY_CARD_H

#include "study/measures.h"

typedef struct tr_card_row {
    char label[80];
    const char *experiment; /* roll: the spring of rolling; cap: its bound; slide: the spring of sliding */
    tr_motion motion;
    double overlap;                            /* [m] */
    double k_n, k_t, mu, k_roll, mu_r, time_s; /* springs, coefficients of their bounds, how long the motion lasts */
} tr_card_row;

/* Motions: of two disks in five ratios of radii, and of a disk on a floor; at two overlaps, by three observers (the
 * floor: two). Speed 0.01 m/s, smaller radius 0.01 m. */
enum { TR_CARD_PAIRS = 8 * 5 * 2 * 3, TR_CARD_FLOORS = 4 * 2 * 2, TR_CARD_ROWS = 3 * (TR_CARD_PAIRS + TR_CARD_FLOORS) };

void tr_card_make(tr_card_row row[TR_CARD_ROWS]);
void tr_card_write(FILE *out, const tr_card_row row[TR_CARD_ROWS]); /* CSV, 17 significant digits */

#endif
