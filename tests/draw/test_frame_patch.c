/* SPDX-License-Identifier: MIT */
/* Frames of the inside of a contact, from states filled by hand: known colours at known places, pictures that must
 * mirror each other, and numbers that no contact has. */
#include "assert_close.h"
#include "draw/canvas.h"
#include "draw/frame.h"
#include "draw/frame_patch.h"
#include "draw/patch_plot.h"
#include <stdlib.h>
#include <string.h>

enum { N_BYTES = 4 * TR_FRAME_WIDTH * TR_FRAME_HEIGHT, N_MOST = 2000 };
/* The contact: middle, half-width at a = a_max, heights of its band and of tau = 0, of tau = mu p_max above it [px]. */
enum { MIDDLE = 448, HALF = 225, BAND = 184, AXIS = 490, HIGH = 150 };

typedef struct fixture {
    tr_canvas *canvas;
    tr_patch_pair pair;
    tr_patch_state state;
    tr_patch_view view;
    double x[N_MOST], p[N_MOST], tau[N_MOST], slip[N_MOST];
    signed char side[N_MOST];
} fixture;

/* All sticks, no traction; the ranges of this state. */
static void contact(fixture *f, int n) {
    f->pair = (tr_patch_pair){.R_star = 1e-3, .E_star = 1e9, .d = 1e-2, .mu = 0.5};
    double P = 1e4, a = tr_patch_a(&f->pair, P);
    f->state = (tr_patch_state){
        .n = n, .P = P, .a = a, .h = 2 * a / n, .x = f->x, .p = f->p, .tau = f->tau, .slip = f->slip, .side = f->side};
    for (int i = 0; i < n; i++) {
        f->x[i] = (i + 0.5) * f->state.h - a, f->p[i] = tr_patch_p(&f->pair, P, f->x[i]);
        f->tau[i] = f->slip[i] = 0, f->side[i] = 0;
    }
    f->view = (tr_patch_view){
        .pair = &f->pair, .state = &f->state, .a_max = a, .p_max = tr_patch_p0(&f->pair, P), .slip_max = 1e-9};
}

/* Element i at Coulomb's bound. */
static void slips(fixture *f, int i, int side, double slip) {
    f->side[i] = (signed char)side, f->tau[i] = side * f->pair.mu * f->p[i], f->slip[i] = side * slip;
}

/* Slip at the right end of a contact that rolls, else tractions below the bound, as after a change of path. */
static void rolls(fixture *f, int n) {
    contact(f, n);
    for (int i = 0; i < n; i++) {
        f->tau[i] = 0.3 * f->pair.mu * f->p[i] * (1 + sin(3 * i * M_PI / n));
        if (4 * i >= 3 * n) slips(f, i, 1, 1e-9 * (4.0 * (i + 1) / n - 3));
    }
    f->view.v_roll = 1, f->view.v_slide = 0.1;
}

static int set_up(void **state) {
    fixture *f = calloc(1, sizeof *f);
    tr_status st = {0};
    f->canvas = tr_canvas_create(&st);
    *state = f;
    return f->canvas ? 0 : -1;
}

static int tear_down(void **state) {
    fixture *f = *state;
    tr_canvas_free(f->canvas);
    free(f);
    return 0;
}

/* 0xRRGGBB */
static unsigned pixel(const fixture *f, int x, int y) {
    const unsigned char *p = tr_canvas_pixels(f->canvas) + 4 * (y * TR_FRAME_WIDTH + x);
    return (unsigned)p[2] << 16 | (unsigned)p[1] << 8 | p[0];
}

/* Pixels of exactly this colour in x0 <= x < x1, y0 <= y < y1. */
static int count(const fixture *f, unsigned hue, int x0, int x1, int y0, int y1) {
    int n = 0;
    for (int y = y0; y < y1; y++)
        for (int x = x0; x < x1; x++) n += pixel(f, x, y) == hue;
    return n;
}

static unsigned char *copy(const fixture *f) {
    unsigned char *bytes = malloc(N_BYTES);
    memcpy(bytes, tr_canvas_pixels(f->canvas), N_BYTES);
    return bytes;
}

