/* SPDX-License-Identifier: MIT */
#include "study/sample_file.h"

#include "base/alloc.h"
#include "base/hash.h"
#include "core/world.h"
#include "study/csv.h"
#include "base/math.h"
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { X, Y, R, CELLS };
typedef struct disk {
    double at[CELLS];
    long line;
} disk;

typedef struct packing {
    const char *path;
    disk *disk;
    int n, capacity;
    double now[CELLS];
    double box[2][2]; /* of x and of y; NAN: not known */
    tr_status *st;
} packing;

__attribute__((format(printf, 3, 4))) static bool fail(const packing *p, long line, const char *format, ...) {
    char text[512];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    return tr_status_fail(p->st, TR_BAD_CASE, "%.400s:%ld: error: %s", p->path, line, text);
}

static bool add(packing *p, long line) {
    if (!(p->now[R] > 0)) return fail(p, line, "the radius is %g: it must be above 0", p->now[R]);
    if (p->n == 10000000) return fail(p, line, "more than 10,000,000 disks");
    if (p->n == p->capacity) {
        int more = p->capacity ? 2 * p->capacity : 512;
        if (!tr_alloc_grow(&p->disk, (size_t)p->n, (size_t)more, sizeof *p->disk, p->st)) return false;
        p->capacity = more;
    }
    disk *d = &p->disk[p->n++];
    memcpy(d->at, p->now, sizeof d->at);
    d->line = line;
    return true;
}

/* ---- CSV */

static const char *const columns[CELLS] = {"x", "y", "r"};

static bool cell(void *context, tr_csv *csv, int column, const char *text, size_t length) {
    packing *p = context;
    (void)length;
    return tr_csv_number(csv, columns[column], text, false, &p->now[column]);
}
static bool row(void *context, tr_csv *csv) {
    return add(context, csv->row_line);
}

static bool read_csv(packing *p) {
    const tr_csv_format format = {columns, CELLS, CELLS, "x,y,r", NULL, cell, row};
    return tr_csv_read(p->path, &format, p, p->st);
}

/* ---- a dump of LAMMPS: ITEM: BOX BOUNDS and ITEM: ATOMS with its columns; the last instant counts */

enum { MOST_CELLS = 64 };
typedef struct dump {
    packing *p;
    FILE *in;
    char *text; /* of the line */
    size_t size;
    long line;
    int column[CELLS]; /* place of x, y and radius in a row; -1: not there */
} dump;

static bool next_line(dump *d) {
    if (getline(&d->text, &d->size, d->in) < 0) return false;
    d->line++;
    d->text[strcspn(d->text, "\r\n")] = '\0';
    return true;
}

static bool read_bounds(dump *d) {
    if (strstr(d->text, " xy xz yz")) return fail(d->p, d->line, "the box is not a rectangle");
    for (int axis = 0; axis < 3; axis++) {
        double low, high;
        if (!next_line(d) || sscanf(d->text, "%lf %lf", &low, &high) != 2 || !(high > low))
            return fail(d->p, d->line, "this must be the low and the high end of the box");
        if (axis < 2) d->p->box[axis][0] = low, d->p->box[axis][1] = high;
    }
    return true;
}

static bool read_columns(dump *d) {
    static const char *const names[CELLS] = {"x", "y", "radius"};
    int k = 0;
    char *rest = NULL;
    for (int c = 0; c < CELLS; c++) d->column[c] = -1;
    for (char *word = strtok_r(d->text + strlen("ITEM: ATOMS"), " ", &rest); word;
         word = strtok_r(NULL, " ", &rest), k++)
        for (int c = 0; c < CELLS; c++)
            if (!strcmp(word, names[c])) d->column[c] = k;
    for (int c = 0; c < CELLS; c++)
        if (d->column[c] < 0) return fail(d->p, d->line, "the atoms have no column %s", names[c]);
    d->p->n = 0; /* of the instant before */
    return true;
}

