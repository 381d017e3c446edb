/* SPDX-License-Identifier: MIT */
/* The brush (a Winkler bed): each point of the surface is a separate bristle. Source [Kuhn2014 sec. 2.3]
 * (Kalker's simplified theory, Al-Bender).
 *
 *   tau = k_w w,   slip = du - [w_n(x) - w_{n-1}(x - dr)],   |tau| <= mu p;   w = 0 where material enters
 *   k_w = pi E_star/(4a), a at the present P: the slope dQ/dxi of Carter's law at Q = 0
 *
 * The deflection w moves with the material: read at x_i - dr between the middles of the elements (linear; 0 on the edge
 * and beyond), then cut to mu p/k_w. The reading is exact for dr a multiple of h at constant P, else it smears kinks
 * over about sqrt(a h), of first order in Q. Material that entered during the step is stretched by its part of du: (x +
 * a)/dr for dr > x + a. When P changes w stays and k_w follows.
 *
 * Steady rolling: tau = min(mu p, k_w xi (x + a)), reached at a roll of 2a at constant creepage; Q/(mu P) is up to 0.08
 * off Carter's and never 1. The bed has no d: without rolling Q = 2 a k_w du at first.
 * Stepping, ranges and failures are those of half_plane.h. */
#ifndef TR_PATCH_BRUSH_H
#define TR_PATCH_BRUSH_H

#include "patch/patch.h"

typedef struct tr_brush tr_brush;

/* k_w [Pa/m]; 0: the default. */
tr_brush *tr_brush_new(const tr_patch_pair *pair, int n, double k_w, tr_status *st);
void tr_brush_free(tr_brush *o);
bool tr_brush_step(tr_brush *o, const tr_patch_step *step, tr_status *st);
bool tr_brush_go(tr_brush *o, const tr_patch_step *row, tr_status *st); /* of any length: cut.h cuts it into steps */
const tr_patch_state *tr_brush_state(const tr_brush *o); /* valid until the next step */

#endif
