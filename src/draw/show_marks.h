/* SPDX-License-Identifier: MIT */
/* What contacts leave on the rims and on the ground. */
#ifndef TR_DRAW_SHOW_MARKS_H
#define TR_DRAW_SHOW_MARKS_H

#include "draw/stage.h"

/* How thick a rubbed trace is on a disk of that radius, and how deep the marks of a floor reach below it [px]. */
double tr_marks_width(double radius);
enum { TR_MARKS_DEPTH = 48 };

void tr_marks_draw(const tr_stage *stage);

/* A double arrow at each contact that slides: each surface its own way past the other. */
void tr_marks_sliding(const tr_stage *stage);

#endif
