/* SPDX-License-Identifier: MIT */
#include "verify/verify.h"

#include "base/alloc.h"
#include "laws/law.h"
#include "out/manifest.h"
#include "out/table.h"
#include "scene/what.h"
#include "study/checks.h"
#include "study/play.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

bool tr_verify_run(tr_verify *v, const tr_verification *which, tr_status *st) {
    v->now = which;
    v->started = now();
    if (which->run(v, st)) return true;
    if (st->code != TR_NUMERICAL) return false;
    tr_status end = *st; /* a run that broke down is a wrong answer too */
    *st = (tr_status){0};
    return tr_verify_outcome(v, "runs to its end", end.text, false, st);
}

void tr_verify_free(tr_verify *v) {
    free(v->row), free(v->point);
    *v = (tr_verify){0};
}

bool tr_verify_go_on(const tr_verify *v, tr_status *st) {
    return !(v->stop && *v->stop) || tr_status_fail(st, TR_INTERRUPTED, "stopped in %s", v->now->name);
}

static tr_verified *next_row(tr_verify *v, tr_status *st) {
    if (v->n == v->capacity) {
        int more = v->capacity ? 2 * v->capacity : 64;
        if (!tr_alloc_grow(&v->row, (size_t)v->capacity, (size_t)more, sizeof *v->row, st)) return NULL;
        v->capacity = more;
    }
    tr_verified *r = &v->row[v->n++];
    *r = (tr_verified){.of = v->now, .seconds = now() - v->started};
    return r;
}

bool tr_verify_add(tr_verify *v, const tr_verify_row *row, tr_status *st) {
    tr_verified *r = next_row(v, st);
    if (!r) return false;
    r->row = *row;
    snprintf(r->quantity, sizeof r->quantity, "%s", row->quantity);
    if (row->outcome) snprintf(r->outcome, sizeof r->outcome, "%s", row->outcome);
    snprintf(r->unit, sizeof r->unit, "%s", row->unit);
    r->row.quantity = r->row.unit = r->row.outcome = NULL;
    r->ok = fabs(row->computed - row->reference) <= row->tolerance; /* false for NaN */
    v->failed += !r->ok;
    return true;
}

bool tr_verify_outcome(tr_verify *v, const char *quantity, const char *outcome, bool ok, tr_status *st) {
    tr_verified *r = next_row(v, st);
    if (!r) return false;
    r->row = (tr_verify_row){.reference = NAN, .computed = NAN, .tolerance = NAN, .order = NAN, .reason = ""};
    snprintf(r->quantity, sizeof r->quantity, "%s", quantity);
    snprintf(r->outcome, sizeof r->outcome, "%s", outcome);
    r->ok = ok;
    v->failed += !ok;
    return true;
}

bool tr_verify_point_add(tr_verify *v, const tr_verify_point *point, tr_status *st) {
    if (v->n_points == v->points_capacity) {
        int more = v->points_capacity ? 2 * v->points_capacity : 64;
        if (!tr_alloc_grow(&v->point, (size_t)v->points_capacity, (size_t)more, sizeof *v->point, st)) return false;
        v->points_capacity = more;
    }
    struct tr_verify_pointed *p = &v->point[v->n_points++];
    *p = (struct tr_verify_pointed){.of = v->now, .point = *point};
    snprintf(p->series, sizeof p->series, "%s", point->series);
    p->point.series = NULL;
    return true;
}

/* ---- tables ---- */

/* Text of a CSV cell: quotes where it needs them. */
static void put_text(FILE *f, const char *text) {
    if (!strpbrk(text, ",\"\n")) {
        fputs(text, f);
        return;
    }
    fputc('"', f);
    for (; *text; text++) {
        if (*text == '"') fputc('"', f);
        fputc(*text, f);
    }
    fputc('"', f);
}

static void put_number(FILE *f, double value) {
    fputc(',', f);
    tr_cell_put(f, value, 9);
}

static void put_row(FILE *f, const tr_verified *r) {
    const char *text[] = {r->of->group, r->of->name, r->quantity, r->unit, r->of->source};
    for (size_t i = 0; i < sizeof text / sizeof *text; i++) {
        if (i) fputc(',', f);
        put_text(f, text[i]);
    }
    put_number(f, r->row.reference), put_number(f, r->row.computed), put_number(f, r->row.computed - r->row.reference);
    put_number(f, r->row.tolerance), put_number(f, r->row.order), put_number(f, r->seconds);
    fprintf(f, ",%s,", r->ok ? "ok" : "FAILED");
    put_text(f, r->outcome), fputc(',', f), put_text(f, r->row.reason), fputc('\n', f);
}

