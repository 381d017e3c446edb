/* SPDX-License-Identifier: MIT */
/* An entry is new, busy or done. Reaching a busy one again is a cycle, and the askers give its path. */
#include "scene/resolve.h"
#include "scene/contact_name.h"
#include "scene/tables.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_DEPTH = 32 }; /* values that refer to values: bounds the stack */

tr_entry *tr_resolve_entry(const tr_scope *scope, const char *key) {
    for (int i = 0; i < scope->n; i++) {
        if (strcmp(scope->entries[i].param->key, key) == 0) return &scope->entries[i];
    }
    return NULL;
}

tr_shown tr_resolve_name(const tr_scope *scope, const char *key) {
    char name[200];
    const char *section = scope->section;
    if (scope->item < 0)
        snprintf(name, sizeof name, "%s%s%s", section, *section ? "." : "", key);
    else
        snprintf(name, sizeof name, "%s.%d.%s%s%s", section, scope->item, scope->sub, *scope->sub ? "." : "", key);
    return tr_text_show(name);
}

/* An error in the text of an entry at its character `at`. A default has no place in the file, so the message quotes
 * it. */
__attribute__((format(printf, 4, 5))) static bool fail(tr_resolver *r, const tr_entry *e, size_t at, const char *format,
                                                       ...) {
    char what[400];
    va_list args;
    va_start(args, format);
    vsnprintf(what, sizeof what, format, args);
    va_end(args);
    if (e->derived) { /* the place is that of the key that asked */
        const tr_entry *by = e->asker;
        while (by && !by->node) by = by->asker;
        return tr_text_fail(r->st, by ? by->node->mark : e->scope->mark,
                            "`%s` stands for `%s` here, and that fails: %s", e->param->key, e->fallback, what);
    }
    if (!e->node)
        return tr_text_fail(r->st, e->scope->mark, "`%s` is not given, and its default `%s` fails: %s; give `%s`",
                            tr_resolve_name(e->scope, e->param->key).text, e->fallback, what, e->param->key);
    tr_mark mark = e->node->mark;
    if (e->node->straight) mark.column += (int)at;
    return tr_text_fail(r->st, mark, "%s", what);
}

/* A key of the same mapping, then of the root: a key that names itself means the root's, and the key of a law that is
 * not chosen is not in the way. With dots section.key or list.number.key; in a list also previous.key, of the item
 * before, which for the first item is the item itself; and
 * list.number.mapping.key. */
static tr_entry *lookup(const tr_resolver *r, const tr_entry *asker, const char *name) {
    const tr_scope *scope = asker->scope;
    const char *dot = strchr(name, '.'), *key = dot ? dot + 1 : name;
    if (!dot) {
        tr_entry *e = tr_resolve_entry(scope, name), *root = tr_resolve_entry(&r->scopes[0], name);
        bool elsewhere = e && root && (e == asker || (e->law && !e->node));
        return e && !elsewhere ? e : root;
    }
    if (scope->item >= 0 && strncmp(name, "previous.", 9) == 0)
        return tr_resolve_entry(scope->item > 0 ? scope - 1 : scope, key);
    long item = -1;
    if (*key >= '0' && *key <= '9') {
        char *end;
        item = strtol(key, &end, 10);
        if (*end != '.') return NULL;
        key = end + 1;
    }
    size_t length = (size_t)(dot - name);
    const char *inner = item >= 0 ? strchr(key, '.') : NULL; /* list.number.mapping.key */
    size_t sub = inner ? (size_t)(inner - key) : 0;
    for (int i = 1; i < r->n_scopes; i++) {
        const tr_scope *s = &r->scopes[i];
        if (s->item == item && strlen(s->section) == length && memcmp(s->section, name, length) == 0 &&
            strlen(s->sub) == sub && memcmp(s->sub, key, sub) == 0)
            return tr_resolve_entry(s, inner ? inner + 1 : key);
    }
    return NULL;
}

