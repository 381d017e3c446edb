/* SPDX-License-Identifier: MIT */
/* One impact of two free disks (or spheres), or of one on a wall; overlaps of 1e-6 R at tr_blow_small_speed, so that
 * the geometry is that of the closed forms to this order. */
#ifndef TR_VERIFY_EXACT_STRIKE_H
#define TR_VERIFY_EXACT_STRIKE_H

#include "base/status.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

#define TR_BLOW_RADIUS 0.01
#define TR_BLOW_DENSITY 1000.0
#define TR_BLOW_K 1e6

/* v_s: sliding, by a velocity along t; spin: of the last body. */
typedef struct tr_blow {
    char contact[200];
    bool sphere, wall;
    double time; /* that it takes, about */
    double v_n, v_s, spin;
} tr_blow;

typedef struct tr_rebound {
    double e, duration, v_s, v_t, spin; /* after; v_t, spin: of the last body, v_t relative to the first */
    double peak;                        /* force on it */
    double damped, energy;              /* of the energy before: by the ledger; what is left in the motion */
} tr_rebound;

static inline double tr_blow_mass(const tr_blow *b) {
    return TR_BLOW_DENSITY * M_PI * TR_BLOW_RADIUS * TR_BLOW_RADIUS * (b->sphere ? 4 * TR_BLOW_RADIUS / 3 : 1);
}
static inline double tr_blow_m_eff(const tr_blow *b) {
    return b->wall ? tr_blow_mass(b) : tr_blow_mass(b) / 2;
}
static inline double tr_blow_small_speed(const tr_blow *b) {
    return 1e-6 * TR_BLOW_RADIUS * sqrt(TR_BLOW_K / tr_blow_m_eff(b));
}

/* n steps in the contact, which begins `phase` of a step after a position. */
bool tr_strike(const tr_blow *b, int n, double phase, tr_rebound *r, tr_status *st);

/* A number of the rebound (its offset): the farthest from `exact` over the phases. */
bool tr_strike_farthest(const tr_blow *b, int n, size_t what, double exact, double *value, tr_status *st);

#endif
