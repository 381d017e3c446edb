/* SPDX-License-Identifier: MIT */
/* The pictures of a run: frames/NNNNN.png, and where ffmpeg is there a film of them, NAME.mp4, and NAME.gif
 * for slides. */
#ifndef TR_STUDY_FILM_H
#define TR_STUDY_FILM_H

#include "base/checkpoint.h"
#include "draw/draw.h"
#include "study/run.h"

typedef struct tr_film {
    const char *dir, *name;
    tr_canvas *canvas; /* to draw a frame on; NULL: no frames asked, Cairo untouched */
    tr_video *video;   /* NULL: no ffmpeg */
    int rate;          /* frames a second */
    int frames;        /* written so far */
    int synced;        /* of them, those that are on the disk for sure */
} tr_film;

/* How long a film of that many frames is [s]. */
double tr_film_seconds(int frames);

/* For that many frames; none: nothing happens. name: of the film, "biaxial.mp4". */
bool tr_film_open(tr_film *film, const char *dir, const char *name, int frames, tr_run_report *report, tr_status *st);

/* Keeps what the canvas shows as the next frame. */
bool tr_film_frame(tr_film *film, tr_status *st);

/* How many there are; they go to the disk, and to load, once more to the film. */
void tr_film_checkpoint(tr_film *film, tr_checkpoint *c);

/* The film gets its name if there is a frame in it; true then. Failures, of the GIF too, go to st. */
bool tr_film_close(tr_film *film, tr_status *st);

#endif
