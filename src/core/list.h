/* SPDX-License-Identifier: MIT */
/* The contacts of a group in their arrays, and how histories and pair constants survive the renewal of the list:
 * contacts are sorted by (a, b), old and new, so one walk over both finds the old place of each. Then each array is
 * copied into the spare one, and the two change places: so one spare array is enough for all. */
#ifndef TR_LIST_H
#define TR_LIST_H

#include "core/world.h"

/* Room for n contacts; the content of the list and of the old one is kept, the rest is 0. */
bool tr_list_reserve(tr_group *group, int n, tr_status *st);

/* Keeps the ids of the present list as the old ones and starts an empty list. The caller fills a, b and n. */
void tr_list_begin(tr_group *group);

/* When a, b and n are there: moves histories and constants to their new places. Histories of new contacts are 0; their
 * radii and g1 are set here. In a cell the images of all contacts are set. */
void tr_list_carry(const tr_world *world, tr_group *group);

/* The laws' constants of new contacts, and of all where they follow the number of contacts. When both lists are there:
 * z, of n_disks numbers, is room to count. */
void tr_list_constants(tr_world *world, int *z);

#endif
