/* SPDX-License-Identifier: MIT */
/* What a check measures. */
#ifndef TR_SCENE_WHAT_H
#define TR_SCENE_WHAT_H

#include "scene/data.h"

tr_scene_quantity tr_scene_what(int what, tr_shape shape);

#endif
