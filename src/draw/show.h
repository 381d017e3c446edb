/* SPDX-License-Identifier: MIT */
/* The parts of tr_draw_show: the stage on which the bodies of a lane move, and the parts beside it. Only frame_show.c
 * knows the places: each part draws into its rectangle. */
#ifndef TR_SHOW_H
#define TR_SHOW_H

#include "draw/frame.h"

/* The contacts of the panel, *n of them: those of the lane, or the one that is chosen, if it touches. */
static inline const tr_record *tr_show_records(const tr_show_lane *lane, int *n) {
    *n = lane->n_records;
    if (lane->contact.a == lane->contact.b) return lane->record;
    for (int i = *n = 0; i < lane->n_records; i++)
        if (lane->record[i].a == lane->contact.a && lane->record[i].b == lane->contact.b)
            return *n = 1, &lane->record[i];
    return NULL;
}

enum { TR_SHOW_CONTACTS = 4 }; /* that have room, in the panel and on the rims */

#endif
