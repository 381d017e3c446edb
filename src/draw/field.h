/* SPDX-License-Identifier: MIT */
/* The field that colours contacts or disks, and ends for its colour bar. */
#ifndef TR_DRAW_FIELD_H
#define TR_DRAW_FIELD_H

#include "core/record.h"
#include "core/world.h"

/* A round end for the colour bar: the smallest 1, 2 or 5 times a power of ten that covers 95 % of the speeds of the
 * contacts. 1 for the other fields, and if everything rests. [1 or m/s] */
double tr_frame_range(const tr_record *record, int n, tr_color color);

/* The field in a contact: mobilisation, |v_s|, |v_r|, the part of the width that slips, or from -1 (slides) to 1
 * (rolls) the faster of both; only the part of the width needs the world. */
double tr_frame_field(const tr_world *world, const tr_record *record, tr_color color);

/* The field of each disk: its mean over the n touching contacts of the disk, 0 without one; TR_COLOR_SPIN: angle turned
 * since the world was made [rad]. ends: how many contacts each disk has. */
void tr_frame_fill(const tr_world *world, const tr_record *record, int n, tr_color color, double *fill, int *ends);

/* The same for bodies: covers every speed of centres, rims, and contacts in this state. [m/s] */
double tr_frame_range_bodies(const tr_world *world, const tr_record *record, int n);

#endif
