/* SPDX-License-Identifier: MIT */
/* A table that a run has written, read back by the names of its columns. */
#ifndef TR_TEST_TABLE_H
#define TR_TEST_TABLE_H

#include "assert_close.h"
#include "study/csv.h"

#include <stdlib.h>
#include <string.h>

enum { TABLE_COLUMNS = 13 };

typedef struct table {
    int n, capacity;
    double now[TABLE_COLUMNS], (*row)[TABLE_COLUMNS]; /* free(row) */
} table;

static bool table_cell(void *context, tr_csv *csv, int column, const char *text, size_t length) {
    (void)length;
    return tr_csv_number(csv, "", text, true, &((table *)context)->now[column]);
}

static bool table_row(void *context, tr_csv *csv) {
    table *t = context;
    (void)csv;
    if (t->n == t->capacity) t->row = realloc(t->row, (size_t)(t->capacity = 2 * t->n + 1000) * sizeof *t->row);
    memcpy(t->row[t->n++], t->now, sizeof t->now);
    return true;
}

static table table_read(const char *folder, const char *name, const char *const columns[], int n) {
    table t = {0};
    char path[300];
    tr_status st = {0};
    snprintf(path, sizeof path, "%s/%s", folder, name);
    if (!tr_csv_read(path, &(tr_csv_format){columns, n, n, "", NULL, table_cell, table_row}, &t, &st))
        fail_msg("%s", st.text);
    return t;
}

#endif
