/* SPDX-License-Identifier: MIT */
/* Built while streaming, so that the limits on depth and width also bound time and memory: libyaml itself needs 20 s
 * for 100,000 opening brackets. */
#include "scene/tree.h"
#include "base/alloc.h"

#include <stdlib.h>
#include <string.h>
#include <yaml.h>

enum { MAX_KEYS = 100, MAX_ITEMS = 10000 };

typedef struct level {
    tr_node *node, *last; /* a list or mapping that is open, its last child */
    int n;                /* children so far */
    char *key;            /* the key that waits for its value */
    tr_mark key_mark;
} level;

typedef struct builder {
    const tr_source *source;
    tr_node *root;
    level levels[TR_TREE_DEPTH + 1]; /* 0: the document */
    int depth;
    tr_status *st;
} builder;

static char *copy(const char *text, size_t length, tr_status *st) {
    char *p = tr_alloc(length + 1, 1, st);
    if (p) memcpy(p, text, length);
    return p;
}

static tr_mark mark_of(const builder *b, yaml_mark_t mark) {
    return (tr_mark){b->source, (int)mark.line + 1, (int)mark.column + 1};
}

/* A new child of the innermost open level. */
static tr_node *add(builder *b, tr_node_type type, tr_mark mark) {
    level *up = &b->levels[b->depth];
    if (up->node && up->node->type == TR_NODE_MAPPING && !up->key)
        return tr_text_fail(b->st, mark, "a key must be plain text"), NULL;
    if (up->n == MAX_ITEMS) return tr_text_fail(b->st, mark, "more than %d items in a list", MAX_ITEMS), NULL;
    tr_node *node = tr_alloc(1, sizeof *node, b->st);
    if (!node) return NULL;
    *node = (tr_node){.type = type, .mark = mark, .key = up->key, .key_mark = up->key_mark};
    up->key = NULL;
    *(up->last ? &up->last->next : up->node ? &up->node->child : &b->root) = node;
    up->last = node;
    up->n++;
    return node;
}

static bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/* `{mu: 0,3}` says that mu is 0, and 3 is a key. */
static bool check_comma(const builder *b, tr_mark mark, const char *text) {
    const tr_node *last = b->levels[b->depth].last;
    size_t n = last && last->text ? strlen(last->text) : 0;
    if (!is_digit(*text) || !n || !is_digit(last->text[n - 1])) return true;
    return tr_text_fail(b->st, mark, "a number has a decimal point: write `%s: %s.%s`", tr_text_show(last->key).text,
                        tr_text_show(last->text).text, tr_text_show(text).text);
}

static bool add_key(builder *b, tr_mark mark, const char *text, size_t length) {
    level *up = &b->levels[b->depth];
    if (!check_comma(b, mark, text)) return false;
    for (const tr_node *node = up->node->child; node; node = node->next) {
        if (strcmp(node->key, text) == 0)
            return tr_text_fail(b->st, mark, "duplicate key `%s`; it is already given in line %d",
                                tr_text_show(text).text, node->key_mark.line);
    }
    if (up->n == MAX_KEYS) return tr_text_fail(b->st, mark, "more than %d keys in one mapping", MAX_KEYS);
    up->key = copy(text, length, b->st);
    up->key_mark = mark;
    return up->key;
}

static bool add_scalar(builder *b, const yaml_event_t *event) {
    const char *text = (const char *)event->data.scalar.value;
    size_t length = event->data.scalar.length, start = event->start_mark.column, end = event->end_mark.column;
    tr_mark mark = mark_of(b, event->start_mark);
    if (memchr(text, 0, length)) return tr_text_fail(b->st, mark, "character U+0000 is not allowed");
    const level *up = &b->levels[b->depth];
    if (up->node && up->node->type == TR_NODE_MAPPING && !up->key) return add_key(b, mark, text, length);
    tr_node *node = add(b, TR_NODE_VALUE, mark);
    if (!node) return false;
    size_t quotes = event->data.scalar.style == YAML_PLAIN_SCALAR_STYLE ? 0 : 2;
    node->straight = event->start_mark.line == event->end_mark.line && end - start == length + quotes;
    if (node->straight) node->mark.column += (int)quotes / 2;
    node->text = copy(text, length, b->st);
    return node->text;
}

static bool open_level(builder *b, tr_node_type type, tr_mark mark) {
    if (b->depth == TR_TREE_DEPTH) return tr_text_fail(b->st, mark, "nested deeper than %d levels", TR_TREE_DEPTH);
    tr_node *node = add(b, type, mark);
    if (node) b->levels[++b->depth] = (level){.node = node};
    return node;
}

