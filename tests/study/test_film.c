/* SPDX-License-Identifier: MIT */
/* Frames beside the solver: with one processor and with all the files are those of a canvas that is drawn on directly,
 * in their order, and ffmpeg gets their pixels in that order; what fails is told, ends the film there, and nothing
 * hangs.
 *
 * In the place of ffmpeg a script that keeps what it is sent. */
#include "assert_close.h"
#include "draw/canvas.h"
#include "draw/frame_biaxial.h"
#include "draw/frame_patch.h"
#include "draw/frame_show.h"
#include "draw/hand_made.h"
#include "out/manifest.h"
#include "study/film.h"

#include <dirent.h>
#include <errno.h>
#include <sched.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* More than the film holds at once. Every other one is a hundred times as much to draw, so that threads finish out of
 * order. */
enum { FRAMES = 10, N_BYTES = 4 * TR_FRAME_WIDTH * TR_FRAME_HEIGHT };

typedef struct fixture {
    char dir[64], path[600];
    cpu_set_t processors;
    tr_film film;
    tr_run_report report;
    hand_made *packing, *pair;
} fixture;

static char *in_dir(const fixture *f, const char *name) {
    static char path[4][128];
    static int turn;
    turn = (turn + 1) % 4;
    snprintf(path[turn], sizeof path[turn], "%s/%s", f->dir, name);
    return path[turn];
}

static void write_text(const char *path, const char *text) {
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    assert_int_equal(fclose(file), 0);
}

static int set_up(void **state) {
    fixture *f = *state = calloc(1, sizeof *f);
    strcpy(f->dir, "/tmp/test_film.XXXXXX");
    snprintf(f->path, sizeof f->path, "%.500s", getenv("PATH"));
    sched_getaffinity(0, sizeof f->processors, &f->processors);
    f->packing = hand_packing(60), f->pair = hand_pair(10e-3, 5e-3, 1.2, -2.4, 0.5, -1);
    alarm(300); /* a film that hangs */
    return mkdtemp(f->dir) ? 0 : -1;
}

static int tear_down(void **state) {
    fixture *f = *state;
    char command[100];
    alarm(0);
    setenv("PATH", f->path, 1);
    sched_setaffinity(0, sizeof f->processors, &f->processors);
    snprintf(command, sizeof command, "rm -r %s", f->dir);
    int gone = system(command);
    free(f->packing), free(f->pair), free(f);
    return gone;
}

/* The threads of a film follow the processors that the process may use. */
static void one_processor(const fixture *f) {
    cpu_set_t one;
    int first = 0;
    while (!CPU_ISSET(first, &f->processors)) first++;
    CPU_ZERO(&one);
    CPU_SET(first, &one);
    assert_int_equal(sched_setaffinity(0, sizeof one, &one), 0);
}

static int threads_now(void) {
    int n = 0;
    DIR *dir = opendir("/proc/self/task");
    for (struct dirent *e; (e = readdir(dir));) n += e->d_name[0] != '.';
    closedir(dir);
    return n;
}

/* A thread that was joined may stay in /proc a little longer. */
static void assert_threads(int wanted) {
    for (int k = 0; k < 1000 && threads_now() != wanted; k++) usleep(1000);
    assert_int_equal(threads_now(), wanted);
}

static void ffmpeg_is(const fixture *f, const char *script) {
    write_text(in_dir(f, "ffmpeg"), script);
    assert_int_equal(chmod(in_dir(f, "ffmpeg"), 0755), 0);
    char path[700];
    snprintf(path, sizeof path, "%s:%s", f->dir, f->path);
    setenv("PATH", path, 1);
}

static const char keeps_all[] = "#!/bin/sh\nfor last; do :; done\n"
                                "case $* in *pipe:0*) exec cat >\"${last#file:}\" ;; *) : >\"${last#file:}\" ;; esac\n";

