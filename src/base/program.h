/* SPDX-License-Identifier: MIT */
/* Programs that the tool can use but does not need: gnuplot, ffmpeg. */
#ifndef TR_PROGRAM_H
#define TR_PROGRAM_H

#include <stdbool.h>

/* Is there an executable of that name on the PATH? Looks; runs nothing. */
bool tr_program_available(const char *name);

#endif
