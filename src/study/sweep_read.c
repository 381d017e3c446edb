/* SPDX-License-Identifier: MIT */
/* A sweep file to a grid: which keys, which texts. Reading the base case shows whether keys exist and values fit
 * (sweep.c). */

#include "study/sweep_read.h"
#include "base/math.h"

#include "base/alloc.h"
#include "study/sweep_duplicates.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_VALUES = 1000000, MAX_POINTS = 1000000000 };

typedef struct reader {
    tr_grid *g;
    bool many;
    tr_status *st;
} reader;

static bool check_keys(const reader *r, const tr_node *mapping, const char *const *allowed, const char *what) {
    if (mapping->type != TR_NODE_MAPPING)
        return tr_text_fail(r->st, mapping->mark, "%s must be a mapping of keys and values", what);
    for (const tr_node *child = mapping->child; child; child = child->next) {
        tr_near near = {NULL, 0};
        char list[100] = "";
        bool known = false;
        for (int i = 0; allowed[i]; i++) {
            known |= strcmp(allowed[i], child->key) == 0;
            tr_text_nearer(&near, child->key, allowed[i]);
            sprintf(list + strlen(list), "%s%s", i ? ", " : "", allowed[i]);
        }
        if (!known)
            return tr_text_fail(r->st, child->key_mark, "unknown key `%s`%s; allowed here: %s",
                                tr_text_show(child->key).text, tr_text_hint(&near).text, list);
    }
    return true;
}

/* The text of a single value; NULL and an error if it is not one. node may be NULL: missing. */
static const char *text_of(const reader *r, const tr_node *node, const tr_node *in, const char *key, const char *doc) {
    if (node && node->type == TR_NODE_VALUE && *node->text) return node->text;
    if (node)
        tr_text_fail(r->st, node->mark, "`%s` must be a single value: %s", key, doc);
    else
        tr_text_fail(r->st, in->mark, "`%s` is missing: %s", key, doc);
    return NULL;
}

static bool add_value(const reader *r, tr_axis *axis, const char *text, tr_mark mark) {
    if (!(axis->value[axis->n] = strdup(text))) return tr_status_fail(r->st, TR_FILE, "error: out of memory");
    axis->mark[axis->n++] = mark;
    return true;
}

static bool reserve(const reader *r, tr_axis *axis, double n, tr_mark mark) {
    if (n <= MAX_VALUES) {
        axis->value = tr_alloc((size_t)n, sizeof *axis->value, r->st);
        axis->mark = tr_alloc((size_t)n, sizeof *axis->mark, r->st);
    } else {
        tr_text_fail(r->st, mark, "%g values, allowed is 1 to %d", n, MAX_VALUES);
    }
    return axis->value && axis->mark;
}

static int compare_texts(const void *a, const void *b) {
    return strcmp(*(char *const *)a, *(char *const *)b);
}

/* Two equal points would have one directory. */
static bool check_twice(const reader *r, const tr_axis *axis) {
    char **sorted = tr_alloc((size_t)axis->n, sizeof *sorted, r->st), *twice = NULL;
    if (!sorted) return false;
    memcpy(sorted, axis->value, (size_t)axis->n * sizeof *sorted);
    qsort(sorted, (size_t)axis->n, sizeof *sorted, compare_texts);
    for (int i = 1; i < axis->n && !twice; i++)
        if (strcmp(sorted[i - 1], sorted[i]) == 0) twice = sorted[i];
    free(sorted);
    for (int i = axis->n - 1; twice && i >= 0; i--)
        if (strcmp(axis->value[i], twice) == 0)
            return tr_text_fail(r->st, axis->mark[i], "`%s` is given twice", tr_text_show(twice).text);
    return true;
}

/* "0.5 mm": a number and whatever unit or product follows it. */
static bool number_of(const reader *r, const tr_node *node, const tr_node *in, const char *key, double *x,
                      const char **unit) {
    const char *text = text_of(r, node, in, key, "an end of the range");
    if (!text) return false;
    char *end;
    *x = strtod(text, &end);
    *unit = end;
    if (!strchr("+-.0123456789", *text) || strncmp(text, "0x", 2) == 0) *x = NAN; /* nan, inf, hexadecimal */
    return isfinite(*x) ||
           tr_text_fail(r->st, node->mark, "`%s` must be a number, with or without a unit; use a list for other values",
                        key);
}

