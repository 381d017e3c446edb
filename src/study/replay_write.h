/* SPDX-License-Identifier: MIT */
/* The tables of a replay. */
#ifndef TR_REPLAY_WRITE_H
#define TR_REPLAY_WRITE_H

#include "study/replay_data.h"

/* replay.csv: each life; replay-errors.csv: their distribution; replay-stress.csv: each instant (every = 1 only). */
bool tr_replay_write(const tr_replay *r, const tr_replay_options *o, tr_run_report *report, tr_status *st);

#endif
