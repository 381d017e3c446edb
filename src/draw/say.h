/* SPDX-License-Identifier: MIT */
/* Words in the language of a canvas. */
#ifndef TR_SAY_H
#define TR_SAY_H

#include "draw/words.h"
#include <cairo.h>

/* Of what is drawn from now on; before, English. */
void tr_say_in(cairo_t *cr, tr_language language);

tr_language tr_say_language(cairo_t *cr);
const char *tr_say(cairo_t *cr, tr_word_key key);
#define TR_SAY(cr, key) tr_say(cr, TR_WORD_##key)

#endif
