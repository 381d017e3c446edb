/* SPDX-License-Identifier: MIT */
/* Programs that the tool can use but does not need: gnuplot, ffmpeg. */
#ifndef TR_PROGRAM_H
#define TR_PROGRAM_H

#include <stdbool.h>

/* Whether the PATH has an executable with that name. Runs nothing. */
bool tr_program_available(const char *name);

#endif
