/* SPDX-License-Identifier: MIT */
/* Random scenes that are valid and small. Laws and their parameters come from the registry, so a new law is among them. */
#ifndef TR_RANDOM_SCENES_H
#define TR_RANDOM_SCENES_H

#include "base/status.h"
#include <stdbool.h>
#include <stdint.h>

/* Writes the scene with this seed to the file. It is as long as the steps that it may take, for which its step is found
 * out here. False: no scene of this kind could be made; st has the message if it is not one that only a trial can tell. */
bool scenes_write(const char *path, uint64_t seed, tr_status *st);

#endif
