/* SPDX-License-Identifier: MIT */
/* The tables, printed for readers. Each table is walked twice: first for the widths of its columns, then to print. */
#include "scene/keys.h"
#include "base/gather.h"
#include "scene/tables.h"

#include <stdio.h>
#include <string.h>

enum { COLUMNS = 5, CELL = 800 };

typedef struct printer {
    FILE *out;
    const tr_param_catalog *catalog;
    unsigned kinds; /* TR_FOR_*: for whom */
    bool spheres;   /* these kinds have a shape */
    bool measures;  /* no printing, only widths */
    int width[COLUMNS];
} printer;

static void add(char cell[CELL], const char *text) {
    size_t used = strlen(cell);
    snprintf(cell + used, CELL - used, "%s", text);
}

static void add_code(char cell[CELL], const char *text) {
    add(cell, "`");
    add(cell, text);
    add(cell, "`");
}

/* Markdown has | between cells; inside of one it is written \|. The last cell is not padded. */
static void print_cell(printer *p, int column, const char *cell) {
    int width = 0;
    for (const char *c = cell; *c; c++) width += ((*c & 0xC0) != 0x80) + (*c == '|');
    if (p->measures) {
        if (width > p->width[column]) p->width[column] = width;
        return;
    }
    fputs(column ? " | " : "| ", p->out);
    for (const char *c = cell; *c; c++) fprintf(p->out, *c == '|' ? "\\|" : "%c", *c);
    fprintf(p->out, "%*s", column < COLUMNS - 1 ? p->width[column] - width : 0, "");
    if (column == COLUMNS - 1) fputs(" |\n", p->out);
}

static void print_head(printer *p) {
    static const char *const head[COLUMNS] = {"key", "unit", "default", "range or choices", "meaning"};
    for (int i = 0; i < COLUMNS; i++) print_cell(p, i, head[i]);
    if (p->measures) return;
    for (int i = 0; i < COLUMNS; i++) {
        fputs("|", p->out);
        for (int k = i < COLUMNS - 1 ? p->width[i] + 2 : 3; k > 0; k--) fputs("-", p->out);
    }
    fputs("|\n", p->out);
}

/* Both parts of "disks|spheres", where there are spheres and the parts differ. */
static void add_by_shape(const printer *p, char cell[CELL], const char *text, void (*put)(char *, const char *)) {
    char disk[TR_BY_SHAPE], sphere[TR_BY_SHAPE];
    const char *of_disk = tr_param_by_shape(text, TR_SHAPE_DISK, disk);
    const char *of_sphere = tr_param_by_shape(text, TR_SHAPE_SPHERE, sphere);
    put(cell, of_disk);
    if (!p->spheres || strcmp(of_disk, of_sphere) == 0) return;
    add(cell, "; spheres: ");
    put(cell, of_sphere);
}

/* A law only for `kind: contact`. */
static bool hidden(const printer *p, const tr_param_table *law) {
    return law->demands & TR_ONLY_DRIVER && !(p->kinds & TR_FOR_CONTACT);
}

static bool hidden_choice(const printer *p, const tr_param *row, int i) {
    for (int k = 0; k < TR_LAW_KINDS && !row->choices; k++) {
        tr_law_place slot = tr_tables_law_kind(p->catalog, k);
        if (strcmp(slot.key, row->key) == 0) return hidden(p, slot.laws[i]);
    }
    return false;
}

static void add_range(const printer *p, char cell[CELL], const tr_param *row) {
    char range[80];
    tr_shown name;
    int n = 0;
    switch (row->type) {
    case TR_CHOICE:
        for (int i = 0; tr_tables_choice(p->catalog, row, i, &name); i++) {
            if (hidden_choice(p, row, i)) continue;
            add(cell, n++ ? ", " : "");
            add(cell, name.text);
        }
        return;
    case TR_SWITCH:
        add(cell, "yes, no");
        return;
    case TR_SEED:
        add(cell, "0 to 2^64 - 1");
        return;
    case TR_TEXT:
        snprintf(range, sizeof range, "a line of at most %g bytes", row->max - 1);
        break;
    case TR_CONTACT_IDS:
        snprintf(range, sizeof range, row->max > 1 ? "a list of at most %g contacts" : "one contact", row->max);
        break;
    case TR_REAL:
    case TR_COUNT:
        snprintf(range, sizeof range, "%g to %g", row->min, row->max);
    }
    add(cell, range);
}

/* In a list, the default of a key is the root key of the same name, which follows from other keys. */
static bool from_root(const printer *p, const tr_param *row) {
    for (int i = 0; i < tr_n_sections; i++) {
        const tr_section *t = &tr_sections[i];
        for (int k = 0; k < t->n && !*t->key && t->derived && t->kinds & p->kinds & TR_FOR_CONTACT; k++)
            if (strcmp(t->params[k].key, row->key) == 0) return true;
    }
    return false;
}

