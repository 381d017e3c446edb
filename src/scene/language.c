/* SPDX-License-Identifier: MIT */
#include "scene/language.h"

#include <string.h>

const char tr_language_choices[] = "en|de";

static bool is_language(const char *key) {
    return strcmp(key, "en") == 0 || strcmp(key, "de") == 0;
}

/* Each has what the first has. */
static bool check_complete(const tr_node *text, tr_status *st) {
    const tr_node *first = text->child;
    for (const tr_node *other = first; other; other = other->next) {
        if (!is_language(other->key))
            return tr_text_fail(st, other->key_mark,
                                "`%s` has texts in languages, and `%s` is none; allowed here: en, de", text->key,
                                tr_text_show(other->key).text);
        for (const tr_node *line = first->child; line && other != first; line = line->next) {
            if (tr_tree_find(other, line->key)) continue;
            return tr_text_fail(st, other->key_mark, "`%s.%s` has no `%s`, which `%s.%s` has", text->key, other->key,
                                tr_text_show(line->key).text, text->key, first->key);
        }
    }
    return true;
}

/* The chosen language takes the place of the mapping of all. */
static void take(tr_node *text, const char *language) {
    tr_node **link = &text->child;
    while (*link && strcmp((*link)->key, language) != 0) link = &(*link)->next;
    if (!*link) link = &text->child;
    tr_node *chosen = *link, *others;
    *link = chosen->next;
    others = text->child;
    text->type = chosen->type, text->mark = chosen->mark, text->straight = chosen->straight;
    text->text = chosen->text, text->child = chosen->child;
    chosen->text = NULL, chosen->child = chosen->next = NULL;
    tr_tree_free(chosen);
    tr_tree_free(others);
}

bool tr_language_choose(tr_node *root, tr_status *st) {
    const tr_node *given = tr_tree_find(root, "language");
    for (tr_node *text = root->type == TR_NODE_MAPPING ? root->child : NULL; text; text = text->next) {
        bool has_languages = strcmp(text->key, "lesson") == 0 || strcmp(text->key, "label") == 0;
        if (!has_languages || text->type != TR_NODE_MAPPING || !text->child || !is_language(text->child->key)) continue;
        if (!check_complete(text, st)) return false;
        take(text, given && given->type == TR_NODE_VALUE ? given->text : "en");
    }
    return true;
}