static bool read_atom(dump *d) {
    int k = 0, found = 0;
    char *rest = NULL, *end;
    for (char *word = strtok_r(d->text, " ", &rest); word && k < MOST_CELLS; word = strtok_r(NULL, " ", &rest), k++)
        for (int c = 0; c < CELLS; c++) {
            if (d->column[c] != k) continue;
            d->p->now[c] = strtod(word, &end);
            if (*end || !isfinite(d->p->now[c])) return fail(d->p, d->line, "`%.40s` is not a number", word);
            found++;
        }
    if (found < CELLS) return fail(d->p, d->line, "fewer cells than the line ITEM: ATOMS names");
    return add(d->p, d->line);
}

static bool read_lines(dump *d) {
    bool atoms = false, any = false;
    while (next_line(d)) {
        bool item = !strncmp(d->text, "ITEM:", 5);
        if (item) atoms = false;
        if (!strncmp(d->text, "ITEM: BOX BOUNDS", 16) && !read_bounds(d)) return false;
        if (!strncmp(d->text, "ITEM: ATOMS", 11)) {
            if (!read_columns(d)) return false;
            atoms = any = true;
        } else if (atoms && *d->text && !read_atom(d)) {
            return false;
        }
    }
    return any || fail(d->p, d->line, "there is no line ITEM: ATOMS");
}

static bool read_dump(packing *p) {
    dump d = {.p = p, .in = fopen(p->path, "r")};
    if (!d.in) return tr_status_fail(p->st, TR_FILE, "error: cannot read %s: %s", p->path, strerror(errno));
    bool ok = read_lines(&d);
    free(d.text);
    fclose(d.in);
    return ok;
}

/* ---- any of them */

/* Hash of the file, and whether it is a dump. */
static bool look_into(packing *p, uint64_t *hash, bool *is_dump) {
    char chunk[1 << 14];
    FILE *in = fopen(p->path, "r");
    if (!in) return tr_status_fail(p->st, TR_FILE, "error: cannot read %s: %s", p->path, strerror(errno));
    bool first = true;
    *hash = TR_HASH_BEGIN, *is_dump = false;
    for (size_t n; (n = fread(chunk, 1, sizeof chunk, in)) > 0; first = false) {
        if (first) *is_dump = n > 5 && !memcmp(chunk, "ITEM:", 5);
        *hash = tr_hash(*hash, chunk, n);
    }
    bool ok = !ferror(in) || tr_status_fail(p->st, TR_FILE, "error: cannot read %s: %s", p->path, strerror(errno));
    fclose(in);
    return ok;
}

/* The box is that of the case, of the file, or around the disks. */
static void set_box(packing *p, const tr_scene_sample *sample) {
    const double given[2] = {sample->width, sample->height};
    for (int axis = 0; axis < 2; axis++) {
        double *box = p->box[axis];
        if (given[axis] > 0) {
            box[0] = 0, box[1] = given[axis];
        } else if (isnan(box[0])) {
            box[0] = INFINITY, box[1] = -INFINITY;
            for (int i = 0; i < p->n; i++) {
                box[0] = fmin(box[0], p->disk[i].at[axis] - p->disk[i].at[R]);
                box[1] = fmax(box[1], p->disk[i].at[axis] + p->disk[i].at[R]);
            }
        }
    }
}

static bool check_inside(const packing *p, bool periodic) {
    for (int i = 0; i < p->n; i++) {
        const disk *d = &p->disk[i];
        double may = periodic ? 0 : (1 - TR_LARGEST_OVERLAP) * d->at[R];
        for (int axis = 0; axis < 2; axis++) {
            const double *box = p->box[axis], v = d->at[axis];
            if (v - may < box[0] || v + may > box[1])
                return fail(p, d->line,
                            "this disk leaves the box: %s = %.9g m, r = %.9g m, and the box is %.9g m to %.9g m",
                            columns[axis], v, d->at[R], box[0], box[1]);
        }
    }
    return true;
}

static int by_x(const void *a, const void *b) {
    const disk *p = a, *q = b;
    return (p->at[X] > q->at[X]) - (p->at[X] < q->at[X]);
}

