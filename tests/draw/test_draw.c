/* SPDX-License-Identifier: MIT */
/* Pictures: files that are whole or absent, colours in order, geometry of the arcs, nothing that a bad number can
 * break. */
#include "assert_close.h"
#include "draw/arc.h"
#include "draw/canvas.h"
#include "draw/field.h"
#include "draw/frame_biaxial.h"
#include "draw/frame_show.h"
#include "draw/hand_made.h"
#include "draw/frame.h"
#include "draw/palette.h"
#include "draw/video.h"
#include <dirent.h>
#include <errno.h>
#include <png.h>
#include <signal.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { N_BYTES = 4 * TR_FRAME_WIDTH * TR_FRAME_HEIGHT };

typedef struct fixture {
    tr_canvas *canvas;
    char dir[64];
} fixture;

static int set_up(void **state) {
    fixture *f = calloc(1, sizeof *f);
    tr_status st = {0};
    strcpy(f->dir, "/tmp/test_draw.XXXXXX");
    f->canvas = tr_canvas_create(&st);
    *state = f;
    return f->canvas && mkdtemp(f->dir) ? 0 : -1;
}

static int tear_down(void **state) {
    fixture *f = *state;
    tr_canvas_free(f->canvas);
    DIR *dir = opendir(f->dir);
    for (struct dirent *e; dir && (e = readdir(dir));) unlinkat(dirfd(dir), e->d_name, 0);
    if (dir) closedir(dir);
    int gone = rmdir(f->dir);
    free(f);
    return gone;
}

static char *in_dir(const fixture *f, const char *name) {
    static char path[4][128];
    static int turn;
    turn = (turn + 1) % 4;
    snprintf(path[turn], sizeof path[turn], "%s/%s", f->dir, name);
    return path[turn];
}

static bool exists(const char *path) {
    struct stat s;
    return lstat(path, &s) == 0;
}

/* 0xRRGGBB */
static unsigned pixel(const tr_canvas *canvas, int x, int y) {
    const unsigned char *p = tr_canvas_pixels(canvas) + 4 * (y * TR_FRAME_WIDTH + x);
    return (unsigned)p[2] << 16 | (unsigned)p[1] << 8 | p[0];
}

/* Pixels of exactly this colour in the picture area, in rows y0 <= y < y1. */
static int count(const tr_canvas *canvas, unsigned hue, int y0, int y1) {
    int n = 0;
    for (int y = y0; y < y1; y++)
        for (int x = 0; x < 840; x++) n += pixel(canvas, x, y) == hue;
    return n;
}

/* CIE L*, 0..100, from sRGB. */
static double lightness(tr_rgb c) {
    double in[] = {c.r, c.g, c.b}, weight[] = {0.2126, 0.7152, 0.0722}, Y = 0;
    for (int k = 0; k < 3; k++) {
        assert_true(in[k] >= 0 && in[k] <= 1);
        Y += weight[k] * (in[k] <= 0.04045 ? in[k] / 12.92 : pow((in[k] + 0.055) / 1.055, 2.4));
    }
    return 116 * cbrt(Y) - 16;
}

static void test_palette_falls_in_lightness(void **state) {
    (void)state;
    for (int i = 0; i < 200; i++) {
        double u = i / 200.0, v = (i + 1) / 200.0;
        for (tr_ramp ramp = TR_RAMP_PLAIN; ramp <= TR_RAMP_ROLLING; ramp++)
            assert_true(lightness(tr_palette_ramp(ramp, v)) < lightness(tr_palette_ramp(ramp, u)) - 0.1);
        assert_true(lightness(tr_palette_diverging(v)) < lightness(tr_palette_diverging(u)) - 0.1);
        assert_true(lightness(tr_palette_diverging(-v)) < lightness(tr_palette_diverging(-u)) - 0.1);
    }
    for (tr_ramp ramp = TR_RAMP_PLAIN; ramp <= TR_RAMP_ROLLING; ramp++)
        assert_true(lightness(tr_palette_ramp(ramp, 0)) - lightness(tr_palette_ramp(ramp, 1)) > 60);
}

/* Relative luminance and contrast as WCAG 2.1 defines them. */
static double luminance(unsigned hue) {
    double Y = (lightness(tr_palette_hue(hue)) + 16) / 116;
    return Y * Y * Y;
}

static double contrast(unsigned p, unsigned q) {
    double high = fmax(luminance(p), luminance(q)), low = fmin(luminance(p), luminance(q));
    return (high + 0.05) / (low + 0.05);
}