/* The key that may replace this one in a case of these kinds, or NULL. */
static const char *other_key(const printer *p, const tr_param *row) {
    if (row->type != TR_REAL || !row->choices) return NULL;
    for (int i = 0; i < tr_n_sections; i++)
        for (int k = 0; k < tr_sections[i].n && tr_sections[i].kinds & p->kinds; k++)
            if (strcmp(tr_sections[i].params[k].key, row->choices) == 0) return row->choices;
    return NULL;
}

static void add_default(const printer *p, char cell[CELL], const tr_param *row, bool of_law) {
    bool root = of_law && from_root(p, row), only_root = root && p->kinds == TR_FOR_CONTACT;
    const char *other = other_key(p, row);
    if (!row->fallback && !only_root)
        add(cell, other ? "this" : "required");
    else if (!only_root && *row->fallback)
        add_by_shape(p, cell, row->fallback, add_code);
    else if (!only_root)
        add(cell, "empty");
    if (other) {
        add(cell, " or ");
        add_code(cell, other);
    }
    if (!root) return;
    if (!only_root) add(cell, "; in `laws`: ");
    add(cell, "the root's ");
    add_code(cell, row->key);
}

/* note: text after the meaning; "": none. */
static void print_row(printer *p, const tr_param *row, bool derived, bool of_law, const char *note) {
    char cell[COLUMNS][CELL] = {""};
    add_code(cell[0], row->key);
    add_by_shape(p, cell[1], row->unit, add);
    add_default(p, cell[2], row, of_law);
    if (derived)
        add(cell[3], "cannot be given");
    else
        add_range(p, cell[3], row);
    add(cell[4], row->doc);
    add(cell[4], note);
    for (int i = 0; i < COLUMNS; i++) print_cell(p, i, cell[i]);
}

/* " (for `what: speed, spin`)": rows that only some choices of a list's first key have. */
static void note_choices(const printer *p, const tr_section *first, unsigned chosen, char note[CELL]) {
    tr_shown name;
    int n = 0;
    for (int i = 0; chosen && tr_tables_choice(p->catalog, first->params, i, &name); i++) {
        if (!(chosen >> i & 1)) continue;
        add(note, n++ ? ", " : " (for `");
        if (n == 1) {
            add(note, first->params->key);
            add(note, ": ");
        }
        add(note, name.text);
    }
    if (n) add(note, "`)");
}

static bool same_row(const tr_param *a, const tr_param *b) {
    const char *x[] = {a->key, a->unit, a->fallback, a->choices, a->doc},
               *y[] = {b->key, b->unit, b->fallback, b->choices, b->doc};
    for (int i = 0; i < 5; i++)
        if (!x[i] != !y[i] || (x[i] && strcmp(x[i], y[i]))) return false;
    return a->type == b->type && a->min == b->min && a->max == b->max;
}

static bool same_rows(const tr_section *a, const tr_section *b) {
    bool same = a->n == b->n;
    for (int i = 0; i < a->n && same; i++) same = same_row(&a->params[i], &b->params[i]);
    return same;
}

/* Equal rows of several choices are printed once, at the first of them. */
static void walk_section(printer *p, const tr_section *first) {
    for (const tr_section *t = first; t; t = tr_tables_next(t, p->kinds)) {
        char note[CELL] = "";
        unsigned chosen = 0;
        bool before = false;
        for (const tr_section *u = first; u; u = tr_tables_next(u, p->kinds))
            if (same_rows(t, u)) chosen |= u->chosen, before |= u < t;
        note_choices(p, first, chosen, note);
        for (int i = 0; i < t->n && !before; i++) print_row(p, &t->params[i], t->derived, false, note);
    }
}

static bool law_has(const tr_param_table *law, const tr_param *row) {
    for (int i = 0; i < law->n; i++)
        if (same_row(&law->params[i], row)) return true;
    return false;
}

/* An equal row of several laws is printed once, at the first of them. */
static void walk_law(printer *p, const tr_law_place *slot, int law) {
    for (int i = 0; i < slot->laws[law]->n; i++) {
        const tr_param *row = &slot->laws[law]->params[i];
        char note[CELL] = " (of ";
        int n = 0;
        bool before = false;
        for (int k = 0; k < slot->n; k++) {
            if (hidden(p, slot->laws[k]) || !law_has(slot->laws[k], row)) continue;
            before |= k < law;
            add(note, n++ ? ", " : "");
            add(note, slot->laws[k]->name);
        }
        add(note, ")");
        if (!before) print_row(p, row, false, true, note);
    }
}

static void walk_law_kind(printer *p, int k) {
    tr_law_place slot = tr_tables_law_kind(p->catalog, k);
    for (int i = 0; i < slot.n; i++)
        if (!hidden(p, slot.laws[i])) walk_law(p, &slot, i);
}

/* Mappings that an item of the list may have. */
static void walk_inner(printer *p, const tr_section *list) {
    for (int i = -1; (i = tr_tables_inside(list->key, p->kinds, i)) < tr_n_sections;) {
        const tr_section *t = &tr_sections[i];
        char cell[COLUMNS][CELL] = {""};
        add_code(cell[0], t->key);
        add(cell[2], t->like ? "the root's " : "none");
        if (t->like) add_code(cell[2], t->like);
        add(cell[3], "a mapping");
        add(cell[4], t->doc);
        for (int k = 0; k < COLUMNS; k++) print_cell(p, k, cell[k]);
    }
}