static void test_same_view_same_pixels(void **state) {
    fixture *f = *state;
    rolls(f, 200);
    tr_draw_patch(f->canvas, &f->view);
    unsigned char *first = copy(f);
    contact(f, 20);
    tr_draw_patch(f->canvas, &f->view);
    assert_memory_not_equal(first, tr_canvas_pixels(f->canvas), N_BYTES);
    rolls(f, 200);
    tr_draw_patch(f->canvas, &f->view);
    assert_memory_equal(first, tr_canvas_pixels(f->canvas), N_BYTES);
    free(first);
}

/* Five elements of 90 px: stick and slip in turn, in the band and between tau and the axis; inside each, clear of the
 * line of tau and of antialiased edges. */
static void test_stick_is_hatched_and_slip_is_not(void **state) {
    fixture *f = *state;
    contact(f, 5);
    for (int i = 0; i < 5; i++) f->tau[i] = 0.5 * f->pair.mu * f->p[i];
    slips(f, 1, 1, 0.3e-9), slips(f, 3, 1, 0.9e-9);
    tr_draw_patch(f->canvas, &f->view);
    for (int i = 0; i < 5; i++) {
        int x0 = MIDDLE - HALF + 90 * i + 8, x1 = x0 + 74;
        int band = count(f, TR_STICKS, x0, x1, BAND - 10, BAND + 10),
            area = count(f, TR_STICKS, x0, x1, AXIS - 30, AXIS - 4);
        int below = count(f, TR_STICKS, x0, x1, AXIS + 4, AXIS + HIGH);
        if (i % 2)
            assert_true(band == 0 && area == 0);
        else
            assert_true(band > 50 && area > 50); /* strokes of 2 in 9 px, of which half are whole pixels: 1/10 */
        assert_int_equal(below, 0);              /* tau > 0 is drawn upwards */
    }
}

/* Colours are exactly the palette's at slip/slip_max; beyond it, its end. */
static void test_colour_follows_slip(void **state) {
    fixture *f = *state;
    contact(f, 9);
    for (int i = 0; i < 9; i++) slips(f, i, i % 2 ? 1 : -1, i * 0.125e-9 * (i < 8 ? 1 : 7));
    tr_draw_patch(f->canvas, &f->view);
    for (int i = 0; i < 9; i++) {
        tr_rgb c = tr_palette_ramp(TR_RAMP_SLIDING, i / 8.0);
        int x = MIDDLE - HALF + 50 * i + 25, y = AXIS + (i % 2 ? -20 : 20);
        for (int k = 0; k < 2; k++) {
            unsigned got = pixel(f, x, k ? BAND : y);
            assert_close((got >> 16) / 255.0, c.r, 0, 1.0 / 255); /* eight bits */
            assert_close((got >> 8 & 255) / 255.0, c.g, 0, 1.0 / 255);
            assert_close((got & 255) / 255.0, c.b, 0, 1.0 / 255);
        }
    }
}

/* Row of the uppermost ink in a column of the traction picture, between the bound's outline and the axis. */
static int top_of_ink(const fixture *f, int x, int y0, int y1) {
    for (int y = y0; y < y1; y++)
        if (pixel(f, x, y) == TR_INK) return y;
    return -1;
}

static int bottom_of_ink(const fixture *f, int x, int y0, int y1) {
    for (int y = y1 - 1; y >= y0; y--)
        if (pixel(f, x, y) == TR_INK) return y;
    return -1;
}

/* tau = mu p_max/4, /2 and 1 (no matter the bound) are HIGH/4, /2 and 1 above the axis; negative, below. The line is
 * 4.2 px wide, of which whole pixels count. */
