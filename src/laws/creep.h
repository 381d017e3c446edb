/* SPDX-License-Identifier: MIT */
/* The rolled distance, for friction laws on the bed. */
#ifndef TR_CREEP_H
#define TR_CREEP_H

#include "laws/bed.h"

#include <math.h>

typedef struct tr_creep_par {
    tr_bed_par bed;
    double E_star;
    int creep_roll;
} tr_creep_par;

#define TR_CREEP_PARAMS(par) TR_BED_PARAMS(par), TR_ROW_E_STAR(par, E_star), TR_ROW_CREEP_ROLL(par, creep_roll)

/* |du_roll| of this step [m]. */
static inline double tr_creep_roll(const tr_creep_par *p, const tr_tile *tile, int i) {
    double weight = p->creep_roll ? tile->g1[i] : 0.5;
    return fabs((1 - weight) * tile->s1[i] + weight * tile->s2[i]) * tile->dt;
}

#endif
