/* SPDX-License-Identifier: MIT */
/* A file under a final name is always whole: it is written as path.part and renamed when done. */
#ifndef TR_PART_H
#define TR_PART_H

#include "base/status.h"

/* "path.part". NULL and TR_FILE when memory is short; free(). */
char *tr_part_name(const char *path, tr_status *st);

/* Renames part to path; where that fails, TR_FILE and part is removed. */
bool tr_part_keep(const char *part, const char *path, tr_status *st);

#endif
