/* SPDX-License-Identifier: MIT */
/* case.yaml, history.csv and paths.csv of a run. Rows that do not fit together are refused with their line. */
#include "study/replay_read.h"
#include "base/math.h"

#include "base/alloc.h"
#include "laws/law.h"
#include "out/dir.h"
#include "out/summary.h"
#include "out/summary_read.h"
#include "study/csv.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { TIME, LIFE, A, B, R1, R2, SLIDE, ROLL, FORCE, FRICTION, WHOLE, X, Y, COLUMNS };
static const char *const columns[COLUMNS] = {"time_s",      "life",       "a",         "b",         "R1_m",
                                             "R2_m",        "du_slide_m", "du_roll_m", "P_N_per_m", "Q_N_per_m",
                                             "f_n_N_per_m", "branch_x_m", "branch_y_m"};

typedef struct reader {
    tr_replay *r;
    int capacity;
    long last_line;
    double now[COLUMNS];
} reader;

static bool cell(void *context, tr_csv *csv, int column, const char *text, size_t length) {
    reader *in = context;
    (void)length;
    return tr_csv_number(csv, columns[column], text, false, &in->now[column]);
}

/* The checks of one row by itself. */
static bool check_row(const tr_replay *r, const double *v, tr_csv *csv) {
    const int disks = r->scene.sample.disks, walls = r->scene.boundary == TR_PERIODIC ? 0 : 4;
    const long line = csv->row_line;
    if (v[A] != floor(v[A]) || v[B] != floor(v[B]) || v[LIFE] != floor(v[LIFE]))
        return tr_csv_fail(csv, line, "life, a and b must be whole numbers");
    if (!(v[B] >= 0 && v[B] < disks && v[A] >= -walls && v[A] < disks))
        return tr_csv_fail(csv, line,
                           "impossible contact: a = %.9g, b = %.9g; case.yaml has the disks 0 to %d and %d walls", v[A],
                           v[B], disks - 1, walls);
    if (v[A] == v[B]) return tr_csv_fail(csv, line, "disk %.0f touches itself: a = b", v[A]);
    if (v[A] > v[B])
        return tr_csv_fail(csv, line, "a = %.0f is above b = %.0f: a contact has the lower disk first", v[A], v[B]);
    if (v[FORCE] < 0 || !(v[R2] > 0) || !(v[A] < 0 || v[R1] > 0) || !(v[LIFE] >= 1 && v[LIFE] < 2e9))
        return tr_csv_fail(csv, line, "impossible contact: P_N_per_m < 0, a radius <= 0 or a life < 1");
    if (!(tr_hypot(v[X], v[Y]) > 0)) return tr_csv_fail(csv, line, "impossible contact: its branch has no length");
    return true;
}

/* Contacts of disks by (a, b), then those of walls by (wall, b). */
static bool is_after(double a, double b, const tr_replay_row *p) {
    if ((a < 0) != (p->a < 0)) return a < 0;
    if (a != p->a) return a < 0 ? a < p->a : a > p->a;
    return b > p->b;
}

/* Instants in the order of time; contacts of an instant in the order of the run. */
static bool check_order(const tr_replay *r, const double *v, tr_csv *csv) {
    if (v[TIME] < 0) return tr_csv_fail(csv, csv->row_line, "time_s is %g: it must start at 0", v[TIME]);
    if (!r->n_rows) return true;
    const tr_replay_row *last = &r->row[r->n_rows - 1];
    if (v[TIME] > last->time) return true;
    if (v[TIME] < last->time) return tr_csv_fail(csv, csv->row_line, "time_s falls: rows must be in the order of time");
    if (v[A] == last->a && v[B] == last->b)
        return tr_csv_fail(csv, csv->row_line, "the contact of %.0f and %.0f occurs twice at this instant", v[A], v[B]);
    return is_after(v[A], v[B], last) ||
           tr_csv_fail(
               csv, csv->row_line,
               "the contact of %.0f and %.0f is out of order, or occurs twice at this instant: contacts of disks "
               "come in the order of a and b, then those of walls",
               v[A], v[B]);
}