/* Values between the ends have six digits, because directories are named after them; the ends stay as given. */
static bool read_range(const reader *r, tr_axis *axis, const tr_node *node) {
    static const char *const keys[] = {"from", "to", "points", "scale", NULL};
    if (!check_keys(r, node, keys, "a range")) return false;
    double x[2], n;
    const char *unit[2], *scale = "lin", *none;
    const tr_node *from = tr_tree_find(node, keys[0]), *to = tr_tree_find(node, keys[1]),
                  *points = tr_tree_find(node, keys[2]), *how = tr_tree_find(node, keys[3]);
    if (!number_of(r, from, node, "from", &x[0], &unit[0]) || !number_of(r, to, node, "to", &x[1], &unit[1]) ||
        !number_of(r, points, node, "points", &n, &none) ||
        (how && !(scale = text_of(r, how, node, "scale", "lin | log"))))
        return false;
    bool log_scale = strcmp(scale, "log") == 0;
    if (strcmp(unit[0], unit[1]) != 0) return tr_text_fail(r->st, to->mark, "`from` and `to` must have the same unit");
    if (!log_scale && strcmp(scale, "lin") != 0)
        return tr_text_fail(r->st, how->mark, "`%s` is not a choice for `scale`; allowed is lin | log",
                            tr_text_show(scale).text);
    if (*none || n != floor(n) || n < 2)
        return tr_text_fail(r->st, points->mark, "`points` must be a whole number, 2 or more");
    if (log_scale && !(x[0] * x[1] > 0)) return tr_text_fail(r->st, how->mark, "a log range must not reach or cross 0");
    if (!reserve(r, axis, n, points->mark) || !add_value(r, axis, from->text, node->mark)) return false;
    for (int i = 1; i < n - 1; i++) {
        double s = i / (n - 1), value = log_scale ? x[0] * tr_pow(x[1] / x[0], s) : x[0] + (x[1] - x[0]) * s;
        char text[300];
        snprintf(text, sizeof text, "%.6g%s", value, unit[0]);
        if (!add_value(r, axis, text, node->mark)) return false;
    }
    return add_value(r, axis, to->text, node->mark);
}

static bool read_values(const reader *r, tr_axis *axis, const tr_node *node) {
    if (node->type == TR_NODE_MAPPING) return read_range(r, axis, node) && check_twice(r, axis);
    if (node->type != TR_NODE_LIST)
        return tr_text_fail(
            r->st, node->mark,
            "give `%s` a list, [0, 0.5], or a range, {from: 0, to: 1, points: 5}; one value belongs to `set`",
            tr_text_show(axis->key).text);
    if (!node->child) return tr_text_fail(r->st, node->mark, "the list of `%s` is empty", tr_text_show(axis->key).text);
    if (!reserve(r, axis, tr_tree_count(node), node->mark)) return false;
    for (const tr_node *item = node->child; item; item = item->next) {
        const char *text = text_of(r, item, node, axis->key, "a value of the list");
        if (!text || !add_value(r, axis, text, item->mark)) return false;
    }
    return check_twice(r, axis);
}

/* "3" or, if a range is allowed, "1-8". */
static bool read_seed(const reader *r, const tr_node *node, bool range, unsigned long long *first,
                      unsigned long long *last) {
    const char *text = node->type == TR_NODE_VALUE ? node->text : "", *digits = "0123456789";
    char *end = NULL;
    errno = 0;
    bool ok = strspn(text, digits) > 0;
    if (ok) *last = *first = strtoull(text, &end, 10);
    if (ok && range && *end == '-' && (ok = strspn(end + 1, digits) > 0)) *last = strtoull(end + 1, &end, 10);
    if (ok && !*end && !errno && *first <= *last) return true;
    return tr_text_fail(r->st, node->mark, "a seed must be a whole number; for several write 1-8 or [1, 2, 5]");
}

static bool read_seeds(const reader *r, tr_axis *axis, const tr_node *node) {
    bool list = node->type == TR_NODE_LIST;
    unsigned long long first = 0, last = 0;
    if (list && !node->child) return tr_text_fail(r->st, node->mark, "the list of `seeds` is empty");
    if (!list && !read_seed(r, node, true, &first, &last)) return false;
    if (!reserve(r, axis, list ? tr_tree_count(node) : (double)(last - first) + 1, node->mark)) return false;
    for (const tr_node *item = list ? node->child : node; item; item = list ? item->next : NULL) {
        if (list && !read_seed(r, item, false, &first, &last)) return false;
        for (unsigned long long seed = first; seed - first <= last - first; seed++) { /* also behind the largest */
            char text[24];
            snprintf(text, sizeof text, "%llu", seed);
            if (!add_value(r, axis, text, item->mark)) return false;
        }
    }
    return check_twice(r, axis);
}

