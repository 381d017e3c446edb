/* SPDX-License-Identifier: MIT */
/* Pictures for a class: no letter is smaller than 1/30 of the height, three numbers at most, every word is there in
 * every language. */
#include "assert_close.h"
#include "draw/canvas.h"
#include "draw/frame_show.h"
#include "draw/hand_made.h"
#include "draw/pen.h"
#include "draw/words.h"
#include <ctype.h>
#include <string.h>

/* What was drawn. */
static double size, smallest;
static char least[128], all[8192];
static int numbers; /* texts with a digit in the panel, right of x = 852 and above the legend */

void __real_cairo_set_font_size(cairo_t *cr, double given);
void __wrap_cairo_set_font_size(cairo_t *cr, double given);
void __real_cairo_show_text(cairo_t *cr, const char *text);
void __wrap_cairo_show_text(cairo_t *cr, const char *text);

void __wrap_cairo_set_font_size(cairo_t *cr, double given) {
    size = given;
    __real_cairo_set_font_size(cr, given);
}

void __wrap_cairo_show_text(cairo_t *cr, const char *text) {
    double x = 0, y = 0;
    cairo_get_current_point(cr, &x, &y);
    if (size < smallest) smallest = size, snprintf(least, sizeof least, "%s", text);
    numbers += x > 852 && y > 60 && y < 640 && strpbrk(text, "0123456789") != NULL;
    size_t used = strlen(all);
    snprintf(all + used, sizeof all - used, "%s|", text);
    __real_cairo_show_text(cr, text);
}

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

static void draw(const tr_show *show) {
    smallest = INFINITY, numbers = 0, *all = 0;
    tr_draw_show(canvas, show);
}

static void draw_all(int lanes, int contacts, bool still, tr_language language) {
    hand_made *h = hand_floor(10e-3, 14e-3, -0.6, 0.2, -6);
    for (int i = 1; i < contacts; i++) {
        hand_disk(h, (double[]){14e-3 + 20e-3 * i, 10e-3, 0.3, 10e-3}, (double[]){-0.1, 0.15, 9, 0});
        hand_contact(h, i - 1, i, 0.1, -0.05, 8e-3, -5e-3);
    }
    tr_rim_mark mark[] = {{0, 0.1, 0.9, 0, 0}, {-1, -0.01, 0.01, 0, 0}, {0, 0, 0, 3, 0.1}, {-1, 0, 0, 3, 0.1}};
    double trace[] = {0, 0, 14e-3, 0};
    tr_show_lane lane[TR_MAX_LANES];
    for (int i = 0; i < lanes; i++) {
        lane[i] = hand_lane(h);
        lane[i].label = "ice", lane[i].slope = 0.1, lane[i].tilt = 0.1;
        lane[i].mark = mark, lane[i].n_marks = 4, lane[i].trace = trace, lane[i].n_trace = 2;
    }
    tr_show_check check[8];
    for (int i = 0; i < 8; i++) check[i] = (tr_show_check){"", "slip ends", "0.6667 m/s", "0.6667 m/s", i % 2};
    tr_show show = hand_show(lane, lanes);
    show.equation = "T = k_r V_r dt,   |T| ≤ μ_r f_n   [Wang eq. 28]", show.slower = 12;
    if (still) show.caption = "A disk is thrown without spin.", show.check = check, show.n_checks = 8;
    tr_canvas_speak(canvas, language);
    draw(&show);
    if (smallest < TR_FRAME_HEIGHT / 30.0)
        fail_msg("%d lanes, %d contacts, still %d, language %d: \"%s\" has %g px", lanes, contacts, still, language,
                 least, smallest);
    if (numbers > 3) fail_msg("%d lanes, %d contacts: %d numbers, %s", lanes, contacts, numbers, all);
    free(h);
}

static void test_class_reads_large_type_and_three_numbers(void **state) {
    (void)state;
    for (int lanes = 1; lanes <= 4; lanes++)
        for (int contacts = 1; contacts <= 1 + 3 * (lanes == 1); contacts++)
            for (int still = 0; still < 2; still++)
                for (tr_language l = TR_EN; l < TR_N_LANGUAGES; l++) draw_all(lanes, contacts, still, l);
}

static int marks(const char *text) {
    int n = 0;
    for (const char *p = text; (p = strstr(p, "%s")); p++) n++;
    return n;
}

static void test_every_language_has_every_word(void **state) {
    (void)state;
    for (tr_language l = TR_EN; l < TR_N_LANGUAGES; l++)
        for (tr_word_key k = 0; k < TR_N_WORDS; k++) {
            const char *word = tr_words_of(l, k), *english = tr_words_of(TR_EN, k);
            if (!word || !*word) fail_msg("language %d has no word for \"%s\"", l, english);
            if (marks(word) != marks(english)) fail_msg("\"%s\" and \"%s\" have not as much to fill in", english, word);
        }
    assert_string_equal(tr_words_of(TR_EN, TR_WORD_language), "en");
    assert_string_equal(tr_words_of(TR_DE, TR_WORD_language), "de");
}

static void test_words_are_drawn_in_the_language_of_the_canvas(void **state) {
    (void)state;
    hand_made *h = hand_pair(10e-3, 10e-3, 0, 0, 1, 1);
    tr_show_lane lane = hand_lane(h);
    tr_show show = hand_show(&lane, 1);
    for (tr_language l = TR_EN; l < TR_N_LANGUAGES; l++) {
        tr_canvas_speak(canvas, l);
        draw(&show);
        assert_non_null(strstr(all, tr_words_of(l, TR_WORD_lamp_slides)));
        assert_non_null(strstr(all, tr_words_of(l, TR_WORD_rolls)));
    }
    free(h);
}

/* "R_eq" has one index of two letters, "k_r V_r" two of one. */
static void test_index_is_a_whole_word(void **state) {
    (void)state;
    *all = 0;
    tr_pen_text(canvas->cr, (tr_text){.x = 10, .y = 50, .size = 30}, "R_eq f_n+x_12_α_βγ");
    assert_string_equal(all, "R|eq| f|n|+x|12|α|β|γ|");
}

static void test_texts_are_filled_in(void **state) {
    (void)state;
    char text[64];
    tr_words_fill(text, sizeof text, "a %s b %s c", "1", "2");
    assert_string_equal(text, "a 1 b 2 c");
    tr_words_fill(text, sizeof text, "%s-mal", "3", "");
    assert_string_equal(text, "3-mal");
    tr_words_fill(text, sizeof text, "100 %", "3", "");
    assert_string_equal(text, "100 %");
}

/* Read by a leak-checking build: fontconfig keeps its caches to the end. */
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void) {
    return "leak:libfontconfig\n";
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_class_reads_large_type_and_three_numbers),
        cmocka_unit_test(test_every_language_has_every_word),
        cmocka_unit_test(test_words_are_drawn_in_the_language_of_the_canvas),
        cmocka_unit_test(test_index_is_a_whole_word),
        cmocka_unit_test(test_texts_are_filled_in),
    };
    return cmocka_run_group_tests_name("class", tests, set_up, tear_down);
}