/* 4.5: what WCAG asks of text. 2: two greys that are told apart side by side. */
static void test_sliding_and_rolling_are_read_and_differ_in_grey(void **state) {
    (void)state;
    const unsigned text[] = {TR_INK, TR_FAINT, TR_SLIDES, TR_ROLLS, TR_GREEN, TR_PURPLE, TR_ARC_A, TR_ARC_B};
    for (int i = 0; i < 8; i++)
        if (!(contrast(text[i], TR_WHITE) >= 4.5))
            fail_msg("#%06X has a contrast of %g", text[i], contrast(text[i], TR_WHITE));
    assert_true(contrast(TR_SLIDES, TR_ROLLS) > 2);
}

static double linear(double c) {
    return c <= 0.04045 ? c / 12.92 : pow((c + 0.055) / 1.055, 2.4);
}

/* As seen without one kind of cones, in linear sRGB: Machado, Oliveira & Fernandes (2009), severity 1. */
static void as_seen(int kind, unsigned hue, double seen[3]) {
    static const double of[3][3][3] = {
        {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}},
        {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}},
        {{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}};
    tr_rgb c = tr_palette_hue(hue);
    double in[3] = {linear(c.r), linear(c.g), linear(c.b)};
    for (int i = 0; i < 3; i++) seen[i] = of[kind][i][0] * in[0] + of[kind][i][1] * in[1] + of[kind][i][2] * in[2];
}

/* With any two kinds of cones sliding and rolling stay further apart than each is from a grey of half its light: 0.1 in
 * linear light, where white is 1. The other hues of films are neither of them: 0.03. */
static void test_two_meanings_stay_apart_for_colour_blind_eyes(void **state) {
    (void)state;
    const unsigned other[] = {TR_INK, TR_GREEN, TR_PURPLE, TR_FAINT, TR_WALL, TR_ARC_A, TR_ARC_B, TR_STICKS};
    for (int kind = 0; kind < 3; kind++) {
        double s[3], r[3], o[3];
        as_seen(kind, TR_SLIDES, s), as_seen(kind, TR_ROLLS, r);
        assert_true(hypot(hypot(s[0] - r[0], s[1] - r[1]), s[2] - r[2]) > 0.1);
        for (int i = 0; i < 8; i++) {
            as_seen(kind, other[i], o);
            double from_s = hypot(hypot(s[0] - o[0], s[1] - o[1]), s[2] - o[2]);
            double from_r = hypot(hypot(r[0] - o[0], r[1] - o[1]), r[2] - o[2]);
            if (!(from_s > 0.03 && from_r > 0.03))
                fail_msg("#%06X is %g from sliding, %g from rolling (cones %d)", other[i], from_s, from_r, kind);
        }
    }
}

static void test_palette_clamps(void **state) {
    (void)state;
    const double odd[][2] = {{-3, 0}, {NAN, 0}, {7, 1}, {INFINITY, 1}, {-INFINITY, 0}};
    for (int i = 0; i < 5; i++) {
        tr_rgb p = tr_palette_ramp(TR_RAMP_PLAIN, odd[i][0]), q = tr_palette_ramp(TR_RAMP_PLAIN, odd[i][1]);
        assert_memory_equal(&p, &q, sizeof p);
        p = tr_palette_diverging(-7), q = tr_palette_diverging(-1);
        assert_memory_equal(&p, &q, sizeof p);
    }
}

/* By libpng: blue, green, red. */
static unsigned char *read_png(const char *path) {
    png_image image = {.version = PNG_IMAGE_VERSION};
    assert_int_not_equal(png_image_begin_read_from_file(&image, path), 0);
    assert_int_equal(image.width, TR_FRAME_WIDTH);
    assert_int_equal(image.height, TR_FRAME_HEIGHT);
    image.format = PNG_FORMAT_BGR;
    unsigned char *read = malloc(PNG_IMAGE_SIZE(image));
    assert_int_not_equal(png_image_finish_read(&image, NULL, read, 0, NULL), 0);
    assert_int_equal(image.warning_or_error, 0);
    return read;
}

static void assert_shows(const tr_canvas *canvas, const unsigned char *bgr) {
    const unsigned char *drawn = tr_canvas_pixels(canvas);
    for (int i = 0; i < TR_FRAME_WIDTH * TR_FRAME_HEIGHT; i++)
        if (memcmp(bgr + 3 * i, drawn + 4 * i, 3) != 0) fail_msg("pixel %d differs", i);
}

/* Read back by libpng and by Cairo. */
static void test_png_round_trip(void **state) {
    fixture *f = *state;
    hand_made *h = hand_packing(60);
    tr_status st = {0};
    char *path = in_dir(f, "frame.png");
    tr_draw_biaxial(f->canvas, &h->view);
    assert_true(tr_canvas_png(f->canvas, path, &st));
    assert_false(exists(in_dir(f, "frame.png.part")));
    unsigned char *read = read_png(path);
    assert_shows(f->canvas, read);
    tr_canvas *loaded = tr_canvas_create(&st);
    assert_true(tr_canvas_load(loaded, path, &st));
    assert_shows(loaded, read);
    tr_canvas_free(loaded);
    free(read);
    free(h);
}

