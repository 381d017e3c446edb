/* SPDX-License-Identifier: MIT */
/* From the rows of a table of definitions to its passes and its array. The file that includes this has
 *
 *   OUT             the lane of the tile that gets the velocity: v_r or v_s
 *   LANE(tile, i)   declares the variables for a formula, of contact i
 *
 * and rows X(function, name, column of `trundle measures`, head of its card, claims, source, formula, V, dV/ds1,
 * dV/ds2). */
#ifndef TR_VELOCITY_ROWS_H
#define TR_VELOCITY_ROWS_H

#include "base/vector.h"
#include "laws/law.h"

#define PASSES(function, name, column, head, claims, source, formula, V, V1, V2)                                       \
    TR_VECTOR static void function(tr_tile *restrict tile, const tr_law_data *data) {                                  \
        (void)data;                                                                                                    \
        for (int i = 0; i < tile->n; i++) {                                                                            \
            LANE(tile, i);                                                                                             \
            tile->OUT[i] = V;                                                                                          \
        }                                                                                                              \
    }                                                                                                                  \
    TR_VECTOR static void function##_partials(tr_tile *restrict tile, const tr_law_data *data) {                       \
        (void)data;                                                                                                    \
        for (int i = 0; i < tile->n; i++) {                                                                            \
            LANE(tile, i);                                                                                             \
            tile->OUT[i] = V, tile->p1[i] = V1, tile->p2[i] = V2;                                                      \
        }                                                                                                              \
    }
#define ROW(function, name, column, head, claims, source, formula, V, V1, V2)                                          \
    {name, column, head, source, formula, claims, function, function##_partials},
#define ONE(...) +1
#define CHOICE(function, name, ...) "|" name

#endif
