/* SPDX-License-Identifier: MIT */
/* Which files of a directory are trundle's. DIR/trundle-files.txt lists them, one name a line; a later line -NAME takes
 * a name off. The list is only appended to, and known by its first line. A name is on the list, and the list is on the
 * disk, before the file exists. So a file that is not listed is the user's: it is never removed or written over.
 *
 * Results have fixed names (history.csv, frames/00012.png, paths/17-42.csv, ...), see manifest.c. A listed name
 * includes NAME.part and NAME.old. Only names of results are ever removed, whatever the list says. */
#ifndef TR_MANIFEST_H
#define TR_MANIFEST_H

#include "base/status.h"

#define TR_MADE_LIST "trundle-files.txt"

/* Lists a file that is about to be written. TR_FILE: a file of that name exists and is not listed, or its folder is a
 * symbolic link, or the list cannot be written. Nothing is done if the name is listed already. */
bool tr_manifest_add(const char *dir, const char *name, tr_status *st);

/* The same for frames/00000.png to frames/<n-1>.png at once. */
bool tr_manifest_add_frames(const char *dir, int n, tr_status *st);

/* Whether a file of that name is on the list. */
bool tr_manifest_lists(const char *dir, const char *name, bool *listed, tr_status *st);

/* Removes the results of an old run, to make room for a new one. TR_FILE, and nothing is changed: the directory has a
 * finished run and `force` is false; or a file has the name of a result and is not listed (with `force` such files may
 * stay in frames/ and paths/); or frames or paths is a symbolic link. */
bool tr_manifest_clear(const char *dir, bool force, tr_status *st);

/* TR_FILE if a run into dir would remove or write over the file `input`, which the run reads. Files are compared by
 * device and inode. An input that does not exist yet is compared by its place. NULL: there is no input. */
bool tr_manifest_spare(const char *dir, const char *input, tr_status *st);

/* TR_FILE if the two paths are one file. NULL: there is no input. */
bool tr_manifest_differ(const char *output, const char *input, tr_status *st);

#endif
