/* SPDX-License-Identifier: MIT */
#include "study/film.h"

#include "base/alloc.h"
#include "base/threads.h"
#include "draw/canvas.h"
#include "draw/video.h"
#include "out/dir.h"
#include "out/manifest.h"
#include <math.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 4, QUEUE = MOST + 2 }; /* threads; frames under way */

typedef struct tr_film_crew {
    pthread_mutex_t lock; /* of all below */
    pthread_cond_t changed;
    pthread_t thread[MOST];
    int n;
    tr_canvas *queue[QUEUE];         /* the strokes of frame k, in k % QUEUE */
    int given, taken, done, written; /* frames; done: number of the next to be written */
    bool closing;
    tr_status failure; /* the first; after it nothing is written */
} tr_film_crew;

/* Frames a second: a film of a few frames lasts four seconds, but is never too slow. */
static int frame_rate(int frames) {
    return (int)fmax(5, fmin(30, frames / 4.0));
}

double tr_film_seconds(int frames) {
    return frames / (double)frame_rate(frames);
}

static bool write_frame(tr_film *film, int k, const tr_canvas *canvas, tr_status *st) {
    char path[TR_PATH + 32];
    snprintf(path, sizeof path, "%s/frames/%05d.png", film->dir, k);
    if (!tr_canvas_write(canvas, path, st)) return false;
    film->crew->written++;
    return !film->video || tr_video_frame(film->video, canvas, st);
}

/* The next frame and its strokes; -1: no more frames. */
static int take(tr_film_crew *crew, tr_canvas **strokes) {
    pthread_mutex_lock(&crew->lock);
    while (crew->taken == crew->given && !crew->closing) pthread_cond_wait(&crew->changed, &crew->lock);
    int k = crew->taken < crew->given ? crew->taken++ : -1;
    if (k >= 0) *strokes = crew->queue[k % QUEUE];
    pthread_mutex_unlock(&crew->lock);
    return k;
}

/* In order. canvas NULL: it could not be drawn, st has the reason. */
static void hand_over(tr_film *film, int k, const tr_canvas *canvas, tr_status *st) {
    tr_film_crew *crew = film->crew;
    pthread_mutex_lock(&crew->lock);
    while (crew->done < k) pthread_cond_wait(&crew->changed, &crew->lock);
    bool failed = crew->failure.code;
    pthread_mutex_unlock(&crew->lock);
    if (!failed && canvas) write_frame(film, k, canvas, st);
    pthread_mutex_lock(&crew->lock);
    if (!failed) crew->failure = *st;
    crew->done++;
    pthread_cond_broadcast(&crew->changed);
    pthread_mutex_unlock(&crew->lock);
}

static void *work(void *context) {
    tr_film *film = context;
    tr_status st = {0};
    tr_canvas *canvas = tr_canvas_create(&st), *strokes;
    for (int k; (k = take(film->crew, &strokes)) >= 0;) {
        bool drawn = canvas && tr_canvas_replay(canvas, strokes, &st) && tr_canvas_encode(canvas, &st);
        tr_canvas_free(strokes);
        hand_over(film, k, drawn ? canvas : NULL, &st);
    }
    tr_canvas_free(canvas);
    return NULL;
}

/* At the first frame of the process, also in a resumed run. */
static bool hire(tr_film *film, tr_status *st) {
    int error = 0;
    tr_film_crew *crew = film->crew = tr_alloc(1, sizeof *crew, st);
    if (!crew) return false;
    pthread_mutex_init(&crew->lock, NULL);
    pthread_cond_init(&crew->changed, NULL);
    crew->given = crew->taken = crew->done = crew->written = film->frames;
    for (int n = tr_processors(); !error && crew->n < n && crew->n < MOST; crew->n += !error)
        error = pthread_create(&crew->thread[crew->n], NULL, work, film);
    return crew->n || tr_status_fail(st, TR_FILE, "error: no thread to draw frames: %s", strerror(error));
}

/* Waits until at most that many frames are not yet written. False: one has failed. */
static bool wait_for(tr_film *film, int left, tr_status *st) {
    tr_film_crew *crew = film->crew;
    pthread_mutex_lock(&crew->lock);
    while (crew->given - crew->done > left) pthread_cond_wait(&crew->changed, &crew->lock);
    if (crew->failure.code) tr_status_fail(st, crew->failure.code, "%s", crew->failure.text);
    pthread_mutex_unlock(&crew->lock);
    return !st->code;
}

