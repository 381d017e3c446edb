/* SPDX-License-Identifier: MIT */
/* One contact along its path: kinds `contact` and `patch`. */
#ifndef TR_RUN_PATH_H
#define TR_RUN_PATH_H

#include "study/report.h"

bool tr_run_path(const tr_scene *scene, const tr_run_options *options, tr_run_report *report, tr_status *st);

/* What tr_run_check finds: NULL, or else the summary to come. Reads the path of a file. */
char *tr_run_check_path(const tr_scene *scene, tr_run_report *report, tr_status *st);

#endif
