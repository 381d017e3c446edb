/* SPDX-License-Identifier: MIT */
/* The side panel of a frame of bodies: velocities of the first contacts as bars. */
#ifndef TR_BODIES_PANEL_H
#define TR_BODIES_PANEL_H

#include "draw/frame.h"

enum { TR_BODIES_CONTACTS = 4 }; /* that have room, in the panel and on the rims */

/* From line y down. range: speed of a full bar [m/s]. */
void tr_bodies_panel(cairo_t *cr, const tr_view *view, double range, double y);

#endif
