/* SPDX-License-Identifier: MIT */
/* What a class reads of the contacts: for each its lamp, how fast it slides and rolls, how far it has slid. All type
 * is at least TR_CLASS_TYPE high; numbers are three at most. */
#ifndef TR_DRAW_SHOW_CLASS_H
#define TR_DRAW_SHOW_CLASS_H

#include "draw/frame.h"

enum { TR_CLASS_TYPE = 24, TR_CLASS_NUMBERS = 3 }; /* 1/30 of the height [px] */

/* In the panel of the only lane. Returns the height used, at most box.h. */
double tr_class_panel(cairo_t *cr, tr_box box, const tr_show_lane *lane, double range);

/* Of one lane among others: the lamp of its first contact, and two bars without numbers. */
enum { TR_CLASS_PAIR_H = 92 };
void tr_class_pair(cairo_t *cr, tr_box box, const tr_show_lane *lane, double range);

/* Verdicts of checks in words, without their numbers. */
double tr_class_checks_height(const tr_show_check *check, int n);
void tr_class_checks(cairo_t *cr, tr_box box, const tr_show_check *check, int n);

/* How far the film is. */
void tr_class_time(cairo_t *cr, double time, double time_end);

#endif
