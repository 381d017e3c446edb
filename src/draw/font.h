/* SPDX-License-Identifier: MIT */
/* The letters of all pictures, from the files of DejaVu Sans, by FreeType and without fontconfig: that ends the program
 * where memory is short, and what a machine has configured must not change the pixels. Where the files are not, Cairo
 * chooses a font. */
#ifndef TR_FONT_H
#define TR_FONT_H

#include "base/status.h"
#include <cairo.h>

/* Gives a context its letters, those of `like` if that is not NULL: drawn letters are kept with them. */
bool tr_font_give(cairo_t *cr, cairo_t *like, tr_status *st);

/* For the text to come. */
void tr_font_choose(cairo_t *cr, bool bold);

#endif
