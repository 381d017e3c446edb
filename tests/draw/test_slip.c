/* SPDX-License-Identifier: MIT */
/* color: slip. Where contacts stick, by the law of the run, against the closed forms of patch/; and what is drawn. */
#include "assert_close.h"
#include "core/bodies.h"
#include "draw/canvas.h"
#include "draw/draw.h"
#include "draw/field.h"
#include "draw/frame_biaxial.h"
#include "draw/palette.h"
#include "draw/stick.h"
#include "laws/law.h"
#include "patch/carter.h"
#include "patch/cattaneo.h"

#include <string.h>

static const double R1 = 0.01, R2 = 0.03;

typedef struct pair {
    tr_scene scene;
    tr_bodies b;
} pair;

/* Disk 1 above disk 0: t points to the right. */
static pair open_pair(const char *contact) {
    char text[500];
    tr_status st = {0};
    pair p;
    snprintf(text, sizeof text,
             "kind: bodies\ntime_end: 1\ncontact: {rolling: none, %s}\n"
             "disks: [{radius: 0.01, x: 0, y: 0}, {radius: 0.03, x: 0, y: 0.03999}]\n",
             contact);
    if (!tr_scene_read(&p.scene, &(tr_scene_source){"a.yaml", text, strlen(text), NULL, 0}, tr_laws_catalog(), &st) ||
        !tr_bodies_init(&p.b, &p.scene, &st))
        fail_msg("%s", st.text);
    return p;
}

static void close_pair(pair *p) {
    tr_bodies_free(&p->b), tr_scene_free(&p->scene);
}

static tr_record contact_of(double q, double s1, double s2) {
    return (tr_record){
        .a = 0, .b = 1, .y = R1, .ny = 1, .R1 = R1, .R2 = R2, .f_n = 100, .mobilisation = q, .s1 = s1, .s2 = s2};
}

#define CREEP "k_n: 10 MPa, friction: dahlberg-alfredsson, mu: 0.4, k_t: 10 MPa, E_star: 20 MPa"
#define SMOOTH "k_n: 10 MPa, friction: dahlberg-alfredsson, mu: 0, k_t: 10 MPa, E_star: 20 MPa"
#define HERTZ "normal: hertz-line, E_star: 20 MPa, friction: "

/* Steady rolling: material that enters sticks. u_roll is -(s1 + s2)/2, or with Wang's rolling -(3 s1 + s2)/4 here. */
static void creep_slips_where_material_leaves(void **state) {
    (void)state;
    static const char *const law[] = {CREEP, CREEP ", creep_roll: wang", HERTZ "kuhn-creep, mu: 0.4, nu: 0.3"};
    static const double share_of_s2[] = {0.5, 0.25, 0.5};
    const tr_patch_pair line = {.R_star = R1 * R2 / (R1 + R2), .E_star = 20e6, .d = 0.02, .mu = 0.4};
    const double s[][2] = {{1, 1}, {-1, -1}, {1, -2}, {-1, 2}, {2, -1}};
    for (int k = 0; k < 3; k++) {
        pair p = open_pair(law[k]);
        for (int i = 0; i < 5; i++)
            for (double q = 0.05; q < 1; q += 0.15) {
                double zone[2], stick[2], a = tr_patch_a(&line, 100);
                double roll = -(1 - share_of_s2[k]) * s[i][0] - share_of_s2[k] * s[i][1];
                tr_record r = contact_of(q, s[i][0], s[i][1]);
                tr_frame_stick(&p.b.world, &r, stick);
                tr_carter_stick(&line, 100, q, roll, zone);
                assert_close(stick[0], zone[0] / a, 0, 1e-12);
                assert_close(stick[1], zone[1] / a, 0, 1e-12);
                assert_close(tr_frame_field(&p.b.world, &r, TR_COLOR_SLIP), 1 - sqrt(1 - q), 0, 1e-12);
            }
        close_pair(&p);
    }
}

