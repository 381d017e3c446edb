/* SPDX-License-Identifier: MIT */
/* What is drawn on. */
#ifndef TR_DRAW_CANVAS_H
#define TR_DRAW_CANVAS_H

#include "draw/draw.h"

/* NULL and TR_FILE when memory is short. Free with tr_canvas_free (NULL is allowed). */
tr_canvas *tr_canvas_create(tr_status *st);

/* A canvas without pixels that only records strokes, in a tenth of the time of drawing. A replay gives the same pixels
 * as drawing, later and in any thread; the data of the view may be gone by then. It serves for one picture, and only
 * for replay. like: the canvas before, whose letters it takes, or NULL. */
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
