/* SPDX-License-Identifier: MIT */
/* A contact along its path, with its table, its curves and its summary. */
#include "study/run_contact.h"

#include "base/alloc.h"
#include "laws/law.h"
#include "out/plot.h"
#include "out/summary.h"
#include "study/clock.h"
#include "study/contact.h"
#include "study/open.h"
#include "study/path.h"
#include "study/warn.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct drive {
    tr_contact *contact;
    const tr_scene *scene;
    int64_t total, done; /* steps */
    tr_file table;
    tr_contact_state state[TR_MAX_LAWS];
    tr_path_result result[TR_MAX_LAWS];
    bool rolling; /* some law has moments */
} drive;

static void name_laws(drive *d) {
    for (int i = 0; i < d->scene->n_laws; i++) {
        const tr_scene_contact *c = &d->scene->laws[i];
        const tr_law *friction = tr_laws_friction[c->friction.law], *rolling = tr_laws_rolling[c->rolling.law];
        d->result[i] = (tr_path_result){.friction = friction->table.name, .rolling = rolling->table.name};
        if (rolling->needs & TR_NEEDS_V_R)
            d->result[i].rolling_velocity = tr_rolling_velocities[c->rolling_velocity].name;
        d->rolling |= rolling->step != NULL;
    }
}

static void keep_result(tr_path_result *r, const tr_contact_state *s) {
    r->Q_end = s->Q, r->q_end = s->q;
    r->merged = s->merged > r->merged ? s->merged : r->merged; /* an opening forgets the count too */
    r->moment_1_end = s->moment_1, r->moment_2_end = s->moment_2;
    r->Q_max = fmax(r->Q_max, fabs(s->Q));
    r->moment_max = fmax(r->moment_max, fmax(fabs(s->moment_1), fabs(s->moment_2)));
}

void tr_run_contact_row(tr_row *row, const tr_contact_state *s) {
    tr_row_add(row, s->law, "law");
    tr_row_add(row, (double)s->step, "step");
    tr_row_add(row, s->segment, "segment");
    tr_row_add(row, s->u_slide, "u_slide_m");
    tr_row_add(row, s->u_roll, "u_roll_m");
    tr_row_add(row, s->P, "P_N_per_m|P_N");
    tr_row_add(row, s->Q, "Q_N_per_m|Q_N");
    tr_row_add(row, s->q, "q");
    tr_row_add(row, s->a, "a_m");
    tr_row_add(row, s->moment_1, "moment_1_N|moment_1_N_m");
    tr_row_add(row, s->moment_2, "moment_2_N|moment_2_N_m");
    tr_row_add(row, s->f_r, "f_r_N_per_m|f_r_N");
    tr_row_add(row, s->overlap, "overlap_m");
}

static bool write_state(drive *d, const tr_contact_state *s, tr_status *st) {
    tr_row row = {.shape = d->scene->shape};
    tr_run_contact_row(&row, s);
    return tr_row_write_exact(&row, &d->table, st);
}

static bool play(drive *d, const tr_run_options *options, tr_status *st) {
    while (d->done < d->total) {
        if (tr_run_stopped(options))
            return tr_status_fail(st, TR_INTERRUPTED, "stopped at step %lld of %lld", (long long)d->done,
                                  (long long)d->total);
        if (!tr_contact_step(d->contact, d->state, st)) return false;
        for (int i = 0; i < d->scene->n_laws; i++) {
            keep_result(&d->result[i], &d->state[i]);
            if (!write_state(d, &d->state[i], st)) return false;
        }
        if (d->done++ % 256 == 0) tr_run_progress(options, "path", (double)d->done / (double)d->total);
    }
    return true;
}

/* The table gets its name whatever ended the run: its rows are whole. Returns st->code == TR_OK. */
static bool close_table(drive *d, const tr_run_options *options, tr_status *st) {
    tr_status closing = {0};
    bool kept = d->table.stream && d->done && tr_file_commit(&d->table, &closing);
    if (!kept) tr_file_discard(&d->table);
    if (closing.code) tr_status_fail(st, closing.code, "%s", closing.text);
    if (!st->code) return true;
    size_t used = strlen(st->text);
    snprintf(st->text + used, sizeof st->text - used,
             "\nkept in %s: %lld steps of contact.csv; not finished, no summary.json", options->dir,
             (long long)(kept ? d->done : 0));
    return false;
}

