/* SPDX-License-Identifier: MIT */
/* A biaxial test. */
#ifndef TR_RUN_BIAXIAL_H
#define TR_RUN_BIAXIAL_H

#include "core/biaxial.h"
#include "study/report.h"

bool tr_run_biaxial(const tr_scene *scene, const tr_run_options *options, tr_run_report *report, tr_status *st);

/* For tr_run_check. Returns the later summary, or NULL after an error. */
char *tr_run_check_biaxial(const tr_scene *scene, tr_run_report *report, tr_status *st);

#endif
