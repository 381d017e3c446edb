/* SPDX-License-Identifier: MIT */
/* What laws of friction on the bed need to know of rolling: its distance. */
#ifndef TR_CREEP_H
#define TR_CREEP_H

#include "laws/bed.h"

#include <math.h>

typedef struct tr_creep_par {
    tr_bed_par bed;
    double E_star;
    int creep_roll;
} tr_creep_par;

#define TR_CREEP_PARAMS(par)                                                                                           \
    TR_BED_PARAMS(par),                                                                                                \
        {"E_star",                                                                                                     \
         TR_REAL,                                                                                                      \
         TR_DIM_MODULUS,                                                                                               \
         "Pa",                                                                                                         \
         NULL,                                                                                                         \
         1e-3,                                                                                                         \
         1e15,                                                                                                         \
         NULL,                                                                                                         \
         offsetof(par, E_star),                                                                                        \
         "contact modulus, 1/E_star = sum of (1 - nu^2)/E of the two; sets the size of the contact"},                  \
    {                                                                                                                  \
        "creep_roll", TR_CHOICE, TR_DIM_NUMBER, "", "kuhn", 0, 0, "kuhn|wang", offsetof(par, creep_roll),              \
            "rolling that creeps: kuhn (s1 + s2)/2, the mean flow of material; wang R1R2/(R1+R2) (w1 - w2)"            \
    }

/* |du_roll| of this step [m]. */
static inline double tr_creep_roll(const tr_creep_par *p, const tr_tile *tile, int i) {
    double weight = p->creep_roll ? tile->g1[i] : 0.5;
    return fabs((1 - weight) * tile->s1[i] + weight * tile->s2[i]) * tile->dt;
}

#endif