/* What cannot be made smaller has room too: noise that libpng wrote comes back. A picture after it leaves nothing of
 * it. */
static void test_png_of_noise(void **state) {
    fixture *f = *state;
    tr_status st = {0};
    char *path = in_dir(f, "noise.png"), *again = in_dir(f, "again.png");
    unsigned char *noise = malloc(3 * TR_FRAME_WIDTH * TR_FRAME_HEIGHT);
    unsigned x = 1;
    for (int i = 0; i < 3 * TR_FRAME_WIDTH * TR_FRAME_HEIGHT; i++)
        x = 1664525 * x + 1013904223, noise[i] = (unsigned char)(x >> 24);
    png_image image = {
        .version = PNG_IMAGE_VERSION, .width = TR_FRAME_WIDTH, .height = TR_FRAME_HEIGHT, .format = PNG_FORMAT_BGR};
    assert_int_not_equal(png_image_write_to_file(&image, path, 0, noise, 0, NULL), 0);
    assert_true(tr_canvas_load(f->canvas, path, &st));
    assert_true(tr_canvas_png(f->canvas, again, &st));
    unsigned char *read = read_png(again);
    assert_memory_equal(read, noise, 3 * TR_FRAME_WIDTH * TR_FRAME_HEIGHT);
    free(read);
    hand_made *h = hand_packing(60);
    tr_draw_biaxial(f->canvas, &h->view);
    assert_true(tr_canvas_png(f->canvas, again, &st));
    assert_shows(f->canvas, read = read_png(again));
    free(read), free(noise), free(h);
}

static void draw_bodies(tr_canvas *canvas, const hand_made *h) {
    tr_show_lane lane = hand_lane(h);
    tr_show show = hand_show(&lane, 1);
    show.range = h->view.range, show.time = h->view.time;
    tr_draw_show(canvas, &show);
}

static void test_same_view_same_bytes(void **state) {
    fixture *f = *state;
    hand_made *h = hand_packing(60), *pair = hand_pair(10e-3, 5e-3, 1.2, -2.4, 0.5, -1);
    unsigned char *first = malloc(N_BYTES);
    tr_draw_biaxial(f->canvas, &h->view);
    memcpy(first, tr_canvas_pixels(f->canvas), N_BYTES);
    draw_bodies(f->canvas, pair);
    assert_memory_not_equal(first, tr_canvas_pixels(f->canvas), N_BYTES);
    tr_draw_biaxial(f->canvas, &h->view);
    assert_memory_equal(first, tr_canvas_pixels(f->canvas), N_BYTES);
    free(first);
    free(pair);
    free(h);
}

/* One disk that fills the view box, then without contacts: known colours at known places. */
static void test_biaxial_pixels(void **state) {
    fixture *f = *state;
    hand_made *h = hand_start();
    hand_disk(h, (double[]){0, 0, M_PI / 2, 1}, (double[]){0, 0, 0, 0});
    hand_disk(h, (double[]){0, -2, 0, 1}, (double[]){0, 0, 0, 0});
    h->view.x0 = h->view.y0 = -3, h->view.x1 = h->view.y1 = 3;
    tr_draw_biaxial(f->canvas, &h->view);
    int cx = 420, cy = 342; /* the origin: middle of the picture area */
    assert_int_equal(pixel(f->canvas, 0, 0), TR_WHITE);
    assert_int_equal(pixel(f->canvas, TR_FRAME_WIDTH - 1, TR_FRAME_HEIGHT - 1), TR_WHITE);
    assert_int_equal(pixel(f->canvas, cx, cy), TR_DISK);
    assert_int_equal(pixel(f->canvas, cx, cy - 75), TR_FAINT); /* the tick, a quarter turn from +x: up */
    assert_int_equal(pixel(f->canvas, cx + 75, cy), TR_DISK);
    h->record[0] = (tr_record){.a = 0, .b = 1, .f_n = 5, .mobilisation = 1, .R1 = 1, .R2 = 1};
    h->view.n_records = 1;
    tr_draw_biaxial(f->canvas, &h->view);
    tr_rgb dark = tr_palette_ramp(TR_RAMP_PLAIN, 1);
    unsigned line = pixel(f->canvas, cx, cy + 105); /* where the disks touch */
    assert_close((line >> 16) / 255.0, dark.r, 0, 0.03);
    assert_close((line >> 8 & 255) / 255.0, dark.g, 0, 0.03);
    free(h);
}

