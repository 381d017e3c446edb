/* SPDX-License-Identifier: MIT */
#include "study/outputs.h"

#include "study/schedule.h"
#include <stdlib.h>
#include <string.h>

/* A run of few steps gives at most one row (frame) a step, and one list of contacts a step after the start. */
static int rows_of(int asked, int64_t total) {
    return asked <= total ? asked : (int)total + 1;
}

static int lists_of(int asked, int64_t total) {
    return asked <= total ? asked : (int)total;
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

bool tr_outputs_open(tr_outputs *o, const tr_outputs_wanted *wanted, tr_run_report *report, tr_status *st) {
    bool (*open)(tr_file *, const char *, const char *, tr_status *) = wanted->resume ? tr_file_reopen : tr_file_open;
    const tr_scene *scene = wanted->scene;
    const tr_run_options *options = wanted->options;
    *o = (tr_outputs){.scene = scene, .options = options};
    note_fewer(o, report, wanted->total);
    if (!open(&o->history, options->dir, "history.csv", st)) return false;
    if (scene->output.contacts && !open(&o->contacts, options->dir, "contacts.csv", st)) return false;
    int frames = scene->output.frames ? rows_of(scene->output.frames, wanted->total) : 0;
    return tr_film_open(&o->film, options->dir, wanted->film, frames, report, st);
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
    if (!c->loading && o->recorder.paths.contacts.n) tr_checkpoint_sync(o->options->dir, "paths", c->st);
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
