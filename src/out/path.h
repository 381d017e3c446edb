/* SPDX-License-Identifier: MIT */
/* Paths of results. */
#ifndef TR_OUT_PATH_H
#define TR_OUT_PATH_H

#include "base/status.h"

enum { TR_PATH = 4096 };

/* dir/name; TR_FILE if the path is too long. */
bool tr_dir_path(char path[TR_PATH], const char *dir, const char *name, tr_status *st);

#endif
