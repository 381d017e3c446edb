/* SPDX-License-Identifier: MIT */
/* What is drawn on. */
#ifndef TR_DRAW_CANVAS_H
#define TR_DRAW_CANVAS_H

#include "draw/draw.h"

/* NULL and TR_FILE when memory is short. Free with tr_canvas_free (NULL is allowed). */
tr_canvas *tr_canvas_create(tr_status *st);

/* The language of the words to come, in the order of the choices of the scene's `language:`; English before. */
void tr_canvas_speak(tr_canvas *canvas, int language);

/* A canvas without pixels, which only keeps the strokes: a tenth of the time of drawing. To replay gives the pixels
 * that drawing would have given, later and by any thread: what the view pointed to may be gone. It is for one picture,
 * and for nothing but to be replayed. like: the canvas before, or NULL; it takes the letters of that. */
tr_canvas *tr_canvas_record(const tr_canvas *like, tr_status *st);
bool tr_canvas_replay(tr_canvas *canvas, const tr_canvas *strokes, tr_status *st);
void tr_canvas_free(tr_canvas *canvas);

/* The pixels, row by row from the top, 4 bytes each: blue, green, red, unused. */
const unsigned char *tr_canvas_pixels(const tr_canvas *canvas);

/* Two halves, the work and the file. The picture is compressed in memory, then written to path.part, which is renamed
 * to path. On failure TR_FILE: path stays as it was, and no part is left. */
bool tr_canvas_encode(tr_canvas *canvas, tr_status *st);
bool tr_canvas_write(const tr_canvas *canvas, const char *path, tr_status *st);

bool tr_canvas_png(tr_canvas *canvas, const char *path, tr_status *st);  /* both */
bool tr_canvas_load(tr_canvas *canvas, const char *path, tr_status *st); /* shows what was written */

#endif
