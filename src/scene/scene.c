/* SPDX-License-Identifier: MIT */
/* A case file to tr_scene: text -> documents -> (merged with the first) -> (--set) -> one scene each (read.h).
 *
 * A further document is the first one with its own changes. After that it is a case like any other, with its own
 * defaults and names. */
#include "scene/scene.h"

#include "base/alloc.h"
#include "scene/language.h"
#include "scene/read.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_DISKS = 1000 }; /* of all documents: written out they must stay under the size limit of a case */

typedef struct sets {
    const char *const *text;
    tr_source *source; /* of each text */
    int n;
} sets;

static bool apply(const sets *sets, tr_node *root, tr_status *st) {
    for (int i = 0; i < sets->n; i++) {
        sets->source[i] = (tr_source){"--set", sets->text[i], strlen(sets->text[i])};
        if (!tr_text_check(&sets->source[i], st) || !tr_tree_set(root, &sets->source[i], st)) return false;
    }
    return true;
}

static bool read_first(tr_scene *scene, tr_node *root, tr_document d, const sets *sets) {
    d.root = root;
    if (root->type == TR_NODE_MAPPING && !apply(sets, root, d.st)) return false;
    if (!tr_language_choose(root, d.st)) return false;
    return tr_read_document(scene, &d);
}

/* Of plain structs of a scene: the reader sets every byte. */
static bool equal(const void *a, const void *b, size_t size) {
    return memcmp(a, b, size) == 0;
}

/* Documents are shown side by side, so they share a clock and a page. */
static bool check_same(const tr_node *doc, const char *key, bool same, tr_status *st) {
    const tr_node *node = tr_tree_find(doc, key);
    return same || tr_text_fail(st, node ? node->key_mark : doc->mark,
                                "`%s` must be the same in every document, and here it is not as in the first", key);
}

/* The first has its --sets; they are applied to this one again, because it may change the keys. */
static bool read_next(tr_scene *scene, const tr_scene *first, tr_node *doc, tr_document d, const sets *sets) {
    if (doc->type != TR_NODE_MAPPING)
        return tr_text_fail(d.st, doc->key_mark, "a further document must be a mapping: the keys that it changes");
    const tr_node *kind = tr_tree_find(doc, "kind");
    bool same = !kind || (kind->type == TR_NODE_VALUE && strcmp(kind->text, tr_tree_find(d.root, "kind")->text) == 0);
    if (!check_same(doc, "kind", same, d.st) || !tr_tree_merge(doc, d.root, d.st) || !apply(sets, doc, d.st) ||
        !tr_language_choose(doc, d.st))
        return false;
    d.root = doc;
    return tr_read_document(scene, &d) && check_same(doc, "time_end", scene->time_end == first->time_end, d.st) &&
           check_same(doc, "output", equal(&scene->output, &first->output, sizeof first->output), d.st) &&
           check_same(doc, "lesson", equal(&scene->lesson, &first->lesson, sizeof first->lesson), d.st);
}

static bool read_more(tr_scene *scene, tr_node *root, tr_document d, const sets *sets) {
    tr_node *doc = root->next;
    int n = 0, disks = scene->n_disks;
    for (const tr_node *node = doc; node; node = node->next) n++;
    if (n == 0) return true;
    if (scene->kind != TR_KIND_BODIES)
        return tr_text_fail(d.st, doc->key_mark, "a second document (---) is not allowed");
    if (n >= TR_MAX_LANES)
        return tr_text_fail(d.st, doc->key_mark, "there are %d documents (---), allowed is 1 to %d", n + 1,
                            TR_MAX_LANES);
    if (!(scene->more = tr_alloc((size_t)n, sizeof *scene->more, d.st))) return false;
    scene->n_more = n;
    d.root = root;
    for (int i = 0; i < n; i++, doc = doc->next) {
        if (!read_next(&scene->more[i], scene, doc, d, sets)) return false;
        disks += scene->more[i].n_disks;
        if (disks > MOST_DISKS)
            return tr_text_fail(d.st, doc->key_mark, "with this document there are %d disks, allowed is 1 to %d in all",
                                disks, MOST_DISKS);
    }
    return true;
}

bool tr_scene_read(tr_scene *scene, const tr_scene_source *of, const tr_param_catalog *catalog, tr_status *st) {
    const char *text = of->text;
    size_t size = of->size;
    *scene = (tr_scene){0};
    if (size >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0) text += 3, size -= 3; /* byte order mark */
    const tr_source source = {of->name, text, size};
    tr_document d = {.name = of->name, .catalog = catalog, .st = st};
    sets sets = {of->sets, tr_alloc((size_t)of->n_sets, sizeof *sets.source, st), of->n_sets};
    tr_node *root = NULL;
    bool ok = sets.source && tr_text_check(&source, st) && (root = tr_tree_read(&source, st)) &&
              (d.expression = tr_expression_new(st));
    if (ok) {
        d.end = tr_text_end(&source);
        ok = read_first(scene, root, d, &sets) && read_more(scene, root, d, &sets);
    }
    tr_expression_free(d.expression);
    tr_tree_free(root);
    free(sets.source);
    if (!ok) tr_scene_free(scene);
    return ok;
}

bool tr_scene_read_file(tr_scene *scene, const char *path, const char *const *sets, int n_sets,
                        const tr_param_catalog *catalog, tr_status *st) {
    *scene = (tr_scene){0};
    size_t size;
    char *text = tr_text_file(path, &size, st);
    bool ok = text && tr_scene_read(scene, &(tr_scene_source){path, text, size, sets, n_sets}, catalog, st);
    free(text);
    return ok;
}

void tr_scene_free(tr_scene *scene) {
    free(scene->disks);
    free(scene->walls);
    free(scene->laws);
    free(scene->path);
    free(scene->path_file);
    free(scene->sample.place);
    free(scene->checks);
    for (int i = 0; i < scene->n_more; i++) tr_scene_free(&scene->more[i]);
    free(scene->more);
    *scene = (tr_scene){0};
}
