/* SPDX-License-Identifier: MIT */
/* The curves of a biaxial test grow with the film, collapses are marked, and contacts have the colour of what they do.
 */
#include "assert_close.h"
#include "draw/canvas.h"
#include "draw/field.h"
#include "draw/frame_biaxial.h"
#include "draw/frame_history.h"
#include "draw/hand_made.h"
#include "draw/palette.h"

static tr_canvas *canvas;

static int set_up(void **state) {
    (void)state;
    tr_status st = {0};
    canvas = tr_canvas_create(&st);
    return canvas ? 0 : -1;
}

static int tear_down(void **state) {
    (void)state;
    tr_canvas_free(canvas);
    return 0;
}

static unsigned pixel(int x, int y) {
    const unsigned char *p = tr_canvas_pixels(canvas) + 4 * (y * TR_FRAME_WIDTH + x);
    return (unsigned)p[2] << 16 | (unsigned)p[1] << 8 | p[0];
}

/* The last column of the panel's curves that has this colour; 0: none. The chart is below the lines, above the force.
 */
static int last_column(unsigned hue) {
    for (int x = TR_FRAME_WIDTH - 1; x > TR_PANEL_X; x--)
        for (int y = 390; y < 490; y++)
            if (pixel(x, y) == hue) return x;
    return 0;
}

enum { ROWS = 40 };

static void test_curves_grow_along(void **state) {
    (void)state;
    hand_made *h = hand_packing(20);
    double strain[ROWS], sin_phi[ROWS], share[ROWS], unbalanced[ROWS];
    for (int i = 0; i < ROWS; i++) strain[i] = 0.005 * (i + 1), sin_phi[i] = 0.5, share[i] = 0.25, unbalanced[i] = 0.01;
    tr_history history = {0, strain, sin_phi, share, unbalanced, 0.2};
    h->view.history = &history;
    int before = 0;
    for (int n = 10; n <= ROWS; n += 10) {
        history.n = n;
        tr_draw_biaxial(canvas, &h->view);
        int end = last_column(TR_ROLLS);
        if (n > 10) assert_close(end - before, 10 * 0.005 / 0.2 * (TR_PANEL_W - 56), 0, 3); /* pixels at both ends */
        before = end;
    }
    free(h);
}

static void test_collapse_is_an_event_and_a_fast_test_is_none(void **state) {
    (void)state;
    double strain[ROWS], zero[ROWS] = {0}, unbalanced[ROWS];
    for (int i = 0; i < ROWS; i++) strain[i] = 0.005 * i, unbalanced[i] = 0.01 * (1 + 0.5 * sin(7 * i));
    tr_history history = {ROWS, strain, zero, zero, unbalanced, 0.2};
    for (int i = 0; i < ROWS; i++) assert_false(tr_history_event(&history, i));
    unbalanced[20] = 0.05, unbalanced[21] = 0.045; /* more than four times 0.01 */
    for (int i = 0; i < ROWS; i++) assert_int_equal(tr_history_event(&history, i), i == 20 || i == 21);
    for (int i = 0; i < ROWS; i++) unbalanced[i] *= 30; /* all of it is fast: nothing stands out more */
    for (int i = 0; i < ROWS; i++) assert_int_equal(tr_history_event(&history, i), i == 20 || i == 21);
    history.n = 7; /* too few to know what is usual */
    for (int i = 0; i < 7; i++) assert_false(tr_history_event(&history, i));
}

static void test_bad_numbers_leave_gaps(void **state) {
    (void)state;
    hand_made *h = hand_packing(20);
    const double bad[] = {NAN, INFINITY, -INFINITY, 1e300};
    for (int k = 0; k < 4; k++) {
        double strain[ROWS], value[ROWS], unbalanced[ROWS];
        for (int i = 0; i < ROWS; i++) strain[i] = 0.005 * i, value[i] = unbalanced[i] = i % 3 ? 0.5 : bad[k];
        tr_history history = {ROWS, strain, value, value, unbalanced, 0.2};
        h->view.history = &history;
        tr_draw_biaxial(canvas, &h->view);
        strain[5] = bad[k];
        tr_draw_biaxial(canvas, &h->view);
        history.strain_end = bad[k];
        tr_draw_biaxial(canvas, &h->view);
        assert_int_equal(pixel(0, 0), TR_WHITE);
    }
    free(h);
}

/* (|V_r| - |V_s|)/(|V_r| + |V_s|): -1 slides, 1 rolls. */
static void test_contact_has_the_colour_of_what_it_does(void **state) {
    (void)state;
    const double v[][3] = {{1, 0, -1}, {-2, 0, -1}, {0, -3, 1}, {0.5, -0.5, 0}, {1, 3, 0.5}, {0, 0, 0}};
    for (int i = 0; i < 6; i++) {
        tr_record r = {.v_s = v[i][0], .v_r = v[i][1]};
        assert_close(tr_frame_field(NULL, &r, TR_COLOR_MOTION), v[i][2], 0, 1e-15);
    }
    const unsigned ends[] = {TR_SLIDES, TR_ROLLS};
    for (int k = 0; k < 2; k++) {
        tr_rgb c = tr_palette_motion(2 * k - 1), want = tr_palette_hue(ends[k]);
        assert_memory_equal(&c, &want, sizeof c);
    }
    tr_rgb grey = tr_palette_motion(0), none = tr_palette_motion(NAN);
    assert_true(grey.r == grey.g && grey.g == grey.b);
    assert_memory_equal(&grey, &none, sizeof grey);
}

/* Read by a leak-checking build: fontconfig keeps its caches to the end. */
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void) {
    return "leak:libfontconfig\n";
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_curves_grow_along),
        cmocka_unit_test(test_collapse_is_an_event_and_a_fast_test_is_none),
        cmocka_unit_test(test_bad_numbers_leave_gaps),
        cmocka_unit_test(test_contact_has_the_colour_of_what_it_does),
    };
    return cmocka_run_group_tests_name("history", tests, set_up, tear_down);
}
