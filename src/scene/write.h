/* SPDX-License-Identifier: MIT */
/* A scene as the text of a case. */
#ifndef TR_SCENE_WRITE_H
#define TR_SCENE_WRITE_H

#include "scene/data.h"

/* The whole case with every default written out, in SI with enough digits, with meaning and unit of each key as a
 * comment. Reading it gives the same scene, bit for bit. Allocated: free(); NULL when memory is short. */
char *tr_scene_write(const tr_scene *scene, const tr_param_catalog *catalog, tr_status *st);

#endif
