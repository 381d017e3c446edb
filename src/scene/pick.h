/* SPDX-License-Identifier: MIT */
/* Names of contacts: "3-17", "wall0-2", "most-mobilised". */
#ifndef TR_SCENE_PICK_H
#define TR_SCENE_PICK_H

#include "scene/data.h"

/* False: no such name. */
bool tr_scene_pick_read(tr_scene_pick *pick, const char *name);
void tr_scene_pick_name(tr_scene_pick pick, char name[TR_PICK_NAME]);

#endif
