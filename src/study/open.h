/* SPDX-License-Identifier: MIT */
/* The directory of a run and its checkpoint, and the threads of its world. */
#ifndef TR_OPEN_H
#define TR_OPEN_H

#include "base/checkpoint.h"
#include "core/world.h"
#include "study/report.h"

/* Empties the directory and writes the resolved case into it; or, with options->resume, opens the checkpoint that is
 * there: then c->loading, and nothing is touched. c NULL: this kind has none. */
bool tr_run_open(const tr_scene *scene, const tr_run_options *options, tr_checkpoint *c, tr_run_report *report,
                 tr_status *st);

/* Of a finished run. A note in the report tells if it cannot be removed. */
void tr_run_remove_checkpoint(const char *dir, tr_run_report *report);

/* Gives the world its threads. */
bool tr_run_share(const tr_run_options *options, tr_world *world, tr_status *st);

#endif
