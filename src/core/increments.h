/* SPDX-License-Identifier: MIT */
/* A sink for the motion of contacts of two disks over an interval, and over the way that each has rolled: the numbers
 * of [Kuhn2014 sec. 3.2]. With u_slide = int Vs dt, u_roll = int -(s1 + s2)/2 dt and u_creep = int sgn(Q) F |du_roll|,
 * F by the friction law, over the interval:
 *
 *   |u_roll|/|u_slide|    rolling over sliding [Kuhn2014 table 3]
 *   |u_creep|/|u_slide|   effect of creep, F with R_star for R/2 [Kuhn2014 eq. 17, table 4]
 *
 * of the contacts that touched all the time; the sums of every contact are in its record. Kuhn takes both from the
 * velocities of an instant; in a packing with inertia these include its vibrations, and an interval averages them out.
 *
 * A run is a way in one direction, int |du_roll|/a, a = sqrt(4 P R/(pi E_star)) or cbrt(3 P R/(4 E_star)) of each step
 * (tr_law_width). It ends where the contact opens or has rolled back by a tenth of a, so vibrations do not end it. A
 * way below a tenth of a is no run. Runs that end in the interval are counted by length, in bins of which 20 are a
 * decade.
 *
 * Stress: the difference sigma_y - sigma_x as sum over contacts of f l, normal and tangential force separately; `share`
 * is the fraction of the latter.
 *
 * P = 0: a = 0, no run gets longer. No E_star: no a, no runs.
 */
#ifndef TR_CORE_INCREMENTS_H
#define TR_CORE_INCREMENTS_H

#include "core/world.h"

enum { TR_RUN_BINS = 140 }; /* from a tenth of a to 1e6 a */

typedef struct tr_increments {
    tr_sink sink;  /* the first: passes get it */
    double E_star; /* that sets a [Pa]; 0: none */
    struct tr_increments_sums {
        double steps, touching;     /* contacts that touch, summed over the steps */
        double widths;              /* a over contacts and steps [m] */
        double normal, tangential;  /* f_y l_y - f_x l_x [N] */
        double runs[TR_RUN_BINS];   /* number */
        double rolled[TR_RUN_BINS]; /* of their lengths [a] */
    } since;                        /* the last read */
} tr_increments;

typedef struct tr_spread {
    double q1, median, q3, mean;
} tr_spread;

/* All 0 where there is nothing to tell of. Field, column of history.csv, what the column is divided by: a new one
 * is a row here and its line in increments.c. R: mean radius of the disks. A SPREAD is four columns. */
#define TR_INCREMENTS(ROW, SPREAD)                                                                                     \
    ROW(followed, "followed", 1) /* contacts that touched all the time, over the mean number of those that touch */    \
    SPREAD(roll, "roll_over_slide")                                                                                    \
    SPREAD(creep, "creep_over_slide")                                                                                  \
    ROW(width, "a_over_R", R)                            /* mean of a over contacts and steps [m] */                   \
    ROW(tangential, "friction_share_of_q", 1)            /* share of friction in sigma_y - sigma_x */                  \
    ROW(run, "run_over_a_median", 1)                     /* half of the runs, */                                       \
    ROW(run_by_length, "run_over_a_median_by_length", 1) /* and half of the way in runs, is longer [a] */              \
    ROW(long_runs, "rolled_in_runs_above_2a", 1)         /* share of the way in runs that is in runs above 2 a */

#define TR_INCREMENT_FIELD(name, ...) double name;
#define TR_INCREMENT_SPREAD(name, ...) tr_spread name;
typedef struct tr_increments_state {
    TR_INCREMENTS(TR_INCREMENT_FIELD, TR_INCREMENT_SPREAD)
} tr_increments_state;

/* Motion of one contact since the last read, or since it touched [m]; signs like Vs, s1 and s2. */
typedef struct tr_increment {
    double slide, roll, creep;
    bool followed; /* it touched all the time */
} tr_increment;

/* Starts it; *increments must outlive the world's laws. Call it after the laws are set. */
void tr_increments_attach(tr_world *world, tr_increments *increments);

/* After tr_step_forces, of contact i of a group; all 0 without this sink: walls have none. */
tr_increment tr_increments_of(const tr_group *group, int i);

/* After tr_step_forces; a new interval begins. */
bool tr_increments_read(tr_increments *increments, tr_increments_state *state, tr_status *st);

#endif
