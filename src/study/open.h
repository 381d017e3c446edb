/* SPDX-License-Identifier: MIT */
/* The directory of a run and its checkpoint, and the threads of its world. */
#ifndef TR_OPEN_H
#define TR_OPEN_H

#include "base/checkpoint.h"
#include "core/world.h"
#include "study/report.h"

/* Empties the directory and writes the resolved case into it; or, with options->resume, opens the checkpoint: then
 * c->loading, and nothing is changed. c NULL: this kind has no checkpoint. */
bool tr_run_open(const tr_scene *scene, const tr_run_options *options, tr_checkpoint *c, tr_run_report *report,
                 tr_status *st);

/* Removes the checkpoint of a finished run. A note in the report says if this fails. */
void tr_run_remove_checkpoint(const char *dir, tr_run_report *report);

/* Gives the world its threads. */
bool tr_run_threads(const tr_run_options *options, tr_world *world, tr_status *st);

#endif
