/* SPDX-License-Identifier: MIT */
/* The slipping part of the width of every contact of a view: see tr_frame_stick. */
#ifndef TR_FRAME_SLIP_H
#define TR_FRAME_SLIP_H

#include "draw/frame.h"

/* Bars across the contacts. mean: force of a bar as long as a mean radius [N/m]. */
void tr_frame_slip(cairo_t *cr, const tr_view *view, const tr_map *map, double mean);

/* What the law of the view knows about the width: "by Carter: what the law tends to"; "" without friction. */
const char *tr_frame_slip_limit(cairo_t *cr, const tr_view *view);

/* The key in the panel, instead of a colour bar. y: base line of its label [px]. */
void tr_frame_slip_key(cairo_t *cr, const tr_view *view, double y);

#endif
