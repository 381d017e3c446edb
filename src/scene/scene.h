/* SPDX-License-Identifier: MIT */
/* A scene from the text of a case. */
#ifndef TR_SCENE_SCENE_H
#define TR_SCENE_SCENE_H

#include "scene/data.h"

/* Reads a case. text: the bytes of the file (need not end in NUL; at most 1 MB). name: the name of the file in
 * messages. sets: n_sets overrides "dotted.key=value" of the command line, under the same checks as the file (list
 * items by number: "disks.0.spin=2"). On success *scene owns its arrays: tr_scene_free. On failure *scene is empty and
 * the message is "name:line:column: error: what, and what is allowed", the source line and a caret; code
 * TR_BAD_CASE. */
bool tr_scene_read(tr_scene *scene, const char *name, const char *text, size_t size, const char *const *sets,
                   int n_sets, const tr_param_catalog *catalog, tr_status *st);

/* The same from a file. Cannot open or read: TR_FILE. */
bool tr_scene_read_file(tr_scene *scene, const char *path, const char *const *sets, int n_sets,
                        const tr_param_catalog *catalog, tr_status *st);

void tr_scene_free(tr_scene *scene);

#endif