/* `vary`, seeds, `set`: in this order. */
static bool read_axes(const reader *r) {
    tr_grid *g = r->g;
    const tr_node *vary = tr_tree_find(g->root, "vary"), *seeds = tr_tree_find(g->root, "seeds"),
                  *set = tr_tree_find(g->root, "set");
    if (!vary && !seeds) return tr_text_fail(r->st, g->root->mark, "nothing varies: give `vary` or `seeds`");
    if (vary && (vary->type != TR_NODE_MAPPING || !vary->child))
        return tr_text_fail(r->st, vary->mark, "`vary` must be a mapping of keys of the base case to lists or ranges");
    if (set && set->type != TR_NODE_MAPPING)
        return tr_text_fail(r->st, set->mark, "`set` must be a mapping of keys of the base case to values");
    int most = 1 + (vary ? tr_tree_count(vary) : 0) + (set ? tr_tree_count(set) : 0);
    g->axis = tr_alloc((size_t)most, sizeof *g->axis, r->st);
    if (!g->axis) return false;
    for (const tr_node *node = vary ? vary->child : NULL; node; node = node->next) {
        tr_axis *axis = &g->axis[g->n_axes++];
        *axis = (tr_axis){.key = node->key, .key_mark = node->key_mark};
        if (strcmp(node->key, "seed") == 0)
            return tr_text_fail(r->st, node->key_mark, "seeds cannot be compared: list them in `seeds`");
        if (!read_values(r, axis, node)) return false;
    }
    g->n_vary = g->n_axes;
    if (seeds) {
        g->axis[g->n_axes++] = (tr_axis){.key = "seed", .key_mark = seeds->key_mark};
        if (!read_seeds(r, &g->axis[g->n_vary], seeds)) return false;
    }
    g->n_named = g->n_axes;
    for (const tr_node *node = set ? set->child : NULL; node; node = node->next) {
        const char *text = text_of(r, node, node, node->key, "the same for all points");
        for (int i = 0; i < g->n_named; i++)
            if (strcmp(g->axis[i].key, node->key) == 0)
                return tr_text_fail(r->st, node->key_mark, "`%s` is already varied in line %d",
                                    tr_text_show(node->key).text, g->axis[i].key_mark.line);
        tr_axis *axis = &g->axis[g->n_axes++];
        *axis = (tr_axis){.key = node->key, .key_mark = node->key_mark};
        if (!text || !reserve(r, axis, 1, node->mark) || !add_value(r, axis, text, node->mark)) return false;
    }
    return true;
}

static bool count_points(const reader *r) {
    tr_grid *g = r->g;
    double n = g->seeds = g->n_named > g->n_vary ? g->axis[g->n_vary].n : 1;
    for (int i = 0; i < g->n_vary; i++) n *= g->axis[i].n;
    const tr_node *where = tr_tree_find(g->root, g->n_vary ? "vary" : "seeds");
    if (n > MAX_POINTS) return tr_text_fail(r->st, where->key_mark, "%g points, allowed is 1 to %d", n, MAX_POINTS);
    if (n > TR_MANY_POINTS && !r->many)
        return tr_text_fail(r->st, where->key_mark, "%.0f points; --yes allows more than %d", n, TR_MANY_POINTS);
    g->n = (int)n;
    g->combinations = g->n / g->seeds;
    return true;
}

static bool read_comparison(const reader *r, const tr_node *node) {
    static const char *const keys[] = {"key", "to", NULL};
    tr_grid *g = r->g;
    if (!check_keys(r, node, keys, "`compare`")) return false;
    const tr_node *key_node = tr_tree_find(node, "key"), *to_node = tr_tree_find(node, "to");
    const char *key = text_of(r, key_node, node, "key", "a key of `vary`"),
               *to = key ? text_of(r, to_node, node, "to", "the value that the others are compared with") : NULL;
    if (!to) return false;
    tr_compare c = {0};
    while (c.axis < g->n_vary && strcmp(g->axis[c.axis].key, key) != 0) c.axis++;
    if (c.axis == g->n_vary)
        return tr_text_fail(r->st, key_node->mark, "`%s` is not in `vary`", tr_text_show(key).text);
    const tr_axis *axis = &g->axis[c.axis];
    while (c.to < axis->n && strcmp(axis->value[c.to], to) != 0) c.to++;
    if (c.to == axis->n)
        return tr_text_fail(r->st, to_node->mark,
                            "`%s` is not one of the values of `%s`: write it as it is written there",
                            tr_text_show(to).text, tr_text_show(key).text);
    for (int i = 0; i < g->n_compare; i++)
        if (g->compare[i].axis == c.axis && g->compare[i].to == c.to)
            return tr_text_fail(r->st, node->mark, "this comparison is given twice");
    g->compare[g->n_compare++] = c;
    return true;
}

