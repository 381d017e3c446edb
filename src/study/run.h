/* SPDX-License-Identifier: MIT */
/* One case, from scene to a directory of results: scene -> core -> out and draw. It does not print and does not
 * exit. */
#ifndef TR_RUN_H
#define TR_RUN_H

#include "study/report.h"

/* Finds what reading a case cannot: a step above the bound, bodies that overlap too much. *report gets notes of likely
 * mistakes (n_warnings). summary: if it is not NULL, the text of the summary.json of such a run, with names but without
 * numbers (free()). */
bool tr_run_check(const tr_scene *scene, tr_run_report *report, char **summary, tr_status *st);

/* Runs the case. Errors of tr_run_check are found before the directory is changed. Stopped: TR_INTERRUPTED, numerical
 * failure: TR_NUMERICAL, a file that cannot be written: TR_FILE; each keeps the rows, frames and film so far and says
 * so; no file has its final name half-written. A checkpoint of another case or a damaged one: TR_FILE, and nothing is
 * changed. */
bool tr_run(const tr_scene *scene, const tr_run_options *options, tr_run_report *report, tr_status *st);

#endif