/* From rest, and where nothing rolls: both ends slip. */
static void the_ends_slip_without_rolling(void **state) {
    (void)state;
    static const char *const law[] = {HERTZ "cattaneo-mindlin, mu: 0.4, nu: 0.3",
                                      HERTZ "vu-quoc-zhang, mu: 0.4, nu: 0.3", CREEP};
    const tr_patch_pair line = {.R_star = R1 * R2 / (R1 + R2), .E_star = 20e6, .d = 0.02, .mu = 0.4};
    for (int k = 0; k < 3; k++) {
        pair p = open_pair(law[k]);
        for (double q = 0.05; q < 1; q += 0.15) {
            double stick[2], c = tr_cattaneo_stick(&line, 100, q) / tr_patch_a(&line, 100), roll = k < 2 ? 0.3 : 0;
            tr_record r = contact_of(q, roll, roll);
            tr_frame_stick(&p.b.world, &r, stick);
            assert_close(stick[0], -c, 0, 1e-12);
            assert_close(stick[1], c, 0, 1e-12);
        }
        close_pair(&p);
    }
}

/* Mindlin: the radius of the sticking circle is a (1 - q)^(1/3), 1/2 at q = 7/8. */
static void spheres_go_by_the_cube_root(void **state) {
    (void)state;
    static const char text[] =
        "kind: bodies\nshape: sphere\ntime_end: 1\ncontact: {normal: hertz-sphere, E_star: 20 MPa, "
        "friction: kuhn-creep, mu: 0.4, nu: 0.3, rolling: none}\n"
        "disks: [{radius: 0.01, x: 0, y: 0}, {radius: 0.03, x: 0, y: 0.03999}]\n";
    tr_status st = {0};
    pair p;
    if (!tr_scene_read(&p.scene, &(tr_scene_source){"a.yaml", text, strlen(text), NULL, 0}, tr_laws_catalog(), &st) ||
        !tr_bodies_init(&p.b, &p.scene, &st))
        fail_msg("%s", st.text);
    tr_record r = contact_of(7.0 / 8, -1, -1);
    double stick[2];
    tr_frame_stick(&p.b.world, &r, stick);
    assert_close(stick[0], -1, 0, 1e-12);
    assert_close(stick[1], 0, 0, 1e-12); /* half of 2a, from the entering edge */
    close_pair(&p);
}

/* A wall does not turn: V_r of Wang is s2 alone there, the mean flow half of both. */
static void a_wall(void **state) {
    (void)state;
    for (int wang = 0; wang < 2; wang++) {
        pair p = open_pair(wang ? CREEP ", creep_roll: wang" : CREEP);
        double stick[2];
        tr_record r = contact_of(0.75, 3, -1); /* s1 + s2 > 0, s2 < 0 */
        r.a = -1, r.R1 = 0;
        tr_frame_stick(&p.b.world, &r, stick);
        assert_close(stick[0], wang ? -1 : 0, 0, 1e-12);
        assert_close(stick[1], wang ? 0 : 1, 0, 1e-12);
        close_pair(&p);
    }
}

/* A spring sticks as a whole until it slips as a whole; without friction all slips; broken numbers break nothing. */
static void all_or_nothing(void **state) {
    (void)state;
    pair spring = open_pair("k_n: 10 MPa, friction: coulomb-spring, mu: 0.4, k_t: 10 MPa"),
         none = open_pair("k_n: 10 MPa, friction: none"), smooth = open_pair(SMOOTH);
    const double q[] = {0, 0.5, 0.999, 1, NAN, INFINITY, -1};
    const double slips[] = {0, 0, 0, 1, 0, 1, 0};
    for (int i = 0; i < 7; i++) {
        tr_record r = contact_of(q[i], 1, 1);
        assert_close(tr_frame_field(&spring.b.world, &r, TR_COLOR_SLIP), slips[i], 0, 0);
        assert_close(tr_frame_field(&none.b.world, &r, TR_COLOR_SLIP), 1, 0, 0);
        assert_close(tr_frame_field(&smooth.b.world, &r, TR_COLOR_SLIP), 1, 0, 0);
    }
    close_pair(&spring), close_pair(&none), close_pair(&smooth);
}

static unsigned pixel(const tr_canvas *canvas, int x, int y) {
    const unsigned char *p = tr_canvas_pixels(canvas) + 4 * (y * TR_FRAME_WIDTH + x);
    return (unsigned)p[2] << 16 | (unsigned)p[1] << 8 | p[0];
}

