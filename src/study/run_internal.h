/* SPDX-License-Identifier: MIT */
/* What the kinds of run share. */
#ifndef TR_RUN_INTERNAL_H
#define TR_RUN_INTERNAL_H

#include "base/checkpoint.h"
#include "draw/draw.h"
#include "out/dir.h"
#include "out/summary.h"
#include "out/table.h"
#include "study/contact.h"
#include "study/film.h"
#include "study/recorder.h"
#include "study/run.h"

bool tr_run_biaxial(const tr_scene *scene, const tr_run_options *options, tr_run_report *report, tr_status *st);
bool tr_run_bodies(const tr_scene *scene, const tr_run_options *options, tr_run_report *report, tr_status *st);
bool tr_run_contact(const tr_scene *scene, const tr_run_options *options, tr_run_report *report, tr_status *st);
bool tr_run_patch(const tr_scene *scene, const tr_run_options *options, tr_run_report *report, tr_status *st);

/* What tr_run_check finds: NULL, or else the summary to come. */
char *tr_run_check_biaxial(const tr_scene *scene, tr_run_report *report, tr_status *st);
char *tr_run_check_bodies(const tr_scene *scene, tr_run_report *report, tr_status *st);
/* Reads the path of a file. */
char *tr_run_check_path(const tr_scene *scene, tr_run_report *report, tr_status *st);

/* The scene with its path from the file, if it is in one. Free with tr_run_drop_path. */
bool tr_run_with_path(const tr_scene *scene, tr_scene *played, tr_status *st);
void tr_run_drop_path(tr_scene *played);
/* What the rows of a file leave out. */
void tr_run_say_rows(const tr_scene *played, tr_run_report *report);

/* One row of contact.csv. */
void tr_run_contact_row(tr_row *row, const tr_contact_state *s);

/* What stays the same in every frame of a biaxial test: one scale and one box for the whole film. */
enum { TR_RUN_TITLE = 96 };
tr_view tr_run_biaxial_view(const tr_biaxial *b, char title[TR_RUN_TITLE]);

/* Of a finished run. A note in the report tells if it cannot be removed. */
void tr_run_remove_checkpoint(const char *dir, tr_run_report *report);

/* Empties the directory and writes the resolved case into it; or, with options->resume, opens the checkpoint that is there:
 * then c->loading, and nothing is touched. c NULL: this kind has none. */
bool tr_run_open(const tr_scene *scene, const tr_run_options *options, tr_checkpoint *c, tr_run_report *report,
                 tr_status *st);

/* Gives the world its threads. */
bool tr_run_share(const tr_run_options *options, tr_world *world, tr_status *st);

double tr_run_clock(void); /* wall time [s] */

void tr_run_say(tr_run_report *report, const char *label, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
/* A check as a line of the report, and as a still shows it. several: with the label of its scene, which is one of them. */
void tr_run_say_check(tr_run_report *report, const tr_check_result *result, bool several);
tr_show_check tr_run_shown_check(const tr_check_result *result, const tr_scene *scene, bool several);
void tr_run_note(tr_run_report *report, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* Item j of n, from 0 to the end; a single one at the end. n <= total + 1, so no two fall on one step. */
bool tr_run_is_due(int j, int n, int64_t k, int64_t total);
/* Before step k: j items have been due. */
bool tr_run_is_between(int j, int n, int64_t k, int64_t total);
bool tr_run_stopped(const tr_run_options *options);
void tr_run_progress(const tr_run_options *options, const char *stage, double fraction);

/* The growing files and the film of a run. */
typedef struct tr_outputs {
    const tr_scene *scene;
    const tr_run_options *options;
    tr_file history, contacts;
    tr_film film;
    tr_recorder recorder;
    int rows, instants; /* written so far */
    tr_record *records;
    int capacity;
    double seconds; /* spent in them; the caller adds it up */
} tr_outputs;

/* Files, film and recorder. To load: after they are opened to be resumed. */
void tr_outputs_checkpoint(tr_outputs *o, tr_checkpoint *c);

typedef void tr_draw(tr_canvas *canvas, const tr_view *view);

/* total: steps of the run. resume: the files go on. When they are too few for all that is asked, a note says how much less there will be. */
bool tr_outputs_open(tr_outputs *o, const tr_scene *scene, const tr_run_options *options, const char *film,
                     int64_t total, bool resume, tr_run_report *report, tr_status *st);
/* What is due at step k of total: rows and frames are spread evenly from 0 to the end, lists of contacts end at the
 * end. */
enum { TR_DUE_ROW = 1, TR_DUE_FRAME = 2, TR_DUE_CONTACTS = 4 };
unsigned tr_outputs_due(const tr_outputs *o, int64_t k, int64_t total);

bool tr_outputs_row(tr_outputs *o, const tr_row *row, tr_status *st);
/* One instant of one scene; number: of several, -1: of one. The caller counts the instants. */
bool tr_outputs_contacts(tr_outputs *o, int number, double time, double strain, const tr_record *records, int n,
                         tr_status *st);
bool tr_outputs_frame(tr_outputs *o, tr_draw *draw, const tr_view *view, tr_status *st);

/* Gives the files their names, whatever ended the run: their rows are whole. A file that could not be written is
 * removed. To the message of a failure it adds what was kept. Returns st->code == TR_OK. */
bool tr_outputs_close(tr_outputs *o, tr_status *st);

#endif