/* Of a section, or, where that is NULL, of the laws of a slot. */
static void print_table(printer *p, const tr_section *section, int slot) {
    memset(p->width, 0, sizeof p->width);
    for (int measures = 1; measures >= 0; measures--) {
        p->measures = measures;
        print_head(p);
        if (section)
            walk_section(p, section), walk_inner(p, section);
        else
            walk_law_kind(p, slot);
    }
}

static void print_section(printer *p, const tr_section *t) {
    fprintf(p->out, *t->key ? "\n### `%s`" : "\n### At the top", t->key);
    if (*t->doc) fprintf(p->out, ": %s", t->doc);
    fputs("\n\n", p->out);
    if (t->item) fprintf(p->out, "A list of %d to %d items", t->min_items, t->max_items);
    if (t->item) fputs(t->file ? ", or the name of a CSV file that holds it.\n\n" : ".\n\n", p->out);
    print_table(p, t, 0);
    for (int i = -1; (i = tr_tables_inside(t->key, p->kinds, i)) < tr_n_sections;) {
        const tr_section *inner = &tr_sections[i];
        if (inner->like) continue; /* whose keys are listed there */
        fprintf(p->out, "\n### `%s` in an item of `%s`: %s\n\n", inner->key, t->key, inner->doc);
        print_table(p, inner, 0);
    }
    for (const tr_section *u = t; u; u = tr_tables_next(u, p->kinds))
        if (u->first_law_kind)
            fputs("\nBeside these: the [parameters of the chosen laws](#parameters-of-laws).\n", p->out);
}

static bool takes_laws(unsigned kinds) {
    for (int i = 0; i < tr_n_sections; i++)
        if (tr_sections[i].first_law_kind && tr_sections[i].kinds & kinds) return true;
    return false;
}

static bool takes_spheres(unsigned kinds) {
    for (int i = 0; i < tr_n_sections; i++)
        for (int k = 0; k < tr_sections[i].n; k++)
            if (tr_sections[i].kinds & kinds && strcmp(tr_sections[i].params[k].key, "shape") == 0) return true;
    return false;
}

static void print_kind(printer *p, const char *name) {
    fprintf(p->out, "\n## `kind: %s`\n", name);
    for (int i = 0; i < tr_n_sections; i++)
        if (tr_tables_begins(i, p->kinds)) print_section(p, &tr_sections[i]);
}

static void print_laws(printer *p) {
    fputs("\n## Parameters of laws\n\nThey stand beside the name of the law: in `contact`, or in an item of `laws` "
          "(`kind: contact`). A key that two chosen laws share is given once.\n",
          p->out);
    for (int k = 0; k < TR_LAW_KINDS; k++) {
        fprintf(p->out, "\n### `%s`\n\n", tr_tables_law_kind(p->catalog, k).key);
        print_table(p, NULL, k);
    }
}

/* Bits of the kinds with this name; 0: none. */
static unsigned find_kinds(const char *kind, const tr_param_catalog *catalog, tr_status *st) {
    tr_shown name;
    tr_near near = {NULL, 0};
    if (!kind) return TR_FOR_ALL;
    const tr_param *row = tr_sections->params;
    tr_shown names[TR_KIND_PATCH + 1];
    for (int i = 0; tr_tables_choice(catalog, row, i, &name); i++) {
        if (strcmp(name.text, kind) == 0) return 1u << i;
        names[i] = name;
        tr_text_nearer(&near, kind, names[i].text);
    }
    tr_status_fail(st, TR_BAD_CASE, "error: no kind of case is called `%s`%s; there are %s", tr_text_show(kind).text,
                   tr_text_hint(&near).text, row->choices);
    return 0;
}

char *tr_scene_keys(const char *kind, const tr_param_catalog *catalog, tr_status *st) {
    tr_gather text;
    tr_shown name;
    unsigned kinds = find_kinds(kind, catalog, st);
    if (!kinds) return NULL;
    if (!tr_gather_begin(&text, st)) return tr_gather_end(&text, st);
    printer p = {.out = text.stream, .catalog = catalog};
    fputs("# Keys of a case\n\nNumbers are in the unit of the table, or have a unit of their own. A default may name "
          "other keys. A key without a default is required, where its section, its item or its law is used.\n",
          p.out);
    for (int i = 0; tr_tables_choice(catalog, tr_sections->params, i, &name); i++) {
        p.kinds = 1u << i & kinds;
        p.spheres = takes_spheres(p.kinds);
        if (p.kinds) print_kind(&p, name.text);
    }
    p.kinds = kinds;
    p.spheres = takes_spheres(kinds);
    if (takes_laws(kinds)) print_laws(&p);
    return tr_gather_end(&text, st);
}
