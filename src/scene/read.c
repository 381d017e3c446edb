/* SPDX-License-Identifier: MIT */
/* One document of a case to tr_scene: tree -> entries -> values.
 *
 * The allowed keys depend on `kind` and on the chosen laws, so these are resolved first. Every key
 * of the case becomes an entry (resolve.h); then all entries are resolved, in any order. */
#include "scene/read.h"
#include "base/alloc.h"
#include "scene/check.h"
#include "scene/tables.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct reader {
    tr_resolver r;
    tr_scene *scene;
    const tr_document *document;
    const tr_node *root;
    tr_entry *entries; /* of all scopes, one after the other */
    int n_entries;
    unsigned kind; /* TR_FOR_* */
    tr_node *made; /* mappings that were filled in */
    tr_status *st;
} reader;

static void *field(void *base, size_t offset) {
    return (char *)base + offset;
}

/* Only the last scope opened can take entries. */
static tr_scope *open_scope(reader *c, const char *section, int item, const tr_node *node) {
    tr_scope *s = &c->r.scopes[c->r.n_scopes++];
    *s = (tr_scope){section, item, "", node, node ? node->mark : c->document->end, c->entries + c->n_entries, 0};
    return s;
}

/* Rows whose values live in *base; base NULL: of a law that is not chosen. Laws may share a key: then they share its
 * text and the default of the first. Laws that are not chosen do not count. A key with the same name at the root takes
 * its default from there. */
static void add_rows(reader *c, tr_scope *s, const tr_param *params, int n, void *base, const char *law) {
    for (int i = 0; i < n; i++) {
        const tr_entry *first = tr_resolve_entry(s, params[i].key);
        if (first && !base) continue;
        tr_entry *e = &s->entries[s->n++];
        c->n_entries++;
        *e = (tr_entry){.param = &params[i], .scope = s, .law = base ? NULL : law};
        e->fallback = first ? first->fallback : params[i].fallback;
        const tr_entry *root = s != c->r.scopes ? tr_resolve_entry(c->r.scopes, params[i].key) : NULL;
        if (root && !(root->derived && s->item < 0)) e->fallback = params[i].key;
        e->node = tr_tree_find(s->node, params[i].key);
        e->value = base ? (char *)base + params[i].offset : (char *)&e->scratch;
    }
}

/* Rows that are only names for an expression. */
static void add_derived(reader *c, tr_scope *s, const tr_param *params, int n, void *base) {
    for (int i = 0; i < n; i++) {
        tr_entry *e = &s->entries[s->n++];
        c->n_entries++;
        *e = (tr_entry){.param = &params[i], .fallback = params[i].fallback, .scope = s, .derived = true};
        e->value = base ? field(base, params[i].offset) : &e->scratch;
    }
}

/* The parameters of the laws of a tr_scene_contact at base. */
static bool add_laws(reader *c, tr_scope *s, void *base, int first_law_kind) {
    for (int chosen = 1; chosen >= 0; chosen--) {
        for (int k = first_law_kind - 1; k < TR_LAW_KINDS; k++) {
            tr_law_place slot = tr_tables_law_kind(c->r.catalog, k);
            tr_scene_law *law = field(base, slot.offset);
            if (chosen && !tr_resolve(&c->r, tr_resolve_entry(s, slot.key), NULL)) return false;
            for (int i = 0; i < slot.n; i++) {
                const tr_param_table *t = slot.laws[i];
                if ((i == law->law) == chosen) add_rows(c, s, t->params, t->n, chosen ? law->par : NULL, t->name);
            }
        }
    }
    return true;
}

static bool is_list(const tr_section *t) {
    return t->item;
}

/* Where a key is known that this scope does not have: another kind of case, or another choice of the first key; or
 * NULL. */
static const tr_section *elsewhere(const tr_scope *s, const char *key) {
    for (int i = 0; i < tr_n_sections && !*s->sub; i++) {
        const tr_section *t = &tr_sections[i];
        if (t->inside) continue;
        if (!*s->section && strcmp(t->key, key) == 0) return t;
        for (int k = 0; k < t->n && strcmp(t->key, s->section) == 0; k++) {
            if (strcmp(t->params[k].key, key) == 0) return t;
        }
    }
    return NULL;
}

static void offer(char *list, size_t size, tr_near *near, const char *wanted, const char *key) {
    size_t used = strlen(list);
    bool full = used && list[used - 1] == '.';
    tr_text_nearer(near, wanted, key);
    if (!full && used + strlen(key) + 8 < size)
        sprintf(list + used, "%s%s", used ? ", " : "", key);
    else if (!full && used + 6 < size)
        strcpy(list + used, ", ...");
}

