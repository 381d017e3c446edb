/* SPDX-License-Identifier: MIT */
/* The part of the width of a contact that sticks. */
#ifndef TR_DRAW_STICK_H
#define TR_DRAW_STICK_H

#include "core/record.h"
#include "core/world.h"

/* Where a contact sticks by its friction law in `world`, from and to, in half-widths along t; the rest of -1 to 1
 * slips. See tr_slip. Without friction, mu = 0 too: nowhere. */
void tr_frame_stick(const tr_world *world, const tr_record *record, double stick[2]);

#endif
