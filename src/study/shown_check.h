/* SPDX-License-Identifier: MIT */
/* A check of a scene in words. */
#ifndef TR_SHOWN_CHECK_H
#define TR_SHOWN_CHECK_H

#include "draw/draw.h"
#include "out/summary.h"
#include "study/report.h"

/* A check as a line of the report, and for a still. several: with the label of its scene. */
void tr_run_say_check(tr_run_report *report, const tr_check_result *result, bool several);
tr_show_check tr_run_shown_check(const tr_check_result *result, const tr_scene *scene, bool several);

#endif
