/* SPDX-License-Identifier: MIT */
/* The tractions in one line contact over x/a: Coulomb's bound +-mu p as a grey area, tau, and between tau and
 * the axis what happens there: hatched where it sticks, coloured by the slip of the step where it slips.
 *
 * Hatching and arrows of slip sit at fixed places of the picture and are uncovered by the zones: between frames only
 * the edges of the zones move. A column of pixels shows the element in its middle. */
#ifndef TR_PATCH_PLOT_H
#define TR_PATCH_PLOT_H

#include "draw/draw.h"
#include "draw/frame.h"
#include "draw/pen.h"

/* Pixel of (x, tau): (x0 + a x/state->a, y0 - scale tau). */
typedef struct tr_patch_plot {
    cairo_t *cr;
    const tr_patch_pair *pair;
    const tr_patch_state *state;
    double x0, y0, a, scale; /* a: half-width [px]; scale [px/Pa] */
    double reach, half;      /* of the axes from x0, and from y0 [px] */
    double slip_range;       /* end of the colours [m] */
    double text;             /* size of the letters [px] */
    bool plain;              /* no numbers along the axis */
} tr_patch_plot;

/* u between -1 and 1; 0 if it is not finite. */
double tr_patch_limited(double u);

/* End of the colours that covers the slip of a state; 0: nothing slipped. */
double tr_patch_slip_range(const tr_patch_state *state);

/* Bound, zones, tau, and the axis of x/a. */
void tr_patch_plot_draw(const tr_patch_plot *plot);

/* Only the zones, as a band over the width of the contact. */
void tr_patch_plot_band(const tr_patch_plot *plot, double top, double bottom);

/* Arrows along y where it slips, in the direction of slip (way 1) or against it (-1). */
void tr_patch_plot_arrows(const tr_patch_plot *plot, double y, int way);

/* The hatching of stick in a rectangle. */
void tr_patch_plot_hatch(cairo_t *cr, double x, double y, double width, double height);

/* The same picture, small, for other frames; ranges of this state, with a scale of its slip. 240 x 160 px or more. A
 * class has no numbers, and letters of 24 px. */
void tr_draw_patch_inset(cairo_t *cr, tr_box box, const tr_patch_state *state, const tr_patch_pair *pair, bool expert);

#endif
