/* SPDX-License-Identifier: MIT */
/* Pairs of several sizes and directions in one tile, driven by hand through the passes of an assembly. */
#ifndef TR_VERIFY_EXACT_TILE_H
#define TR_VERIFY_EXACT_TILE_H

#include "base/status.h"
#include "laws/law.h"
#include "scene/scene.h"

enum { TR_PAIRS = 8, TR_NORMAL_SLOT = 0, TR_FRICTION_SLOT, TR_ROLLING_SLOT };

typedef struct tr_pairs_tile {
    tr_tile tile;
    double R1[TR_TILE], R2[TR_TILE], g1[TR_TILE], nx[TR_TILE], ny[TR_TILE];
    double hist[3][TR_MAX_HIST][TR_TILE], pair[3][TR_MAX_PAIR][TR_TILE];
    double *hist_at[3][TR_MAX_HIST], *pair_at[3][TR_MAX_PAIR];
    double par[3][TR_LAW_PAR];
    const tr_law *law[3];
    const char *rolling_velocity;
    tr_shape shape;
} tr_pairs_tile;

/* delta: overlap of the smaller radius; v_n: its rate [m/s]; Vt, spins; W: an observer who turns at -W. */
typedef struct tr_pair_motion {
    double delta, v_n, Vt, w1, w2, W;
} tr_pair_motion;

/* All histories 0. The law under test has only a normal spring beside it; its parameters are the defaults or, without
 * defaults, a stiffness 2e6 and a number 0.3. */
void tr_pairs_set(tr_pairs_tile *p, int slot, const tr_law *law);
void tr_pairs_drive(tr_pairs_tile *p, int i, tr_pair_motion m);
void tr_pairs_run(tr_pairs_tile *p, double dt);

#endif