static bool row(void *context, tr_csv *csv) {
    reader *in = context;
    tr_replay *r = in->r;
    const double *v = in->now;
    in->last_line = csv->row_line;
    if (!check_row(r, v, csv) || !check_order(r, v, csv)) return false;
    if (r->n_rows == in->capacity) {
        int grown = in->capacity * 2 + 4096;
        if (!tr_alloc_grow(&r->row, (size_t)r->n_rows, (size_t)grown, sizeof *r->row, csv->st)) return false;
        in->capacity = grown;
    }
    bool next = !r->n_rows || v[TIME] > r->row[r->n_rows - 1].time;
    r->row[r->n_rows++] = (tr_replay_row){.life = (int)v[LIFE],
                                          .instant = r->n_instants += next,
                                          .line = csv->row_line,
                                          .a = (int)v[A],
                                          .b = (int)v[B],
                                          .time = v[TIME],
                                          .R1 = v[R1],
                                          .R2 = v[R2],
                                          .slide = v[SLIDE],
                                          .roll = v[ROLL],
                                          .P = v[FORCE],
                                          .Q = v[FRICTION],
                                          .f_n = v[WHOLE],
                                          .x = v[X],
                                          .y = v[Y]};
    r->row[r->n_rows - 1].instant--; /* from 0 */
    return true;
}

/* Cells of the present row, and the last two rows. */
typedef struct course {
    double cell[2], row[2][2];
} course;

static bool strain_cell(void *context, tr_csv *csv, int column, const char *text, size_t length) {
    course *c = context;
    (void)length;
    return tr_csv_number(csv, column ? "time_s" : "strain", text, false, &c->cell[column]);
}

static bool strain_row(void *context, tr_csv *csv) {
    course *c = context;
    (void)csv;
    memcpy(c->row[0], c->row[1], sizeof c->row[0]), memcpy(c->row[1], c->cell, sizeof c->cell);
    return true;
}

/* A stopped run did not reach its end, but it reached its full speed. */
static bool read_rate(tr_replay *r, const char *run, tr_status *st) {
    static const char *const names[] = {"strain", "time_s"};
    const tr_csv_format format = {names, 2, 2, "strain,...,time_s,...", NULL, strain_cell, strain_row};
    char path[TR_PATH];
    course c = {0};
    if (!tr_dir_path(path, run, "history.csv", st) || !tr_csv_read(path, &format, &c, st)) return false;
    const double *before = c.row[0], *last = c.row[1];
    if (!(last[1] > before[1])) return tr_status_fail(st, TR_BAD_CASE, "%.480s:1: error: no row after the start", path);
    r->rate = (last[0] - before[0]) / (last[1] - before[1]);
    r->start = fmax(0, 2 * (last[1] - last[0] / r->rate));
    return true;
}

static int by_life(const void *a, const void *b) {
    const tr_replay_row *p = a, *q = b;
    return p->life != q->life ? (p->life > q->life) - (p->life < q->life) : p->instant - q->instant;
}

/* A life belongs to one contact, and has a row at every instant until it ends. */
static bool check_lives(const tr_replay *r, const char *path, tr_status *st) {
    for (int i = 1; i < r->n_rows; i++) {
        const tr_replay_row *p = &r->row[i - 1], *q = p + 1;
        if (p->life != q->life) continue;
        if (p->a != q->a || p->b != q->b)
            return tr_status_fail(st, TR_BAD_CASE,
                                  "%.400s:%ld: error: life %d is of %d and %d here, of %d and %d in line %ld", path,
                                  q->line, q->life, q->a, q->b, p->a, p->b, p->line);
        if (p->R1 != q->R1 || p->R2 != q->R2)
            return tr_status_fail(st, TR_BAD_CASE,
                                  "%.400s:%ld: error: the radii of life %d are %.9g and %.9g here, %.9g and %.9g in "
                                  "line %ld",
                                  path, q->line, q->life, q->R1, q->R2, p->R1, p->R2, p->line);
        if (q->instant != p->instant + 1)
            return tr_status_fail(st, TR_BAD_CASE,
                                  "%.400s:%ld: error: life %d was last in line %ld, not at the instant before this one",
                                  path, q->line, q->life, p->line);
    }
    return true;
}