typedef struct request {
    tr_resolver *resolver;
    tr_entry *asker;
} request;

static tr_found unknown(const request *q, const char *name, tr_problem *problem) {
    const tr_scope *scopes[] = {q->asker->scope, &q->resolver->scopes[0]};
    tr_near near = {NULL, 0};
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < scopes[k]->n; i++) tr_text_nearer(&near, name, scopes[k]->entries[i].param->key);
    }
    snprintf(problem->text, sizeof problem->text,
             "unknown name `%s`%s; a name is a key of this mapping, section.key, or a unit: " TR_EXPRESSION_UNITS,
             tr_text_show(name).text, tr_text_hint(&near).text);
    return TR_UNKNOWN;
}

static tr_found find(void *context, const char *name, tr_quantity *quantity, tr_problem *problem) {
    const request *q = context;
    tr_entry *e = lookup(q->resolver, q->asker, name);
    if (!e) return tr_expression_reserved(name) ? TR_UNKNOWN : unknown(q, name, problem);
    if (e->law && !e->node) {
        snprintf(problem->text, sizeof problem->text, "`%s` belongs to the law %s, which is not chosen", name, e->law);
        return TR_FAILED;
    }
    if (e->param->type != TR_REAL && e->param->type != TR_COUNT) {
        snprintf(problem->text, sizeof problem->text, "`%s` is not a quantity", name);
        return TR_FAILED;
    }
    if (!tr_resolve(q->resolver, e, q->asker)) return TR_FAILED;
    if (e->param->type == TR_REAL && isnan(*(double *)e->value)) {
        snprintf(problem->text, sizeof problem->text, "`%s` is not known: `%s` is given in its place",
                 tr_resolve_name(e->scope, e->param->key).text, e->param->choices);
        return TR_FAILED;
    }
    if (e->param->type == TR_REAL)
        *quantity = (tr_quantity){*(double *)e->value, tr_dim_of(e->param->dim, q->resolver->shape)};
    else
        *quantity = (tr_quantity){*(int *)e->value, TR_DIM_NUMBER};
    return TR_FOUND;
}

/* TR_REAL and TR_COUNT: text to a number within the bounds of the row. */
static bool read_number(tr_resolver *r, tr_entry *e, const char *text, double *value) {
    const tr_param *p = e->param;
    char buffer[TR_BY_SHAPE];
    const char *key = p->key, *unit = "";
    if (p->type == TR_REAL && strcmp(p->unit, "1") != 0) unit = tr_param_by_shape(p->unit, r->shape, buffer);
    request q = {r, e};
    tr_problem problem;
    const tr_dim number = TR_DIM_NUMBER;
    if (!tr_expression_value(r->expression, text, p->type == TR_REAL ? tr_dim_of(p->dim, r->shape) : number,
                             &(tr_names){find, &q}, value, &problem)) {
        if (problem.no_memory) return tr_status_fail(r->st, TR_FILE, "error: out of memory");
        return fail(r, e, problem.at, "%s (`%s` is %s%s)", problem.text, key, *unit ? "in " : "a number", unit);
    }
    if (p->type == TR_COUNT && *value != floor(*value))
        return fail(r, e, 0, "`%s` must be a whole number, %g to %g", key, p->min, p->max);
    if (!(*value >= p->min && *value <= p->max))
        return fail(r, e, 0, "`%s` is %.9g, allowed is %g to %g%s%s", key, *value, p->min, p->max, *unit ? " " : "",
                    unit);
    return true;
}

/* uint64_t: all digits count, so no arithmetic in double. */
static bool read_seed(tr_resolver *r, tr_entry *e, const char *text) {
    size_t digits = strspn(text, "0123456789");
    errno = 0;
    *(uint64_t *)e->value = strtoull(text, NULL, 10);
    if (digits && !text[digits] && errno == 0) return true;
    return fail(r, e, 0, "`%s` must be a whole number, 0 to %llu", e->param->key, (unsigned long long)UINT64_MAX);
}

