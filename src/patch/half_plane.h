/* SPDX-License-Identifier: MIT */
/* The exact transient contact of two half-planes with dry friction: sliding, rolling and normal force along any path.
 * Source [Kalker1971], [Kuhn2014 eq. 6].
 *
 *   Hertz's pressure on [-a, a], a at the present P; n elements that move with the contact and scale with a, tau
 *   constant over each. Per step, in the middle of each element:
 *
 *   slip = b - A tau,   b_i = du + u_{n-1}(x_i - dr),   |tau_i| <= mu p_i,   and the law of friction    (bounded.h)
 *   A_ij = (2/(pi E_star)) int over element j of ln(d/|x_i - s|) ds: symmetric Toeplitz
 *
 * u_{n-1} is the displacement by the tractions before, on the grid before, also outside of the contact. It is not zero
 * there: material comes in deformed.
 *
 * One step is implicit: where it slips, the direction is that at the end of the step. Steps of dr = h or less resolve
 * the transient of rolling; a grid that scales by more than about a/n in one step resolves that of loading. Shorter
 * ones are somewhat less accurate than dr = h, where u_{n-1} is read in the middle of elements: errors are O(h).
 *
 * By force, du is the multiplier of sum tau h = Q. At |Q| = mu P (to 1e-12) every larger du also fits: du is the
 * smallest at which all slips, the limit from below.
 *
 * P = 0: open, without memory. a(P) >= d is refused. Cost: n^3/24 multiplications at most, where the sets change (per
 * guess); n^2 logarithms where P changes, else 2n.
 * differs: [Kuhn2014 eq. 6] has the sign right only for u^p - u^q. */
#ifndef TR_PATCH_HALF_PLANE_H
#define TR_PATCH_HALF_PLANE_H

#include "base/checkpoint.h"
#include "patch/patch.h"

typedef struct tr_half_plane tr_half_plane;

/* An open contact with n elements, 2 to TR_PATCH_MAX; memory 10 n^2 bytes. NULL on failure. */
tr_half_plane *tr_half_plane_new(const tr_patch_pair *pair, int n, tr_status *st);
void tr_half_plane_free(tr_half_plane *o);

/* Fails as tr_patch_step_check does, at a >= d, and where the solution does not converge (TR_NUMERICAL, with the
 * residual). After a failure the contact is open. */
bool tr_half_plane_step(tr_half_plane *o, const tr_patch_step *step, tr_status *st);

/* The same for a row of a path, of any length: cut.h cuts it into steps. */
bool tr_half_plane_go(tr_half_plane *o, const tr_patch_step *row, tr_status *st);

/* Tractions, slip and the start of the next step; grid and matrices follow from P. To load: into a new one. */
void tr_half_plane_checkpoint(tr_half_plane *o, tr_checkpoint *c);

/* Valid until the next step. */
const tr_patch_state *tr_half_plane_state(const tr_half_plane *o);

#endif
