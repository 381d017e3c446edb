/* SPDX-License-Identifier: MIT */
/* Contacts that are pressed deeper than TR_LARGEST_OVERLAP: the stiffness that would hold. An estimate, for a
 * message. */
#ifndef TR_CRUSH_H
#define TR_CRUSH_H

#include "core/world.h"

/* The stiffness parameter of a normal law, its value, and the needed value; key NULL: not known. */
typedef struct tr_crush_limit {
    const char *key, *unit;
    double is, holds;
} tr_crush_limit;

/* holds: the smallest value, in steps of a tenth, at which a contact of these radii (R1 = 0: a wall) carries this force
 * and takes this energy within TR_LARGEST_OVERLAP. */
tr_crush_limit tr_crush_find(const tr_group_law *normal, tr_shape shape, double R1, double R2, double force,
                             double energy);

/* For a few bodies, for the message about this contact: the value that stops the approach, if no prescribed motion
 * presses. */
void tr_crush_say(const tr_world *world, const tr_crush *crush, char *text, size_t size);

#endif
