/* SPDX-License-Identifier: MIT */
/* The directory of results, and files in it that are never half-written under their final name: a file grows as
 * NAME.part and gets its name when it is complete. A directory that holds summary.json is a finished run. */
#ifndef TR_DIR_H
#define TR_DIR_H

#include "base/checkpoint.h"
#include "out/path.h"
#include <stdio.h>

typedef struct tr_file {
    FILE *stream;       /* NULL: not open */
    char path[TR_PATH]; /* final name */
    char *part;         /* name while it grows */
    long kept;          /* bytes that a checkpoint needs; 0: no checkpoint */
} tr_file;

/* Makes the directory (and its parents) and takes it for this process: two runs never write into one. Started programs
 * inherit the lock, because they outlive a killed run and still write. So it waits TR_DIR_WAIT before TR_FILE. Close
 * *lock in the end; -1: this file system has no locks. */
enum { TR_DIR_WAIT = 5 }; /* [s] gnuplot and ffmpeg need less to end */
bool tr_dir_lock(const char *dir, int *lock, tr_status *st);

/* Whether the file dir/name is this text. TR_FILE: it exists and cannot be read. */
bool tr_dir_holds(const char *dir, const char *name, const char *text, bool *same, tr_status *st);

/* Makes dir/name. */
bool tr_dir_make(const char *dir, const char *name, tr_status *st);

/* Opens dir/name for writing, and lists it first: see manifest.h. */
bool tr_file_open(tr_file *file, const char *dir, const char *name, tr_status *st);
/* The same for a file that the user has named by its path. It is not listed. */
bool tr_file_open_path(tr_file *file, const char *path, tr_status *st);
/* Continues a file that a stopped run has left, with or without its final name. tr_file_checkpoint then cuts it. */
bool tr_file_reopen(tr_file *file, const char *dir, const char *name, tr_status *st);
bool tr_file_check(tr_file *file, tr_status *st);  /* flush; a full disk shows here */
bool tr_file_commit(tr_file *file, tr_status *st); /* close and give it its name; on failure it is discarded */
/* Closes and removes it, or cuts it to the bytes that a checkpoint needs. Does nothing if it is not open. */
void tr_file_discard(tr_file *file);

/* Its length. To save, its bytes go to the disk; to load, the rest is cut off. Does nothing if it is not open. */
void tr_file_checkpoint(tr_file *file, tr_checkpoint *c);

/* A whole file at once. */
bool tr_file_write(const char *dir, const char *name, const char *text, tr_status *st);

#endif
