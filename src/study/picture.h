/* SPDX-License-Identifier: MIT */
/* From scenes that play side by side to the picture that draw/ makes of them: one box, one range of speeds and of
 * curves for the whole film, so that only the bodies move in the picture. */
#ifndef TR_PICTURE_H
#define TR_PICTURE_H

#include "out/summary.h"
#include "study/play.h"

typedef struct tr_cast {
    const tr_scene *scene; /* the first; its lesson and output apply to all */
    const char *title;     /* where the lesson has none */
    tr_play *play[TR_MAX_LANES];
    int n, leader; /* scenes; the scene with the most steps gives the time */
} tr_cast;

/* Found by a run without outputs: box in the turned plane [m], speeds [m/s], values of the curves. */
typedef struct tr_view_box {
    double x0, x1, y0, y1, range, bottom, top;
} tr_view_box;

tr_view_box tr_picture_empty(void);

/* Makes room for the present state, too. Call it for each frame. */
void tr_picture_widen(tr_view_box *view, const tr_play *play);

/* At the end: curves, and room around the disks (hatching of a floor, arcs along it). */
void tr_picture_settle(tr_view_box *view, const tr_cast *cast);

/* A frame of the film. With results it is the still, with its sentence and the numbers of its checks. */
void tr_picture_draw(tr_canvas *canvas, const tr_cast *cast, const tr_view_box *view, const tr_check_result *result,
                     int n_results);

#endif