static void test_height_is_the_traction(void **state) {
    fixture *f = *state;
    for (int k = 1; k <= 4; k *= 2)
        for (int sign = -1; sign <= 1; sign += 2) {
            contact(f, 2);
            f->tau[0] = f->tau[1] = sign * k / 4.0 * f->pair.mu * f->view.p_max;
            tr_draw_patch(f->canvas, &f->view);
            int x = MIDDLE + 100;
            double y = sign > 0 ? top_of_ink(f, x, AXIS - 158, AXIS) + 2 : bottom_of_ink(f, x, AXIS, AXIS + 158) - 2;
            assert_close(y, AXIS - sign * k * HIGH / 4.0, 0, 2.5);
            f->view.p_max *= 2;
            tr_draw_patch(f->canvas, &f->view);
            y = sign > 0 ? top_of_ink(f, x, AXIS - 158, AXIS) + 2 : bottom_of_ink(f, x, AXIS, AXIS + 158) - 2;
            assert_close(y, AXIS - sign * k * HIGH / 8.0, 0, 2.5);
        }
}

/* In the band, whose columns are filled to the pixel. */
static void test_width_is_that_of_the_contact(void **state) {
    fixture *f = *state;
    for (int k = 1; k <= 4; k *= 2) {
        contact(f, 40);
        for (int i = 0; i < 40; i++) slips(f, i, 1, 1e-9);
        f->view.a_max *= k;
        tr_draw_patch(f->canvas, &f->view);
        tr_rgb c = tr_palette_ramp(TR_RAMP_SLIDING, 1);
        unsigned dark =
            (unsigned)lround(255 * c.r) << 16 | (unsigned)lround(255 * c.g) << 8 | (unsigned)lround(255 * c.b);
        assert_close(count(f, dark, 0, 840, BAND, BAND + 1), 2.0 * HALF / k, 0, 3); /* less the outline */
    }
}

/* Pressure and bound need no traction: the bound is where mu p is, an ellipse: half-way out it has sqrt(3)/2 of its
 * height. */
static void test_bound_is_mu_p(void **state) {
    fixture *f = *state;
    contact(f, 40);
    tr_draw_patch(f->canvas, &f->view);
    for (int side = -1; side <= 1; side += 2) {
        int x = MIDDLE + side * (HALF / 2), edge = (int)lround(HIGH * sqrt(0.75));
        assert_int_equal(pixel(f, x, AXIS - edge + 5), TR_DISK); /* outline of 2.5 px */
        assert_int_equal(pixel(f, x, AXIS + edge - 5), TR_DISK);
        assert_int_equal(pixel(f, x, AXIS - edge - 5), TR_WHITE);
        assert_int_equal(pixel(f, x, AXIS + edge + 5), TR_WHITE);
    }
    f->pair.mu *= 0.5; /* half the bound on half the scale */
    tr_draw_patch(f->canvas, &f->view);
    assert_int_equal(pixel(f, MIDDLE, AXIS - HIGH + 5), TR_DISK);
    f->view.p_max *= 2;
    tr_draw_patch(f->canvas, &f->view);
    assert_int_equal(pixel(f, MIDDLE, AXIS - HIGH / 2 - 5), TR_WHITE);
    assert_int_equal(pixel(f, MIDDLE, AXIS - HIGH / 2 + 5), TR_DISK);
}

/* Antialiasing is not symmetric to the last bit, and hatching leans one way: compared are the line of tau and the
 * colours of slip, which fill whole pixels. */
static void test_mirrored_state_mirrored_picture(void **state) {
    fixture *f = *state;
    const int n = 150; /* three columns each: no element ends in the middle of a pixel */
    static int line[2 * HALF];
    static unsigned color[2 * HALF], band[2 * HALF];
    rolls(f, n);
    tr_draw_patch(f->canvas, &f->view);
    for (int k = 0; k < 2 * HALF; k++) {
        int x = MIDDLE - HALF + k;
        line[k] = top_of_ink(f, x, AXIS - HIGH - 8, AXIS), color[k] = pixel(f, x, AXIS - 10),
        band[k] = pixel(f, x, BAND);
    }
    for (int i = 0, j = n - 1; i < j; i++, j--) {
        double tau = f->tau[i], slip = f->slip[i];
        signed char side = f->side[i];
        f->tau[i] = f->tau[j], f->slip[i] = f->slip[j], f->side[i] = f->side[j];
        f->tau[j] = tau, f->slip[j] = slip, f->side[j] = side;
    }
    tr_draw_patch(f->canvas, &f->view);
    for (int k = 6; k < 2 * HALF - 6; k++) { /* off the steep ends of tau */
        int m = 2 * HALF - 1 - k, x = MIDDLE - HALF + m;
        assert_close(top_of_ink(f, x, AXIS - HIGH - 8, AXIS), line[k], 0, fabs(k - 1.5 * HALF) < 8 ? HIGH : 2);
        if (k < 1.5 * HALF + 4) continue; /* what sticks */
        assert_int_equal(pixel(f, x, AXIS - 10), color[k]);
        assert_int_equal(pixel(f, x, BAND), band[k]);
    }
}

