/* SPDX-License-Identifier: MIT */
/* How wrong is a run? `trundle converge CASE` runs a case with finer and coarser settings and tells, of each number
 * that is quoted, the error and its causes.
 *
 * A cause is a setting of the program that physics does not know: a step, a number of elements, a sample
 * (converge_causes.h). A ladder is the case with that setting alone changed, level by level, each a factor finer
 * than the one before. What the numbers do along it decides what is said of their error (converge_ladder.h).
 *
 * Each level is a sweep of its own, DIR/sweeps/CAUSE-LEVEL.yaml, and its points go to DIR/points. So a converge that
 * is stopped goes on, runs are shared between processors or the jobs of a cluster, and a student can run a level by
 * hand. */
#ifndef TR_STUDY_CONVERGE_H
#define TR_STUDY_CONVERGE_H

#include "study/converge_data.h"

/* Runs what it takes and writes DIR/converge.csv, levels.csv, converge.md, comment.txt and the pictures. *text: what
 * the terminal shows (free()). A level that fails is a note. TR_BAD_CASE: a name that is none of the case's numbers,
 * a budget that is too small. TR_INTERRUPTED: stopped; the same command goes on. */
bool tr_converge_run(const tr_converge_options *options, char **text, tr_status *st);

#endif
