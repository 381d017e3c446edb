/* SPDX-License-Identifier: MIT */
/* Statistics over the seeds, only from summaries: the same bytes for any order of the points.
 *
 * Differences are taken seed by seed and then averaged, so that the scatter between samples, which is most of it,
 * cancels. If points are missing, a mean is over the finished ones, and says their number. */

#include "study/sweep_collect.h"

#include "base/alloc.h"
#include "base/student.h"
#include "out/dir.h"
#include "out/summary.h"
#include "out/summary_read.h"
#include "out/table.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Number k of collect to value[k*points + point]; NaN if the point is not finished. */
static bool read_point(const tr_grid *g, int point, const char *dir, double *value, bool *finished, tr_status *st) {
    char name[TR_POINT_NAME], path[TR_PATH], summary[TR_PATH];
    tr_point_state state;
    tr_grid_name(g, point, name);
    if (!tr_grid_state(g, point, dir, &state, st) || !tr_dir_path(path, dir, name, st) ||
        !tr_dir_path(summary, path, "summary.json", st))
        return false;
    finished[point] = state == TR_POINT_FINISHED;
    if (!finished[point] && point < g->combinations && !tr_grid_check(g, point, st)) return false;
    for (int k = 0; k < g->n_collect; k++) {
        double *x = &value[(size_t)k * (size_t)g->n + (size_t)point];
        *x = NAN;
        if (finished[point] && !tr_summary_read(summary, g->collect[k], x, st)) return false;
    }
    return true;
}

/* RFC 4180 */
static void put_text(FILE *out, const char *text) {
    bool quote = strpbrk(text, ",\"\n\r");
    if (quote) putc('"', out);
    for (; *text; text++) {
        if (*text == '"') putc('"', out);
        putc(*text, out);
    }
    if (quote) putc('"', out);
}

static void put_mean(FILE *out, const tr_mean *m) {
    const double number[] = {m->mean, m->error, m->low, m->high};
    fprintf(out, ",%d", m->n);
    for (int i = 0; i < 4; i++) putc(',', out), tr_cell_put(out, number[i], 10);
}

static void put_header(FILE *out, const tr_grid *g) {
    for (int i = 0; i < g->n_vary; i++) put_text(out, g->axis[i].key), putc(',', out);
    fputs("quantity,minus,seeds,mean,standard_error,low_95,high_95\n", out);
}

/* c: NULL for the quantity itself. x: room for a number of each seed */
static void put_row(FILE *out, const tr_grid *g, int combination, int k, const tr_compare *c, const double *value,
                    double *x) {
    const double *of = value + (size_t)k * (size_t)g->n;
    char minus[512] = "";
    for (int i = 0; i < g->n_vary; i++)
        put_text(out, g->axis[i].value[tr_grid_value(g, combination, i)]), putc(',', out);
    put_text(out, g->collect[k]), putc(',', out);
    if (c) snprintf(minus, sizeof minus, "%s=%s", g->axis[c->axis].key, g->axis[c->axis].value[c->to]);
    put_text(out, minus);
    int other = c ? tr_grid_with(g, combination, c->axis, c->to) : 0;
    for (int s = 0; s < g->seeds; s++)
        x[s] = of[s * g->combinations + combination] - (c ? of[s * g->combinations + other] : 0);
    tr_mean mean = tr_mean_of(x, g->seeds);
    put_mean(out, &mean);
    putc('\n', out);
}

/* A row of each point that is finished. */
static void put_points(FILE *out, const tr_grid *g, const double *value, const bool *finished) {
    for (int i = 0; i < g->n_named; i++) put_text(out, g->axis[i].key), putc(',', out);
    for (int k = 0; k < g->n_collect; k++) put_text(out, g->collect[k]), putc(k + 1 < g->n_collect ? ',' : '\n', out);
    for (int point = 0; point < g->n; point++) {
        if (!finished[point]) continue;
        for (int i = 0; i < g->n_named; i++)
            put_text(out, g->axis[i].value[tr_grid_value(g, point, i)]), putc(',', out);
        for (int k = 0; k < g->n_collect; k++) {
            tr_cell_put(out, value[(size_t)k * (size_t)g->n + (size_t)point], 10);
            putc(k + 1 < g->n_collect ? ',' : '\n', out);
        }
    }
}

static void put_rows(FILE *out, const tr_grid *g, const double *value, double *x) {
    for (int c = -1; c < g->n_compare; c++) {
        const tr_compare *compare = c < 0 ? NULL : &g->compare[c];
        for (int i = 0; i < g->combinations; i++) {
            if (compare && tr_grid_value(g, i, compare->axis) == compare->to) continue;
            for (int k = 0; k < g->n_collect; k++) put_row(out, g, i, k, compare, value, x);
        }
    }
}

bool tr_grid_collect(const tr_grid *g, const char *dir, int *missing, tr_status *st) {
    double *value = tr_alloc((size_t)g->n * (size_t)g->n_collect, sizeof *value, st);
    double *x = tr_alloc((size_t)g->seeds, sizeof *x, st);
    bool *finished = tr_alloc((size_t)g->n, sizeof *finished, st);
    tr_file file;
    *missing = 0;
    bool ok = value && x && finished;
    for (int point = 0; ok && point < g->n; point++) {
        ok = read_point(g, point, dir, value, finished, st);
        *missing += !finished[point];
    }
    if (ok && tr_file_open(&file, dir, "points.csv", st)) {
        put_points(file.stream, g, value, finished);
        ok = tr_file_commit(&file, st);
    }
    if (ok && !st->code && tr_file_open(&file, dir, "collect.csv", st)) {
        put_header(file.stream, g);
        put_rows(file.stream, g, value, x);
        tr_file_commit(&file, st);
    }
    free(value), free(x), free(finished);
    return !st->code;
}
