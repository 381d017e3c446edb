/* SPDX-License-Identifier: MIT */
/* Every key of a case file: its section, its kind of case, and the row with everything else. */
#ifndef TR_TABLES_H
#define TR_TABLES_H

#include "scene/data.h"
#include "scene/text.h"

enum {
    TR_FOR_BIAXIAL = 1 << TR_KIND_BIAXIAL,
    TR_FOR_BODIES = 1 << TR_KIND_BODIES,
    TR_FOR_CONTACT = 1 << TR_KIND_CONTACT,
    TR_FOR_PATCH = 1 << TR_KIND_PATCH,
    TR_FOR_PAIR = TR_FOR_CONTACT | TR_FOR_PATCH,    /* kinds where a path drives one contact */
    TR_FOR_WORLDS = TR_FOR_BIAXIAL | TR_FOR_BODIES, /* kinds in which forces move disks */
    TR_FOR_ALL = TR_FOR_WORLDS | TR_FOR_PAIR,
    TR_LAW_KINDS = 3
};

/* Rows of one section. Neighbours with the same key are one section, some of whose keys are for one kind only, or for
 * some choices of its first key. */
typedef struct tr_section {
    const char *key; /* in the root mapping; "": the root mapping itself */
    const char *doc;
    const char *example; /* of a mapping: for one who gave a value in its place; NULL: none is asked for */
    unsigned kinds;      /* TR_FOR_* */
    const tr_param *params;
    int n;
    size_t offset; /* in tr_scene, of the struct that the rows describe; of a list: of the pointer to its items */
    size_t item;   /* of a list: size of an item; 0: not a list */
    size_t count;  /* of a list: offset in tr_scene of the number of items */
    size_t file;   /* of a list: offset in tr_scene of a char *: a single value instead of the list names a file with
                    * the list; 0: not allowed */
    int min_items, max_items;
    unsigned chosen; /* of a list whose items begin with an int, the choice of its first key: bits of the choices for
                        which these rows are; 0: all */
    bool derived;    /* the rows follow from other keys by their default: they can be named, but neither given nor
                       written. In a list their values have no place in the scene */
    const char *inside; /* of a mapping in the items of a list: the key of that list. offset, given: in the item; NULL:
                           not so */
    size_t given;       /* of such a mapping: offset of a bool that says whether the item has it */
    const char *like;   /* of such a mapping: what it does not say is as in this mapping of the root; NULL: not so */
    int first_law_kind; /* of sections whose struct is a tr_scene_contact: the keys of the laws of this and later slots
                      are in it too; 0: none, so it counts from 1 */
} tr_section;

extern const tr_section tr_sections[];
extern const int tr_n_sections;

/* Section i is the first one with its key for this kind (TR_FOR_*). */
bool tr_tables_begins(int i, unsigned kind);
/* The number of the next section behind i that is a mapping in the items of this list, for this kind; start with -1.
 * tr_n_sections: there is none. */
int tr_tables_inside(const char *list, unsigned kind, int i);

/* The next of these neighbours that is for this kind, or NULL. */
const tr_section *tr_tables_next(const tr_section *section, unsigned kind);

/* Whether these rows are for this item. */
bool tr_tables_chosen(const tr_section *section, const void *item);

/* kind: contact: default of the root's `depth` if `bodies.Lambda` is given. */
extern const char tr_tables_depth_from_Lambda[];

/* The kinds of law: normal, friction, rolling. The key of a kind is in `contact` or in an item of `laws`, and the
 * parameters of the law are beside it. */
typedef struct tr_law_place {
    const char *key;
    const tr_param_table *const *laws;
    int n;
    size_t offset; /* of the tr_scene_law in tr_scene_contact */
} tr_law_place;

tr_law_place tr_tables_law_kind(const tr_param_catalog *catalog, int i);

/* Name of choice i of a TR_CHOICE row; false when there are no more. Rows with choices from the catalog have choices
 * NULL. */
bool tr_tables_choice(const tr_param_catalog *catalog, const tr_param *param, int i, tr_shown *name);

#endif
