/* SPDX-License-Identifier: MIT */
/* The frame of a biaxial test. */
#ifndef TR_DRAW_FRAME_BIAXIAL_H
#define TR_DRAW_FRAME_BIAXIAL_H

#include "draw/draw.h"
#include "draw/words.h"

/* Biaxial test: world->wall is bottom, top, left, right, or there is a periodic cell. A wall or side with mass is drawn
 * as loaded, one without as driven. */
void tr_draw_biaxial(tr_canvas *canvas, const tr_view *view);

enum { TR_INSET_NUMBERS = 96 };

/* "Q/(μP):  law 0.68, exact 1.00" of a view with an inset, or "open". */
void tr_frame_inset_numbers(const tr_view *view, tr_language language, char text[TR_INSET_NUMBERS]);

#endif
