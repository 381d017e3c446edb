/* SPDX-License-Identifier: MIT */
/* The inside of one contact: kind `patch`. */
#ifndef TR_RUN_PATCH_H
#define TR_RUN_PATCH_H

#include "study/report.h"

bool tr_run_patch(const tr_scene *scene, const tr_run_options *options, tr_run_report *report, tr_status *st);

#endif