/* A disk between pixels, without a rim: its area, and its width in each row where the edge is steep. The polygon has
 * 0.6 % less area than the circle and leaves it by 1/8 px, along a row 1.4 times that; coverage is to 1/4 px; both at
 * two edges. */
static void test_disks_are_round(void **state) {
    fixture *f = *state;
    hand_made *h = hand_start();
    const double fill = 1, x = 420.3, y = 342.6, r = 15;
    hand_disk(h, (double[]){(x - 420) / r, (342 - y) / r, 0, 1}, (double[]){0, 0, 0, 0});
    h->view.x0 = h->view.y0 = -314 / r, h->view.x1 = h->view.y1 = 314 / r; /* the picture area is 628 px high */
    h->view.fill = &fill, h->view.range = 1;
    tr_draw_biaxial(f->canvas, &h->view);
    double full = 255 - (pixel(f->canvas, 420, 342) & 255), area = 0;
    for (int row = 342 - 20; row < 342 + 20; row++) {
        double width = 0, up = row + 0.5 - y;
        for (int k = 420 - 20; k < 420 + 20; k++) width += (255 - (pixel(f->canvas, k, row) & 255)) / full;
        if (fabs(up) < 0.7 * r) assert_close(width, 2 * sqrt(r * r - up * up), 0, 2 * (1.4 / 8 + 0.25 / 2));
        area += width;
    }
    assert_close(area, M_PI * r * r, 0.01, 0);
    free(h);
}

static bool near(unsigned hue, tr_rgb c) { /* to half a step of 33, in which a channel changes by 0.035 */
    tr_rgb h = tr_palette_hue(hue);
    return fabs(h.r - c.r) < 0.04 && fabs(h.g - c.g) < 0.04 && fabs(h.b - c.b) < 0.04;
}

/* Four disks in a row over the width of the view, in the colour of their rotation or of the mean field of their
 * contacts, by hand; lines are not drawn over them. */
static void test_disks_in_the_colour_of_a_field(void **state) {
    fixture *f = *state;
    hand_made *h = hand_start();
    double fill[4], turned[] = {-2, 0, 0.5, 1};
    int ends[4];
    for (int i = 0; i < 4; i++) hand_disk(h, (double[]){2 * i - 3, 0, turned[i], 1}, (double[]){0, 0, 0, 0});
    h->view.x0 = h->view.y0 = -4, h->view.x1 = h->view.y1 = 4, h->view.fill = fill, h->view.range = 1;
    h->record[0] = (tr_record){.a = 0, .b = 1, .f_n = 5, .v_r = -0.2, .v_s = 3, .mobilisation = 0.5};
    h->record[1] = (tr_record){.a = 1, .b = 2, .f_n = 5, .v_r = 1, .v_s = -5, .mobilisation = 1};
    h->record[2] = (tr_record){.a = -1, .b = 0, .f_n = 5, .v_r = 0.8, .v_s = 4, .mobilisation = 0};
    h->view.n_records = 3;
    /* without a law of friction all of a contact slips */
    const double want[][4] = {{0.25, 0.75, 1, 0}, {3.5, 4, 5, 0}, {0.5, 0.6, 1, 0}, {1, 1, 1, 0}, {-2, 0, 0.5, 1}};
    for (tr_color color = TR_COLOR_MOBILISATION; color <= TR_COLOR_SPIN; color++) {
        h->view.color = color;
        tr_frame_fill(&h->world, h->record, 3, color, fill, ends);
        for (int i = 0; i < 4; i++) assert_close(fill[i], want[color][i], 1e-15, 0);
        tr_draw_biaxial(f->canvas, &h->view);
        for (int i = 0; i < 4; i++) {
            unsigned hue = pixel(f->canvas, 420 + (2 * i - 3) * 75, 342); /* a disk is 150 px wide */
            bool spin = color == TR_COLOR_SPIN;
            if (!near(hue, spin ? tr_palette_diverging(want[color][i])
                                : tr_palette_ramp(tr_frame_ramp(color), want[color][i])))
                fail_msg("color %d, disk %d: %06x", (int)color, i, hue);
        }
        assert_int_equal(pixel(f->canvas, 420 + 150, 342 - 100), TR_WHITE); /* no rims, nothing between disks */
    }
    assert_int_equal(ends[0], 2);
    assert_int_equal(ends[1], 2);
    assert_int_equal(ends[3], 0);
    /* the bar: green on the left, light grey in the middle, purple on the right */
    assert_true(near(pixel(f->canvas, 854, 648), tr_palette_diverging(-1)));
    assert_true(near(pixel(f->canvas, 1052, 648), tr_palette_diverging(0)));
    assert_true(near(pixel(f->canvas, 1250, 648), tr_palette_diverging(1)));
    free(h);
}

