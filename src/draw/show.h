/* SPDX-License-Identifier: MIT */
/* The parts of tr_draw_show: the stage on which the bodies of a lane move, and the parts beside it. Only frame_show.c
 * knows the places: each part draws into its rectangle. */
#ifndef TR_SHOW_H
#define TR_SHOW_H

#include "draw/frame.h"

enum { TR_SHOW_CONTACTS = 4 }; /* that have room, in the panel and on the rims */

#endif
