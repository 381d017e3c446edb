/* SPDX-License-Identifier: MIT */
/* One case, from scene to a directory of results: scene -> core -> out and draw. Neither prints nor exits. */
#ifndef TR_RUN_H
#define TR_RUN_H

#include "study/report.h"

/* Finds what reading a case cannot: a step above the bound, bodies that overlap too much. *report gets notes of what may not be
 * meant (n_warnings). summary: if it is not NULL, the text of the summary.json that a run of this case leaves, with its names and
 * without its numbers (free()). */
bool tr_run_check(const tr_scene *scene, tr_run_report *report, char **summary, tr_status *st);

/* Runs the case. What tr_run_check finds is found before the directory is touched. Stopped: TR_INTERRUPTED, numerical
 * failure: TR_NUMERICAL, a file that cannot be written: TR_FILE; each keeps the rows, frames and film up to then and
 * says so, and nothing is half-written under a final name. A checkpoint that is resumed but not of this case, or damaged: TR_FILE,
 * and nothing is touched. */
bool tr_run(const tr_scene *scene, const tr_run_options *options, tr_run_report *report, tr_status *st);

#endif