/* One disk across the right edge of a cell: in full inside, its image on the left too, what is outside is pale; a
 * contact across the edge goes to the image. The origin is at (420, 342) px. */
static void test_cell_pixels(void **state) {
    fixture *f = *state;
    hand_made *h = hand_start();
    hand_disk(h, (double[]){1.9, 0, 0, 0.5}, (double[]){0, 0, 0, 0});
    hand_disk(h, (double[]){-1.2, 0, 0, 0.5}, (double[]){0, 0, 0, 0});
    h->world.cell.side[0] = 4, h->world.cell.side[1] = 3;
    h->view.x0 = h->view.y0 = -3, h->view.x1 = h->view.y1 = 3;
    tr_draw_biaxial(f->canvas, &h->view);
    double scale = 0;
    for (int x = 420; scale == 0 && x < TR_FRAME_WIDTH; x++) /* the edge at x = 2, above the disk */
        if (pixel(f->canvas, x, 260) == TR_WALL) scale = (x + 1 - 420) / 2.0;
    assert_true(scale > 50);
    int inside = 420 + (int)(1.7 * scale), image = 420 - (int)(1.95 * scale), outside = 420 + (int)(2.25 * scale),
        low = 342 + (int)(0.2 * scale);
    assert_int_equal(pixel(f->canvas, inside, low), TR_DISK);
    assert_int_equal(pixel(f->canvas, image, low), TR_DISK);
    unsigned pale = pixel(f->canvas, outside, low);
    assert_true(pale != TR_DISK && pale != TR_WHITE && (pale & 255) > (TR_DISK & 255));
    assert_int_equal(pixel(f->canvas, 420, low), TR_WHITE); /* no line from one to the other through the cell */
    h->record[0] = (tr_record){.a = 0, .b = 1, .f_n = 5, .mobilisation = 1, .R1 = 0.5, .R2 = 0.5};
    h->view.n_records = 1;
    tr_draw_biaxial(f->canvas, &h->view);
    tr_rgb dark = tr_palette_ramp(TR_RAMP_PLAIN, 1);
    int at[2] = {420 + (int)(1.95 * scale), 420 - (int)(1.6 * scale)};
    for (int k = 0; k < 2; k++) assert_close((pixel(f->canvas, at[k], 342) >> 16) / 255.0, dark.r, 0, 0.03);
    assert_int_equal(pixel(f->canvas, 420, 342), TR_WHITE);
    free(h);
}

static void test_line_width_follows_force(void **state) {
    fixture *f = *state;
    hand_made *h = hand_start();
    for (int i = 0; i < 2; i++) hand_disk(h, (double[]){2.0 * i - 1, 0, 0, 1}, (double[]){0, 0, 0, 0});
    h->view.x0 = h->view.y0 = -3, h->view.x1 = h->view.y1 = 3, h->view.f_mean = 10, h->view.n_records = 1;
    int wide[4];
    for (int k = 0; k < 4; k++) {
        h->record[0] = (tr_record){.a = 0, .b = 1, .f_n = (double[]){10, 20, 40, 4000}[k], .mobilisation = 0.5};
        tr_draw_biaxial(f->canvas, &h->view);
        wide[k] = 0;
        for (int y = 0; y < TR_FRAME_HEIGHT; y++) wide[k] += pixel(f->canvas, 400, y) == pixel(f->canvas, 400, 342);
    }
    assert_in_range(wide[1], 2 * wide[0] - 2, 2 * wide[0] + 2);
    assert_in_range(wide[2], 4 * wide[0] - 4, 4 * wide[0] + 4);
    assert_int_equal(wide[3], wide[2]); /* the cap */
    free(h);
}

static void test_bodies_shows_arcs_bars_and_walls(void **state) {
    fixture *f = *state;
    hand_made *h = hand_floor(10e-3, 14e-3, -0.6, 0.2, -6);
    draw_bodies(f->canvas, h);
    assert_true(count(f->canvas, TR_ARC_A, 0, TR_FRAME_HEIGHT) > 1000);
    assert_true(count(f->canvas, TR_ARC_B, 0, TR_FRAME_HEIGHT) > 400);
    assert_true(count(f->canvas, TR_WALL, 0, TR_FRAME_HEIGHT) > 2000);
    assert_true(count(f->canvas, TR_GREEN, 0, 660) > 300);
    h->view.n_records = 0;
    draw_bodies(f->canvas, h);
    assert_int_equal(count(f->canvas, TR_ARC_A, 0, TR_FRAME_HEIGHT), 0);
    assert_int_equal(count(f->canvas, TR_ARC_B, 0, TR_FRAME_HEIGHT), 0);
    assert_true(count(f->canvas, TR_DISK, 0, TR_FRAME_HEIGHT) > 10000);
    free(h);
}

