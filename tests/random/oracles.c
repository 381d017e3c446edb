/* SPDX-License-Identifier: MIT */
#include "random/oracles.h"

#include <dirent.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_COLUMNS = 128, MOST_NAME = 700, MOST_FILES = 256 };

static bool wrong(oracle_text *why, const char *format, ...) {
    va_list args;
    va_start(args, format);
    vsnprintf(why->text, sizeof why->text, format, args);
    va_end(args);
    return false;
}

static char *read_all(const char *path, size_t *size) {
    FILE *f = fopen(path, "rb");
    if (!f) return NULL;
    fseek(f, 0, SEEK_END);
    *size = (size_t)ftell(f);
    rewind(f);
    char *text = malloc(*size + 1);
    if (text && fread(text, 1, *size, f) != *size) free(text), text = NULL;
    if (text) text[*size] = '\0';
    fclose(f);
    return text;
}

/* ---- tables ---- */

typedef struct table {
    char *text, *next;
    char *column[MOST_COLUMNS];
    char *cell[MOST_COLUMNS]; /* of the row that was read last */
    int n, row;
} table;

static int cut(char *line, char *cells[MOST_COLUMNS]) {
    int n = 0;
    for (char *p = line; p && n < MOST_COLUMNS;) cells[n++] = strsep(&p, ",");
    return n;
}

static bool table_open(table *t, const char *dir, const char *name) {
    char path[MOST_NAME];
    size_t size;
    *t = (table){0};
    snprintf(path, sizeof path, "%s/%s", dir, name);
    t->text = t->next = read_all(path, &size);
    if (t->text) t->n = cut(strsep(&t->next, "\n"), t->column);
    return t->text;
}

static int table_row(table *t) {
    char *line = strsep(&t->next, "\n");
    if (!line || !*line) return 0;
    t->row++;
    return cut(line, t->cell);
}

static double value(const table *t, const char *column) {
    for (int k = 0; k < t->n; k++)
        if (strncmp(t->column[k], column, strlen(column)) == 0) return *t->cell[k] ? strtod(t->cell[k], NULL) : NAN;
    return NAN;
}

/* ---- numbers ---- */

/* What may have no number: tan phi of a stress that pulls; the spread of what no contact did; the bound of a step
 * where nothing can vibrate; what never happened, of a check; the creepage of a step that does not roll. */
static bool may_be_empty(const char *column) {
    static const char *const part[] = {"tan_phi",    "_over_slide",    "a_over_R",
                                       "run_over_a", "rolled_in_runs", "friction_share_of_q",
                                       "dt_bound_s", "\"measured\"",   "\"error\"", "creepage"};
    for (size_t k = 0; k < sizeof part / sizeof *part; k++)
        if (strstr(column, part[k])) return true;
    return false;
}

static bool check_table(const char *dir, const char *name, oracle_text *why) {
    table t;
    bool ok = true;
    if (!table_open(&t, dir, name)) return wrong(why, "cannot read %s", name);
    for (int n; ok && (n = table_row(&t)) > 0;) {
        if (n != t.n) ok = wrong(why, "%s: row %d has %d cells of %d", name, t.row, n, t.n);
        for (int k = 0; ok && k < n; k++) {
            char *end;
            double number = strtod(t.cell[k], &end);
            bool text = end == t.cell[k] && *end; /* the name of a law */
            if (!*t.cell[k] ? !may_be_empty(t.column[k]) : !isfinite(number) && !text)
                ok = wrong(why, "%s: row %d, %s is \"%s\"", name, t.row, t.column[k], t.cell[k]);
        }
    }
    free(t.text);
    return ok;
}

static bool check_json(const char *dir, const char *name, oracle_text *why) {
    char path[MOST_NAME];
    size_t size;
    bool ok = true;
    snprintf(path, sizeof path, "%s/%s", dir, name);
    char *text = read_all(path, &size);
    if (!text) return wrong(why, "cannot read %s", name);
    for (char *p = text, *line; ok && (line = strsep(&p, "\n"));) {
        char *at = strstr(line, ": ");
        if (at && (strncmp(at, ": null", 6) == 0 || strncasecmp(at, ": nan", 5) == 0 || strstr(at, ": inf")) &&
            !may_be_empty(line))
            ok = wrong(why, "%s: %s", name, line);
    }
    free(text);
    return ok;
}

static bool ends(const char *name, const char *end) {
    size_t n = strlen(name), m = strlen(end);
    return n >= m && strcmp(name + n - m, end) == 0;
}

/* Names of the files under dir, sorted by name, folders opened. */
typedef struct listing {
    char name[MOST_FILES][MOST_NAME / 2];
    int n;
} listing;

static void list(listing *l, const char *dir, const char *below) {
    char path[MOST_NAME];
    struct dirent **entry;
    snprintf(path, sizeof path, "%s/%s", dir, below);
    int n = scandir(path, &entry, NULL, alphasort);
    for (int i = 0; i < n; i++) {
        char name[MOST_NAME];
        const char *is = entry[i]->d_name;
        bool own = strcmp(is, "trundle-files.txt") != 0 && strncmp(is, "checkpoint.bin", 14) != 0;
        snprintf(name, sizeof name, "%s%s", below, is);
        if (*is != '.' && entry[i]->d_type == DT_DIR)
            strcat(name, "/"), list(l, dir, name);
        else if (*is != '.' && own && l->n < MOST_FILES)
            snprintf(l->name[l->n++], sizeof l->name[0], "%.340s", name);
        free(entry[i]);
    }
    if (n >= 0) free(entry);
}

