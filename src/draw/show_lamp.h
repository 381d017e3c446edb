/* SPDX-License-Identifier: MIT */
/* What a contact does, in one word: ROLLS, SLIDES, BOTH or NEITHER. */
#ifndef TR_DRAW_SHOW_LAMP_H
#define TR_DRAW_SHOW_LAMP_H

#include "draw/frame.h"

typedef enum tr_lamp { TR_LAMP_NEITHER, TR_LAMP_SLIDES, TR_LAMP_ROLLS, TR_LAMP_BOTH } tr_lamp;

/* Rolling and sliding velocity as the scene defines them, against 1 % of the range of the bars: below it a bar is not
 * seen either, and springs swing. */
tr_lamp tr_lamp_of(const tr_world *world, const tr_record *record, double range);

/* The rolling velocity by the scene's definition. */
double tr_lamp_rolling(const tr_world *world, const tr_record *record);

/* Filled with the colour of the word, its two halves for BOTH, none for NEITHER. */
void tr_lamp_draw(cairo_t *cr, tr_box box, tr_lamp lamp);

/* The contact point in the same colours. */
void tr_lamp_dot(cairo_t *cr, tr_point at, double radius, tr_lamp lamp);

#endif