/* Both disks turned to the left: the arc goes up from the contact on the left disk, down on the right one. */
static void test_arcs_go_the_right_way(void **state) {
    fixture *f = *state;
    const int middle = 366; /* of the stage */
    for (int sign = -1; sign <= 1; sign += 2) {
        hand_made *h = hand_pair(8e-3, 8e-3, 0.9 * sign, 0.9 * sign, 0, 0);
        draw_bodies(f->canvas, h);
        int up_a = count(f->canvas, TR_ARC_A, 100, middle), down_a = count(f->canvas, TR_ARC_A, middle + 1, 640);
        int up_b = count(f->canvas, TR_ARC_B, 100, middle), down_b = count(f->canvas, TR_ARC_B, middle + 1, 640);
        assert_true(sign > 0 ? up_a > 1000 && down_a == 0 : down_a > 1000 && up_a == 0);
        assert_true(sign > 0 ? down_b > 300 && up_b == 0 : up_b > 300 && down_b == 0);
        free(h);
    }
}

static void test_bad_numbers_are_left_out(void **state) {
    fixture *f = *state;
    const double bad[] = {NAN, INFINITY, -INFINITY, 0, -1, 1e300};
    tr_status st = {0};
    for (int i = 0; i < 6; i++)
        for (int k = 0; k < 22; k++) {
            hand_made *h = hand_pair(10e-3, 5e-3, 1.2, -2.4, 0.5, -1);
            tr_record *r = h->record;
            h->world.n_walls = 4;
            h->world.wall[2].mass = 1;
            double fill[] = {bad[i], 0};
            h->view.color = (tr_color)(k % 5);
            if (h->view.color == TR_COLOR_SPIN) h->view.fill = fill;
            double *target[] = {&h->pos[0],      &h->pos[1],
                                &h->pos[2],      &h->pos[3],
                                &h->vel[0],      &h->vel[2],
                                &r->x,           &r->nx,
                                &r->R1,          &r->R2,
                                &r->f_n,         &r->mobilisation,
                                &r->v_s,         &r->v_r,
                                &r->v_r_by[1],   &r->da,
                                &r->db,          &h->view.range,
                                &h->view.f_mean, &h->view.x1,
                                &h->view.time,   &h->world.wall[1].y};
            *target[k] = bad[i];
            tr_draw_biaxial(f->canvas, &h->view);
            draw_bodies(f->canvas, h);
            double range = tr_frame_range(r, 1, h->view.color), speed = tr_frame_range_bodies(&h->world, r, 1);
            assert_true(range > 0 && isfinite(range) && speed > 0 && isfinite(speed));
            free(h);
        }
    hand_made *none = hand_start();
    tr_draw_biaxial(f->canvas, &none->view);
    draw_bodies(f->canvas, none);
    free(none);
    char *path = in_dir(f, "bad.png");
    assert_true(tr_canvas_png(f->canvas, path, &st)); /* Cairo is still in good health */
}

static void test_range(void **state) {
    (void)state;
    tr_record r[100] = {0};
    assert_close(tr_frame_range(r, 100, TR_COLOR_SLIDING), 1, 0, 0);
    assert_close(tr_frame_range(r, 0, TR_COLOR_ROLLING), 1, 0, 0);
    for (int i = 0; i < 100; i++) r[i].v_s = -0.018e-3 * (i + 1), r[i].v_r = i < 97 ? 3e-3 : 9;
    assert_close(tr_frame_range(r, 100, TR_COLOR_SLIDING), 2e-3, 1e-12, 0);
    assert_close(tr_frame_range(r, 100, TR_COLOR_ROLLING), 5e-3, 1e-12, 0); /* three runaways do not count */
    assert_close(tr_frame_range(r, 100, TR_COLOR_MOBILISATION), 1, 0, 0);
    for (int i = 0; i < 100; i++) r[i].v_s = 5e-7;
    assert_close(tr_frame_range(r, 100, TR_COLOR_SLIDING), 5e-7, 1e-12, 0);
}

/* Follows the material points that touched first by turning vectors, and asks where they are. Of a ring (R1 < 0) n
 * points from the contact to its centre. */