/* In a periodic cell the nearest image counts. Disks are sorted by x: a pair is at most two of the largest radii
 * apart. */
static bool check_pair(const packing *p, const disk *one, const disk *two, bool periodic) {
    double dx = two->at[X] - one->at[X], dy = two->at[Y] - one->at[Y];
    double width = p->box[0][1] - p->box[0][0], height = p->box[1][1] - p->box[1][0];
    if (periodic) dx -= width * rint(dx / width), dy -= height * rint(dy / height);
    double overlap = one->at[R] + two->at[R] - tr_hypot(dx, dy), least = fmin(one->at[R], two->at[R]);
    if (overlap <= TR_LARGEST_OVERLAP * least) return true;
    const disk *last = one->line > two->line ? one : two, *first = last == one ? two : one;
    return fail(p, last->line,
                "this disk and that of line %ld overlap by %.3g m, more than 0.3 of the smaller radius, %.3g m",
                first->line, overlap, least);
}

static bool check_overlaps(const packing *p, bool periodic) {
    double most = 0, width = p->box[0][1] - p->box[0][0];
    disk *sorted = tr_alloc((size_t)p->n, sizeof *sorted, p->st);
    if (!sorted) return false;
    memcpy(sorted, p->disk, (size_t)p->n * sizeof *sorted);
    qsort(sorted, (size_t)p->n, sizeof *sorted, by_x);
    for (int i = 0; i < p->n; i++) most = fmax(most, sorted[i].at[R]);
    bool ok = true;
    for (int i = 0; ok && i < p->n; i++)
        for (int k = i + 1; ok && k < i + p->n; k++) { /* around the cell */
            bool around = k >= p->n;
            double apart = sorted[k % p->n].at[X] + (around ? width : 0) - sorted[i].at[X];
            if (apart > sorted[i].at[R] + most || (around && !periodic)) break;
            ok = check_pair(p, &sorted[i], &sorted[k % p->n], periodic);
        }
    free(sorted);
    return ok;
}

static bool keep(const packing *p, tr_scene_sample *sample) {
    sample->place = tr_alloc(tr_body(p->n), sizeof *sample->place, p->st);
    if (!sample->place) return false;
    for (int i = 0; i < p->n; i++) {
        double *to = sample->place + tr_body(i);
        to[0] = p->disk[i].at[X] - p->box[0][0], to[1] = p->disk[i].at[Y] - p->box[1][0], to[3] = p->disk[i].at[R];
    }
    sample->disks = p->n;
    for (int axis = 0; axis < 2; axis++) sample->side[axis] = p->box[axis][1] - p->box[axis][0];
    return true;
}

bool tr_sample_file_read(tr_scene *scene, tr_status *st) {
    tr_scene_sample *sample = &scene->sample;
    if (scene->kind != TR_KIND_BIAXIAL || !*sample->file || sample->place) return true;
    packing p = {.path = sample->file, .box = {{NAN, NAN}, {NAN, NAN}}, .st = st};
    bool periodic = scene->boundary == TR_PERIODIC, is_dump = false;
    uint64_t hash = 0;
    bool ok = look_into(&p, &hash, &is_dump);
    if (ok && sample->file_hash && sample->file_hash != hash)
        ok = tr_status_fail(
            st, TR_BAD_CASE,
            "error: %s is not the file that it was: sample.file_hash says %llu, and this has %llu; leave "
            "sample.file_hash out to take it as it is",
            sample->file, (unsigned long long)sample->file_hash, (unsigned long long)hash);
    ok = ok && (is_dump ? read_dump(&p) : read_csv(&p));
    if (ok && p.n < 2) ok = fail(&p, 1, "%d disk%s: a sample has two or more", p.n, p.n == 1 ? "" : "s");
    if (ok) set_box(&p, sample);
    ok = ok && check_inside(&p, periodic) && check_overlaps(&p, periodic) && keep(&p, sample);
    sample->file_hash = ok ? hash : sample->file_hash;
    free(p.disk);
    return ok;
}