static void put_point(FILE *f, const struct tr_verify_pointed *p) {
    put_text(f, p->of->name), fputc(',', f), put_text(f, p->series), fputc(',', f), put_text(f, p->point.step_name);
    put_number(f, p->point.step), put_number(f, p->point.error), put_number(f, p->point.seconds);
    put_number(f, p->point.low), put_number(f, p->point.high);
    fprintf(f, ",%d\n", p->point.usual);
}

bool tr_verify_claim(const char *dir, tr_status *st) {
    return tr_dir_make(dir, ".", st) && tr_manifest_add(dir, "verify.csv", st) &&
           tr_manifest_add(dir, "points.csv", st);
}

bool tr_verify_write(const tr_verify *v, const char *dir, tr_status *st) {
    tr_file file;
    if (!tr_file_open(&file, dir, "verify.csv", st)) return false;
    fputs("group,case,quantity,unit,source,reference,computed,error,tolerance,order,seconds,verdict,outcome,reason\n",
          file.stream);
    for (int i = 0; i < v->n; i++) put_row(file.stream, &v->row[i]);
    if (!tr_file_commit(&file, st)) return false;
    if (!v->n_points) return true;
    if (!tr_file_open(&file, dir, "points.csv", st)) return false;
    fputs("case,series,step_name,step,error,seconds,seconds_low,seconds_high,default\n", file.stream);
    for (int i = 0; i < v->n_points; i++) put_point(file.stream, &v->point[i]);
    return tr_file_commit(&file, st);
}

/* ---- scenes ---- */

bool tr_verify_play(const tr_verify *v, const tr_scene *scene, int halvings, tr_check_result *result, tr_status *st) {
    tr_scene fine = *scene;
    tr_play *p = tr_alloc(1, sizeof *p, st);
    if (!p) return false;
    const tr_run_options options = {.stop = v->stop};
    fine.step.safety /= 1 << halvings, fine.step.dt /= 1 << halvings;
    bool ok = tr_play_open(p, &fine, TR_CURVE_NONE, st) && tr_checks_thresholds(&p->checks, &options, st) &&
              tr_play_to(p, p->b.steps, st);
    if (ok) tr_checks_results(&p->checks, result);
    for (int k = 0; k < scene->n_checks && ok; k++) result[k].check = &scene->checks[k]; /* which outlives fine */
    tr_play_close(p);
    free(p);
    return ok;
}

bool tr_verify_scene(tr_verify *v, const char *text, const char *const *sets, int n_sets, int halvings,
                     const char *reason, tr_status *st) {
    enum { MOST = 32 };
    tr_scene scene;
    tr_check_result coarse[MOST] = {{0}}, result[MOST] = {{0}};
    if (!tr_scene_read(&scene, &(tr_scene_source){v->now->name, text, strlen(text), sets, n_sets}, tr_laws_catalog(),
                       st))
        return false;
    bool ok = true;
    for (int h = 0; h <= halvings && ok; h++) {
        memcpy(coarse, result, sizeof coarse);
        ok = tr_verify_play(v, &scene, h, result, st) && tr_verify_go_on(v, st);
    }
    for (int k = 0; k < scene.n_checks && ok; k++) {
        const tr_scene_check *c = &scene.checks[k];
        const tr_what_row *row = &tr_whats[c->what];
        char quantity[80], part[TR_BY_SHAPE];
        snprintf(quantity, sizeof quantity, "%s of %s", row->name, result[k].of);
        double error = fabs(result[k].measured - c->exact), before = fabs(coarse[k].measured - c->exact);
        bool above = halvings > 0 && error > 1e-10 * fabs(c->exact) && error > 0;
        ok = tr_verify_add(v,
                           &(tr_verify_row){.quantity = quantity,
                                            .unit = tr_param_by_shape(row->unit, scene.shape, part),
                                            .reference = c->exact,
                                            .computed = result[k].measured,
                                            .tolerance = c->tolerance,
                                            .reason = reason,
                                            .order = above ? log2(before / error) : NAN},
                           st);
    }
    tr_scene_free(&scene);
    return ok;
}
