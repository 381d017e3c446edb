/* SPDX-License-Identifier: MIT */
/* What a biaxial test has done so far. */
#ifndef TR_DRAW_FRAME_HISTORY_H
#define TR_DRAW_FRAME_HISTORY_H

#include "draw/frame.h"

/* Row i is an event: its unbalanced force is more than four times the median of all rows so far, of which there are
 * eight or more. Disks fall into a new place. */
bool tr_history_event(const tr_history *history, int i);

void tr_frame_history(cairo_t *cr, tr_box box, const tr_history *history);

#endif
