/* SPDX-License-Identifier: MIT */
#include "study/csv.h"

#include "base/alloc.h"
#include <csv.h>
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_CELLS = 1024, CHUNK = 1 << 16, MAX_CELL = 1 << 20, IGNORED = -1 };

typedef struct reader {
    tr_csv at;
    const tr_csv_format *format;
    void *context;
    bool after_cr;         /* the next line feed belongs to the line that just ended */
    int cell, n_cells;     /* number of the cell in its row; cells of the header, 0 before it */
    int column[MAX_CELLS]; /* of the file -> number in format->columns, or IGNORED */
} reader;

bool tr_csv_fail(tr_csv *csv, long line, const char *format, ...) {
    char text[512];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    return tr_status_fail(csv->st, TR_BAD_CASE, "%.480s:%ld: error: %s", csv->path, line, text);
}

const char *tr_csv_show(const char *text, char to[TR_CSV_SHOWN]) {
    int n = snprintf(to, TR_CSV_SHOWN, "%.40s%s", text, strlen(text) > 40 ? "..." : "");
    for (int i = 0; i < n; i++)
        if ((unsigned char)to[i] < ' ' || to[i] == 127) to[i] = '?';
    return to;
}

bool tr_csv_number(tr_csv *csv, const char *name, const char *text, bool may_be_inf, double *value) {
    char show[TR_CSV_SHOWN], *end;
    bool decimal = strspn(text, "0123456789+-.eE") == strlen(text);
    if (!*text) return tr_csv_fail(csv, csv->line, "%s is empty", name);
    *value = strtod(text, &end);
    if (*end || end == text || (!decimal && !isinf(*value)))
        return tr_csv_fail(csv, csv->line, "%s is \"%s\", which is not a number", name, tr_csv_show(text, show));
    if (isinf(*value) && decimal)
        return tr_csv_fail(csv, csv->line, "%s is %s, which is too large", name, tr_csv_show(text, show));
    if (isinf(*value) && !may_be_inf)
        return tr_csv_fail(csv, csv->line, "%s is %s: it must be finite", name, tr_csv_show(text, show));
    return true;
}

static bool header_cell(reader *c, const char *text) {
    const tr_csv_format *f = c->format;
    if (c->cell == MAX_CELLS) return tr_csv_fail(&c->at, c->at.line, "more than %d columns", MAX_CELLS);
    int k = 0;
    while (k < f->n && strcmp(text, f->columns[k])) k++;
    if (k == f->n) k = IGNORED;
    for (int i = 0; i < c->cell && k != IGNORED; i++)
        if (c->column[i] == k) return tr_csv_fail(&c->at, c->at.line, "column %s occurs twice", text);
    c->column[c->cell] = k;
    return true;
}

static bool end_header(reader *c) {
    const tr_csv_format *f = c->format;
    char missing[256] = "";
    for (int k = 0; k < f->required; k++) {
        int i = 0;
        while (i < c->cell && c->column[i] != k) i++;
        size_t used = strlen(missing);
        if (i == c->cell) snprintf(missing + used, sizeof missing - used, "%s%s", used ? "," : "", f->columns[k]);
    }
    if (*missing)
        return tr_csv_fail(&c->at, c->at.row_line, "no column %s in the header line (cells are separated by commas)",
                           missing);
    c->n_cells = c->cell;
    return !f->begin || f->begin(c->context, &c->at);
}

static bool end_row(reader *c) {
    if (c->cell != c->n_cells)
        return tr_csv_fail(&c->at, c->at.row_line, "%d cell%s, but the header line has %d", c->cell,
                           c->cell == 1 ? "" : "s", c->n_cells);
    return c->format->row(c->context, &c->at);
}

/* libcsv calls these; it cannot be stopped, so after a failure these do nothing. Cells end with a zero byte. */
static void on_cell(void *cell, size_t length, void *data) {
    reader *c = data;
    const char *text = cell;
    if (c->at.st->code) return;
    c->after_cr = false;
    if (c->cell == 0) c->at.row_line = c->at.line;
    if (memchr(text, '\0', length))
        tr_csv_fail(&c->at, c->at.line, "a zero byte: not a text file in UTF-8 or ASCII");
    else if (!c->n_cells)
        header_cell(c, text);
    else if (c->cell < c->n_cells && c->column[c->cell] != IGNORED) /* too many are reported at the end of the row */
        c->format->cell(c->context, &c->at, c->column[c->cell], text, length);
    for (size_t i = 0; i < length; i++) c->at.line += text[i] == '\n'; /* in quotes */
    c->cell++;
}

/* After each carriage return and line feed, and at the end of the file (-1). Rows without cells are blank lines. */
static void on_line(int end, void *data) {
    reader *c = data;
    if (c->at.st->code) return;
    if (c->cell > 0) (void)(c->n_cells ? end_row(c) : end_header(c));
    c->cell = 0;
    if (!(end == '\n' && c->after_cr)) c->at.line++;
    c->after_cr = end == '\r';
}

static bool parse(reader *c, struct csv_parser *csv, const char *text, size_t length) {
    tr_status *st = c->at.st;
    if (csv_parse(csv, text, length, on_cell, on_line, c) < length && !st->code) {
        if (csv_error(csv) != CSV_EPARSE) return tr_status_fail(st, TR_FILE, "error: out of memory");
        return tr_csv_fail(&c->at, c->at.line, "a quote inside a cell (write \"\" for it, and quotes around the cell)");
    }
    if (!st->code && csv_get_buffer_size(csv) > MAX_CELL)
        return tr_csv_fail(&c->at, c->at.line, "a cell of more than %d bytes: is a quote not closed?", MAX_CELL);
    return !st->code;
}

static bool read_all(reader *c, FILE *in, struct csv_parser *csv) {
    static const char mark[] = "\xEF\xBB\xBF"; /* of UTF-8, as spreadsheets write it */
    tr_status *st = c->at.st;
    char *chunk = tr_alloc(CHUNK, 1, st);
    bool ok = chunk, first = true;
    for (size_t n; ok && (n = fread(chunk, 1, CHUNK, in)) > 0; first = false) {
        size_t skip = first && n >= 3 && !memcmp(chunk, mark, 3) ? 3 : 0;
        ok = parse(c, csv, chunk + skip, n - skip);
    }
    if (ok && ferror(in)) ok = tr_status_fail(st, TR_FILE, "error: cannot read %s: %s", c->at.path, strerror(errno));
    free(chunk);
    if (!ok) return false;
    if (csv_fini(csv, on_cell, on_line, c) && !st->code)
        return tr_csv_fail(&c->at, c->at.line, "a quote that is not closed");
    if (st->code) return false;
    return c->n_cells ||
           tr_csv_fail(&c->at, 1, "the file is empty; its first line names the columns: %s", c->format->example);
}

bool tr_csv_read(const char *path, const tr_csv_format *format, void *context, tr_status *st) {
    FILE *in = fopen(path, "r");
    if (!in) return tr_status_fail(st, TR_FILE, "error: cannot read %s: %s", path, strerror(errno));
    struct csv_parser csv;
    reader *c = tr_alloc(1, sizeof *c, st);
    bool ok = false;
    if (c && csv_init(&csv, CSV_STRICT | CSV_STRICT_FINI | CSV_REPALL_NL | CSV_APPEND_NULL) == 0) {
        c->at = (tr_csv){.path = path, .line = 1, .st = st};
        c->format = format, c->context = context;
        ok = read_all(c, in, &csv);
        csv_free(&csv);
    }
    free(c);
    fclose(in);
    return ok;
}
