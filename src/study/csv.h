/* SPDX-License-Identifier: MIT */
/* Reads a table from a CSV file: a header line that names the columns, in any order, then rows of as many cells. It
 * uses libcsv and adds messages with lines, for missing columns and for text that is not a number.
 *
 * Rows stream: memory does not grow with the file. */
#ifndef TR_STUDY_CSV_H
#define TR_STUDY_CSV_H

#include "base/status.h"
#include <stddef.h>

/* The position of the reader, for the callbacks. */
typedef struct tr_csv {
    const char *path;
    long line, row_line; /* of the cell being read, of the start of its row; from 1 */
    tr_status *st;
} tr_csv;

/* The columns of a table and the callbacks. A callback that returns false has written the error, by tr_csv_fail or
 * otherwise. */
typedef struct tr_csv_format {
    const char *const *columns;                /* their names; other columns of the file are ignored */
    int n, required;                           /* the first `required` of the n must be there */
    const char *example;                       /* how a header line begins */
    bool (*begin)(void *context, tr_csv *csv); /* the header is read; NULL: nothing to do */
    /* A cell of column k of `columns`; text ends in NUL and has no other. */
    bool (*cell)(void *context, tr_csv *csv, int k, const char *text, size_t length);
    bool (*row)(void *context, tr_csv *csv); /* after the last cell of a row */
} tr_csv_format;

/* TR_BAD_CASE with "path:line: error: ...", or TR_FILE. */
bool tr_csv_read(const char *path, const tr_csv_format *format, void *context, tr_status *st);

/* Fails with "path:line: error: ...". Returns false. */
bool tr_csv_fail(tr_csv *csv, long line, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* A decimal number or, with may_be_inf, `inf`: less than strtod allows. name: the column. */
bool tr_csv_number(tr_csv *csv, const char *name, const char *text, bool may_be_inf, double *value);

/* A cell for a message: short, without control characters. */
enum { TR_CSV_SHOWN = 44 };
const char *tr_csv_show(const char *text, char to[TR_CSV_SHOWN]);

#endif