/* Mean column of a colour less x0; 0: none. */
static double lean(const fixture *f, unsigned hue, int x0, int x1, int y0, int y1) {
    double sum = 0, n = 0;
    for (int y = y0; y < y1; y++)
        for (int x = x0; x < x1; x++)
            if (pixel(f, x, y) == hue) sum += x - 0.5 * (x0 + x1 - 1), n++;
    return n > 0 ? sum / n : 0;
}

static void test_velocities_of_the_rims(void **state) {
    fixture *f = *state;
    /* v_slide, v_roll; signs of v_1, v_2 */
    const double v[][4] = {{1, 0, -1, 1}, {-1, 0, 1, -1}, {0, 1, 1, 1}, {0, -3, -1, -1}, {0.2, 1, 1, 1},
                           {2, 1, 0, 1},  {-2, 1, 1, 0},  {0, 0, 0, 0}, {NAN, 1, 1, 1}};
    for (int i = 0; i < 9; i++) {
        contact(f, 20);
        f->view.v_slide = v[i][0], f->view.v_roll = v[i][1];
        tr_draw_patch(f->canvas, &f->view);
        double lower = lean(f, TR_GREEN, 84, 812, BAND + 20, 290), upper = lean(f, TR_GREEN, 84, 812, 76, BAND - 20);
        assert_true(v[i][2] * lower > 0 || (v[i][2] == 0 && lower == 0));
        assert_true(v[i][3] * upper > 0 || (v[i][3] == 0 && upper == 0));
    }
    /* lengths in proportion: v_2 = 3 v_1 along the shaft, whose arrow begins 24 px from the middle */
    contact(f, 20);
    f->view.v_slide = 1, f->view.v_roll = 1;
    tr_draw_patch(f->canvas, &f->view);
    int reach[2] = {0};
    for (int k = 0; k < 2; k++)
        for (int x = MIDDLE; x < 812 && (x < MIDDLE + 30 || pixel(f, x - 1, k ? BAND - 70 : BAND + 70) == TR_GREEN);
             x++)
            reach[k] = x - MIDDLE - 24;
    assert_close(reach[1], 3 * reach[0], 0, 6); /* a pixel or two of the point of each head */
    assert_in_range(reach[1], 160, 172);
}

/* Whether x0 <= x < x1, y0 <= y < y1 shows this text and nothing else. Wipes the canvas. */
static bool reads(fixture *f, tr_text at, const char *text, int x0, int x1, int y0, int y1) {
    unsigned char *given = copy(f);
    tr_pen_hue(f->canvas->cr, TR_WHITE);
    cairo_paint(f->canvas->cr);
    tr_pen_text(f->canvas->cr, at, text);
    const unsigned char *drawn = tr_canvas_pixels(f->canvas);
    bool same = count(f, TR_INK, x0, x1, y0, y1) > 0;
    for (int y = y0; y < y1; y++) {
        size_t start = 4 * ((size_t)y * TR_FRAME_WIDTH + (size_t)x0);
        same = same && memcmp(given + start, drawn + start, 4 * (size_t)(x1 - x0)) == 0;
    }
    free(given);
    return same;
}