/* Anchors and tags: the same fields in three kinds of event. */
static bool refuse(builder *b, tr_mark mark, const yaml_char_t *anchor, const yaml_char_t *tag) {
    if (anchor) return tr_text_fail(b->st, mark, "anchors (&name) are not allowed; write the value out");
    return tag ? tr_text_fail(b->st, mark, "tags (!name) are not allowed") : true;
}

/* One event; false on failure. */
static bool take(builder *b, const yaml_event_t *event) {
    tr_mark mark = mark_of(b, event->start_mark);
    switch (event->type) {
    case YAML_DOCUMENT_START_EVENT:
        if (event->data.document_start.tag_directives.start != event->data.document_start.tag_directives.end)
            return tr_text_fail(b->st, mark, "tags (%%TAG) are not allowed");
        b->levels[0].key_mark = mark;
        return true;
    case YAML_ALIAS_EVENT:
        return tr_text_fail(b->st, mark, "aliases (*name) are not allowed; write the value out");
    case YAML_SCALAR_EVENT:
        return refuse(b, mark, event->data.scalar.anchor, event->data.scalar.tag) && add_scalar(b, event);
    case YAML_SEQUENCE_START_EVENT:
        return refuse(b, mark, event->data.sequence_start.anchor, event->data.sequence_start.tag) &&
               open_level(b, TR_NODE_LIST, mark);
    case YAML_MAPPING_START_EVENT:
        return refuse(b, mark, event->data.mapping_start.anchor, event->data.mapping_start.tag) &&
               open_level(b, TR_NODE_MAPPING, mark);
    case YAML_SEQUENCE_END_EVENT:
    case YAML_MAPPING_END_EVENT:
        b->depth--;
        return true;
    default:
        return true;
    }
}

static bool parser_failed(builder *b, const yaml_parser_t *parser) {
    if (parser->error == YAML_MEMORY_ERROR) return tr_status_fail(b->st, TR_FILE, "error: out of memory");
    const char *problem = parser->problem ? parser->problem : "unreadable";
    tr_mark mark = mark_of(b, parser->problem_mark);
    if (!parser->context) return tr_text_fail(b->st, mark, "not valid YAML: %s", problem);
    return tr_text_fail(b->st, mark, "not valid YAML: %s, %s that begins in line %d", problem, parser->context,
                        mark_of(b, parser->context_mark).line);
}

tr_node *tr_tree_read(const tr_source *source, tr_status *st) {
    builder b = {.source = source, .st = st};
    yaml_parser_t parser;
    if (!yaml_parser_initialize(&parser)) return tr_status_fail(st, TR_FILE, "error: out of memory"), NULL;
    yaml_parser_set_encoding(&parser, YAML_UTF8_ENCODING);
    yaml_parser_set_input_string(&parser, (const unsigned char *)source->text, source->size);
    bool ok = true, end = false;
    while (ok && !end) {
        yaml_event_t event;
        ok = yaml_parser_parse(&parser, &event) ? take(&b, &event) : parser_failed(&b, &parser);
        end = event.type == YAML_STREAM_END_EVENT;
        yaml_event_delete(&event);
    }
    yaml_parser_delete(&parser);
    if (ok && !b.root) ok = tr_text_fail(st, (tr_mark){source, 1, 1}, "the file is empty; a case begins with `kind:`");
    if (ok) return b.root;
    for (int i = 0; i <= TR_TREE_DEPTH; i++) free(b.levels[i].key);
    tr_tree_free(b.root);
    return NULL;
}

const tr_node *tr_tree_find(const tr_node *mapping, const char *key) {
    if (!mapping || mapping->type != TR_NODE_MAPPING) return NULL;
    const tr_node *node = mapping->child;
    while (node && strcmp(node->key, key) != 0) node = node->next;
    return node;
}

/* The child that one step of a --set path names; made when a mapping has none. */
static tr_node *step(tr_node *parent, const char *key, tr_mark mark, tr_status *st) {
    if (parent->type == TR_NODE_VALUE && parent->text[0] == '\0')
        parent->type = TR_NODE_MAPPING; /* `output:` and no more */
    if (parent->type == TR_NODE_VALUE) {
        const char *name = parent->key ? parent->key : parent->text; /* an item of a list has no key */
        return tr_text_fail(st, mark, "`%s` is a single value, it has no keys", tr_text_show(name).text), NULL;
    }
    tr_node **link = &parent->child;
    if (parent->type == TR_NODE_LIST) {
        char *end;
        int n = tr_tree_count(parent);
        long item = strtol(key, &end, 10);
        if (*end || item < 0 || item >= n) {
            tr_text_fail(st, mark, "`%s` is not the number of an item; there are %d, counted from 0",
                         tr_text_show(key).text, n);
            return NULL;
        }
        while (item--) link = &(*link)->next;
        return *link;
    }
    for (; *link; link = &(*link)->next)
        if (strcmp((*link)->key, key) == 0) return *link;
    tr_node *node = tr_alloc(1, sizeof *node, st);
    if (!node) return NULL;
    *node = (tr_node){.type = TR_NODE_MAPPING, .mark = mark, .key_mark = mark, .key = copy(key, strlen(key), st)};
    if (node->key) return *link = node;
    free(node);
    return NULL;
}

