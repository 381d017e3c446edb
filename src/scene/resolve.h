/* SPDX-License-Identifier: MIT */
/* From the text of one key, or its default, to the value in the scene. Values may name other keys, so they are computed
 * on demand. */
#ifndef TR_RESOLVE_H
#define TR_RESOLVE_H

#include "scene/expression.h"
#include "scene/data.h"
#include "scene/tree.h"

/* One key of one mapping of the case. */
typedef struct tr_entry {
    const tr_param *param;
    const char *fallback; /* default text; NULL: must be given */
    const tr_node *node;  /* the value in the case; NULL: not given */
    void *value;          /* where the value goes */
    double scratch;       /* buffer, if the scene has no place: only a law that is not chosen knows the key, or it is
                           * derived. Without a node such an entry is resolved only if another key names it */
    const char *law;      /* name of that law, else NULL. Such a key may be given and named; it has no default */
    char by_shape[TR_BY_SHAPE]; /* buffer for the default of the case's shape */
    bool derived;               /* follows from other keys by its default; node is NULL */
    enum { TR_ENTRY_NEW, TR_ENTRY_BUSY, TR_ENTRY_DONE } state;
    struct tr_entry *asker; /* while busy: the key whose text named this one */
    struct tr_scope *scope;
} tr_entry;

/* One mapping of the case: its keys look for names here first, then in scopes[0], the root. */
typedef struct tr_scope {
    const char *section;
    int item;            /* number in a list; -1: not in a list */
    const char *sub;     /* of a mapping in an item: its key; "": the item itself, or no list */
    const tr_node *node; /* NULL: not given */
    tr_mark mark;        /* the place of a missing key */
    tr_entry *entries;
    int n;
} tr_scope;

typedef struct tr_resolver {
    const tr_param_catalog *catalog;
    tr_shape shape;
    tr_scope *scopes;
    int n_scopes, depth;
    tr_expression *expression;
    tr_status *st;
} tr_resolver;

/* Writes the value of an entry, and of all entries that it names. asker: NULL. */
bool tr_resolve(tr_resolver *r, tr_entry *entry, tr_entry *asker);

/* First entry of a scope with this key, or NULL. */
tr_entry *tr_resolve_entry(const tr_scope *scope, const char *key);

/* "compaction.pressure", "disks.3.radius", "seed". */
tr_shown tr_resolve_name(const tr_scope *scope, const char *key);

#endif