/* The next mapping that an item may have, as tr_tables_inside. */
static int inner_of(const reader *c, const tr_scope *s, int i) {
    return s->item < 0 || *s->sub ? tr_n_sections : tr_tables_inside(s->section, c->kind, i);
}

static bool has_key(const tr_param *params, int n, const char *key) {
    for (int i = 0; i < n; i++)
        if (strcmp(params[i].key, key) == 0) return true;
    return false;
}

static bool some_law_has(const reader *c, int first_law_kind, const char *key) {
    for (int k = first_law_kind - 1; first_law_kind && k < TR_LAW_KINDS; k++) {
        tr_law_place slot = tr_tables_law_kind(c->r.catalog, k);
        for (int i = 0; i < slot.n; i++)
            if (has_key(slot.laws[i]->params, slot.laws[i]->n, key)) return true;
    }
    return false;
}

/* The way to a key of another section of this kind of case: "contact.mu_r", "disks.0.radius". */
static bool other_section(const reader *c, const char *key, char *name, size_t size) {
    for (const tr_section *t = tr_sections; t < tr_sections + tr_n_sections; t++) {
        if (!*t->key || !(t->kinds & c->kind) || t->derived) continue;
        if (!has_key(t->params, t->n, key) && !some_law_has(c, t->first_law_kind, key)) continue;
        snprintf(name, size, "%s.%s%s", t->key, t->item ? "0." : "", key);
        return true;
    }
    return false;
}

static bool unknown_key(reader *c, const tr_scope *s, const tr_node *child) {
    char list[200] = "", place[64];
    tr_near near = {NULL, 0};
    for (int i = 0; i < s->n; i++)
        if (!s->entries[i].derived) offer(list, sizeof list, &near, child->key, s->entries[i].param->key);
    for (int i = 0; i < tr_n_sections && !*s->section; i++) {
        const tr_section *t = &tr_sections[i];
        if (*t->key && tr_tables_begins(i, c->kind)) offer(list, sizeof list, &near, child->key, t->key);
    }
    for (int i = -1; (i = inner_of(c, s, i)) < tr_n_sections;)
        offer(list, sizeof list, &near, child->key, tr_sections[i].key);
    tr_shown key = tr_resolve_name(s, child->key);
    bool placed = other_section(c, child->key, place, sizeof place);
    const tr_section *other = placed && !*s->section ? NULL : elsewhere(s, child->key);
    const tr_entry *first = other && other->kinds & c->kind ? s->entries : c->r.scopes->entries; /* which says that */
    if (other)
        return tr_text_fail(c->st, child->key_mark, "`%s` is not for `%s: %s`; allowed here: %s", key.text,
                            first->param->key, first->node->text, list);
    if (placed) near.word = place;
    return tr_text_fail(c->st, child->key_mark, "unknown key `%s`%s; allowed here: %s", key.text,
                        tr_text_hint(&near).text, list);
}

static bool check_keys(reader *c, const tr_scope *s) {
    for (const tr_node *child = s->node ? s->node->child : NULL; child; child = child->next) {
        const tr_entry *e = tr_resolve_entry(s, child->key);
        char buffer[TR_BY_SHAPE];
        if (e && e->derived)
            return tr_text_fail(c->st, child->key_mark, "`%s` follows from other keys, %s, and cannot be given",
                                tr_resolve_name(s, child->key).text,
                                tr_param_by_shape(e->fallback, c->r.shape, buffer));
        bool known = e;
        for (int i = 0; i < tr_n_sections && !known && !*s->section; i++)
            known = (tr_sections[i].kinds & c->kind) && !tr_sections[i].inside &&
                    strcmp(tr_sections[i].key, child->key) == 0;
        for (int i = -1; (i = inner_of(c, s, i)) < tr_n_sections && !known;)
            known = strcmp(tr_sections[i].key, child->key) == 0;
        if (!known) return unknown_key(c, s, child);
    }
    return true;
}

/* `walls:` without a value is an empty section. */
static bool check_type(reader *c, const tr_node *node, tr_node_type type, const char *what, const char *example) {
    bool empty = node && node->type == TR_NODE_VALUE && !*node->text;
    if (!node || node->type == type || empty) return true;
    return tr_text_fail(c->st, node->mark, "%s must be a %s%s%s", what,
                        type == TR_NODE_LIST ? "list, one `- key: value` for each" : "mapping of keys and values",
                        *example ? ": write " : "", example);
}

