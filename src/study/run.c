/* SPDX-License-Identifier: MIT */
#include "study/run_internal.h"

#include "laws/law.h"
#include "out/made.h"
#include "study/contact.h"
#include <assert.h>
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

/* A run that is to go on has reached its end already. One of another case is refused. */
static bool finished(const tr_scene *scene, const tr_run_options *options, tr_status *st) {
    char path[TR_PATH];
    char version[TR_SUMMARY_VERSION];
    if (!options->resume || !tr_dir_path(path, options->dir, "summary.json", st)) return false;
    if (!tr_summary_version(path, version, st) || !*version) return false;
    bool same = false;
    char *resolved = tr_scene_write(scene, tr_laws_catalog(), st);
    if (resolved) tr_dir_holds(options->dir, "case.yaml", resolved, &same, st);
    free(resolved);
    if (!same)
        tr_status_fail(st, TR_FILE, "error: %s holds a finished run of another case; give another -o", options->dir);
    return same;
}

void tr_run_remove_checkpoint(const char *dir, tr_run_report *report) {
    if (tr_checkpoint_remove(dir)) return;
    tr_run_note(report, "the checkpoint of this finished run could not be removed: %s; it is of no more use",
                strerror(errno));
}

static bool run(const tr_scene *scene, const tr_run_options *options, tr_run_report *report, tr_status *st) {
    if (finished(scene, options, st)) {
        char path[TR_PATH];
        bool ours;
        if (!tr_made_listed(options->dir, TR_CHECKPOINT, &ours, st)) return false;
        if (ours) tr_run_remove_checkpoint(options->dir, report); /* if it was killed right before that */
        tr_run_note(report, "nothing to resume: this run is finished");
        return tr_dir_path(path, options->dir, "summary.json", st) && tr_summary_failed(path, &report->failed, st);
    }
    if (st->code) return false;
    switch (scene->kind) {
    case TR_KIND_BIAXIAL:
        return tr_run_biaxial(scene, options, report, st);
    case TR_KIND_BODIES:
        return tr_run_bodies(scene, options, report, st);
    case TR_KIND_CONTACT:
        return tr_run_contact(scene, options, report, st);
    case TR_KIND_PATCH:
        return tr_run_patch(scene, options, report, st);
    }
    return false;
}

static char *check(const tr_scene *scene, tr_run_report *report, tr_status *st) {
    switch (scene->kind) {
    case TR_KIND_BIAXIAL:
        return tr_run_check_biaxial(scene, report, st);
    case TR_KIND_BODIES:
        return tr_run_check_bodies(scene, report, st);
    case TR_KIND_CONTACT:
    case TR_KIND_PATCH:
        return tr_run_check_path(scene, report, st);
    }
    return NULL;
}

bool tr_run_check(const tr_scene *scene, tr_run_report *report, char **summary, tr_status *st) {
    *report = (tr_run_report){0};
    char *text = check(scene, report, st);
    report->n_warnings = report->n_notes;
    bool ok = text;
    if (summary)
        *summary = text;
    else
        free(text);
    return ok;
}

bool tr_run(const tr_scene *scene, const tr_run_options *options, tr_run_report *report, tr_status *st) {
    int lock = -1;
    bool ok = tr_run_check(scene, report, NULL, st);
    if (ok && options->foretold) options->foretold(report);
    ok = ok && tr_dir_lock(options->dir, &lock, st) && run(scene, options, report, st);
    if (lock >= 0) close(lock);
    return ok;
}

/* Of all that the run reads. */
static bool spare_inputs(const tr_scene *scene, const tr_run_options *o, tr_status *st) {
    return tr_made_spare(o->dir, o->case_file, st) && tr_made_spare(o->dir, o->sample, st) &&
           tr_made_spare(o->dir, scene->path_file, st);
}

