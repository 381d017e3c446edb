/* SPDX-License-Identifier: MIT */
/* Likely mistakes of a case, reported before the run. Notes, not errors. */
#ifndef TR_WARN_H
#define TR_WARN_H

#include "core/biaxial.h"
#include "core/bodies.h"
#include "study/report.h"

/* Of a world at its start. label: of the scene, if there are several; else empty. */
void tr_warn_bodies(const tr_bodies *b, const char *label, tr_run_report *report);
void tr_warn_biaxial(const tr_biaxial *b, tr_run_report *report);
void tr_warn_contact(const tr_scene *played, tr_run_report *report); /* with its path */

#endif
