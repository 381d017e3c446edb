/* SPDX-License-Identifier: MIT */
/* One contact along its path, with its table, its curves, its checks and its summary. What differs between the kinds is
 * in run_contact.c and run_patch.c. */
#include "study/run_path.h"

#include "base/alloc.h"
#include "laws/law.h"
#include "out/plot.h"
#include "out/table.h"
#include "scene/what.h"
#include "study/clock.h"
#include "study/open.h"
#include "study/path.h"
#include "study/run_contact.h"
#include "study/run_patch.h"
#include "study/shown_check.h"
#include "study/warn.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const tr_driven_kind *kind_of(const tr_scene *scene) {
    return scene->kind == TR_KIND_PATCH ? &tr_driven_patch : &tr_driven_contact;
}

static void name_all(tr_driven *d) {
    const tr_scene *scene = d->scene;
    d->n = scene->kind == TR_KIND_PATCH ? 1 : scene->n_laws;
    for (int i = 0; i < d->n; i++) kind_of(scene)->name(d, i);
    for (int k = 0; k < scene->n_checks; k++) {
        const tr_scene_check *check = &scene->checks[k];
        const tr_column_row *row = &tr_columns[check->what];
        tr_check_result *r = &d->check[k];
        *r = (tr_check_result){.lane = "", .shape = scene->shape, .check = check, .what = row->name, .unit = row->unit};
        r->measured = NAN;
        int segment = check->segment < 0 ? scene->n_segments - 1 : check->segment;
        if (scene->kind == TR_KIND_CONTACT)
            snprintf(r->of, sizeof r->of, "laws.%d, path.%d", check->law, segment);
        else
            snprintf(r->of, sizeof r->of, "path.%d", segment);
    }
}

/* A step overwrites the one before: the last of a segment stays. */
static void measure(tr_driven *d, const tr_contact_state *s) {
    for (int k = 0; k < d->scene->n_checks; k++) {
        const tr_scene_check *check = d->check[k].check;
        if (check->law != s->law || (check->segment >= 0 && check->segment != s->segment)) continue;
        d->check[k].measured = tr_contact_value(s, check->what);
        d->check[k].ok = fabs(d->check[k].measured - check->exact) <= check->tolerance; /* false for NaN */
    }
}

static void keep_result(tr_path_result *r, const tr_contact_state *s) {
    r->Q_end = s->Q, r->q_end = s->q;
    r->u_slide_end = s->u_slide, r->dissipated = s->dissipated;
    r->merged = s->merged > r->merged ? s->merged : r->merged; /* an opening forgets the count too */
    r->moment_1_end = s->moment_1, r->moment_2_end = s->moment_2;
    r->Q_max = fmax(r->Q_max, fabs(s->Q));
    r->moment_max = fmax(r->moment_max, fmax(fabs(s->moment_1), fabs(s->moment_2)));
}

/* State and motion of the two bodies as `trundle measures` takes them, so that another code can be driven along the
 * same path: body 1 rests at the origin, the line of centres is along x. Places are those at the end of the step,
 * velocities those of the step. Vt = 0: w1, w2 follow from Vs = R1 w1 + R2 w2 and V_r = (R1 w1 - R2 w2)/2 (contact.h).
 */
static void add_motion(tr_row *row, const tr_scene *scene, const tr_contact_state *before, const tr_contact_state *s) {
    const tr_scene_segment *g = &scene->path[s->segment];
    const double dt = (g->time > 0 ? g->time : 1) / g->steps, R1 = scene->pair.R1, R2 = scene->pair.R2;
    const double closes = before->step ? (s->overlap - before->overlap) / dt : 0;
    double slide = (s->u_slide - before->u_slide) / dt, roll = (s->u_roll - before->u_roll) / dt;
    tr_row_add(row, R1, "R1"), tr_row_add(row, R2, "R2");
    tr_row_add(row, 0, "x1x"), tr_row_add(row, 0, "x1y");
    tr_row_add(row, R1 + R2 - s->overlap, "x2x"), tr_row_add(row, 0, "x2y");
    tr_row_add(row, 0, "v1x"), tr_row_add(row, 0, "v1y");
    tr_row_add(row, 0.0 - closes, "v2x"), tr_row_add(row, 0, "v2y");
    tr_row_add(row, (slide / 2 - roll) / R1 + 0.0, "w1"), tr_row_add(row, (slide / 2 + roll) / R2 + 0.0, "w2");
    tr_row_add(row, dt, "dt_s");
}