static void dismiss(tr_film *film, tr_status *st) {
    tr_film_crew *crew = film->crew;
    wait_for(film, 0, st);
    pthread_mutex_lock(&crew->lock);
    crew->closing = true;
    pthread_cond_broadcast(&crew->changed);
    pthread_mutex_unlock(&crew->lock);
    for (int i = 0; i < crew->n; i++) pthread_join(crew->thread[i], NULL);
    pthread_cond_destroy(&crew->changed);
    pthread_mutex_destroy(&crew->lock);
    film->frames = crew->written;
    free(crew);
    film->crew = NULL;
}

/* NAME.gif of NAME.mp4 */
static void name_gif(char *gif, size_t size, const char *mp4) {
    snprintf(gif, size, "%.*s.gif", (int)(strrchr(mp4, '.') - mp4), mp4);
}

static bool add_films(const char *dir, const char *name, tr_status *st) {
    char gif[32];
    name_gif(gif, sizeof gif, name);
    return tr_manifest_add(dir, name, st) && tr_manifest_add(dir, gif, st);
}

bool tr_film_open(tr_film *film, const char *dir, const char *name, int frames, tr_run_report *report, tr_status *st) {
    *film = (tr_film){.dir = dir, .name = name, .rate = frame_rate(frames)};
    if (!frames) return true;
    char path[TR_PATH];
    if (!tr_dir_make(dir, "frames", st) || !tr_manifest_add_frames(dir, frames, st) ||
        !(film->canvas = tr_canvas_record(NULL, st)))
        return false;
    if (!tr_video_available())
        tr_run_note(report, "no film: ffmpeg is not installed; frames/ has the pictures");
    else if (!add_films(dir, name, st) || !tr_dir_path(path, dir, name, st) ||
             !(film->video = tr_video_open(path, film->rate, st)))
        return false;
    return true;
}

bool tr_film_frame(tr_film *film, tr_status *st) {
    if (!film->crew && !hire(film, st)) return false;
    tr_film_crew *crew = film->crew;
    tr_canvas *next = wait_for(film, QUEUE - 1, st) ? tr_canvas_record(film->canvas, st) : NULL;
    if (!next) return false;
    pthread_mutex_lock(&crew->lock);
    crew->queue[crew->given++ % QUEUE] = film->canvas;
    pthread_cond_broadcast(&crew->changed);
    pthread_mutex_unlock(&crew->lock);
    film->canvas = next, film->frames++;
    return true;
}

void tr_film_checkpoint(tr_film *film, tr_checkpoint *c) {
    char name[32], path[TR_PATH + 32];
    if (film->crew) wait_for(film, 0, c->st);
    TR_KEEP(c, &film->frames, 1);
    tr_canvas *shown = c->loading && film->video ? tr_canvas_create(c->st) : NULL;
    for (; !c->st->code && film->synced < film->frames; film->synced++) {
        snprintf(name, sizeof name, "frames/%05d.png", film->synced);
        snprintf(path, sizeof path, "%s/%s", film->dir, name);
        if (!c->loading)
            tr_checkpoint_sync(film->dir, name, c->st);
        else if (shown && tr_canvas_load(shown, path, c->st))
            tr_video_frame(film->video, shown, c->st);
    }
    tr_canvas_free(shown);
    if (!c->loading) tr_checkpoint_sync(film->dir, "frames", c->st);
}

static bool make_gif(const tr_film *film, tr_status *st) {
    char mp4[TR_PATH], gif[TR_PATH];
    if (!tr_dir_path(mp4, film->dir, film->name, st)) return false;
    name_gif(gif, sizeof gif, mp4);
    return tr_video_gif(mp4, gif, film->rate, st);
}

bool tr_film_close(tr_film *film, tr_status *st) {
    if (film->crew) dismiss(film, st);
    bool kept = film->video && tr_video_close(film->video, film->frames > 0, st);
    tr_canvas_free(film->canvas);
    film->video = NULL, film->canvas = NULL;
    if (kept) make_gif(film, st);
    return kept;
}