bool tr_run_open(const tr_scene *scene, const tr_run_options *options, tr_checkpoint *c, tr_run_report *report,
                 tr_status *st) {
    tr_checkpoint none;
    tr_status instead = {0};
    char *resolved = tr_scene_write(scene, tr_laws_catalog(), st);
    bool resume = resolved && options->resume &&
                  tr_checkpoint_open(c ? c : &none, options->dir, TR_CHECKPOINT, resolved, &instead, st);
    if (resume &&
        (!tr_made_add(options->dir, TR_CHECKPOINT, st) || !tr_made_spare(options->dir, options->sample, st))) {
        if (!c) free(none.bytes); /* c is the caller's, who frees its bytes */
        return free(resolved), false;
    }
    if (resume) tr_checkpoint_remove_part(options->dir);
    if (resume && instead.code) tr_run_note(report, "from the checkpoint before the last: %.150s", instead.text);
    bool ok = resume || (resolved && !st->code && spare_inputs(scene, options, st) &&
                         tr_made_clear(options->dir, options->force, st) &&
                         (!c || tr_made_add(options->dir, TR_CHECKPOINT, st)) &&
                         tr_file_write(options->dir, "case.yaml", resolved, st));
    free(resolved);
    return ok;
}

/* A run of few steps cannot give more than one row (frame) a step, and one list of contacts a step after the start. */
static int rows_of(int asked, int64_t total) {
    return asked <= total ? asked : (int)total + 1;
}

static int lists_of(int asked, int64_t total) {
    return asked <= total ? asked : (int)total;
}

static int64_t instant_of(int j, int n, int64_t total) {
    return n == 1 ? total : (int64_t)llround((double)total * j / (n - 1));
}

bool tr_run_is_due(int j, int n, int64_t k, int64_t total) {
    return j < n && k == instant_of(j, n, total);
}

bool tr_run_is_between(int j, int n, int64_t k, int64_t total) {
    if (j < 0 || j > n) return false;
    return (j == 0 || instant_of(j - 1, n, total) < k) && (j == n || instant_of(j, n, total) >= k);
}

unsigned tr_outputs_due(const tr_outputs *o, int64_t k, int64_t total) {
    const tr_scene_output *want = &o->scene->output;
    int lists = lists_of(want->contacts, total);
    unsigned due = tr_run_is_due(o->rows, rows_of(want->rows, total), k, total) ? TR_DUE_ROW : 0;
    if (tr_run_is_due(o->film.frames, rows_of(want->frames, total), k, total)) due |= TR_DUE_FRAME;
    if (tr_run_is_due(o->instants + 1, lists + 1, k, total)) due |= TR_DUE_CONTACTS;
    return due;
}

static void note_fewer(const tr_outputs *o, tr_run_report *report, int64_t total) {
    const tr_scene_output *want = &o->scene->output;
    int rows = rows_of(want->rows, total), frames = rows_of(want->frames, total),
        lists = lists_of(want->contacts, total);
    if (rows < want->rows || frames < want->frames || lists < want->contacts)
        tr_run_note(report, "the run has only %lld steps: %d rows, %d frames, %d instants of contacts",
                    (long long)total, rows, frames, lists);
}

bool tr_run_share(const tr_run_options *options, tr_world *world, tr_status *st) {
    if (options->share_few) world->alone_to = 0;
    return tr_world_set_threads(world, options->threads, st);
}