static void test_material_enters_upstream(void **state) {
    fixture *f = *state;
    contact(f, 20);
    tr_draw_patch(f->canvas, &f->view);
    assert_int_equal(count(f, TR_INK, 84, 190, BAND - 20, BAND + 24), 0); /* no rolling, no word */
    for (int k = 0; k < 4; k++) {
        int at_right = k % 2, roll = k < 2 ? 1 : -1, x = MIDDLE + (at_right ? 314 : -314);
        f->view.v_roll = roll;
        tr_draw_patch(f->canvas, &f->view);
        tr_text at = {.x = x, .y = BAND + 21, .size = 22, .align = TR_CENTRE};
        const char *word = (roll > 0) == at_right ? "leaves" : "enters";
        assert_true(reads(f, at, word, x - 36, x + 36, BAND + 3, BAND + 22));
    }
}

/* Half of a range that begins with 5 is not a whole number. */
static void test_colour_bar_tells_its_middle(void **state) {
    fixture *f = *state;
    const double range[] = {5e-9, 5e-8, 1e-9, 2e-6};
    const char *const middle[] = {"2.5", "25", "0.5", "1"};
    for (int i = 0; i < 4; i++) {
        tr_unit unit = tr_frame_unit(range[i], "m");
        tr_pen_hue(f->canvas->cr, TR_WHITE);
        cairo_paint(f->canvas->cr);
        tr_frame_color_bar(f->canvas->cr, &(tr_scale){"", range[i], &unit, TR_RAMP_SLIDING, false, false}, 600);
        tr_text at = {.x = TR_PANEL_X + TR_PANEL_W / 2.0, .y = 670, .size = 24, .align = TR_CENTRE};
        assert_true(reads(f, at, middle[i], TR_PANEL_X + 100, TR_PANEL_X + 300, 648, 690));
    }
}

/* Mean row of the outline of body 2 at a column, up from that of the contact. */
static double rise(const fixture *f, int x, int way) {
    double sum = 0, n = 0;
    for (int k = 10; k < 104; k++)
        if (pixel(f, x, BAND - way * k) == TR_WALL) sum += k, n++;
    return sum / n - 13;
}

/* The gap of Hertz has the slope sqrt(x^2 - a^2)/R_star: integrated here, compared up to the scale of the picture,
 * above and below. The line is 3 px wide, the rises 20 to 60 px. */
static void test_gap_is_that_of_hertz(void **state) {
    fixture *f = *state;
    contact(f, 20);
    for (int k = 1; k <= 2; k++) { /* half-width HALF/k */
        f->view.a_max = k * f->state.a;
        tr_draw_patch(f->canvas, &f->view);
        double a = (double)HALF / k, h = 0, h_near = 0;
        int near = k == 1 ? 300 : 200, far = k == 1 ? 360 : 290;
        for (int i = 0; i < 10000; i++) {
            double x = a + (far - a) * (i + 0.5) / 10000, dh = sqrt(x * x - a * a) * (far - a) / 10000;
            h += dh;
            if (x < near) h_near += dh;
        }
        for (int way = -1; way <= 1; way += 2)
            for (int side = -1; side <= 1; side += 2)
                assert_close(rise(f, MIDDLE + side * near, way) / rise(f, MIDDLE + side * far, way), h_near / h, 0,
                             0.03);
        assert_int_equal(count(f, TR_WHITE, MIDDLE + (int)a + 8, MIDDLE + (int)a + 40, BAND - 8, BAND + 8), 32 * 16);
    }
}

/* An arrow has more ink on the side of its head. The middle one is centred on the contact. */
static void test_slip_arrows(void **state) {
    fixture *f = *state;
    for (int side = -1; side <= 1; side++) {
        contact(f, 20);
        for (int i = 0; i < 20 && side; i++) slips(f, i, side, 0.5e-9);
        tr_draw_patch(f->canvas, &f->view);
        double on_2 = lean(f, TR_INK, MIDDLE - 18, MIDDLE + 19, BAND - 36, BAND - 17);
        double on_1 = lean(f, TR_INK, MIDDLE - 18, MIDDLE + 19, BAND + 18, BAND + 37);
        assert_true(side == 0 ? on_2 == 0 && on_1 == 0 : side * on_2 > 0.5 && -side * on_1 > 0.5);
    }
}

