/* SPDX-License-Identifier: MIT */
/* Every key of a case file: which section, which kind of case, and the row that says everything else. */
#ifndef TR_TABLES_H
#define TR_TABLES_H

#include "scene/scene.h"
#include "scene/text.h"

enum { TR_FOR_BIAXIAL = 1 << TR_KIND_BIAXIAL, TR_FOR_BODIES = 1 << TR_KIND_BODIES, TR_FOR_ALL = 3, TR_SLOTS = 3 };

/* Rows of one section. Neighbours with the same key are one section, some of whose keys are for one kind only. */
typedef struct tr_section {
    const char *key; /* in the root mapping; "": the root mapping itself */
    const char *doc;
    unsigned kinds; /* TR_FOR_* */
    const tr_param *params;
    int n;
    size_t offset; /* in tr_scene, of the struct that the rows describe; of a list: of the pointer to its items */
    size_t item;   /* of a list: size of an item; 0: not a list */
    size_t count;  /* of a list: offset in tr_scene of the number of items */
    int min_items, max_items;
} tr_section;

extern const tr_section tr_sections[];
extern const int tr_n_sections;

/* The places for laws: normal, friction, rolling. A slot's key is in `contact`, and so are the parameters of its law.
 */
typedef struct tr_law_place {
    const char *key;
    const tr_param_table *const *laws;
    int n;
    size_t offset; /* of the tr_scene_law in tr_scene */
} tr_law_place;

tr_law_place tr_tables_slot(const tr_param_catalog *catalog, int i);

/* Name of choice i of a TR_CHOICE row; false when there are no more. Rows whose choices the catalog knows have choices
 * NULL. */
bool tr_tables_choice(const tr_param_catalog *catalog, const tr_param *param, int i, tr_shown *name);

#endif