static bool write_row(tr_driven *d, const tr_contact_state *s, tr_status *st) {
    tr_row row = {.shape = d->scene->shape};
    int n = d->scene->kind == TR_KIND_PATCH ? TR_N_PATCH_COLUMNS : TR_N_COLUMNS;
    tr_row_add(&row, s->law, "law");
    tr_row_add(&row, (double)s->step, "step");
    tr_row_add(&row, s->segment, "segment");
    for (int i = 0; i < n; i++) tr_row_add_in(&row, tr_contact_value(s, i), tr_columns[i].name, tr_columns[i].unit);
    add_motion(&row, d->scene, &d->before[s->law], s);
    d->before[s->law] = *s;
    return tr_row_write_exact(&row, &d->table, st);
}

static bool keep(tr_driven *d, tr_status *st) {
    for (int i = 0; i < d->n; i++) {
        keep_result(&d->result[i], &d->state[i]);
        measure(d, &d->state[i]);
        if (!write_row(d, &d->state[i], st)) return false;
    }
    const tr_driven_kind *kind = kind_of(d->scene);
    return !kind->keep || kind->keep(d, st);
}

static bool go(tr_driven *d, bool rehearsal, tr_status *st) {
    const tr_driven_kind *kind = kind_of(d->scene);
    for (d->done = 0; d->done < d->total;) {
        if (tr_run_stopped(d->options))
            return tr_status_fail(st, TR_INTERRUPTED, "stopped at step %lld of %lld%s", (long long)d->done,
                                  (long long)d->total, rehearsal ? " of the rehearsal for the film" : "");
        if (d->done % 16 == 0)
            tr_run_progress(d->options, rehearsal ? "rehearsal" : "path", (double)d->done / (double)d->total);
        if (!kind->step(d, st)) return false;
        d->done++;
        if (rehearsal)
            kind->watch(d);
        else if (!keep(d, st))
            return d->done--, false;
    }
    return true;
}

/* Files get their names whatever ended the run: their rows are whole. Returns st->code == TR_OK. */
static bool close_files(tr_driven *d, tr_status *st) {
    const tr_driven_kind *kind = kind_of(d->scene);
    tr_status closing = {0};
    char more[80] = "";
    bool kept = d->table.stream && d->done && tr_file_commit(&d->table, &closing);
    if (!kept) tr_file_discard(&d->table);
    if (kind->close) kind->close(d, more, &closing);
    if (closing.code) tr_status_fail(st, closing.code, "%s", closing.text);
    if (!st->code) return true;
    size_t used = strlen(st->text);
    snprintf(st->text + used, sizeof st->text - used,
             "\nkept in %s: %lld steps of contact.csv%s; not finished, no summary.json", d->options->dir,
             (long long)(kept ? d->done : 0), more);
    return false;
}

static bool plot(const tr_driven *d, tr_status *st) {
    if (!d->scene->output.curves) return true;
    if (!tr_plot_available())
        return tr_run_note(d->report, "no curves: gnuplot is not installed; contact.csv has the numbers"), true;
    const char *label[TR_MAX_LAWS];
    for (int i = 0; i < d->n; i++) label[i] = d->result[i].label;
    int code = 0;
    if (!tr_plot_contact(d->options->dir, label, d->n, d->rolling, d->scene->shape, &code, st)) return false;
    if (code) tr_run_note(d->report, "no curves: gnuplot failed (%d) on plot.gp; run it there to see why", code);
    return true;
}

