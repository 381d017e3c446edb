/* SPDX-License-Identifier: MIT */
/* The frame of the inside of a contact. */
#ifndef TR_DRAW_FRAME_PATCH_H
#define TR_DRAW_FRAME_PATCH_H

#include "draw/draw.h"

/* The two bodies, where the contact sticks, where it slips and in which direction, and the traction within Coulomb's
 * bound. */
void tr_draw_patch(tr_canvas *canvas, const tr_patch_view *view);

#endif
