/* SPDX-License-Identifier: MIT */
/* The growing files and the film of a run. */
#ifndef TR_OUTPUTS_H
#define TR_OUTPUTS_H

#include "base/checkpoint.h"
#include "draw/draw.h"
#include "out/dir.h"
#include "out/table.h"
#include "study/film.h"
#include "study/recorder.h"
#include "study/report.h"

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

/* Files, film and recorder. To load: after they are opened for resuming. */
void tr_outputs_checkpoint(tr_outputs *o, tr_checkpoint *c);

typedef void tr_draw(tr_canvas *canvas, const tr_view *view);

typedef struct tr_outputs_wanted {
    const tr_scene *scene;
    const tr_run_options *options;
    const char *film; /* name of its file */
    int64_t total;    /* steps of the run */
    bool resume;      /* the files are continued */
} tr_outputs_wanted;

/* If the steps are too few for all outputs, a note says how many
 * fewer there will be. */
bool tr_outputs_open(tr_outputs *o, const tr_outputs_wanted *wanted, tr_run_report *report, tr_status *st);
/* What is due at step k of total: rows and frames are spread evenly from 0 to the end, lists of contacts end at the
 * end. */
enum { TR_DUE_ROW = 1, TR_DUE_FRAME = 2, TR_DUE_CONTACTS = 4 };
unsigned tr_outputs_due(const tr_outputs *o, int64_t k, int64_t total);

bool tr_outputs_row(tr_outputs *o, const tr_row *row, tr_status *st);
/* One instant of one scene; number: of several, -1: of one. The caller counts the instants. */
bool tr_outputs_contacts(tr_outputs *o, int number, double time, double strain, const tr_record *records, int n,
                         tr_status *st);
bool tr_outputs_frame(tr_outputs *o, tr_draw *draw, const tr_view *view, tr_status *st);

/* Gives the files their names after any end of the run: their rows are complete. A file that could not be written is
 * removed. It adds the list of kept files to the message of a failure. Returns st->code == TR_OK. */
bool tr_outputs_close(tr_outputs *o, tr_status *st);

#endif