/* A packing, two disks and the inside of a contact in turn. What they are made of is gone when the next is drawn. */
static void draw(fixture *f, tr_canvas *canvas, int k) {
    if (k % 2 == 0) {
        for (int i = 0; i < HAND_DISKS; i++) f->packing->pos[4 * i + 2] = k + i, f->packing->record[i].f_n = 20 + k * i;
        f->packing->view.time = 0.01 * k;
        tr_draw_biaxial(canvas, &f->packing->view);
        for (int i = 0; i < HAND_DISKS; i++) f->packing->pos[4 * i + 2] = f->packing->record[i].f_n = NAN;
    } else if (k % 4 == 1) {
        f->pair->pos[2] = 0.1 * k;
        tr_show_lane lane = hand_lane(f->pair);
        tr_show show = hand_show(&lane, 1);
        tr_draw_show(canvas, &show);
        f->pair->pos[2] = NAN;
    } else {
        tr_status st = {0};
        tr_patch_pair pair = {.R_star = 1e-3, .E_star = 1e9, .d = 1, .mu = 0.5};
        tr_patch_state inside;
        assert_true(tr_patch_state_new(&inside, &pair, 50, &st));
        tr_patch_state_grid(&inside, &pair, 1e3 * k);
        tr_draw_patch(canvas, &(tr_patch_view){.pair = &pair, .state = &inside, .v_roll = 1, .p_max = 1e9});
        tr_patch_state_free(&inside);
    }
}

static bool same_files(const char *p, const char *q) {
    char command[300];
    snprintf(command, sizeof command, "cmp -s %s %s", p, q);
    return system(command) == 0;
}

static int files_in(const char *path) {
    int n = 0;
    DIR *dir = opendir(path);
    for (struct dirent *e; (e = readdir(dir));) n += e->d_name[0] != '.';
    closedir(dir);
    return n;
}

/* Every frame is drawn once more, on a canvas, and compared with its file and with what ffmpeg was sent. */
static void whole_film(fixture *f) {
    tr_status st = {0};
    char name[32];
    ffmpeg_is(f, keeps_all);
    assert_true(tr_film_open(&f->film, f->dir, "x.mp4", FRAMES, &f->report, &st));
    for (int k = 0; k < FRAMES; k++) {
        draw(f, f->film.canvas, k);
        assert_true(tr_film_frame(&f->film, &st));
        assert_int_equal(f->film.frames, k + 1);
    }
    assert_true(tr_film_close(&f->film, &st));
    assert_int_equal(st.code, TR_OK);
    assert_int_equal(f->film.frames, FRAMES);
    assert_int_equal(files_in(in_dir(f, "frames")), FRAMES);
    tr_canvas *canvas = tr_canvas_create(&st);
    FILE *sent = fopen(in_dir(f, "x.mp4"), "rb");
    unsigned char *pixels = malloc(N_BYTES);
    for (int k = 0; k < FRAMES; k++) {
        draw(f, canvas, k);
        assert_true(tr_canvas_png(canvas, in_dir(f, "direct.png"), &st));
        snprintf(name, sizeof name, "frames/%05d.png", k);
        if (!same_files(in_dir(f, "direct.png"), in_dir(f, name))) fail_msg("%s differs", name);
        assert_int_equal(fread(pixels, 1, N_BYTES, sent), N_BYTES);
        if (memcmp(pixels, tr_canvas_pixels(canvas), N_BYTES)) fail_msg("ffmpeg was sent another frame %d", k);
    }
    assert_int_equal(fgetc(sent), EOF);
    fclose(sent), free(pixels), tr_canvas_free(canvas);
}

static void test_all_processors(void **state) {
    whole_film(*state);
}

static void test_one_processor(void **state) {
    one_processor(*state);
    whole_film(*state);
}

static void test_a_thread_for_each_processor(void **state) {
    fixture *f = *state;
    tr_status st = {0};
    setenv("PATH", "/nowhere", 1);
    for (int one = 0; one < 2; one++) {
        if (one) one_processor(f);
        int n = one ? 1 : CPU_COUNT(&f->processors), before = threads_now();
        assert_true(tr_film_open(&f->film, f->dir, "x.mp4", 2, &f->report, &st));
        assert_threads(before); /* none before there is a frame */
        draw(f, f->film.canvas, 0);
        assert_true(tr_film_frame(&f->film, &st));
        assert_threads(before + (n < 4 ? n : 4));
        assert_false(tr_film_close(&f->film, &st)); /* no film without ffmpeg */
        assert_int_equal(st.code, TR_OK);
        assert_int_equal(f->film.frames, 1);
        assert_threads(before);
    }
}

/* Draws until it is told of the failure, at the latest when the film is closed. */
static void fails(fixture *f, int frames, tr_status *st) {
    assert_true(tr_film_open(&f->film, f->dir, "x.mp4", 100, &f->report, st));
    for (int k = 0; k < frames && !st->code; k++) {
        draw(f, f->film.canvas, k);
        bool ok = tr_film_frame(&f->film, st);
        assert_int_equal(ok, !st->code);
    }
    tr_film_close(&f->film, st);
    assert_int_equal(st->code, TR_FILE);
}

