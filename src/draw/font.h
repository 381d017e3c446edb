/* SPDX-License-Identifier: MIT */
/* The letters of all pictures, from the files of DejaVu Sans, by FreeType, without fontconfig: fontconfig ends the
 * program if memory is short, and settings of a machine must not change the pixels. If the files are missing, Cairo
 * chooses a font. */
#ifndef TR_FONT_H
#define TR_FONT_H

#include "base/status.h"
#include <cairo.h>

/* Gives a context its letters. If `like` is not NULL, it takes the letters of `like`, with those already drawn. */
bool tr_font_give(cairo_t *cr, cairo_t *like, tr_status *st);

/* For the text to come. */
void tr_font_choose(cairo_t *cr, bool bold);

#endif
