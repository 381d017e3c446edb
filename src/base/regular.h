/* SPDX-License-Identifier: MIT */
/* Reading files of results: a pipe or a device with that name must not make a program wait. */
#ifndef TR_REGULAR_H
#define TR_REGULAR_H

#include "base/status.h"
#include <stdio.h>

/* Opens a regular file to read it. NULL without a failure: it does not exist. NULL and TR_FILE: it cannot be opened, or
 * is not a regular file. */
FILE *tr_regular_open(const char *path, tr_status *st);

#endif