bool tr_tree_set(tr_node *root, const tr_source *set, tr_status *st) {
    const char *text = set->text, *value = strchr(text, '=');
    if (!value) return tr_text_fail(st, (tr_mark){set, 1, 1}, "no `=`; write key=value, as in step.safety=0.2");
    tr_node *node = root;
    for (int depth = 1; text < value; depth++) {
        char key[64];
        text += strspn(text, " ");
        size_t n = strcspn(text, ".= ");
        tr_mark mark = {set, 1, (int)(text - set->text) + 1};
        if (n == 0 || n >= sizeof key || depth > TR_TREE_DEPTH)
            return tr_text_fail(st, mark, "no key here; write key=value, as in step.safety=0.2");
        memcpy(key, text, n);
        key[n] = '\0';
        node = step(node, key, mark, st);
        if (!node) return false;
        text += n;
        text += strspn(text, " ");
        if (*text != '.' && text != value)
            return tr_text_fail(st, (tr_mark){set, 1, (int)(text - set->text) + 1}, "expected `.` or `=` here");
        node->key_mark = mark;
        if (*text == '.') text++;
    }
    if (node == root) return tr_text_fail(st, (tr_mark){set, 1, 1}, "no key before `=`");
    value++;
    value += strspn(value, " ");
    size_t n = strlen(value);
    while (n && value[n - 1] == ' ') n--;
    tr_tree_free(node->child);
    free(node->text);
    node->child = NULL;
    node->type = TR_NODE_VALUE;
    node->mark = (tr_mark){set, 1, (int)(value - set->text) + 1};
    node->straight = true;
    node->text = copy(value, n, st);
    return node->text;
}

/* A copy of a node and its children. keyed: it is in a mapping. */
static tr_node *twin(const tr_node *node, bool keyed, tr_status *st) {
    tr_node *t = tr_alloc(1, sizeof *t, st);
    if (!t) return NULL;
    *t = (tr_node){.type = node->type, .mark = node->mark, .straight = node->straight, .key_mark = node->key_mark};
    bool ok = !node->text || (t->text = copy(node->text, strlen(node->text), st));
    ok = ok && (!keyed || (t->key = copy(node->key, strlen(node->key), st)));
    tr_node **link = &t->child;
    for (const tr_node *child = node->child; ok && child; child = child->next) {
        ok = (*link = twin(child, node->type == TR_NODE_MAPPING, st));
        if (ok) link = &(*link)->next;
    }
    if (ok) return t;
    tr_tree_free(t);
    return NULL;
}

bool tr_tree_merge(tr_node *over, const tr_node *base, tr_status *st) {
    if (over->type != TR_NODE_MAPPING || base->type != TR_NODE_MAPPING) return true;
    for (const tr_node *child = base->child; child; child = child->next) {
        tr_node **link = &over->child;
        while (*link && strcmp((*link)->key, child->key) != 0) link = &(*link)->next;
        if (*link ? !tr_tree_merge(*link, child, st) : !(*link = twin(child, true, st))) return false;
    }
    return true;
}

tr_node *tr_tree_merged(const tr_node *over, const tr_node *base, tr_status *st) {
    tr_node *node = twin(over, over->key, st);
    if (node && node->type == TR_NODE_VALUE && !*node->text) node->type = TR_NODE_MAPPING;
    if (!node || !base || tr_tree_merge(node, base, st)) return node;
    tr_tree_free(node);
    return NULL;
}

int tr_tree_count(const tr_node *node) {
    int n = 0;
    for (const tr_node *child = node->child; child; child = child->next) n++;
    return n;
}

void tr_tree_free(tr_node *root) {
    while (root) {
        tr_node *next = root->next;
        tr_tree_free(root->child); /* never deeper than TR_TREE_DEPTH */
        free(root->text);
        free(root->key);
        free(root);
        root = next;
    }
}
