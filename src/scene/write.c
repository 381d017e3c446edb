/* SPDX-License-Identifier: MIT */
/* tr_scene to case text: the same tables, in the other direction. */
#include "scene/write.h"

#include "scene/contact_name.h"
#include "scene/tables.h"
#include "base/alloc.h"
#include "base/gather.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct writer {
    const tr_scene *scene;
    const tr_param_catalog *catalog;
    FILE *out;
} writer;

/* The fewest digits, 17 at most, that read back to the same bits. */
static void write_real(char *text, size_t size, double value) {
    for (int digits = 6; digits <= 17; digits++) {
        snprintf(text, size, "%.*g", digits, value);
        if (strtod(text, NULL) == value) return;
    }
}

static int write_quoted(FILE *out, const char *text) {
    int n = fprintf(out, "\"");
    for (; *text; text++) n += fprintf(out, strchr("\"\\", *text) ? "\\%c" : "%c", *text);
    return n + fprintf(out, "\"");
}

static int write_contact_ids(FILE *out, const tr_contact_ids *picks) {
    int n = fprintf(out, "[");
    for (int i = 0; i < picks->n; i++) {
        char name[TR_CONTACT_NAME];
        tr_contact_name_write(picks->item[i], name);
        n += fprintf(out, "%s%s", i ? ", " : "", name);
    }
    return n + fprintf(out, "]");
}

/* Returns its length in bytes. */
static int write_value(const writer *w, const tr_param *p, const void *value) {
    char number[32];
    tr_shown name = {{0}};
    switch (p->type) {
    case TR_REAL:
        write_real(number, sizeof number, *(const double *)value);
        return fprintf(w->out, "%s", number);
    case TR_COUNT:
        return fprintf(w->out, "%d", *(const int *)value);
    case TR_SEED:
        return fprintf(w->out, "%" PRIu64, *(const uint64_t *)value);
    case TR_SWITCH:
        return fprintf(w->out, "%s", *(const bool *)value ? "yes" : "no");
    case TR_CHOICE:
        tr_tables_choice(w->catalog, p, *(const int *)value, &name);
        return fprintf(w->out, "%s", name.text);
    case TR_CONTACT_IDS:
        return write_contact_ids(w->out, value);
    case TR_TEXT:
        return write_quoted(w->out, value);
    }
    return 0;
}

/* One key; lead is the text before it. False: it is not given, another key replaces it. */
static bool write_key(const writer *w, const tr_param *p, const void *base, const char *lead, bool comment) {
    enum { COLUMN = 42 }; /* of the meanings */
    const void *value = (const char *)base + p->offset;
    char unit[TR_BY_SHAPE];
    if (p->type == TR_REAL && p->choices && isnan(*(const double *)value)) return false;
    int n = fprintf(w->out, "%s%s: ", lead, p->key);
    n += write_value(w, p, value);
    if (comment) fprintf(w->out, "%*s # %s", n < COLUMN ? COLUMN - n : 0, "", p->doc);
    if (comment && p->type == TR_REAL) fprintf(w->out, " [%s]", tr_param_by_shape(p->unit, w->scene->shape, unit));
    fprintf(w->out, "\n");
    return true;
}

static const tr_scene_law *law_at(const void *base, const tr_law_place *slot) {
    return (const void *)((const char *)base + slot->offset);
}

/* Parameters of the chosen laws of the tr_scene_contact at base. A key that two of them share is written once. */
static void write_laws(const writer *w, const void *base, int first_law_kind, const char *lead) {
    for (int k = first_law_kind - 1; k < TR_LAW_KINDS; k++) {
        tr_law_place slot = tr_tables_law_kind(w->catalog, k);
        const tr_scene_law *law = law_at(base, &slot);
        const tr_param_table *table = slot.laws[law->law];
        for (int i = 0; i < table->n; i++) {
            bool written = false;
            for (int before = first_law_kind - 1; before < k; before++) {
                tr_law_place other = tr_tables_law_kind(w->catalog, before);
                const tr_param_table *t = other.laws[law_at(base, &other)->law];
                for (int j = 0; j < t->n; j++) written |= strcmp(t->params[j].key, table->params[i].key) == 0;
            }
            if (!written) write_key(w, &table->params[i], law->par, lead, true);
        }
    }
}

/* A mapping in an item, if it has one. */
static void write_inner(const writer *w, const tr_section *t, const char *item) {
    if (!*(const bool *)(item + t->given)) return;
    fprintf(w->out, "    %s:\n", t->key);
    for (int k = 0; k < t->n; k++) write_key(w, &t->params[k], item + t->offset, "      ", true);
    if (t->first_law_kind) write_laws(w, item + t->offset, t->first_law_kind, "      ");
}

/* Meanings stand at the first item only: a thousand disks must stay under the size limit of a case. */
static void write_list(const writer *w, const tr_section *t) {
    const char *items;
    memcpy(&items, (const char *)w->scene + t->offset, sizeof items);
    int n = *(const int *)(const void *)((const char *)w->scene + t->count);
    for (int i = 0; i < n; i++) {
        const char *item = items + (size_t)i * t->item;
        const char *lead = "  - ";
        for (const tr_section *u = t; u; u = tr_tables_next(u, 1u << w->scene->kind)) {
            for (int k = 0; k < u->n && !u->derived && tr_tables_chosen(u, item); k++)
                if (write_key(w, &u->params[k], item, lead, i == 0)) lead = "    ";
            if (u->first_law_kind) write_laws(w, item, u->first_law_kind, "    ");
        }
        for (int k = -1; (k = tr_tables_inside(t->key, 1u << w->scene->kind, k)) < tr_n_sections;)
            write_inner(w, &tr_sections[k], item);
    }
}

static void write_section(const writer *w, const tr_section *t, bool begins) {
    if (t->derived || t->inside) return;
    const char *file = NULL;
    if (t->file) memcpy(&file, (const char *)w->scene + t->file, sizeof file);
    if (file && !begins) return;
    if (file) {
        fprintf(w->out, "\n%s: ", t->key);
        write_quoted(w->out, file);
        fprintf(w->out, "\n");
        return;
    }
    if (*t->key && begins) fprintf(w->out, *t->doc ? "\n%s: # %s\n" : "\n%s:\n", t->key, t->doc);
    if (t->item) {
        if (begins) write_list(w, t);
        return;
    }
    for (int i = 0; i < t->n; i++)
        write_key(w, &t->params[i], (const char *)w->scene + t->offset, *t->key ? "  " : "", true);
    if (t->first_law_kind) write_laws(w, (const char *)w->scene + t->offset, t->first_law_kind, "  ");
}

static void write_document(const writer *w) {
    unsigned kind = 1u << w->scene->kind;
    for (int i = 0; i < tr_n_sections; i++) {
        const tr_section *t = &tr_sections[i];
        if (t->kinds & kind) write_section(w, t, tr_tables_begins(i, kind));
    }
}

char *tr_scene_write(const tr_scene *scene, const tr_param_catalog *catalog, tr_status *st) {
    tr_gather text;
    if (!tr_gather_begin(&text, st)) return tr_gather_end(&text, st);
    writer w = {scene, catalog, text.stream};
    write_document(&w);
    for (int i = 0; i < scene->n_more; i++) {
        fprintf(w.out, "\n---\n");
        w.scene = &scene->more[i];
        write_document(&w);
    }
    return tr_gather_end(&text, st);
}