static void test_open_contact(void **state) {
    fixture *f = *state;
    rolls(f, 60);
    tr_draw_patch(f->canvas, &f->view);
    assert_int_equal(pixel(f, MIDDLE + 100, AXIS + 60), TR_DISK);
    assert_true(count(f, TR_STICKS, 84, 812, 76, 650) > 1000);
    f->state.P = 0; /* the arrays still hold what was */
    tr_draw_patch(f->canvas, &f->view);
    assert_int_equal(count(f, TR_STICKS, 84, 812, 76, 650), 0);
    assert_int_equal(count(f, TR_DISK, 116, 784, 330, 650), 0);
    assert_int_equal(count(f, TR_WHITE, MIDDLE - 60, MIDDLE + 60, BAND - 12, BAND + 12), 120 * 24); /* apart */
    assert_true(count(f, TR_FAINT, 200, 700, AXIS - 60, AXIS - 4) > 100);                           /* and says so */
    tr_patch_state_clear(&f->state);
    f->view.a_max = f->view.p_max = f->view.slip_max = 0;
    tr_draw_patch(f->canvas, &f->view);
    assert_int_equal(count(f, TR_DISK, 116, 784, 330, 650), 0);
}

/* Where one more element slips, at either end of what sticks, nothing changes but its own columns, the line's joints
 * beside it, and whole arrows. */
static void test_film_is_steady(void **state) {
    fixture *f = *state;
    for (int k = 0; k < 2; k++) {
        int i = k ? 0 : 149, changed = 0;
        rolls(f, 200);
        f->view.v_slide = f->view.v_roll = 0;
        tr_draw_patch(f->canvas, &f->view);
        unsigned char *before = copy(f);
        slips(f, i, 1, 0);
        tr_draw_patch(f->canvas, &f->view);
        const unsigned char *after = tr_canvas_pixels(f->canvas);
        double x = MIDDLE + HALF * ((i + 0.5) / 100 - 1);
        for (int b = 0; b < N_BYTES; b++) {
            if (before[b] == after[b]) continue;
            int column = b / 4 % TR_FRAME_WIDTH, row = b / 4 / TR_FRAME_WIDTH;
            bool arrow = row > BAND - 40 && row < BAND + 40 && abs(row - BAND) > 15;
            changed++;
            assert_true(fabs(column + 0.5 - x) < (arrow ? 36 : 8));
        }
        assert_true(changed > 50);
        free(before);
    }
}

/* Whatever the numbers: the margins stay white, and a sane frame afterwards is as ever. Cairo's fixed-point coordinates
 * would wrap beyond 2^23 px. */
static void test_odd_numbers(void **state) {
    fixture *f = *state;
    const double odd[] = {NAN, INFINITY, -INFINITY, 0, -1, 1e300, -1e300, 1e-300, 1e9};
    const int n[] = {2, 2000};
    rolls(f, 200);
    tr_draw_patch(f->canvas, &f->view);
    unsigned char *sane = copy(f);
    for (int k = 0; k < 16; k++)
        for (int i = 0; i < 9; i++) {
            rolls(f, n[(i + k) % 2]);
            double *target[] = {&f->tau[1],        &f->slip[1],     &f->p[1],         &f->state.a,
                                &f->state.P,       &f->state.h,     &f->view.a_max,   &f->view.p_max,
                                &f->view.slip_max, &f->view.v_roll, &f->view.v_slide, &f->view.progress,
                                &f->pair.mu,       &f->pair.R_star, &f->pair.E_star,  &f->pair.d};
            *target[k] = odd[i];
            tr_draw_patch(f->canvas, &f->view);
            assert_int_equal(count(f, TR_WHITE, 0, 24, 0, TR_FRAME_HEIGHT), 24 * TR_FRAME_HEIGHT);
            assert_int_equal(count(f, TR_WHITE, 820, 848, 0, TR_FRAME_HEIGHT), 28 * TR_FRAME_HEIGHT);
            tr_draw_patch_inset(f->canvas->cr, (tr_box){40, 40, 300, 200}, &f->state, &f->pair, true);
        }
    rolls(f, 200);
    tr_draw_patch(f->canvas, &f->view);
    assert_memory_equal(sane, tr_canvas_pixels(f->canvas), N_BYTES);
    free(sane);
}