/* q = 0.75: half of the width slips, to the right where material leaves to the right. Under the mean force, disks of
 * half the mean R_star have a bar of their mean radius times sqrt(R_star/(R/2)): 0.02 sqrt(0.0075/0.01) = 0.0173
 * long. */
static void a_bar_in_two_colours(void **state) {
    (void)state;
    tr_status st = {0};
    pair p = open_pair(CREEP);
    tr_canvas *canvas = tr_canvas_create(&st);
    for (int way = -1; way <= 1; way += 2) {
        tr_record r = contact_of(0.75, -way, -way);
        tr_view view = {.world = &p.b.world,
                        .record = &r,
                        .n_records = 1,
                        .color = TR_COLOR_SLIP,
                        .f_mean = 100,
                        .range = 1,
                        .x0 = -0.04,
                        .x1 = 0.04,
                        .y0 = -0.03,
                        .y1 = 0.05};
        tr_draw_biaxial(canvas, &view);
        int left[2] = {TR_FRAME_WIDTH, TR_FRAME_WIDTH}, right[2] = {0};
        unsigned hue[] = {TR_STICKS, TR_SLIDES};
        for (int x = 0; x < 840; x++)
            for (int k = 0; k < 2; k++)
                for (int y = 100; y < 600; y++)
                    if (pixel(canvas, x, y) == hue[k]) left[k] = left[k] < x ? left[k] : x, right[k] = x;
        double scale = (right[0] > right[1] ? right[0] : right[1]) - (left[0] < left[1] ? left[0] : left[1]) + 1;
        double want = (TR_FRAME_HEIGHT - 64 - 28) / 0.08 * 0.02 * sqrt(0.75);
        assert_close(scale, want, 0, 3);
        assert_true(way > 0 ? right[0] < left[1] : right[1] < left[0]);
        for (int k = 0; k < 2; k++) assert_close(right[k] - left[k] + 1, want / 2, 0, 3); /* edges are blended */
        /* and the key */
        int keys[2] = {0};
        for (int x = 850; x < TR_FRAME_WIDTH; x++)
            for (int k = 0; k < 2; k++) keys[k] += pixel(canvas, x, 646) == hue[k];
        assert_true(keys[0] > 40 && keys[1] > 40);
    }
    tr_canvas_free(canvas), close_pair(&p);
}

/* Without a bar at its image a contact at the edge of a cell is seen once. */
static void in_a_cell(void **state) {
    (void)state;
    tr_status st = {0};
    pair p = open_pair(CREEP);
    tr_canvas *canvas = tr_canvas_create(&st);
    p.b.world.cell.side[0] = p.b.world.cell.side[1] = 0.07;
    tr_record r = contact_of(0, 0, 0);
    r.x = 0.035; /* half of it on either side */
    tr_view view = {.world = &p.b.world,
                    .record = &r,
                    .n_records = 1,
                    .color = TR_COLOR_SLIP,
                    .f_mean = 100,
                    .range = 1,
                    .x0 = -0.05,
                    .x1 = 0.05,
                    .y0 = -0.05,
                    .y1 = 0.05};
    tr_draw_biaxial(canvas, &view);
    int left = 0, right = 0;
    for (int x = 0; x < 840; x++)
        for (int y = 100; y < 600; y++) *(x < 420 ? &left : &right) += pixel(canvas, x, y) == TR_STICKS;
    assert_true(left > 100 && right > 100);
    tr_canvas_free(canvas), close_pair(&p);
}

/* Read by a leak-checking build: fontconfig keeps its caches to the end. */
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void) {
    return "leak:libfontconfig\n";
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(creep_slips_where_material_leaves),
                                       cmocka_unit_test(the_ends_slip_without_rolling),
                                       cmocka_unit_test(spheres_go_by_the_cube_root),
                                       cmocka_unit_test(a_wall),
                                       cmocka_unit_test(in_a_cell),
                                       cmocka_unit_test(all_or_nothing),
                                       cmocka_unit_test(a_bar_in_two_colours)};
    return cmocka_run_group_tests_name("slip", tests, NULL, NULL);
}
