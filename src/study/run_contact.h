/* SPDX-License-Identifier: MIT */
/* Laws along the path of one contact, kind `contact`, and what kind `patch` shares with it. */
#ifndef TR_RUN_CONTACT_H
#define TR_RUN_CONTACT_H

#include "out/table.h"
#include "study/contact.h"
#include "study/report.h"

bool tr_run_contact(const tr_scene *scene, const tr_run_options *options, tr_run_report *report, tr_status *st);

/* What tr_run_check finds: NULL, or else the summary to come. Reads the path of a file. */
char *tr_run_check_path(const tr_scene *scene, tr_run_report *report, tr_status *st);

/* The scene with its path from the file, if it is in one. Free with tr_run_drop_path. */
bool tr_run_with_path(const tr_scene *scene, tr_scene *played, tr_status *st);
void tr_run_drop_path(tr_scene *played);
/* What the rows of a file leave out. */
void tr_run_say_rows(const tr_scene *played, tr_run_report *report);

/* One row of contact.csv. */
void tr_run_contact_row(tr_row *row, const tr_contact_state *s);

#endif
