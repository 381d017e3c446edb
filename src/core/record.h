/* SPDX-License-Identifier: MIT */
/* One touching contact, for contacts.csv and frames. Read from finished tiles. */
#ifndef TR_RECORD_H
#define TR_RECORD_H

#include "core/increments.h"

typedef struct tr_record {
    int a, b;                    /* disks; a = -1-w for wall w */
    double x, y;                 /* contact point: at the arms r1, r2 on the line of centres [m] */
    double nx, ny;               /* from a to b */
    double R1, R2;               /* [m]; R1 = 0 at a wall */
    double delta;                /* overlap [m] */
    double f_n, f_t;             /* [N/m]; friction on b is -f_t t, t = (ny, -nx) */
    double f_r;                  /* force of the rolling law, like f_t; 0 for most [N/m] */
    double m1, m2;               /* rolling moments on a and b [N] */
    double v_n, v_s, v_r;        /* approach, sliding, rolling (scene's definition) [m/s] */
    double s1, s2;               /* [m/s] */
    double mobilisation;         /* |f_t| / its bound mu f_n, 0..1; 0 without friction */
    double rolling_mobilisation; /* the larger of |m1|, |m2| / its bound; 0 without rolling resistance */
    tr_increment increment;      /* all 0 unless the world has that sink */
    double da, db; /* arcs rolled over rims a and b since the contact formed [m]; 0 unless the world tracks arcs */
    double v_r_by[TR_MAX_VELOCITY_MEASURES]; /* rolling velocity by every definition, in the order of the registry */
    double v_s_by[TR_MAX_VELOCITY_MEASURES]; /* sliding velocity by every definition; v_s is Wang's */
} tr_record;

/* Contacts with overlap > 0 as of the last tr_step_forces, disk-disk first, then wall-disk, each sorted by (a, b).
 * Changes nothing in the world. Returns how many; *records points to an array of *capacity records that grows as
 * needed. */
int tr_record_all(tr_world *world, tr_record **records, int *capacity, tr_status *st);

#endif
