/* SPDX-License-Identifier: MIT */
/* YAML text as a small tree that keeps the place of everything. Only this file uses libyaml.
 *
 * The subset is what a case needs and a reader can see: mappings, lists and single values, in block or flow style. No
 * anchors, aliases, tags or keys that are not text; nothing is nested deeper than TR_TREE_DEPTH. Documents of one file
 * are siblings. */
#ifndef TR_TREE_H
#define TR_TREE_H

#include "scene/text.h"

enum { TR_TREE_DEPTH = 16 };

typedef enum tr_node_type { TR_NODE_VALUE, TR_NODE_LIST, TR_NODE_MAPPING } tr_node_type;

typedef struct tr_node {
    tr_node_type type;
    tr_mark mark;  /* where it begins */
    bool straight; /* of a value: letter i of text stands i columns behind mark (not so with escapes and many lines) */
    char *text;    /* of a value; never NULL there */
    char *key;     /* of a child of a mapping, else NULL */
    tr_mark key_mark;             /* of a document: where it begins, its `---` */
    struct tr_node *child, *next; /* first child; next sibling */
} tr_node;

/* The first document of a source that passed tr_text_check. NULL on failure. Free with tr_tree_free. */
tr_node *tr_tree_read(const tr_source *source, tr_status *st);

/* Applies a --set, "a.b.c=value": replaces that value, and makes missing mappings on the way. A number names an item of
 * a list. The reader decides whether the key is allowed. */
bool tr_tree_set(tr_node *root, const tr_source *set, tr_status *st);

/* over becomes base with the changes of over: mappings key by key, lists and values as a whole. Nodes from base keep
 * their marks. */
bool tr_tree_merge(tr_node *over, const tr_node *base, tr_status *st);

/* A new node: a copy of over, merged with base, which may be NULL. An empty value counts as an empty mapping. NULL on
 * failure. Free with tr_tree_free. */
tr_node *tr_tree_merged(const tr_node *over, const tr_node *base, tr_status *st);

/* Child of a mapping by key; NULL when it has none, or is not a mapping, or is NULL. */
const tr_node *tr_tree_find(const tr_node *mapping, const char *key);

int tr_tree_count(const tr_node *node); /* children */

void tr_tree_free(tr_node *root);

#endif
