/* SPDX-License-Identifier: MIT */
/* A cell of a table of a run, by name: history.COLUMN@STRAIN of a biaxial test, history.DISK.COLUMN@TIME of bodies,
 * contact.LAW.COLUMN@SEGMENT of a path (the end of segment 1, 2, ...); `end` stands for the last instant. */
#ifndef TR_STUDY_CONVERGE_CELL_H
#define TR_STUDY_CONVERGE_CELL_H

#include "scene/data.h"

/* Whether the name can be one of a case of this kind. TR_BAD_CASE: how one is written. */
bool tr_converge_cell_check(tr_kind kind, const char *name, tr_status *st);

/* The cell in the table of the run in dir; between two instants: linear. No such column, disk or instant:
 * TR_BAD_CASE. */
bool tr_converge_cell(const char *dir, tr_kind kind, const char *name, double *value, tr_status *st);

#endif