static bool read_choice(tr_resolver *r, tr_entry *e, const char *text) {
    char list[240] = "";
    tr_near near = {NULL, 0};
    tr_shown name, nearest;
    for (int i = 0; tr_tables_choice(r->catalog, e->param, i, &name); i++) {
        if (strcmp(name.text, text) == 0) return *(int *)e->value = i, true;
        tr_text_nearer(&near, text, name.text);
        if (near.word == name.text) nearest = name, near.word = nearest.text;
        size_t used = strlen(list);
        snprintf(list + used, sizeof list - used, "%s%s", used ? " | " : "", name.text);
    }
    for (int i = 0; i < r->catalog->n_renamed; i++) {
        const tr_param_renamed *was = &r->catalog->renamed[i];
        if (strcmp(was->key, e->param->key) == 0 && strcmp(was->old, text) == 0)
            return fail(r, e, 0, "`%s` has another name now: write %s", text, was->now);
    }
    if (strcmp(e->param->key, "kind") == 0 && strcmp(text, "sweep") == 0)
        return fail(r, e, 0, "this is a sweep over many cases: `trundle sweep` runs it; a case has `kind`: %s", list);
    return fail(r, e, 0, "`%s` is not a choice for `%s`%s; allowed is %s", tr_text_show(text).text, e->param->key,
                tr_text_hint(&near).text, list);
}

static bool read_switch(tr_resolver *r, tr_entry *e, const char *text) {
    bool yes = strcmp(text, "yes") == 0 || strcmp(text, "true") == 0;
    *(bool *)e->value = yes;
    if (yes || strcmp(text, "no") == 0 || strcmp(text, "false") == 0) return true;
    return fail(r, e, 0, "`%s` is not a choice for `%s`; allowed is yes | no", tr_text_show(text).text, e->param->key);
}

/* A list of names, or a single one. */
static bool read_contact_ids(tr_resolver *r, tr_entry *e) {
    tr_contact_ids *picks = e->value;
    const tr_node *node = e->node && e->node->type == TR_NODE_LIST ? e->node->child : e->node;
    for (*picks = (tr_contact_ids){0}; node; node = node == e->node ? NULL : node->next) {
        tr_contact_id pick;
        if (node->type != TR_NODE_VALUE || !tr_contact_name_read(&pick, node->text))
            return tr_text_fail(r->st, node->mark,
                                "%s%s%sno contact; name it 17-42 (disks 17 and 42), wall0-3 (wall 0 and disk 3) or "
                                "most-mobilised",
                                node->text ? "`" : "this is ", node->text ? tr_text_show(node->text).text : "",
                                node->text ? "` is " : "");
        for (int i = 0; i < picks->n; i++)
            if (picks->item[i].a == pick.a && picks->item[i].b == pick.b)
                return tr_text_fail(r->st, node->mark, "`%s` is given twice", node->text);
        if (picks->n == (int)e->param->max)
            return tr_text_fail(r->st, node->mark, "more than %d contact%s in `%s`", picks->n, picks->n > 1 ? "s" : "",
                                e->param->key);
        picks->item[picks->n++] = pick;
    }
    if (picks->n == 0 && !e->fallback)
        return tr_text_fail(r->st, e->scope->mark, "`%s` is missing: %s", tr_resolve_name(e->scope, e->param->key).text,
                            e->param->doc);
    e->state = TR_ENTRY_DONE;
    return true;
}

static bool read_text(tr_resolver *r, tr_entry *e, const char *text) {
    size_t room = (size_t)e->param->max, n = tr_text_line(text, e->value, room);
    if (n == 0) return fail(r, e, 0, "`%s` holds a character that is not allowed; it is a line of text", e->param->key);
    return n <= room ||
           fail(r, e, 0, "`%s` is %zu bytes of UTF-8 long, allowed is %zu", e->param->key, n - 1, room - 1);
}