/* One, or a list of them. */
static bool read_compare(const reader *r) {
    tr_grid *g = r->g;
    const tr_node *node = tr_tree_find(g->root, "compare");
    if (!node) return true;
    bool list = node->type == TR_NODE_LIST;
    g->compare = tr_alloc(list ? (size_t)tr_tree_count(node) : 1, sizeof *g->compare, r->st);
    for (const tr_node *item = list ? node->child : node; item && !r->st->code; item = list ? item->next : NULL)
        read_comparison(r, item);
    return !r->st->code;
}

static bool read_collect(const reader *r) {
    static const char *const usual[] = {"sin_phi_residual", "sin_phi_peak", "e_residual"};
    tr_grid *g = r->g;
    const tr_node *node = tr_tree_find(g->root, "collect");
    if (node && (node->type != TR_NODE_LIST || !node->child))
        return tr_text_fail(r->st, node->mark, "`collect` must be a list of numbers of summary.json");
    int n = node ? tr_tree_count(node) : 3;
    g->collect = tr_alloc((size_t)n, sizeof *g->collect, r->st);
    g->collect_mark = tr_alloc((size_t)n, sizeof *g->collect_mark, r->st);
    if (!g->collect || !g->collect_mark) return false;
    const tr_node *item = node ? node->child : NULL;
    for (int i = 0; i < n; i++, item = node ? item->next : NULL) {
        g->collect_mark[i] = node ? item->mark : g->root->mark;
        g->collect[i] = node ? text_of(r, item, node, "collect", "a number of summary.json") : usual[i];
        if (!g->collect[i]) return false;
        for (int k = 0; k < i; k++)
            if (strcmp(g->collect[k], g->collect[i]) == 0)
                return tr_text_fail(r->st, item->mark, "`%s` is given twice", tr_text_show(g->collect[i]).text);
    }
    g->n_collect = n;
    return true;
}

static bool read_base(const reader *r) {
    const tr_source *file = &r->g->source;
    const char *base = text_of(r, tr_tree_find(r->g->root, "base"), r->g->root, "base", "the case that is varied"),
               *slash = strrchr(file->name, '/');
    if (!base) return false;
    int folder = slash && *base != '/' ? (int)(slash + 1 - file->name) : 0;
    if (asprintf(&r->g->base, "%.*s%s", folder, file->name, base) >= 0) return true;
    r->g->base = NULL;
    return tr_status_fail(r->st, TR_FILE, "error: out of memory");
}

bool tr_grid_read(tr_grid *g, const char *path, bool many, tr_status *st) {
    static const char *const keys[] = {"kind", "base", "seeds", "vary", "set", "compare", "collect", NULL};
    *g = (tr_grid){0};
    reader r = {g, many, st};
    size_t size;
    if (!(g->text = tr_text_file(path, &size, st))) return false;
    g->source = (tr_source){path, g->text, size};
    if (!tr_text_check(&g->source, st) || !(g->root = tr_tree_read(&g->source, st))) return false;
    const tr_node *kind = tr_tree_find(g->root, "kind");
    if (g->root->next) return tr_text_fail(st, g->root->next->key_mark, "a second document (---) is not allowed");
    if (kind && kind->type == TR_NODE_VALUE && strcmp(kind->text, "sweep") != 0)
        return tr_text_fail(st, kind->mark, "this is not a sweep, `kind: sweep`; trundle run runs a single case");
    return check_keys(&r, g->root, keys, "a sweep") && text_of(&r, kind, g->root, "kind", "sweep") && read_base(&r) &&
           read_axes(&r) && count_points(&r) && read_compare(&r) && read_collect(&r) && tr_grid_check_duplicates(g, st);
}

void tr_grid_free(tr_grid *g) {
    for (int i = 0; i < g->n_axes; i++) {
        for (int k = 0; k < g->axis[i].n; k++) free(g->axis[i].value[k]);
        free(g->axis[i].value);
        free(g->axis[i].mark);
    }
    free(g->axis);
    free(g->collect);
    free(g->collect_mark);
    free(g->compare);
    free(g->base);
    tr_tree_free(g->root);
    free(g->text);
    *g = (tr_grid){0};
}
