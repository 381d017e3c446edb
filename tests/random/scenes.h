/* SPDX-License-Identifier: MIT */
/* Random scenes that are valid and small. Laws and their parameters come from the registry, so a new law joins. */
#ifndef TR_RANDOM_SCENES_H
#define TR_RANDOM_SCENES_H

#include "base/status.h"
#include <stdbool.h>
#include <stdint.h>

/* Writes the scene with this seed to the file. It lasts a few thousand steps at most; how long a step is, is found out
 * here. False: the scene is refused, or cannot be written; st has the message. */
bool scenes_write(const char *path, uint64_t seed, tr_status *st);

#endif
