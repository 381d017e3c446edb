/* SPDX-License-Identifier: MIT */
/* A file with its final name is always complete: it is written as path.part, then renamed. */
#ifndef TR_TEMPORARY_H
#define TR_TEMPORARY_H

#include "base/status.h"

/* "path.part". NULL and TR_FILE when memory is short; free(). */
char *tr_temporary_name(const char *path, tr_status *st);

/* Renames part to path; if that fails: TR_FILE, and part is removed. */
bool tr_temporary_rename(const char *part, const char *path, tr_status *st);

#endif