static bool plot(const drive *d, const tr_run_options *options, tr_run_report *report, tr_status *st) {
    if (!d->scene->output.curves) return true;
    if (!tr_plot_available())
        return tr_run_note(report, "no curves: gnuplot is not installed; contact.csv has the numbers"), true;
    char text[TR_MAX_LAWS][160];
    const char *label[TR_MAX_LAWS];
    for (int i = 0; i < d->scene->n_laws; i++) {
        const tr_path_result *r = &d->result[i];
        snprintf(text[i], sizeof text[i], "%d: %s%s%s", i, r->friction, d->rolling ? ", " : "",
                 d->rolling ? r->rolling : "");
        label[i] = text[i];
    }
    int code = 0;
    if (!tr_plot_contact(options->dir, label, d->scene->n_laws, d->rolling, d->scene->shape, &code, st)) return false;
    if (code) tr_run_note(report, "no curves: gnuplot failed (%d) on plot.gp; run it there to see why", code);
    return true;
}

static void report_contact(const drive *d, tr_run_report *r) {
    bool sphere = d->scene->shape == TR_SHAPE_SPHERE;
    tr_run_say(r, "segments, steps", "%d, %lld", d->scene->n_segments, (long long)d->total);
    tr_run_say_rows(d->scene, r);
    tr_run_say(r, "E_star, R_star", "%.6g Pa, %.6g m", d->scene->pair.E_star, d->scene->pair.R_star);
    for (int i = 0; i < d->scene->n_laws && i < 16; i++) {
        char label[24];
        snprintf(label, sizeof label, "laws.%d", i);
        tr_run_say(r, label,
                   sphere ? "%s, %s: at the end Q = %.6g N, moment_1 = %.6g N m"
                          : "%s, %s: at the end Q = %.6g N/m, moment_1 = %.6g N",
                   d->result[i].friction, d->result[i].rolling, d->result[i].Q_end, d->result[i].moment_1_end);
    }
}

static bool finish(const drive *d, const tr_run_options *options, double started, double stepping, tr_status *st) {
    tr_timing timing = {tr_run_clock() - started, (double)d->total * d->scene->n_laws / stepping};
    char *text = tr_summary_contact(d->scene, d->total, d->result, &timing, st);
    bool ok = text && tr_file_write(options->dir, "summary.json", text, st);
    free(text);
    return ok;
}

static bool run(const tr_scene *scene, const tr_run_options *options, tr_run_report *report, tr_status *st) {
    drive *d = tr_alloc(1, sizeof *d, st);
    if (!d) return false;
    d->scene = scene, d->total = tr_contact_steps(scene);
    name_laws(d);
    double started = tr_run_clock();
    bool ok = (d->contact = tr_contact_new(scene, st)) && tr_run_open(scene, options, NULL, report, st);
    if (ok) {
        double playing = tr_run_clock();
        if (tr_file_open(&d->table, options->dir, "contact.csv", st)) play(d, options, st);
        ok = close_table(d, options, st);
        double stepping = tr_run_clock() - playing;
        ok = ok && plot(d, options, report, st) && finish(d, options, started, stepping, st);
        if (ok) report_contact(d, report);
    }
    tr_contact_free(d->contact);
    free(d);
    return ok;
}

bool tr_run_with_path(const tr_scene *scene, tr_scene *played, tr_status *st) {
    *played = *scene;
    if (!scene->path_file || tr_path_read(played, st)) return true;
    free(played->path);
    return false;
}

void tr_run_drop_path(tr_scene *played) {
    if (played->path_file) free(played->path);
}

void tr_run_say_rows(const tr_scene *played, tr_run_report *report) {
    double roll = 0, slide = 0;
    if (!played->path_file) return;
    for (int i = 0; i < played->n_segments; i++) {
        const tr_scene_segment *g = &played->path[i];
        double a = tr_law_width(played->shape, g->force, played->pair.R_star, played->pair.E_star);
        if (a > 0) roll = fmax(roll, fabs(g->roll) / a), slide = fmax(slide, fabs(g->slide));
    }
    tr_run_say(report, "rows of the path", "straight between two; the longest rolls %.3g a, slides %.3g m%s", roll,
               slide, roll > 1 ? "; how the path bent in a row is not known" : "");
}

bool tr_run_contact(const tr_scene *scene, const tr_run_options *options, tr_run_report *report, tr_status *st) {
    tr_scene played;
    if (!tr_run_with_path(scene, &played, st)) return false;
    bool ok = run(&played, options, report, st);
    tr_run_drop_path(&played);
    return ok;
}

char *tr_run_check_path(const tr_scene *scene, tr_run_report *report, tr_status *st) {
    tr_scene played;
    drive d = {.scene = scene};
    const tr_patch_result patch = {.solver = ""};
    if (!tr_run_with_path(scene, &played, st)) return NULL;
    if (scene->kind == TR_KIND_CONTACT) tr_warn_contact(&played, report);
    tr_run_drop_path(&played);
    if (scene->kind == TR_KIND_PATCH) return tr_summary_patch(scene, 0, &patch, &(tr_timing){0}, st);
    name_laws(&d);
    return tr_summary_contact(scene, 0, d.result, &(tr_timing){0}, st);
}
