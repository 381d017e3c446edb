/* SPDX-License-Identifier: MIT */
/* Reading files of results: a pipe or a device in their place must not make a program wait. */
#ifndef TR_REGULAR_H
#define TR_REGULAR_H

#include "base/status.h"
#include <stdio.h>

/* Opens a regular file to read it. NULL without a failure: there is none of that name. NULL and TR_FILE: it cannot be opened, or
 * is no regular file. */
FILE *tr_regular_open(const char *path, tr_status *st);

#endif
