/* SPDX-License-Identifier: MIT */
/* Measures of a sample, as used in the field. */
#ifndef TR_MEASURES_H
#define TR_MEASURES_H

#include "core/record.h"

/* Field, unit "disk|sphere", and 1 where the mean over the residual is in summary.json. They are columns of
 * history.csv: a new one is a row here and its line in measures.c. Contacts are disk-disk alone unless it says
 * otherwise.
 *
 * opposed_fraction: the rims run opposite ways, as in sliding (pure rolling: s1 = s2), and "model 2" sees no
 * rolling [Wang2015 eqs. 23-24, Fig. 5]. The same as |s1 - s2| > |s1 + s2|: more sliding than mean flow through
 * the contact. */
#define TR_CONTACT_MEASURES(ROW)                                                                                       \
    ROW(n_contacts, "1", 0)       /* touching, disk-disk and wall-disk */                                              \
    ROW(coordination, "1", 0)     /* (2 disk-disk + wall-disk contacts) / disks */                                     \
    ROW(sliding_fraction, "1", 0) /* share of the contacts at the friction bound */                                    \
    ROW(rolling_share, "1", 1)    /* sum |V_r| / sum (|V_r| + |V_s|) */                                                \
    ROW(opposed_fraction, "1", 1) /* share of the contacts with s1 s2 < 0 */                                           \
    ROW(mobilisation, "1", 0)     /* mean */
#define TR_FORCE_MEASURES(ROW)                                                                                         \
    ROW(unbalanced, "1", 0)      /* mean net force on a disk / mean contact force */                                   \
    ROW(mean_f_n, "N/m|N", 0)    /* of all contacts */                                                                 \
    ROW(largest_overlap, "1", 0) /* delta / smaller radius, of all contacts */

#define TR_MEASURE_FIELD(name, ...) double name;
typedef struct tr_measures {
    TR_CONTACT_MEASURES(TR_MEASURE_FIELD)
    TR_FORCE_MEASURES(TR_MEASURE_FIELD)
} tr_measures;

/* From the state of the last tr_step_forces and its records. */
tr_measures tr_measures_of(const tr_world *world, const tr_record *records, int n);

double tr_measures_disk_area(const tr_disks *disks); /* sum of pi R^2; overlaps not corrected [m^2] */

#endif
