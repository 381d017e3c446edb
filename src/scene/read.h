/* SPDX-License-Identifier: MIT */
/* One document of a case, as a tree, to one tr_scene. */
#ifndef TR_READ_H
#define TR_READ_H

#include "scene/expression.h"
#include "scene/data.h"
#include "scene/tree.h"

typedef struct tr_document {
    const tr_node *root;
    const char *name; /* of the file */
    tr_mark end;      /* of the file: the place of a missing section */
    const tr_param_catalog *catalog;
    tr_expression *expression;
    tr_status *st;
} tr_document;

/* Fills *scene, which is empty. Also after a failure it goes to tr_scene_free. */
bool tr_read_document(tr_scene *scene, const tr_document *document);

#endif
