/* SPDX-License-Identifier: MIT */
/* A finished run, for its replay. */
#ifndef TR_REPLAY_READ_H
#define TR_REPLAY_READ_H

#include "study/replay_data.h"

/* Scene, rows, lives. */
bool tr_replay_read(tr_replay *r, const char *run, tr_status *st);

#endif