static bool summarise(const tr_driven *d, const tr_timing *timing, tr_status *st) {
    char *text = tr_summary_path(d->scene, d->total, d->result, d->check, timing, st);
    bool ok = text && tr_file_write(d->options->dir, "summary.json", text, st);
    free(text);
    return ok;
}

/* What the rows of a file leave out. */
static void say_rows(const tr_driven *d) {
    double roll = 0, slide = 0;
    if (!d->scene->path_file) return;
    for (int i = 0; i < d->scene->n_segments; i++) {
        const tr_scene_segment *g = &d->scene->path[i];
        double a = tr_law_width(d->scene->shape, g->force, d->scene->pair.R_star, d->scene->pair.E_star);
        if (a > 0) roll = fmax(roll, fabs(g->roll) / a), slide = fmax(slide, fabs(g->slide));
    }
    tr_run_say(d->report, "rows of the path", "straight between two; the longest rolls %.3g a, slides %.3g m%s", roll,
               slide, roll > 1 ? "; how the path bent in a row is not known" : "");
}

static void say(tr_driven *d) {
    tr_run_say(d->report, "segments, steps", "%d, %lld", d->scene->n_segments, (long long)d->total);
    say_rows(d);
    kind_of(d->scene)->say(d);
    for (int k = 0; k < d->scene->n_checks; k++) tr_run_say_check(d->report, &d->check[k], false);
}

static bool run(tr_driven *d, tr_status *st) {
    const tr_driven_kind *kind = kind_of(d->scene);
    double started = tr_run_clock();
    if (!kind->start(d, st) || !tr_run_open(d->scene, d->options, NULL, d->report, st)) return false;
    if (kind->rehearses && kind->rehearses(d) && !(go(d, true, st) && kind->start(d, st))) return false;
    d->done = 0;
    double playing = tr_run_clock();
    if (tr_file_open(&d->table, d->options->dir, "contact.csv", st) && (!kind->open || kind->open(d, st)))
        go(d, false, st);
    if (!close_files(d, st)) return false;
    double now = tr_run_clock();
    tr_timing timing = {now - started, (double)d->total * d->n / (now - playing)};
    if (!plot(d, st) || !summarise(d, &timing, st)) return false;
    say(d);
    return true;
}

/* The scene with its path from the file, if it is in one. */
static bool read_path(const tr_scene *scene, tr_scene *played, tr_status *st) {
    *played = *scene;
    if (!scene->path_file || tr_path_read(played, st)) return true;
    free(played->path);
    return false;
}

static void drop_path(tr_scene *played) {
    if (played->path_file) free(played->path);
}

bool tr_run_path(const tr_scene *scene, const tr_run_options *options, tr_run_report *report, tr_status *st) {
    tr_scene played;
    if (!read_path(scene, &played, st)) return false;
    tr_driven *d = tr_alloc(1, sizeof *d, st);
    bool ok = false;
    if (d) {
        d->scene = &played, d->options = options, d->report = report;
        d->total = tr_contact_steps(&played);
        name_all(d);
        ok = run(d, st);
        kind_of(&played)->free(d);
        free(d);
    }
    drop_path(&played);
    return ok;
}

char *tr_run_check_path(const tr_scene *scene, tr_run_report *report, tr_status *st) {
    tr_scene played;
    if (!read_path(scene, &played, st)) return NULL;
    if (scene->kind == TR_KIND_CONTACT) tr_warn_contact(&played, report);
    tr_driven *d = tr_alloc(1, sizeof *d, st);
    char *summary = NULL;
    if (d) {
        d->scene = &played;
        name_all(d);
        summary = tr_summary_path(&played, 0, d->result, d->check, &(tr_timing){0}, st);
        free(d);
    }
    drop_path(&played);
    return summary;
}
