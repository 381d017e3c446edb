/* SPDX-License-Identifier: MIT */
/* The pictures of a run: frames/NNNNN.png, and a film of them where ffmpeg is there. */
#ifndef TR_STUDY_FILM_H
#define TR_STUDY_FILM_H

#include "draw/draw.h"
#include "study/run.h"

typedef struct tr_film {
    const char *dir;
    tr_canvas *canvas; /* to draw a frame on; NULL: no frames asked, Cairo untouched */
    tr_video *video;   /* NULL: no ffmpeg */
    int frames;        /* written so far */
} tr_film;

/* For that many frames; none: nothing happens. name: of the film, "biaxial.mp4". */
bool tr_film_open(tr_film *film, const char *dir, const char *name, int frames, tr_run_report *report, tr_status *st);

/* Keeps what the canvas shows as the next frame. */
bool tr_film_frame(tr_film *film, tr_status *st);

/* The film gets its name if there is a frame in it; true then. Failures go to st. */
bool tr_film_close(tr_film *film, tr_status *st);

#endif
