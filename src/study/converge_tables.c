/* SPDX-License-Identifier: MIT */
#include "study/converge_tables.h"

#include "base/student.h"
#include "out/plot_converge.h"
#include "out/plot.h"
#include "out/table.h"
#include "study/converge_errors.h"
#include "study/converge_points.h"
#include "study/converge_text.h"
#include <math.h>
#include <stdlib.h>

static const char *const verdicts[] = {"not examined", "exact",     "order",
                                       "scattered",    "no change", "not converged"}; /* tr_verdict */

static void put_numbers(FILE *f, const double *x, int n) {
    for (int i = 0; i < n; i++) putc(',', f), tr_cell_put(f, x[i], 10);
}

static bool write_causes(const tr_converge *c, tr_status *st) {
    tr_file file;
    if (!tr_file_open(&file, c->options->dir, "converge.csv", st)) return false;
    FILE *f = file.stream;
    fputs("number,cause,key,verdict,setting,value,error,limit,limit_error,order,seen,seen_error\n", f);
    for (int q = 0; q < c->n_numbers; q++) {
        for (int i = 0; i < c->n_ladders; i++) {
            const tr_converge_ladder *l = &c->ladder[i];
            const tr_ladder *of = &l->of[q];
            const double row[] = {l->level[l->own].setting,
                                  c->own.value[q][0],
                                  of->half,
                                  of->limit,
                                  of->unsure,
                                  of->order,
                                  of->seen,
                                  of->seen_half};
            fprintf(f, "%s,%s,%s,%s", c->number[q].name, l->cause->name, l->cause->key, verdicts[of->verdict]);
            put_numbers(f, row, 8);
            putc('\n', f);
        }
        if (!tr_converge_sampled(c)) continue;
        const tr_sample_error *s = &c->sample[q];
        const double row[] = {(double)c->scene.seed, c->own.value[q][0], s->one_half, s->mean, s->half, NAN, NAN, NAN};
        fprintf(f, "%s,sample,seed,%d seeds", c->number[q].name, s->seeds);
        put_numbers(f, row, 8);
        putc('\n', f);
    }
    return tr_file_commit(&file, st);
}

static bool write_levels(const tr_converge *c, tr_status *st) {
    tr_file file;
    if (!tr_file_open(&file, c->options->dir, "levels.csv", st)) return false;
    FILE *f = file.stream;
    fputs("number,cause,setting,seeds,value,standard_error,error,seconds,own,front\n", f);
    for (int q = 0; q < c->n_numbers; q++)
        for (int i = 0; i < c->n_ladders; i++)
            for (int k = 0; k < c->ladder[i].n; k++) {
                const tr_converge_ladder *l = &c->ladder[i];
                if (l->level[k].state != TR_LEVEL_DONE) continue;
                tr_mean m = tr_mean_of(l->level[k].value[q], TR_CONVERGE_SEEDS);
                const double row[] = {m.mean, m.error, tr_converge_error(c, l, q, k), l->level[k].seconds};
                fprintf(f, "%s,%s,%.10g,%d", c->number[q].name, l->cause->name, l->level[k].setting, m.n);
                put_numbers(f, row, 4);
                fprintf(f, ",%d,%d\n", k == l->own, tr_converge_front(c, l, q, k));
            }
    return tr_file_commit(&file, st);
}

static void widen(double x, double *low, double *high) {
    if (!(x > 0) || !isfinite(x)) return;
    *low = *low > 0 ? fmin(*low, x) : x;
    *high = fmax(*high, x);
}

static void label_number(const tr_converge *c, int q, tr_plot_converge_labels *labels) {
    int unknown, n = labels->n_numbers++;
    labels->number[n].name = c->number[q].name;
    labels->number[n].total = tr_converge_total(c, q, &unknown);
    labels->number[n].whole = !unknown;
    for (int i = 0; i < c->n_ladders; i++) {
        const tr_converge_ladder *l = &c->ladder[i];
        labels->number[n].part[i] = l->of[q].half;
        for (int k = 0; k < l->n; k++) {
            widen(tr_converge_error(c, l, q, k), &labels->number[n].low, &labels->number[n].high);
            widen(l->level[k].seconds, &labels->fast, &labels->slow);
        }
    }
    labels->number[n].part[c->n_ladders] = c->sample[q].one_half;
}

/* The first numbers, and the causes by their names, as the pictures show them. */
static bool draw(tr_converge *c, tr_status *st) {
    tr_plot_converge_labels labels = {0};
    int code = 0;
    if (!tr_plot_available()) return tr_converge_note(c, "no pictures: gnuplot is not installed"), true;
    for (int q = 0; q < c->n_numbers && labels.n_numbers < TR_PLOT_NUMBERS; q++)
        if (!tr_converge_idle(c, q)) label_number(c, q, &labels);
    for (int i = 0; i < c->n_ladders; i++) labels.cause[labels.n_causes++] = c->ladder[i].cause->name;
    if (tr_converge_sampled(c)) labels.cause[labels.n_causes++] = "sample";
    if (!labels.n_numbers || !(labels.fast > 0)) return true;
    if (!tr_plot_converge(c->options->dir, &labels, &code, st)) return false;
    if (code) tr_converge_note(c, "no pictures: gnuplot ended with code %d", code);
    return true;
}

bool tr_converge_write(tr_converge *c, char **text, tr_status *st) {
    return write_causes(c, st) && write_levels(c, st) && draw(c, st) && tr_converge_write_text(c, text, st);
}
