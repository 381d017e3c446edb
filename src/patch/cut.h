/* SPDX-License-Identifier: MIT */
/* A row of a path, of any length, for solvers that need short steps. Only this file cuts rows. Along a row dr, du
 * (or, by force, Q) and P are linear.
 *
 * Rolling: in pieces of an element h = 2a/n, the first one shorter. Loading: where the contact also slides or rolls, P
 * goes in stairs. On each a changes by no more than an element of the wider end, and then stays. So does a prescribed Q
 * while the contact rolls, by no more than 2/n of mu P. Sliding without loading and loading without sliding need no
 * cut: the direction of slip does not change within the row.
 *
 * Long rolling. On a stair all rates are constant, and the contact tends to a steady state: the rest falls at least as
 * fast as exp(-L/(Lambda a)) over the roll L. When a piece changes no traction by more than 2e-2/(n^2 Lambda) of mu p0,
 * less than 1e-2/n is left to come, a tenth of the error of the elements or less. From then on, or after 20 Lambda a
 * (e^-20), the later pieces are taken as equal to this one. So a stair has at most 10 Lambda n pieces, for any roll.
 * (Lambda: at least 1.)
 *
 * The state then describes the whole row: du and dissipated are sums over the pieces, slip[i] is the sum of the slip at
 * element i while material ran through it.
 *
 * The path between the ends of a row is not known. It is taken as straight. */
#ifndef TR_PATCH_CUT_H
#define TR_PATCH_CUT_H

#include "patch/patch.h"

/* Equal steps from half-width a_from to a, with the roll dr: in each the contact rolls at most an element 2a/n, and a
 * changes by at most one. At most 1000: for laws, longer steps do no harm in a steady state. a = 0: 1. */
int tr_patch_pieces(double a_from, double a, int n, double dr);

/* Takes `row` by calls of `piece`, each a step from the present state. False: piece failed, or the row is refused
 * (tr_patch_step_check). */
typedef bool tr_patch_piece(void *body, const tr_patch_step *piece, tr_status *st);
bool tr_patch_walk(tr_patch_state *s, const tr_patch_pair *pair, const tr_patch_step *row, tr_patch_piece *piece,
                   void *body, tr_status *st);

#endif
