/* SPDX-License-Identifier: MIT */
/* What a sample is like, as numbers of the field. */
#ifndef TR_MEASURES_H
#define TR_MEASURES_H

#include "core/record.h"

typedef struct tr_measures {
    int n_contacts;          /* touching, disk-disk and wall-disk */
    int n_disk_contacts;     /* disk-disk alone */
    double coordination;     /* (2 disk-disk + wall-disk contacts) / disks */
    double sliding_fraction; /* share of the disk-disk contacts at the friction bound */
    double rolling_share;    /* sum |V_r| / sum (|V_r| + |V_s|) over disk-disk contacts */
    double
        opposed_fraction;   /* share of the disk-disk contacts with s1 s2 < 0: the rims run opposite ways, as in sliding
                                (pure rolling: s1 = s2), and "model 2" sees no rolling [Wang2015 eqs. 23-24, Fig. 5].
                                The same as |s1 - s2| > |s1 + s2|: more sliding than mean flow through the contact */
    double mobilisation;    /* mean over disk-disk contacts */
    double unbalanced;      /* mean net force on a disk / mean contact force */
    double mean_f_n;        /* [N/m] */
    double largest_overlap; /* delta / smaller radius */
} tr_measures;

/* From the state of the last tr_step_forces and its records. */
tr_measures tr_measures_of(const tr_world *world, const tr_record *records, int n);

double tr_measures_disk_area(const tr_disks *disks); /* sum of pi R^2; overlaps not corrected [m^2] */

#endif
