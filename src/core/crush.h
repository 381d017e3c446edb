/* SPDX-License-Identifier: MIT */
/* Contacts that are pressed deeper than TR_LARGEST_OVERLAP: what would have held. An estimate, for a message. */
#ifndef TR_CRUSH_H
#define TR_CRUSH_H

#include "core/world.h"

/* The parameter that says how stiff a normal law is, what it is, and what it would have to be; key NULL: not known. */
typedef struct tr_crush_limit {
    const char *key, *unit;
    double is, holds;
} tr_crush_limit;

/* holds: in steps of a tenth, the least value at which a contact of these radii (R1 = 0: a wall) carries this force, and
 * takes up this energy, within TR_LARGEST_OVERLAP. */
tr_crush_limit tr_crush_find(const tr_slot *normal, tr_shape shape, double R1, double R2, double force, double energy);

/* Of a few bodies, for the message about this contact: which value stops the approach, if no given motion presses. */
void tr_crush_say(const tr_world *world, const tr_crush *crush, char *text, size_t size);

#endif