/* Units and defaults depend on the shape, so it is read as soon as its scope exists. */
static bool find_shape(reader *c, const tr_scope *s) {
    tr_entry *e = tr_resolve_entry(s, "shape");
    if (e && !tr_resolve(&c->r, e, NULL)) return false;
    c->r.shape = c->scene->shape;
    return true;
}

/* One mapping section: t and its neighbours of the same key. */
static bool read_mapping(reader *c, const tr_section *t) {
    const tr_node *node = tr_tree_find(c->root, t->key);
    char what[48];
    snprintf(what, sizeof what, "`%s`", t->key);
    if (!check_type(c, node, TR_NODE_MAPPING, what, t->example ? t->example : "")) return false;
    tr_scope *s = open_scope(c, t->key, -1, node);
    for (const tr_section *u = t; u; u = tr_tables_next(u, c->kind))
        add_rows(c, s, u->params, u->n, field(c->scene, u->offset), NULL);
    if (t->first_law_kind && !add_laws(c, s, field(c->scene, t->offset), t->first_law_kind)) return false;
    return find_shape(c, s) && check_keys(c, s);
}

/* `path: FILE.csv`: the name is relative to the folder of the case. It is made absolute, so that it also serves the
 * resolved case, which is in another folder. */
static bool read_file_name(reader *c, const tr_section *t, const tr_node *node) {
    const char *name = c->document->name, *slash = strrchr(name, '/');
    char text[2048];
    snprintf(text, sizeof text, "%.*s%s", slash && *node->text != '/' ? (int)(slash + 1 - name) : 0, name, node->text);
    char *whole = realpath(text, NULL);
    if (!whole) return tr_text_fail(c->st, node->mark, "cannot read %.300s: %s", text, strerror(errno));
    memcpy(field(c->scene, t->file), &whole, sizeof whole);
    return true;
}

/* A mapping in item i of list t, if the item has it. What it is like fills in what it leaves out, before it is read. */
static bool read_inner(reader *c, const tr_section *t, int i, const tr_node *node, char *item) {
    char what[80];
    snprintf(what, sizeof what, "`%s.%d.%s`", t->inside, i, t->key);
    if (!node) return true;
    if (!check_type(c, node, TR_NODE_MAPPING, what, t->example ? t->example : "")) return false;
    tr_node *whole = tr_tree_merged(node, t->like ? tr_tree_find(c->root, t->like) : NULL, c->st);
    if (!whole) return false;
    whole->next = c->made, c->made = whole;
    tr_scope *s = open_scope(c, t->inside, i, whole);
    s->sub = t->key;
    *(bool *)field(item, t->given) = true;
    add_rows(c, s, t->params, t->n, field(item, t->offset), NULL);
    if (t->first_law_kind && !add_laws(c, s, field(item, t->offset), t->first_law_kind)) return false;
    return check_keys(c, s);
}

/* Behind all items, so that neighbours in the list are neighbours among the scopes. */
static bool read_inside(reader *c, const tr_section *list, const tr_node *node, char *items) {
    for (int k = -1; (k = tr_tables_inside(list->key, c->kind, k)) < tr_n_sections;) {
        char *item = items;
        int i = 0;
        for (const tr_node *child = node->child; child; child = child->next, i++, item += list->item)
            if (!read_inner(c, &tr_sections[k], i, tr_tree_find(child, tr_sections[k].key), item)) return false;
    }
    return true;
}

static bool read_list(reader *c, const tr_section *t) {
    const tr_node *node = tr_tree_find(c->root, t->key);
    char what[48];
    snprintf(what, sizeof what, "`%s`", t->key);
    if (t->file && node && node->type == TR_NODE_VALUE && *node->text) return read_file_name(c, t, node);
    if (!check_type(c, node, TR_NODE_LIST, what, "")) return false;
    int n = node ? tr_tree_count(node) : 0;
    if (n < t->min_items || n > t->max_items)
        return tr_text_fail(c->st, node ? node->mark : c->document->end, "`%s` has %d items, allowed is %d to %d",
                            t->key, n, t->min_items, t->max_items);
    char *items = tr_alloc((size_t)n, t->item, c->st);
    if (!items) return false;
    memcpy(field(c->scene, t->offset), &items, sizeof items); /* a pointer of some struct: its type is not known here */
    *(int *)field(c->scene, t->count) = n;
    const tr_node *child = n ? node->child : NULL;
    for (int i = 0; i < n; i++, child = child->next) {
        snprintf(what, sizeof what, "`%s.%d`", t->key, i);
        if (!check_type(c, child, TR_NODE_MAPPING, what, "")) return false;
        tr_scope *s = open_scope(c, t->key, i, child);
        char *item = items + (size_t)i * t->item;
        for (const tr_section *u = t; u; u = tr_tables_next(u, c->kind)) {
            if (u->chosen && !tr_resolve(&c->r, s->entries, NULL)) return false;
            if (!tr_tables_chosen(u, item)) continue;
            if (u->derived)
                add_derived(c, s, u->params, u->n, NULL);
            else
                add_rows(c, s, u->params, u->n, item, NULL);
            if (u->first_law_kind && !add_laws(c, s, item, u->first_law_kind)) return false;
        }
        if (!check_keys(c, s)) return false;
    }
    return !n || read_inside(c, t, node, items);
}

