/* SPDX-License-Identifier: MIT */
/* Files that the user names. */
#ifndef TR_CLI_OPEN_H
#define TR_CLI_OPEN_H

#include "out/dir.h"

/* A file that the user has named by its path. It must not be the file `input`, which the command reads (NULL: none). */
bool tr_cli_open(tr_file *file, const char *path, const char *input, tr_status *st);

#endif