static bool split(tr_replay *r, const char *path, tr_status *st) {
    qsort(r->row, (size_t)r->n_rows, sizeof *r->row, by_life);
    if (!check_lives(r, path, st)) return false;
    for (int i = 0; i < r->n_rows; i++) r->n_lives += !i || r->row[i].life != r->row[i - 1].life;
    if (!(r->life = tr_alloc((size_t)r->n_lives, sizeof *r->life, st))) return false;
    for (int i = 0, k = -1, number = 0; i < r->n_rows; i++) {
        if (r->row[i].life != number) number = r->row[i].life, r->life[++k].first = i;
        r->life[k].n++;
        r->row[i].life = k;
    }
    return true;
}

/* A run writes summary.json last. */
static bool check_finished(const char *run, tr_status *st) {
    char path[TR_PATH];
    if (!tr_dir_path(path, run, "summary.json", st)) return false;
    return !access(path, F_OK) ||
           tr_status_fail(st, TR_BAD_CASE,
                          "error: %.400s has no summary.json: the run is not finished, and its paths break off; let it "
                          "go on (trundle run --resume), or run it again",
                          run);
}

/* A file that was cut at the end of a line looks complete. */
static bool check_whole(const tr_replay *r, const char *run, const char *path, long last_line, tr_status *st) {
    char summary[TR_PATH];
    struct stat now;
    double bytes;
    if (!tr_dir_path(summary, run, "summary.json", st) || !tr_summary_read(summary, "paths_bytes", &bytes, st))
        return false;
    if (stat(path, &now) || (double)now.st_size != bytes)
        return tr_status_fail(
            st, TR_BAD_CASE,
            "%.300s:%ld: error: the file ends here with %lld bytes; the run wrote %.0f (summary.json): it "
            "was cut or changed since",
            path, last_line, (long long)now.st_size, bytes);
    if (r->n_instants > r->scene.output.path_rows)
        return tr_status_fail(st, TR_BAD_CASE, "%.400s:%ld: error: %d instants; case.yaml has output.path_rows: %d",
                              path, last_line, r->n_instants, r->scene.output.path_rows);
    return true;
}

bool tr_replay_read(tr_replay *r, const char *run, tr_status *st) {
    char path[TR_PATH];
    reader in = {.r = r};
    struct stat file;
    if (!stat(run, &file) && !S_ISDIR(file.st_mode))
        return tr_status_fail(st, TR_BAD_CASE,
                              "error: %.400s is a file; a replay is of the directory of a finished run", run);
    if (!tr_dir_path(path, run, "case.yaml", st) ||
        !tr_scene_read_file(&r->scene, path, NULL, 0, tr_laws_catalog(), st))
        return false;
    if (r->scene.kind != TR_KIND_BIAXIAL || r->scene.shape != TR_SHAPE_DISK || !r->scene.output.path_rows)
        return tr_status_fail(st, TR_BAD_CASE,
                              "%.480s:1: error: replay needs disks, kind: biaxial, and output.path_rows", path);
    if (r->scene.compaction.mu > 0) /* the friction at the start is not in the path */
        return tr_status_fail(st, TR_BAD_CASE,
                              "%.480s:1: error: replay needs contacts that start without friction: a run "
                              "with compaction.mu: 0, not %g",
                              path, r->scene.compaction.mu);
    if (!check_finished(run, st)) return false;
    const tr_csv_format format = {columns, COLUMNS, COLUMNS, "time_s,life,a,b,...", NULL, cell, row};
    if (!tr_dir_path(path, run, "paths.csv", st) || !tr_csv_read(path, &format, &in, st)) return false;
    if (!r->n_rows) return tr_status_fail(st, TR_BAD_CASE, "%.480s:1: error: it has no contact", path);
    return check_whole(r, run, path, in.last_line, st) && split(r, path, st) && read_rate(r, run, st);
}
