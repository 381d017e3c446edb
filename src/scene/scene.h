/* SPDX-License-Identifier: MIT */
/* A scene from the text of a case. */
#ifndef TR_SCENE_SCENE_H
#define TR_SCENE_SCENE_H

#include "scene/data.h"

/* A case and what the command line adds to it. */
typedef struct tr_scene_source {
    const char *name, *text; /* name: of the file, in messages; text: its bytes, which need not end in NUL */
    size_t size;             /* of the text, at most 1 MB */
    const char *const *sets; /* overrides "dotted.key=value", checked as the file is (list items: "disks.0.spin=2") */
    int n_sets;
} tr_scene_source;

/* Reads a case. On success *scene owns its arrays: tr_scene_free. On failure *scene is empty and
 * the message is "name:line:column: error: what, and what is allowed", the source line and a caret; code
 * TR_BAD_CASE. */
bool tr_scene_read(tr_scene *scene, const tr_scene_source *of, const tr_param_catalog *catalog, tr_status *st);

/* The same from a file. Cannot open or read: TR_FILE. */
bool tr_scene_read_file(tr_scene *scene, const char *path, const char *const *sets, int n_sets,
                        const tr_param_catalog *catalog, tr_status *st);

void tr_scene_free(tr_scene *scene);

#endif
