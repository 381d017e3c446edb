/* SPDX-License-Identifier: MIT */
/* The runs of a level: a sweep file, its points, and the numbers that they give. */
#ifndef TR_STUDY_CONVERGE_POINTS_H
#define TR_STUDY_CONVERGE_POINTS_H

#include "study/converge_data.h"

/* Runs what is missing of a level, for the first `seeds` of the seeds, and reads the values and times of all that are
 * there. cause NULL: the case as it is. A level that cannot run, or none of whose points does, is TR_LEVEL_FAILED
 * with a note; one that the end of the budget stops stays TR_LEVEL_OPEN. False: files, memory, stopped by the user. */
bool tr_converge_level_run(tr_converge *c, const tr_cause *cause, int finer, int seeds, tr_converge_level *level,
                           tr_status *st);

/* Whether all of it is finished before anything runs. */
bool tr_converge_level_there(tr_converge *c, const tr_cause *cause, int finer, int seeds);

void tr_converge_note(tr_converge *c, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
