/* SPDX-License-Identifier: MIT */
/* case.yaml, history.csv and paths.csv of a run. */
#include "base/alloc.h"
#include "laws/law.h"
#include "out/dir.h"
#include "study/csv.h"
#include "study/replay.h"
#include <stdlib.h>

enum { TIME, LIFE, A, B, R1, R2, SLIDE, ROLL, FORCE, FRICTION, WHOLE, X, Y, COLUMNS };
static const char *const columns[COLUMNS] = {"time_s",      "life",       "a",         "b",         "R1_m",
                                             "R2_m",        "du_slide_m", "du_roll_m", "P_N_per_m", "Q_N_per_m",
                                             "f_n_N_per_m", "branch_x_m", "branch_y_m"};

typedef struct reader {
    tr_replay *r;
    int capacity;
    double now[COLUMNS];
} reader;

static bool cell(void *context, tr_csv *csv, int column, const char *text, size_t length) {
    reader *in = context;
    (void)length;
    return tr_csv_number(csv, columns[column], text, false, &in->now[column]);
}

static bool row(void *context, tr_csv *csv) {
    reader *in = context;
    tr_replay *r = in->r;
    const double *v = in->now;
    if (r->n_rows == in->capacity) {
        int grown = in->capacity * 2 + 4096;
        if (!tr_alloc_grow(&r->row, (size_t)r->n_rows, (size_t)grown, sizeof *r->row, csv->st)) return false;
        in->capacity = grown;
    }
    bool next = !r->n_rows || v[TIME] > r->row[r->n_rows - 1].time;
    if (r->n_rows && v[TIME] < r->row[r->n_rows - 1].time)
        return tr_csv_fail(csv, csv->row_line, "time_s falls: rows are in the order of time");
    if (v[FORCE] < 0 || !(v[R2] > 0) || !(v[A] < 0 || v[R1] > 0) || !(v[LIFE] >= 1 && v[LIFE] < 2e9))
        return tr_csv_fail(csv, csv->row_line, "no such contact: P_N_per_m < 0, a radius <= 0 or a life < 1");
    r->row[r->n_rows++] = (tr_replay_row){.life = (int)v[LIFE],
                                          .instant = r->n_instants += next,
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

/* The strain grows at a constant rate; a run that was stopped did not come to its end. */
static bool strain_cell(void *context, tr_csv *csv, int column, const char *text, size_t length) {
    (void)length;
    return tr_csv_number(csv, column ? "time_s" : "strain", text, false, (double *)context + column);
}

static bool strain_row(void *context, tr_csv *csv) {
    (void)context, (void)csv;
    return true; /* the last one counts */
}

static bool read_rate(tr_replay *r, const char *run, tr_status *st) {
    static const char *const names[] = {"strain", "time_s"};
    const tr_csv_format format = {names, 2, 2, "strain,...,time_s,...", NULL, strain_cell, strain_row};
    char path[TR_PATH];
    double last[2] = {0};
    if (!tr_dir_path(path, run, "history.csv", st) || !tr_csv_read(path, &format, last, st)) return false;
    if (!(last[1] > 0)) return tr_status_fail(st, TR_BAD_CASE, "%.480s:1: error: no row after the start", path);
    r->rate = last[0] / last[1];
    return true;
}

static int by_life(const void *a, const void *b) {
    const tr_replay_row *p = a, *q = b;
    return p->life != q->life ? (p->life > q->life) - (p->life < q->life) : p->instant - q->instant;
}

static bool split(tr_replay *r, tr_status *st) {
    qsort(r->row, (size_t)r->n_rows, sizeof *r->row, by_life);
    for (int i = 0; i < r->n_rows; i++) r->n_lives += !i || r->row[i].life != r->row[i - 1].life;
    if (!(r->life = tr_alloc((size_t)r->n_lives, sizeof *r->life, st))) return false;
    for (int i = 0, k = -1, number = 0; i < r->n_rows; i++) {
        if (r->row[i].life != number) number = r->row[i].life, r->life[++k].first = i;
        r->life[k].n++;
        r->row[i].life = k;
    }
    return true;
}

bool tr_replay_read(tr_replay *r, const char *run, tr_status *st) {
    char path[TR_PATH];
    reader in = {.r = r};
    if (!tr_dir_path(path, run, "case.yaml", st) ||
        !tr_scene_read_file(&r->scene, path, NULL, 0, tr_laws_catalog(), st))
        return false;
    if (r->scene.kind != TR_KIND_BIAXIAL || r->scene.shape != TR_SHAPE_DISK || !r->scene.output.path_rows)
        return tr_status_fail(st, TR_BAD_CASE,
                              "%.480s:1: error: a replay is of disks, kind: biaxial, with output.path_rows", path);
    const tr_csv_format format = {columns, COLUMNS, COLUMNS, "time_s,life,a,b,...", NULL, cell, row};
    if (!tr_dir_path(path, run, "paths.csv", st) || !tr_csv_read(path, &format, &in, st)) return false;
    if (!r->n_rows) return tr_status_fail(st, TR_BAD_CASE, "%.480s:1: error: no contact in it", path);
    return split(r, st) && read_rate(r, run, st);
}
