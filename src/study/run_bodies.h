/* SPDX-License-Identifier: MIT */
/* A handful of bodies: kind `bodies`. */
#ifndef TR_RUN_BODIES_H
#define TR_RUN_BODIES_H

#include "study/report.h"

bool tr_run_bodies(const tr_scene *scene, const tr_run_options *options, tr_run_report *report, tr_status *st);

/* For tr_run_check. Returns the later summary, or NULL after an error. */
char *tr_run_check_bodies(const tr_scene *scene, tr_run_report *report, tr_status *st);

#endif
