/* SPDX-License-Identifier: MIT */
/* The inside of one contact along a path: kind `patch`. */
#ifndef TR_RUN_PATCH_H
#define TR_RUN_PATCH_H

#include "study/driven.h"

extern const tr_driven_kind tr_driven_patch;

#endif
