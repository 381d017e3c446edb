/* SPDX-License-Identifier: MIT */
/* The contacts of a group in their arrays, and how histories and pair constants survive the renewal of the list: contacts are
 * sorted by (a, b), old and new, so that one walk over both finds where each stood. Then array by array is carried over into the
 * spare one, which takes its place: what one array needs is the same for all, and no array has a double. */
#ifndef TR_LIST_H
#define TR_LIST_H

#include "core/world.h"

/* Room for n contacts; what the list and the one before it hold is kept, the rest is 0. */
bool tr_list_reserve(tr_group *group, int n, tr_status *st);

/* Keeps the ids of the present list as the old ones and starts an empty list. The caller fills a, b and n. */
void tr_list_begin(tr_group *group);

/* When a, b and n are there: brings histories and constants to their new places; histories of new contacts are 0, and their radii,
 * g1 and (in a cell) images are made here, images of all. */
void tr_list_carry(const tr_world *world, tr_group *group);

/* The laws' constants of new contacts, and of all where they follow the number of contacts. When both lists are there: z, of n_disks
 * numbers, is room to count. */
void tr_list_constants(tr_world *world, int *z);

#endif