static void test_arcs_end_at_the_material_points(void **state) {
    (void)state;
    const double R[][2] = {{1, 1}, {2, 0.75}, {1, 10}, {-3, 1}}, motion[][3] = {/* th1, th2, beta */
                                                                       {0.7, 0.7, 0.7}, {0.4, -0.8, 0}, {0, 1.3, 0.5},
                                                                       {0.6, 0.6, 0},   {0, 0, 0.9},    {-2, 9, 0.3}};
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 6; k++) {
            double side = R[i][0] < 0 ? -1 : 1, start = 0.35, th1 = motion[k][0], th2 = motion[k][1],
                   beta = motion[k][2], n = start + beta;
            tr_record r = {.nx = cos(n), .ny = sin(n), .R1 = R[i][0], .R2 = R[i][1]};
            r.da = r.R1 * (th1 - beta), r.db = r.R2 * (th2 - beta); /* int s1 dt, -int s2 dt */
            tr_arc a, b;
            tr_arc_angles(&r, &a, &b);
            assert_close(cos(a.from), side * r.nx, 0, 1e-12);
            assert_close(sin(b.from), -r.ny, 0, 1e-12);
            assert_close(cos(a.from + a.sweep), side * cos(start + th1), 0, 1e-12);
            assert_close(sin(a.from + a.sweep), side * sin(start + th1), 0, 1e-12);
            assert_close(cos(b.from + b.sweep), -cos(start + th2), 0, 1e-12);
            assert_close(sin(b.from + b.sweep), -sin(start + th2), 0, 1e-12);
        }
}

/* On a floor the point touched first stays where it was, however the disk slides or rolls on. */
static void test_arc_on_a_wall_ends_where_the_contact_began(void **state) {
    (void)state;
    for (int k = 0; k < 8; k++) {
        double n = 0.8 * k, nx = cos(n), ny = sin(n), way = 3.5; /* along t = (ny, -nx) */
        tr_record r = {.a = -1, .nx = nx, .ny = ny, .R2 = 1, .da = way, .x = 0.2 + way * ny, .y = 0.1 - way * nx};
        double x, y;
        tr_arc_wall(&r, &x, &y);
        assert_close(x, 0.2, 0, 1e-12);
        assert_close(y, 0.1, 0, 1e-12);
    }
}

static void test_png_failures_leave_no_file(void **state) {
    fixture *f = *state;
    tr_status st = {0};
    assert_false(tr_canvas_png(f->canvas, "/nowhere/at/all/x.png", &st));
    assert_int_equal(st.code, TR_FILE);
    assert_string_equal(st.text, "error: cannot write /nowhere/at/all/x.png: No such file or directory");

    /* a full disk: the part file is a way to /dev/full */
    char *path = in_dir(f, "full.png"), *part = in_dir(f, "full.png.part");
    assert_int_equal(symlink("/dev/full", part), 0);
    st = (tr_status){0};
    assert_false(tr_canvas_png(f->canvas, path, &st));
    assert_int_equal(st.code, TR_FILE);
    assert_non_null(strstr(st.text, strerror(ENOSPC)));
    assert_non_null(strstr(st.text, path));
    assert_false(exists(path) || exists(part));

    /* the final name is taken by a directory: the rename fails */
    assert_int_equal(mkdir(path, 0700), 0);
    st = (tr_status){0};
    assert_false(tr_canvas_png(f->canvas, path, &st));
    assert_int_equal(st.code, TR_FILE);
    assert_false(exists(part));
    rmdir(path);
}

static bool film(const fixture *f, const char *path, int frames, tr_status *st) {
    hand_made *h = hand_pair(10e-3, 5e-3, 1.2, -2.4, 0.5, -1);
    tr_video *video = tr_video_open(path, 25, st);
    bool ok = video;
    for (int i = 0; ok && i < frames; i++) {
        h->pos[2] += 0.1;
        draw_bodies(f->canvas, h);
        ok = tr_video_frame(video, f->canvas, st);
    }
    free(h);
    return tr_video_close(video, true, st) && ok;
}

static char *slurp(const char *path, size_t *size) {
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    fseek(file, 0, SEEK_END);
    *size = (size_t)ftell(file);
    rewind(file);
    char *bytes = malloc(*size);
    assert_int_equal(fread(bytes, 1, *size, file), *size);
    fclose(file);
    return bytes;
}

/* Width, height, rate, and number of frames, as ffprobe sees them. */
static void probe(const char *path, char said[100]) {
    char command[400];
    snprintf(command, sizeof command,
             "ffprobe -v error -count_frames -show_entries stream=width,height,r_frame_rate,nb_read_frames -of csv=p=0 "
             "'file:%s'",
             path);
    FILE *out = popen(command, "r");
    assert_non_null(fgets(said, 100, out));
    pclose(out);
}

static void test_video(void **state) {
    fixture *f = *state;
    if (!tr_video_available()) skip();
    tr_status st = {0};
    char *one = in_dir(f, "one.mp4"), *two = in_dir(f, "t:wo.mp4");
    assert_true(film(f, one, 12, &st));
    assert_true(film(f, two, 12, &st));
    size_t n1, n2;
    char *b1 = slurp(one, &n1), *b2 = slurp(two, &n2);
    assert_int_equal(n1, n2);
    assert_memory_equal(b1, b2, n1);
    free(b1);
    free(b2);
    char said[100];
    probe(one, said);
    assert_string_equal(said, "1280,720,25/1,12\n");
}

