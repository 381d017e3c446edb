/* SPDX-License-Identifier: MIT */
#include "study/run_internal.h"

#include "laws/law.h"
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

bool tr_run(const tr_scene *scene, const tr_run_options *options, tr_run_report *report, tr_status *st) {
    *report = (tr_run_report){0};
    if (!tr_dir_open(options->dir, options->force, st)) return false;
    char *resolved = tr_scene_write(scene, tr_laws_catalog(), st);
    bool ok = resolved && tr_file_write(options->dir, "case.yaml", resolved, st);
    free(resolved);
    if (!ok) return false;
    return scene->kind == TR_KIND_BIAXIAL ? tr_run_biaxial(scene, options, report, st)
                                          : tr_run_bodies(scene, options, report, st);
}

/* Item j of n, from 0 to the end; a single one at the end. */
static bool is_due(int j, int n, int64_t k, int64_t total) {
    return j < n && k == (n == 1 ? total : (int64_t)llround((double)total * j / (n - 1)));
}

unsigned tr_outputs_due(const tr_outputs *o, int64_t k, int64_t total) {
    const tr_scene_output *want = &o->scene->output;
    unsigned due = is_due(o->rows, want->rows, k, total) ? TR_DUE_ROW : 0;
    if (is_due(o->frames, want->frames, k, total)) due |= TR_DUE_FRAME;
    if (o->instants < want->contacts && k == total * (o->instants + 1) / want->contacts) due |= TR_DUE_CONTACTS;
    return due;
}

double tr_run_clock(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

void tr_run_say(tr_run_report *report, const char *label, const char *format, ...) {
    struct tr_report_line *line = &report->line[report->n_lines++];
    va_list args;
    va_start(args, format);
    snprintf(line->label, sizeof line->label, "%s", label);
    vsnprintf(line->value, sizeof line->value, format, args);
    va_end(args);
}

void tr_run_note(tr_run_report *report, const char *format, ...) {
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

/* A film of a few frames should last long enough to see them: half as many a second as there are, within 5..30. */
static int frame_rate(int frames) {
    return (int)fmax(5, fmin(30, frames / 4.0));
}

bool tr_outputs_open(tr_outputs *o, const tr_scene *scene, const tr_run_options *options, const char *film,
                     tr_run_report *report, tr_status *st) {
    *o = (tr_outputs){.scene = scene, .options = options};
    char path[TR_PATH];
    if (!tr_file_open(&o->history, options->dir, "history.csv", st)) return false;
    if (scene->output.contacts && !tr_file_open(&o->contacts, options->dir, "contacts.csv", st)) return false;
    if (!scene->output.frames) return true;
    if (!tr_dir_path(path, options->dir, "frames", st)) return false;
    if (mkdir(path, 0777) && errno != EEXIST)
        return tr_status_fail(st, TR_FILE, "error: cannot make directory %s: %s", path, strerror(errno));
    if (!(o->canvas = tr_canvas_create(st))) return false;
    if (!tr_video_available())
        return tr_run_note(report, "no film: ffmpeg is not installed; frames/ has the pictures"), true;
    if (!tr_dir_path(path, options->dir, film, st)) return false;
    return (o->video = tr_video_open(path, frame_rate(scene->output.frames), st)) != NULL;
}

bool tr_outputs_row(tr_outputs *o, const tr_row *row, tr_status *st) {
    o->rows++;
    return tr_row_write(row, &o->history, st);
}

bool tr_outputs_contacts(tr_outputs *o, double time, double strain, int n_records, tr_status *st) {
    o->instants++;
    for (int i = 0; i < n_records; i++) {
        tr_row row;
        tr_row_contact(&row, time, strain, &o->records[i]);
        if (!tr_row_write(&row, &o->contacts, st)) return false;
    }
    return true;
}

bool tr_outputs_frame(tr_outputs *o, tr_draw *draw, const tr_view *view, tr_status *st) {
    char path[TR_PATH + 32];
    draw(o->canvas, view);
    snprintf(path, sizeof path, "%s/frames/%05d.png", o->options->dir, o->frames++);
    return tr_canvas_png(o->canvas, path, st) && (!o->video || tr_video_frame(o->video, o->canvas, st));
}

bool tr_outputs_close(tr_outputs *o, tr_status *st) {
    bool keep = st->code != TR_FILE;
    tr_status closing = {0};
    if (keep && o->rows)
        tr_file_commit(&o->history, &closing);
    else
        tr_file_discard(&o->history);
    if (keep && o->instants)
        tr_file_commit(&o->contacts, &closing);
    else
        tr_file_discard(&o->contacts);
    tr_video_close(o->video, keep && o->frames, &closing);
    tr_canvas_free(o->canvas);
    free(o->records);
    if (closing.code && keep) tr_status_fail(st, closing.code, "%s", closing.text);
    if (st->code == TR_INTERRUPTED || st->code == TR_NUMERICAL) {
        size_t used = strlen(st->text);
        snprintf(st->text + used, sizeof st->text - used,
                 "\nkept in %s: %d rows of history.csv, %d frames%s; not finished, no summary.json", o->options->dir,
                 o->rows, o->frames, o->video && o->frames ? " and their film" : "");
    }
    return st->code == TR_OK;
}