double tr_run_clock(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

void tr_run_say(tr_run_report *report, const char *label, const char *format, ...) {
    assert(report->n_lines < (int)(sizeof report->line / sizeof *report->line));
    struct tr_report_line *line = &report->line[report->n_lines++];
    va_list args;
    va_start(args, format);
    snprintf(line->label, sizeof line->label, "%s", label);
    vsnprintf(line->value, sizeof line->value, format, args);
    va_end(args);
}

/* "4.2 mm/s" */
static void shown_number(char *text, size_t size, double value, double largest, const char *unit) {
    static const char *const small[] = {"", "m", "µ", "n"}, *const large[] = {"", "k", "M", "G"};
    int k = 0;
    bool prefix = strcmp(unit, "m") == 0 || strcmp(unit, "m/s") == 0 || unit[0] == 'N' || unit[0] == 'W' ||
                  strcmp(unit, "s") == 0;
    while (prefix && k > -3 && largest != 0 && largest < 0.1) k--, largest *= 1e3, value *= 1e3;
    while (prefix && k < 3 && largest >= 1e4) k++, largest /= 1e3, value /= 1e3;
    const char *square = strstr(unit, "^2");
    int length = square ? (int)(square - unit) : (int)strlen(unit);
    bool apart = *unit && strcmp(unit, "°") != 0;
    snprintf(text, size, "%s%.4g%s%s%.*s%s", value < 0 ? "−" : "", fabs(value), apart ? " " : "",
             k < 0 ? small[-k] : large[k], length, unit, square ? "²" : "");
}

tr_show_check tr_run_shown_check(const tr_check_result *r, const tr_scene *scene, bool several) {
    static const char *const symbol[] = {[TR_SLIDING_VELOCITY] = "V_s", [TR_ROLLING_VELOCITY] = "V_r"};
    tr_scene_quantity q = tr_scene_what(r->check->what, r->shape);
    tr_show_check shown = {.ok = r->ok};
    double scale = 1, measured = r->measured, exact = r->check->exact;
    for (char *p = q.name; *p; p++)
        if (*p == '-') *p = ' ';
    const char *what = r->check->what <= TR_ROLLING_VELOCITY ? symbol[r->check->what] : q.name, *unit = q.unit;
    if (strcmp(unit, "rad") == 0) unit = "°", scale = 180 / M_PI;
    if (strcmp(unit, "1") == 0) unit = "";
    if (fabs(measured) < 0.01 * r->check->tolerance) measured = 0; /* rounding */
    snprintf(shown.group, sizeof shown.group, "%s", several ? r->lane : "");
    if (r->check->what == TR_POWER) unit = r->shape == TR_SHAPE_SPHERE ? "W" : "W/m";
    int used = snprintf(shown.what, sizeof shown.what, "%.24s", what);
    if (scene->n_disks > 1) used += snprintf(shown.what + used, sizeof shown.what - (size_t)used, ", %.9s", r->of);
    if (r->check->at > 0 && r->check->at < scene->time_end)
        snprintf(shown.what + used, sizeof shown.what - (size_t)used, ", %.3g s", r->check->at);
    double largest = fmax(fabs(measured), fabs(exact)) * scale;
    shown_number(shown.measured, sizeof shown.measured, measured * scale, largest, unit);
    shown_number(shown.exact, sizeof shown.exact, exact * scale, largest, unit);
    if (isnan(r->measured)) snprintf(shown.measured, sizeof shown.measured, "never");
    return shown;
}

void tr_run_say_check(tr_run_report *report, const tr_check_result *r, bool several) {
    tr_scene_quantity q = tr_scene_what(r->check->what, r->shape);
    const char *what = q.name, *unit = strcmp(q.unit, "1") == 0 ? "" : q.unit;
    double exact = r->check->exact, error = r->measured - exact;
    char label[40], number[48], off[32] = "";
    snprintf(label, sizeof label, "%s", what);
    snprintf(number, sizeof number, isnan(r->measured) ? "never happened" : "%.5g%s%s", r->measured, *unit ? " " : "",
             unit);
    if (!isnan(error)) snprintf(off, sizeof off, "error %.1e, ", error);
    tr_run_say(report, label, "%s%s%s: %s, exact %.5g%s%s, %sallowed %.1e: %s", r->of, several ? ", " : "",
               several ? r->lane : "", number, exact, *unit ? " " : "", unit, off, r->check->tolerance,
               r->ok ? "ok" : "FAILED");
    if (!r->ok) report->failed++;
}

void tr_run_note(tr_run_report *report, const char *format, ...) {
    assert(report->n_notes < (int)(sizeof report->note / sizeof *report->note));
    va_list args;
    va_start(args, format);
    vsnprintf(report->note[report->n_notes++], sizeof report->note[0], format, args);
    va_end(args);
}

bool tr_run_stopped(const tr_run_options *options) {
    return options->stop && *options->stop;
}

void tr_run_progress(const tr_run_options *options, const char *stage, double fraction) {
    if (options->progress) options->progress(options->context, stage, fraction);
}

bool tr_outputs_open(tr_outputs *o, const tr_scene *scene, const tr_run_options *options, const char *film,
                     int64_t total, bool resume, tr_run_report *report, tr_status *st) {
    bool (*open)(tr_file *, const char *, const char *, tr_status *) = resume ? tr_file_reopen : tr_file_open;
    *o = (tr_outputs){.scene = scene, .options = options};
    note_fewer(o, report, total);
    if (!open(&o->history, options->dir, "history.csv", st)) return false;
    if (scene->output.contacts && !open(&o->contacts, options->dir, "contacts.csv", st)) return false;
    int frames = scene->output.frames ? rows_of(scene->output.frames, total) : 0;
    return tr_film_open(&o->film, options->dir, film, frames, report, st);
}

void tr_outputs_checkpoint(tr_outputs *o, tr_checkpoint *c) {
    TR_KEEP(c, &o->rows, 1);
    TR_KEEP(c, &o->instants, 1);
    tr_file_checkpoint(&o->history, c);
    tr_file_checkpoint(&o->contacts, c);
    tr_film_checkpoint(&o->film, c);
    tr_recorder_checkpoint(&o->recorder, c);
    const tr_scene_output *want = &o->scene->output;
    const int64_t k = o->recorder.steps, total = o->recorder.total;
    const int lists = lists_of(want->contacts, total), frames = want->frames ? rows_of(want->frames, total) : 0;
    tr_checkpoint_check(c, tr_run_is_between(o->rows, rows_of(want->rows, total), k, total), "a number of rows");
    tr_checkpoint_check(c, tr_run_is_between(o->film.frames, frames, k, total), "a number of frames");
    bool none = !o->instants && (!lists || !k), some = o->instants >= 0 && o->instants <= lists;
    tr_checkpoint_check(c, none || (some && tr_run_is_between(o->instants + 1, lists + 1, k, total)),
                        "a number of instants");
    if (!c->loading && o->recorder.paths.picks.n) tr_checkpoint_sync(o->options->dir, "paths", c->st);
}

bool tr_outputs_row(tr_outputs *o, const tr_row *row, tr_status *st) {
    if (!tr_row_write(row, &o->history, st)) return false;
    o->rows++;
    return true;
}

bool tr_outputs_contacts(tr_outputs *o, int number, double time, double strain, const tr_record *records, int n,
                         tr_status *st) {
    const tr_record none = {0};
    for (int i = -1; i < n; i++) { /* the first for the header */
        tr_row row = {.shape = o->scene->shape};
        if (number >= 0) tr_row_add(&row, number, "scene");
        const tr_record *record = i < 0 ? &none : &records[i];
        tr_row_contact(&row, time, strain, record);
        if (o->scene->output.increments) tr_row_increment(&row, &record->increment);
        if (i < 0)
            tr_row_header(&row, &o->contacts);
        else if (!tr_row_write(&row, &o->contacts, st))
            return false;
    }
    return true;
}

bool tr_outputs_frame(tr_outputs *o, tr_draw *draw, const tr_view *view, tr_status *st) {
    draw(o->film.canvas, view);
    return tr_film_frame(&o->film, st);
}

/* Gives a table of n rows its name; one that could not be written is already gone. */
static bool close_table(tr_file *file, int n, tr_status *st) {
    if (file->stream && n) return tr_file_commit(file, st);
    tr_file_discard(file);
    return false;
}

bool tr_outputs_close(tr_outputs *o, tr_status *st) {
    tr_status closing = {0};
    bool table = close_table(&o->history, o->rows, &closing);
    close_table(&o->contacts, o->instants, &closing);
    tr_recorder_close(&o->recorder, &closing);
    bool film = tr_film_close(&o->film, &closing);
    free(o->records);
    o->records = NULL;
    if (closing.code) tr_status_fail(st, closing.code, "%s", closing.text);
    if (!st->code) return true;
    size_t used = strlen(st->text);
    snprintf(st->text + used, sizeof st->text - used,
             "\nkept in %s: %d rows of history.csv, %d frames%s; not finished, no summary.json", o->options->dir,
             table ? o->rows : 0, o->film.frames, film ? " and their film" : "");
    return false;
}
