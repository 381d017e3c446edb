/* SPDX-License-Identifier: MIT */
/* Programs that the tool can use but does not need: gnuplot, ffmpeg. */
#ifndef TR_PROGRAM_H
#define TR_PROGRAM_H

#include <stdbool.h>

/* Is there an executable of that name on the PATH? Looks; runs nothing. */
bool tr_program_available(const char *name);

/* A helper outlives a run that is killed, and would write into the files of the run that goes on. So a helper inherits a lock on
 * the file (made if it is not there) or directory that it writes, and the next one waits for it. Close the lock when the helper
 * has been started; -1: this file system has no locks. */
int tr_program_lock(const char *path);

#endif
