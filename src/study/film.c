/* SPDX-License-Identifier: MIT */
#include "study/film.h"

#include "out/dir.h"
#include "study/run_internal.h"
#include <math.h>
#include <string.h>

/* Frames a second: a film of a few frames lasts four seconds, but never crawls. */
static int frame_rate(int frames) {
    return (int)fmax(5, fmin(30, frames / 4.0));
}

double tr_film_seconds(int frames) {
    return frames / (double)frame_rate(frames);
}

bool tr_film_open(tr_film *film, const char *dir, const char *name, int frames, tr_run_report *report, tr_status *st) {
    *film = (tr_film){.dir = dir, .name = name, .rate = frame_rate(frames)};
    if (!frames) return true;
    char path[TR_PATH];
    if (!tr_dir_make(dir, "frames", st) || !(film->canvas = tr_canvas_create(st))) return false;
    if (!tr_video_available())
        return tr_run_note(report, "no film: ffmpeg is not installed; frames/ has the pictures"), true;
    if (!tr_dir_path(path, dir, name, st)) return false;
    return (film->video = tr_video_open(path, film->rate, st)) != NULL;
}

bool tr_film_frame(tr_film *film, tr_status *st) {
    char path[TR_PATH + 32];
    snprintf(path, sizeof path, "%s/frames/%05d.png", film->dir, film->frames);
    if (!tr_canvas_png(film->canvas, path, st)) return false;
    film->frames++;
    return !film->video || tr_video_frame(film->video, film->canvas, st);
}

void tr_film_checkpoint(tr_film *film, tr_checkpoint *c) {
    char name[32], path[TR_PATH + 32];
    TR_KEEP(c, &film->frames, 1);
    for (; !c->st->code && film->synced < film->frames; film->synced++) {
        snprintf(name, sizeof name, "frames/%05d.png", film->synced);
        snprintf(path, sizeof path, "%s/%s", film->dir, name);
        if (!c->loading)
            tr_checkpoint_sync(film->dir, name, c->st);
        else if (film->video && tr_canvas_load(film->canvas, path, c->st))
            tr_video_frame(film->video, film->canvas, c->st);
    }
    if (!c->loading) tr_checkpoint_sync(film->dir, "frames", c->st);
}

/* NAME.gif of NAME.mp4 */
static bool make_gif(const tr_film *film, tr_status *st) {
    char mp4[TR_PATH], gif[TR_PATH];
    if (!tr_dir_path(mp4, film->dir, film->name, st)) return false;
    strcpy(strrchr(strcpy(gif, mp4), '.'), ".gif");
    return tr_video_gif(mp4, gif, film->rate, st);
}

bool tr_film_close(tr_film *film, tr_status *st) {
    bool kept = film->video && tr_video_close(film->video, film->frames > 0, st);
    tr_canvas_free(film->canvas);
    film->video = NULL, film->canvas = NULL;
    if (kept) make_gif(film, st);
    return kept;
}