/* Of 37 frames at 25 a second, every third (8 1/3 a second): 13. */
static void test_gif(void **state) {
    fixture *f = *state;
    if (!tr_video_available()) skip();
    tr_status st = {0};
    char *mp4 = in_dir(f, "a.mp4"), *gif = in_dir(f, "a:.gif"), said[100];
    assert_true(film(f, mp4, 37, &st));
    assert_true(tr_video_gif(mp4, gif, 25, &st));
    probe(gif, said);
    assert_string_equal(said, "640,360,25/3,13\n");
    size_t n, at = 0;
    char *bytes = slurp(gif, &n);
    while (at + 16 < n && memcmp(bytes + at, "NETSCAPE2.0\3\1\0\0", 16)) at++; /* 0 rounds: for ever */
    assert_true(at + 16 < n);
    free(bytes);

    char *full = in_dir(f, "full.gif"), *part = in_dir(f, "full.gif.part");
    assert_int_equal(symlink("/dev/full", part), 0);
    st = (tr_status){0};
    assert_false(tr_video_gif(mp4, full, 25, &st));
    assert_int_equal(st.code, TR_FILE);
    assert_non_null(strstr(st.text, "full.gif: "));
    assert_non_null(strstr(st.text, "No space left on device"));
    assert_false(exists(full) || exists(part));
}

static void test_video_failures_leave_no_file(void **state) {
    fixture *f = *state;
    if (!tr_video_available()) skip();
    struct sigaction before, after;
    sigaction(SIGPIPE, NULL, &before);
    tr_status st = {0};
    assert_false(film(f, "/nowhere/at/all/x.mp4", 30, &st));
    assert_int_equal(st.code, TR_FILE);
    assert_non_null(strstr(st.text, "/nowhere/at/all/x.mp4"));
    assert_non_null(strstr(st.text, "No such file"));

    char *path = in_dir(f, "full.mp4"), *part = in_dir(f, "full.mp4.part");
    assert_int_equal(symlink("/dev/full", part), 0);
    st = (tr_status){0};
    assert_false(film(f, path, 30, &st));
    assert_int_equal(st.code, TR_FILE);
    assert_false(exists(path) || exists(part));

    st = (tr_status){0};
    assert_false(film(f, path, 0, &st));
    assert_non_null(strstr(st.text, "no frames"));
    assert_false(exists(path) || exists(part));

    st = (tr_status){0};
    tr_video *dropped = tr_video_open(path, 25, &st);
    assert_true(tr_video_frame(dropped, f->canvas, &st));
    assert_true(tr_video_close(dropped, false, &st));
    assert_false(exists(path) || exists(part));
    sigaction(SIGPIPE, NULL, &after);
    assert_true(before.sa_handler == after.sa_handler);
}

static void test_video_without_ffmpeg(void **state) {
    fixture *f = *state;
    char *path = strdup(getenv("PATH"));
    setenv("PATH", "/nowhere", 1);
    tr_status st = {0};
    bool available = tr_video_available();
    tr_video *video = tr_video_open(in_dir(f, "x.mp4"), 25, &st);
    setenv("PATH", path, 1);
    free(path);
    assert_false(available);
    assert_null(video);
    assert_int_equal(st.code, TR_FILE);
    assert_non_null(strstr(st.text, "ffmpeg"));
}

/* Read by a leak-checking build: fontconfig keeps its caches to the end. */
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void) {
    return "leak:libfontconfig\n";
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_palette_falls_in_lightness),
        cmocka_unit_test(test_palette_clamps),
        cmocka_unit_test(test_sliding_and_rolling_are_read_and_differ_in_grey),
        cmocka_unit_test(test_two_meanings_stay_apart_for_colour_blind_eyes),
        cmocka_unit_test(test_range),
        cmocka_unit_test(test_arcs_end_at_the_material_points),
        cmocka_unit_test(test_arc_on_a_wall_ends_where_the_contact_began),
        cmocka_unit_test_setup_teardown(test_png_round_trip, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_png_of_noise, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_same_view_same_bytes, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_biaxial_pixels, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_disks_are_round, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_disks_in_the_colour_of_a_field, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_cell_pixels, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_line_width_follows_force, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_bodies_shows_arcs_bars_and_walls, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_arcs_go_the_right_way, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_bad_numbers_are_left_out, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_png_failures_leave_no_file, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_video, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_gif, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_video_failures_leave_no_file, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_video_without_ffmpeg, set_up, tear_down),
    };
    return cmocka_run_group_tests_name("draw", tests, NULL, NULL);
}