/* Zones of 0.2 px, of which columns of pixels show one each. */
static void test_two_and_two_thousand_elements(void **state) {
    fixture *f = *state;
    for (int n = 2; n <= N_MOST; n += N_MOST - 2) {
        contact(f, n);
        for (int i = n / 2; i < n; i++) slips(f, i, 1, 0);
        for (int i = 0; i < n / 2; i++) f->tau[i] = 0.5 * f->pair.mu * f->p[i];
        tr_draw_patch(f->canvas, &f->view);
        tr_rgb c = tr_palette_ramp(TR_RAMP_SLIDING, 0);
        unsigned light =
            (unsigned)lround(255 * c.r) << 16 | (unsigned)lround(255 * c.g) << 8 | (unsigned)lround(255 * c.b);
        assert_int_equal(count(f, light, MIDDLE, MIDDLE + 200, AXIS - 10, AXIS - 9), 200); /* no seams */
        assert_int_equal(count(f, light, MIDDLE - HALF, MIDDLE, AXIS - 10, AXIS - 9), 0);
        assert_true(count(f, TR_STICKS, MIDDLE - 200, MIDDLE - 4, AXIS - 30, AXIS - 4) > 200);
        assert_int_equal(count(f, TR_STICKS, MIDDLE, MIDDLE + 200, AXIS - 30, AXIS - 4), 0);
    }
}

/* The inset keeps to its rectangle and shows the zones of the frame. */
static void test_inset(void **state) {
    fixture *f = *state;
    rolls(f, 200);
    for (int k = 0; k < 2; k++) {
        int x = 101, y = 57, w = k ? 640 : 240, h = k ? 400 : 160;
        tr_pen_hue(f->canvas->cr, TR_PURPLE);
        cairo_paint(f->canvas->cr);
        tr_draw_patch_inset(f->canvas->cr, (tr_box){x, y, w, h}, &f->state, &f->pair, true);
        assert_int_equal(count(f, TR_PURPLE, 0, TR_FRAME_WIDTH, 0, TR_FRAME_HEIGHT),
                         TR_FRAME_WIDTH * TR_FRAME_HEIGHT - w * h);
        assert_true(count(f, TR_STICKS, x, x + w / 2, y, y + h) > 20);
        assert_int_equal(count(f, TR_STICKS, x + 3 * w / 4, x + w, y, y + h), 0); /* the last quarter slips */
        int text = k ? 24 : 16, axis = y + (h - 3 * text) / 2; /* three lines below: numbers, a scale of the slip */
        assert_true(count(f, TR_DISK, x, x + w, axis, y + h) > w * h / 10);
        assert_true(count(f, TR_STICKS, x, x + 2 * text, y + h - text, y + h) > 20); /* stick in its key */
    }
}

/* Decades of slip: a step of 2 pm is not 0.00 nm. */
static void test_unit_below_a_nanometre(void **state) {
    (void)state;
    const double size[] = {1e-12, 1e-9, 1e-6, 1e9};
    const char *const name[] = {"pm", "nm", "µm", "Gm"};
    for (int i = 0; i < 4; i++) {
        tr_unit unit = tr_frame_unit(2 * size[i], "m");
        assert_close(unit.size, size[i], 1e-15, 0);
        assert_string_equal(unit.name, name[i]);
    }
}

/* Read by a leak-checking build: fontconfig keeps its caches to the end. */
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void) {
    return "leak:libfontconfig\n";
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_same_view_same_pixels, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_stick_is_hatched_and_slip_is_not, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_colour_follows_slip, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_height_is_the_traction, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_width_is_that_of_the_contact, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_bound_is_mu_p, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_mirrored_state_mirrored_picture, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_velocities_of_the_rims, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_material_enters_upstream, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_colour_bar_tells_its_middle, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_gap_is_that_of_hertz, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_slip_arrows, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_open_contact, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_film_is_steady, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_odd_numbers, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_two_and_two_thousand_elements, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_inset, set_up, tear_down),
        cmocka_unit_test(test_unit_below_a_nanometre),
    };
    return cmocka_run_group_tests_name("frame_patch", tests, NULL, NULL);
}