static bool read_value(tr_resolver *r, tr_entry *e, const char *text) {
    double value;
    switch (e->param->type) {
    case TR_REAL:
        return read_number(r, e, text, e->value);
    case TR_COUNT:
        return read_number(r, e, text, &value) && (*(int *)e->value = (int)value, true);
    case TR_SEED:
        return read_seed(r, e, text);
    case TR_CHOICE:
        return read_choice(r, e, text);
    case TR_SWITCH:
        return read_switch(r, e, text);
    case TR_TEXT:
        return read_text(r, e, text);
    case TR_CONTACT_IDS: /* no text: see tr_resolve */
        break;
    }
    return false;
}

/* asker's text names e, which is busy: asker was asked by ..., which was asked by e. */
static bool cycle(tr_resolver *r, const tr_entry *e, const tr_entry *asker) {
    const tr_entry *way[MAX_DEPTH + 1];
    int n = 0;
    for (way[n++] = e; asker != e && n <= MAX_DEPTH; asker = asker->asker) way[n++] = asker;
    char text[300] = "";
    for (int i = n; i >= 0; i--) {
        size_t used = strlen(text);
        const tr_entry *step = way[i % n]; /* e, first asked ... last asker, e */
        snprintf(text + used, sizeof text - used, "%s%s", used ? " -> " : "",
                 tr_resolve_name(step->scope, step->param->key).text);
    }
    return fail(r, n > 1 ? way[1] : e, 0, "these keys refer to each other in a circle: %s", text);
}

/* An empty text is as good as none. */
static bool is_given(const tr_entry *e) {
    return e->node && !(e->param->type == TR_TEXT && e->node->type == TR_NODE_VALUE && !*e->node->text);
}

bool tr_resolve(tr_resolver *r, tr_entry *e, tr_entry *asker) {
    if (e->state == TR_ENTRY_DONE) return true;
    if (e->state == TR_ENTRY_BUSY) return cycle(r, e, asker);
    const tr_param *p = e->param;
    if (p->type == TR_CONTACT_IDS) return read_contact_ids(r, e);
    tr_shown name = tr_resolve_name(e->scope, p->key);
    const char *instead = p->type == TR_REAL ? p->choices : NULL;
    const tr_entry *other = instead ? tr_resolve_entry(e->scope, instead) : NULL;
    if (other && e->node && is_given(other))
        return tr_text_fail(r->st, e->node->mark, "`%s` and `%s` mean the same: give one of them", p->key, instead);
    if (other && !e->node && (is_given(other) || (!e->fallback && other->fallback && *other->fallback))) {
        *(double *)e->value = NAN;
        e->state = TR_ENTRY_DONE;
        return true;
    }
    if (e->fallback) e->fallback = tr_param_by_shape(e->fallback, r->shape, e->by_shape);
    if (!e->node && !e->fallback) {
        char buffer[TR_BY_SHAPE];
        return tr_text_fail(r->st, e->scope->mark,
                            p->type == TR_REAL ? "`%s` is missing: %s [%s]%s%s" : "`%s` is missing: %s", name.text,
                            p->doc, tr_param_by_shape(p->unit, r->shape, buffer), other ? "; or give " : "",
                            other ? instead : "");
    }
    if (e->node && e->node->type != TR_NODE_VALUE)
        return tr_text_fail(r->st, e->node->mark, "`%s` must be a single value: %s", name.text, p->doc);
    const char *text = e->node ? e->node->text : e->fallback;
    if (*text == '\0' && p->type != TR_TEXT) return fail(r, e, 0, "`%s` has no value: %s", name.text, p->doc);
    if (r->depth == MAX_DEPTH) return fail(r, e, 0, "values refer to other values more than %d levels deep", MAX_DEPTH);
    e->state = TR_ENTRY_BUSY;
    e->asker = asker;
    r->depth++;
    bool ok = read_value(r, e, text);
    r->depth--;
    e->state = TR_ENTRY_DONE;
    return ok;
}
