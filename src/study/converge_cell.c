/* SPDX-License-Identifier: MIT */
#include "study/converge_cell.h"

#include "out/dir.h"
#include "study/csv.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct cell {
    const char *table, *along, *items; /* file; column of the instants; column of the items, NULL: there are none */
    long item;
    char column[64];
    double at; /* NaN: the end */
    bool by_segment;
    /* while the table is read */
    double now[3], value, before, after, value_before, value_after;
    bool found;
} cell;

static bool is_path(tr_kind kind) {
    return kind == TR_KIND_CONTACT || kind == TR_KIND_PATCH;
}

static bool split(cell *c, tr_kind kind, const char *name) {
    bool path = is_path(kind);
    const char *head = path ? "contact." : "history.";
    *c = (cell){.table = path ? "contact.csv" : "history.csv",
                .along = path                     ? "segment"
                         : kind == TR_KIND_BODIES ? "time_s"
                                                  : "strain",
                .items = path                     ? "law"
                         : kind == TR_KIND_BODIES ? "disk"
                                                  : NULL,
                .by_segment = path,
                .before = -INFINITY,
                .after = INFINITY,
                .value = NAN};
    if (strncmp(name, head, strlen(head)) != 0) return false;
    name += strlen(head);
    char *end;
    if (c->items) {
        c->item = strtol(name, &end, 10);
        if (end == name || *end != '.' || c->item < 0) return false;
        name = end + 1;
    }
    size_t n = strcspn(name, "@");
    if (!n || n >= sizeof c->column || name[n] != '@') return false;
    memcpy(c->column, name, n);
    c->at = strtod(name + n + 1, &end);
    if (!strcmp(name + n + 1, "end")) return c->at = NAN, true;
    return end > name + n + 1 && !*end && isfinite(c->at);
}

bool tr_converge_cell_check(tr_kind kind, const char *name, tr_status *st) {
    cell c;
    return split(&c, kind, name) ||
           tr_status_fail(st, TR_BAD_CASE, "error: `%.60s` is no cell of a table; one is %s, or ...@end", name,
                          is_path(kind)            ? "contact.LAW.COLUMN@SEGMENT, as contact.0.Q_N_per_m@2"
                          : kind == TR_KIND_BODIES ? "history.DISK.COLUMN@TIME, as history.0.vx_m_per_s@0.1"
                                                   : "history.COLUMN@STRAIN, as history.sin_phi@0.05");
}

enum { VALUE, ALONG, ITEM };

static bool take(void *context, tr_csv *csv, int k, const char *text, size_t length) {
    cell *c = context;
    c->now[k] = NAN;
    return !length || tr_csv_number(csv, k == VALUE ? c->column : "cell", text, true, &c->now[k]);
}

static bool row(void *context, tr_csv *csv) {
    cell *c = context;
    double x = c->now[ALONG], y = c->now[VALUE];
    (void)csv;
    if (c->items && c->now[ITEM] != (double)c->item) return true;
    c->found = true;
    if (isnan(c->at) || (c->by_segment && x == c->at - 1)) c->value = y;
    if (x <= c->at && x >= c->before) c->before = x, c->value_before = y;
    if (x >= c->at && x < c->after) c->after = x, c->value_after = y;
    return true;
}

bool tr_converge_cell(const char *dir, tr_kind kind, const char *name, double *value, tr_status *st) {
    cell c;
    char path[TR_PATH];
    if (!split(&c, kind, name)) return tr_converge_cell_check(kind, name, st);
    const char *const columns[] = {c.column, c.along, c.items ? c.items : c.along};
    const tr_csv_format format = {columns, c.items ? 3 : 2, c.items ? 3 : 2, c.column, NULL, take, row};
    if (!tr_dir_path(path, dir, c.table, st) || !tr_csv_read(path, &format, &c, st)) return false;
    bool between = isfinite(c.before) && isfinite(c.after) && !c.by_segment;
    if (between) {
        double s = c.after > c.before ? (c.at - c.before) / (c.after - c.before) : 0;
        c.value = c.value_before + s * (c.value_after - c.value_before);
    }
    *value = c.value;
    if (!c.found) return tr_status_fail(st, TR_BAD_CASE, "error: %.300s has no rows for `%.60s`", path, name);
    if (isnan(c.at) || between || !isnan(c.value)) return true;
    return tr_status_fail(st, TR_BAD_CASE, "error: %.300s does not reach the instant of `%.60s`", path, name);
}
