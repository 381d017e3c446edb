/* SPDX-License-Identifier: MIT */
/* The directory of results, and files in it that are never half-written under their final name: a file grows as
 * NAME.part and gets its name when it is complete. A directory that holds summary.json is a finished run. */
#ifndef TR_DIR_H
#define TR_DIR_H

#include "base/status.h"
#include <stdio.h>

enum { TR_PATH = 4096 };

typedef struct tr_file {
    FILE *stream;       /* NULL: not open */
    char path[TR_PATH]; /* final name */
    char *part;         /* name while it grows */
} tr_file;

/* Makes the directory (and its parents). A finished run is refused with TR_FILE unless force; with force the results of
 * the old run are removed, and nothing else. */
bool tr_dir_open(const char *dir, bool force, tr_status *st);

/* dir/name; TR_FILE if the path is too long. */
bool tr_dir_path(char path[TR_PATH], const char *dir, const char *name, tr_status *st);

/* Makes dir/name. */
bool tr_dir_make(const char *dir, const char *name, tr_status *st);

bool tr_file_open(tr_file *file, const char *dir, const char *name, tr_status *st);
bool tr_file_check(tr_file *file, tr_status *st);  /* flush; a full disk shows here */
bool tr_file_commit(tr_file *file, tr_status *st); /* close and give it its name; on failure the part is removed */
void tr_file_discard(tr_file *file);               /* close and remove; nothing if not open */

/* A whole file at once. */
bool tr_file_write(const char *dir, const char *name, const char *text, tr_status *st);

#endif
