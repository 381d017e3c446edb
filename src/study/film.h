/* SPDX-License-Identifier: MIT */
/* The pictures of a run: frames/NNNNN.png and, if ffmpeg is installed, a film of them, NAME.mp4, and NAME.gif for
 * slides.
 *
 * They are drawn beside the solver:
 *
 *     the run     draws on film.canvas, which only keeps the strokes      -> a queue of a few frames
 *     a crew one thread a processor, four at most, each with a canvas of its own: takes a frame, draws and encodes it,
 *                 waits for its turn, then writes the file and gives ffmpeg the pixels
 *
 * Files are written in the order of the frames, and none after the first failure. The run sees the failure at its next
 * frame, at a checkpoint or at the end. The strokes are a copy: frames do not see later steps of the solver, and the
 * solver only waits if the queue is full. Pixels do not depend on the number of threads. Rejected: copies of worlds
 * (each kind of picture would need its own), a process for each frame (the order must be kept, too). */
#ifndef TR_STUDY_FILM_H
#define TR_STUDY_FILM_H

#include "base/checkpoint.h"
#include "draw/video.h"
#include "study/report.h"

typedef struct tr_film {
    const char *dir, *name;
    tr_canvas *canvas; /* to draw the next frame on; NULL: no frames asked, Cairo untouched */
    tr_video *video;   /* NULL: no ffmpeg */
    int rate;          /* frames a second */
    int frames;        /* so far; after closing, those that were written */
    int synced;        /* of them, those that are on the disk for sure */
    struct tr_film_crew *crew;
} tr_film;

/* Length of a film of that many frames [s]. */
double tr_film_seconds(int frames);

/* For that many frames; 0: does nothing. name: of the film, "biaxial.mp4". The film must not move until it is
 * closed. */
bool tr_film_open(tr_film *film, const char *dir, const char *name, int frames, tr_run_report *report, tr_status *st);

/* Takes the drawing on the canvas as the next frame. False: an earlier one has failed. */
bool tr_film_frame(tr_film *film, tr_status *st);

/* The number of frames. To save, they go to the disk; to load, they go to the film again. */
void tr_film_checkpoint(tr_film *film, tr_checkpoint *c);

/* The film gets its name if it has a frame; true then. Failures, of the GIF too, go to st. */
bool tr_film_close(tr_film *film, tr_status *st);

#endif