bool oracle_numbers(const char *dir, oracle_text *why) {
    listing *l = calloc(1, sizeof *l);
    bool ok = l != NULL;
    if (l) list(l, dir, "");
    for (int i = 0; ok && i < l->n; i++) {
        if (ends(l->name[i], ".csv")) ok = check_table(dir, l->name[i], why);
        if (ends(l->name[i], ".json")) ok = check_json(dir, l->name[i], why);
        if (ends(l->name[i], ".part")) ok = wrong(why, "%s is left", l->name[i]);
    }
    free(l);
    return ok;
}

/* ---- walls ---- */

static bool inside_planes(const tr_scene *scene, const char *dir, oracle_text *why) {
    table t;
    bool ok = true;
    if (!table_open(&t, dir, "history.csv")) return wrong(why, "no history.csv");
    while (ok && table_row(&t)) {
        double x = value(&t, "x_m"), y = value(&t, "y_m"), time = value(&t, "time_s");
        for (int w = 0; ok && w < scene->n_walls; w++) {
            const tr_scene_wall *s = &scene->walls[w];
            double off = (x - s->x - s->vx * time) * s->nx + (y - s->y - s->vy * time) * s->ny;
            if (!(off > 0)) ok = wrong(why, "disk %g is %g m beyond wall %d at %g s", value(&t, "disk"), -off, w, time);
        }
    }
    free(t.text);
    return ok;
}

bool oracle_inside(const tr_scene *scene, const char *dir, oracle_text *why) {
    if (scene->kind == TR_KIND_BODIES) return inside_planes(scene, dir, why);
    if (scene->kind != TR_KIND_BIAXIAL || scene->boundary == TR_PERIODIC || !scene->output.contacts) return true;
    table t;
    double height = 0, width = 0, strain = 0, low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    if (!table_open(&t, dir, "history.csv")) return wrong(why, "no history.csv");
    while (table_row(&t)) height = value(&t, "height_m"), width = value(&t, "width_m"), strain = value(&t, "strain");
    free(t.text);
    if (!table_open(&t, dir, "disks.csv")) return wrong(why, "no disks.csv");
    while (table_row(&t)) { /* of the last instant, which is that of the last row */
        if (fabs(value(&t, "strain") - strain) > 1e-8) continue;
        double at[2] = {value(&t, "x_m"), value(&t, "y_m")};
        for (int k = 0; k < 2; k++) low[k] = fmin(low[k], at[k]), high[k] = fmax(high[k], at[k]);
    }
    free(t.text);
    /* Nine digits of places that may be some sides away from 0. */
    const double rounding = 1e-7 * (height + width);
    if (high[0] - low[0] < width + rounding && high[1] - low[1] < height + rounding && isfinite(low[0])) return true;
    return wrong(why, "centres over %g x %g m between walls %g x %g m apart", high[0] - low[0], high[1] - low[1], width,
                 height);
}

/* ---- energy ---- */

bool oracle_energy(const tr_scene *scene, const char *dir, oracle_text *why) {
    static const char *const term[] = {
        "work_J",     "kinetic_J", "elastic_normal_J", "elastic_friction_J", "elastic_rolling_J", "damped_J",
        "friction_J", "rolling_J", "damped_made",      "friction_made",      "rolling_made"};
    table t;
    double most = 0, worst = 0;
    if (scene->kind != TR_KIND_BIAXIAL || !scene->output.energy) return true;
    if (!table_open(&t, dir, "history.csv")) return wrong(why, "no history.csv");
    while (table_row(&t)) {
        for (int k = 0; k < 11; k++) most = fmax(most, fabs(value(&t, term[k])));
        worst = fmax(worst, fabs(value(&t, "residual_J")));
    }
    free(t.text);
    /* It is of first order in the step: contacts open and close between two. At most 0.031 times the share that the
     * step is of its bound was seen in 300 tests of a few disks and a few hundred steps; there it halves with the
     * step. */
    return worst <= 0.06 * scene->step.safety * most ||
           wrong(why, "the energy residual is %.3g of the largest term", worst / most);
}

/* ---- bytes ---- */

/* "timing": {...} says how long it took. */
static void forget_timing(char *text, size_t *size) {
    char *from = strstr(text, "\"timing\""), *to = from ? strchr(from, '}') : NULL;
    if (!to) return;
    memmove(from, to, *size - (size_t)(to - text) + 1);
    *size -= (size_t)(to - from);
}

bool oracle_same(const char *dir, const char *reference, oracle_text *why) {
    listing *l = calloc(2, sizeof *l);
    if (!l) return wrong(why, "no memory");
    list(&l[0], dir, ""), list(&l[1], reference, "");
    bool ok = l[0].n == l[1].n || wrong(why, "%d files, not %d as in %s", l[0].n, l[1].n, reference);
    for (int i = 0; ok && i < l[0].n; i++) {
        char path[2][MOST_NAME], *text[2];
        size_t size[2] = {0};
        const char *at[2] = {dir, reference};
        for (int k = 0; k < 2; k++) {
            snprintf(path[k], sizeof path[k], "%s/%s", at[k], l[0].name[i]);
            text[k] = read_all(path[k], &size[k]);
            if (text[k] && ends(path[k], "summary.json")) forget_timing(text[k], &size[k]);
        }
        if (!text[0] || !text[1] || size[0] != size[1] || memcmp(text[0], text[1], size[0]) != 0)
            ok = wrong(why, "%s differs from %s", path[0], path[1]);
        free(text[0]), free(text[1]);
    }
    free(l);
    return ok;
}