/* Frame 3 goes to a full disk; the run draws on for a while, or ends with that frame. */
static void full_disk(fixture *f, int frames) {
    tr_status st = {0};
    setenv("PATH", "/nowhere", 1);
    assert_int_equal(mkdir(in_dir(f, "frames"), 0700), 0);
    assert_true(tr_manifest_add(f->dir, "frames/00003.png", &st)); /* or it would be taken for a file of the user's */
    assert_int_equal(symlink("/dev/full", in_dir(f, "frames/00003.png.part")), 0);
    fails(f, frames, &st);
    setenv("PATH", f->path, 1);
    assert_non_null(strstr(st.text, "frames/00003.png: "));
    assert_non_null(strstr(st.text, strerror(ENOSPC)));
    assert_int_equal(f->film.frames, 3);
    assert_int_equal(files_in(in_dir(f, "frames")), 3); /* none behind it, no part of it */
    assert_int_equal(access(in_dir(f, "frames/00002.png"), F_OK), 0);
    char command[100];
    snprintf(command, sizeof command, "rm -r %s/frames", f->dir);
    assert_int_equal(system(command), 0);
}

static void test_full_disk(void **state) {
    fixture *f = *state;
    full_disk(f, 40), full_disk(f, 4);
    one_processor(f);
    full_disk(f, 40), full_disk(f, 4);
}

/* It takes a frame and a bit. The picture that it broke off at is there. */
static void test_ffmpeg_gone(void **state) {
    fixture *f = *state;
    tr_status st = {0};
    ffmpeg_is(f, "#!/bin/sh\nhead -c 3700000 >/dev/null\necho worn out >&2\nexit 1\n");
    fails(f, 40, &st);
    assert_non_null(strstr(st.text, "x.mp4: ffmpeg stopped: "));
    assert_int_equal(files_in(in_dir(f, "frames")), f->film.frames);
    assert_int_equal(f->film.frames, 2); /* the socket does not hold the rest */
    assert_int_not_equal(access(in_dir(f, "x.mp4"), F_OK), 0);
}

/* A checkpoint finds all files there; the frames go on behind them, and the film is sent those before once more. */
static void test_checkpoint(void **state) {
    fixture *f = *state;
    tr_status st = {0}, instead = {0};
    tr_checkpoint c;
    ffmpeg_is(f, keeps_all);
    assert_true(tr_film_open(&f->film, f->dir, "x.mp4", FRAMES, &f->report, &st));
    for (int k = 0; k < 5; k++) {
        draw(f, f->film.canvas, k);
        assert_true(tr_film_frame(&f->film, &st));
    }
    tr_checkpoint_begin(&c, "case", &st);
    tr_film_checkpoint(&f->film, &c);
    assert_int_equal(files_in(in_dir(f, "frames")), 5);
    assert_true(tr_checkpoint_write(&c, f->dir, TR_CHECKPOINT));
    draw(f, f->film.canvas, 7); /* lost */
    assert_true(tr_film_frame(&f->film, &st));
    assert_true(tr_film_close(&f->film, &st));

    assert_true(tr_film_open(&f->film, f->dir, "x.mp4", FRAMES, &f->report, &st));
    assert_true(tr_checkpoint_open(&c, f->dir, TR_CHECKPOINT, "case", &instead, &st));
    tr_film_checkpoint(&f->film, &c);
    assert_true(tr_checkpoint_close(&c));
    assert_int_equal(f->film.frames, 5);
    draw(f, f->film.canvas, 5);
    assert_true(tr_film_frame(&f->film, &st));
    assert_true(tr_film_close(&f->film, &st));
    assert_int_equal(files_in(in_dir(f, "frames")), 6);
    tr_canvas *canvas = tr_canvas_create(&st);
    draw(f, canvas, 5);
    assert_true(tr_canvas_png(canvas, in_dir(f, "direct.png"), &st));
    assert_true(same_files(in_dir(f, "direct.png"), in_dir(f, "frames/00005.png")));
    tr_canvas_free(canvas);
    struct stat sent;
    assert_int_equal(stat(in_dir(f, "x.mp4"), &sent), 0);
    assert_int_equal(sent.st_size, 6 * N_BYTES);
}

/* Read by a leak-checking build: fontconfig keeps its caches to the end. */
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void) {
    return "leak:libfontconfig\n";
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_all_processors, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_one_processor, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_a_thread_for_each_processor, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_full_disk, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_ffmpeg_gone, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_checkpoint, set_up, tear_down),
    };
    return cmocka_run_group_tests_name("film", tests, NULL, NULL);
}