/* Room for every scope and entry that the case can have. */
static bool reserve(reader *c) {
    int scopes = 1, entries = 0, laws = 0; /* laws: rows of all laws */
    for (int k = 0; k < TR_LAW_KINDS; k++) {
        tr_law_place slot = tr_tables_law_kind(c->r.catalog, k);
        for (int i = 0; i < slot.n; i++) laws += slot.laws[i]->n;
    }
    for (int i = 0; i < tr_n_sections; i++) {
        const tr_section *t = &tr_sections[i];
        const char *list = t->inside ? t->inside : is_list(t) ? t->key : NULL;
        const tr_node *node = list ? tr_tree_find(c->root, list) : NULL;
        int items = list ? (node ? tr_tree_count(node) : 0) : 1;
        scopes += items;
        entries += items * (t->n + (t->first_law_kind ? laws : 0));
    }
    c->r.scopes = tr_alloc((size_t)scopes, sizeof(tr_scope), c->st);
    c->entries = tr_alloc((size_t)entries, sizeof(tr_entry), c->st);
    return c->r.scopes && c->entries;
}

/* The root's keys; `kind` first, because it decides about the others. */
static bool read_root(reader *c) {
    tr_scope *s = open_scope(c, "", -1, c->root);
    for (const tr_section *t = tr_sections; !*t->key; t++) {
        bool ours = t == tr_sections || (t->kinds & c->kind);
        if (ours && t->derived)
            add_derived(c, s, t->params, t->n, c->scene);
        else if (ours)
            add_rows(c, s, t->params, t->n, c->scene, NULL);
        if (t == tr_sections && !tr_resolve(&c->r, tr_resolve_entry(s, "kind"), NULL)) return false;
        c->kind = 1u << c->scene->kind;
    }
    return find_shape(c, s) && check_keys(c, s);
}

/* Lambda gives a depth, by the first force of the path. */
static bool take_Lambda(reader *c) {
    bool patch = c->scene->kind == TR_KIND_PATCH;
    const tr_scope *at = patch ? c->r.scopes : tr_check_scope(&c->r, "bodies", -1);
    const tr_scope *first = tr_check_scope(&c->r, "path", 0);
    const tr_node *node = at ? tr_tree_find(at->node, "Lambda") : NULL;
    if (!node) return true;
    if (!first || !tr_tree_find(first->node, "force"))
        return tr_text_fail(c->st, node->mark,
                            "`Lambda` is ln(2d/a) at the force of the first segment, which %s: give `depth`",
                            first ? "gives none" : "is not in the case");
    if (!patch) tr_resolve_entry(c->r.scopes, "depth")->fallback = tr_tables_depth_from_Lambda;
    return true;
}

static bool resolve_all(reader *c) {
    if (!take_Lambda(c)) return false;
    for (int i = 0; i < c->n_entries; i++) {
        tr_entry *e = &c->entries[i];
        bool on_demand = e->value == &e->scratch && !e->node;
        if (!on_demand && !tr_resolve(&c->r, e, NULL)) return false;
    }
    return true;
}

static bool read_document(reader *c) {
    if (!check_type(c, c->root, TR_NODE_MAPPING, "a case", "")) return false;
    if (!reserve(c) || !read_root(c)) return false;
    for (int i = 0; i < tr_n_sections; i++) {
        const tr_section *t = &tr_sections[i];
        if (!*t->key || !tr_tables_begins(i, c->kind)) continue;
        if (!(is_list(t) ? read_list(c, t) : read_mapping(c, t))) return false;
    }
    return resolve_all(c) && tr_check_together(&c->r, c->scene);
}

bool tr_read_document(tr_scene *scene, const tr_document *d) {
    reader c = {.r = {.catalog = d->catalog, .expression = d->expression, .st = d->st},
                .scene = scene,
                .document = d,
                .root = d->root,
                .st = d->st};
    bool ok = read_document(&c);
    free(c.r.scopes);
    free(c.entries);
    tr_tree_free(c.made);
    return ok;
}
