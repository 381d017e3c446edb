/* SPDX-License-Identifier: MIT */
/* The inset of frames: the half-plane in it against closed forms of its path; which contacts can have one; where it
 * stands in the frame. */
#include "assert_close.h"
#include "core/bodies.h"
#include "draw/canvas.h"
#include "draw/draw.h"
#include "draw/frame_biaxial.h"
#include "laws/law.h"
#include "study/inset.h"

#include <stdlib.h>
#include <string.h>

#define CREEP "friction: dahlberg-alfredsson, mu: 0.4, k_t: 80 MPa, E_star: 200 MPa"
static const double R1 = 0.01, R2 = 0.02, mu = 0.4, E_star = 200e6, P = 100;

typedef struct pair {
    tr_scene scene;
    tr_bodies b;
    tr_inset inset;
} pair;

static bool open_pair(pair *p, const char *contact, const char *shape, tr_contact_id pick) {
    char text[500];
    tr_status st = {0};
    snprintf(
        text, sizeof text,
        "kind: bodies\nshape: %s\ntime_end: 1\ncontact: {k_n: %s, rolling: none, %s}\nwalls: [{nx: 0, ny: 1, y: -5}]\n"
        "disks: [{radius: 0.01, x: 0, y: 0}, {radius: 0.02, x: 0.0299, y: 0}]\n",
        shape, strcmp(shape, "disk") ? "1 kN/m" : "1 MPa", contact);
    if (!tr_scene_read(&p->scene, &(tr_scene_source){"a.yaml", text, strlen(text), NULL, 0}, tr_laws_catalog(), &st) ||
        !tr_bodies_init(&p->b, &p->scene, &st))
        fail_msg("%s", st.text);
    return tr_inset_open(&p->inset, &p->b.world, pick, &st);
}

static void close_pair(pair *p) {
    tr_inset_close(&p->inset);
    tr_bodies_free(&p->b), tr_scene_free(&p->scene);
}

/* Goes straight to a point in n steps, as an assembly would: short against the elements. */
static void go(pair *p, tr_path_point to, int n) {
    tr_path_point from = p->inset.at, now;
    tr_status st = {0};
    for (int k = 1; k <= n; k++) {
        double part = (double)k / n;
        now = (tr_path_point){.u_slide = from.u_slide + part * (to.u_slide - from.u_slide),
                              .u_roll = from.u_roll + part * (to.u_roll - from.u_roll),
                              .P = from.P + part * (to.P - from.P)};
        if (!tr_inset_step(&p->inset, now, &st)) fail_msg("%s", st.text);
    }
}

/* Rolling on and on at creepage xi: q = 1 - (1 - xi/F0)^2 [Carter]; 60 elements are good to some percent. The way of
 * sliding gives the sign, the way of rolling does not. */
static void carter(void **state) {
    (void)state;
    const double R = R1 * R2 / (R1 + R2), a = sqrt(4 * P * R / (M_PI * E_star)), xi = 0.5 * mu * a / R;
    for (int way = 0; way < 4; way++) {
        pair p;
        double slide = way & 1 ? -1 : 1, roll = way & 2 ? -1 : 1;
        assert_true(open_pair(&p, CREEP, "disk", (tr_contact_id){0, 1}));
        go(&p, (tr_path_point){.P = P}, 1);
        go(&p, (tr_path_point){slide * xi * 15 * a, roll * 15 * a, P, 0}, 20000);
        const tr_patch_state *s = tr_half_plane_state(p.inset.solver);
        assert_close(s->Q / (mu * P), 0.75 * slide, 0, 0.03);
        int slips = 0;
        for (int i = 0; i < s->n; i++) {
            bool leaves = (s->x[i] > 0) == (roll > 0); /* slip: half of the width, where material leaves */
            slips += s->side[i] != 0;
            assert_true(leaves || s->side[i] == 0 || fabs(s->x[i]) < 0.1 * a || fabs(s->x[i]) > 0.95 * a);
        }
        assert_close((double)slips / s->n, 0.5, 0, 0.06);
        close_pair(&p);
    }
}

/* Rolling wears friction off, against four times as many elements that roll by one each step: steps are short
 * enough. */
static void transient(void **state) {
    (void)state;
    pair p;
    tr_status st = {0};
    assert_true(open_pair(&p, CREEP, "disk", (tr_contact_id){0, 1}));
    const double R = R1 * R2 / (R1 + R2), a = sqrt(4 * P * R / (M_PI * E_star)), slide = 6 * mu * P / (M_PI * E_star);
    enum { FINE = 240 };
    tr_half_plane *fine = tr_half_plane_new(&p.inset.pair, FINE, &st);
    assert_true(tr_half_plane_step(fine, &(tr_patch_step){.P = P}, &st));
    for (int i = 0; i < 100; i++)
        assert_true(tr_half_plane_step(fine, &(tr_patch_step){.P = P, .du = slide / 100}, &st));
    go(&p, (tr_path_point){.P = P}, 1);
    go(&p, (tr_path_point){slide, 0, P, 0}, 2000);
    for (int k = 1; k <= 3; k++) {
        go(&p, (tr_path_point){slide, k * a, P, 0}, 2000);
        for (int i = 0; i < FINE / 2; i++)
            assert_true(tr_half_plane_step(fine, &(tr_patch_step){.P = P, .dr = 2 * a / FINE}, &st));
        double q = tr_half_plane_state(p.inset.solver)->Q / (mu * P), right = tr_half_plane_state(fine)->Q / (mu * P);
        print_message("rolled %d a: q = %.4f, fine %.4f\n", k, q, right);
        assert_close(q, right, 0, 0.005);
        assert_true(right > 0.02);
    }
    tr_half_plane_free(fine);
    close_pair(&p);
}

/* Further than it can remember in one step: the steady state, at the cost of a few half-widths. */
static void far_in_one_step(void **state) {
    (void)state;
    pair p;
    const double R = R1 * R2 / (R1 + R2), a = sqrt(4 * P * R / (M_PI * E_star)), xi = 0.5 * mu * a / R;
    assert_true(open_pair(&p, CREEP, "disk", (tr_contact_id){0, 1}));
    go(&p, (tr_path_point){.P = P}, 1);
    go(&p, (tr_path_point){xi * 1e8 * a, 1e8 * a, P, 0}, 1);
    assert_close(tr_half_plane_state(p.inset.solver)->Q / (mu * P), 0.75, 0, 0.03); /* as in carter */
    close_pair(&p);
}

/* Sliding alone stays stuck in the middle, [Cattaneo]: c/a = sqrt(1 - q). Open: nothing, and nothing is remembered. */
static void cattaneo_and_open(void **state) {
    (void)state;
    pair p;
    assert_true(open_pair(&p, CREEP, "disk", (tr_contact_id){0, 1}));
    const double full = 2 * mu * P / (M_PI * E_star);
    go(&p, (tr_path_point){.P = P}, 1);
    go(&p, (tr_path_point){.u_slide = 3 * full, .P = P}, 20000);
    const tr_patch_state *s = tr_half_plane_state(p.inset.solver);
    double q = s->Q / (mu * P);
    int sticks = 0;
    for (int i = 0; i < s->n; i++) sticks += s->side[i] == 0;
    assert_true(q > 0.2 && q < 0.95);
    assert_close((double)sticks / s->n, sqrt(1 - q), 0, 2.0 / s->n + 0.01); /* two edges of an element each */
    go(&p, (tr_path_point){.u_slide = 3 * full, .P = 0}, 1);
    assert_true(tr_half_plane_state(p.inset.solver)->P == 0);
    go(&p, (tr_path_point){.u_slide = 3 * full, .P = P}, 1);
    assert_close(tr_half_plane_state(p.inset.solver)->Q, 0, 0, 1e-9 * P);
    close_pair(&p);
}

static void who_has_one(void **state) {
    (void)state;
    static const struct {
        const char *contact, *shape;
        tr_contact_id pick;
        bool has;
    } rows[] = {{CREEP, "disk", {0, 1}, true},
                {CREEP, "disk", {-1, 1}, true},
                {"friction: coulomb-spring, mu: 0.4", "disk", {0, 1}, false},
                {"friction: none", "disk", {0, 1}, false},
                {"friction: dahlberg-alfredsson, mu: 0, k_t: 80 MPa, E_star: 200 MPa", "disk", {0, 1}, false},
                {"friction: coulomb-spring, mu: 0.4", "sphere", {0, 1}, false}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        pair p;
        assert_int_equal(open_pair(&p, rows[i].contact, rows[i].shape, rows[i].pick), rows[i].has);
        close_pair(&p);
    }
}

/* In the panel between its text and its keys, and a line to the contact; open, no line. */
static void in_the_frame(void **state) {
    (void)state;
    pair p;
    tr_status st = {0};
    assert_true(open_pair(&p, CREEP, "disk", (tr_contact_id){0, 1}));
    tr_canvas *canvas = tr_canvas_create(&st);
    const tr_view_line line[5] = {{"a", "1"}, {"b", "2"}, {"c", "3"}, {"d", "4"}, {"e", "5"}};
    tr_view view = {.world = &p.b.world,
                    .range = 1,
                    .f_mean = 1,
                    .x0 = -0.02,
                    .x1 = 0.06,
                    .y0 = -0.04,
                    .y1 = 0.04,
                    .line = line,
                    .n_lines = 5};
    enum { W = TR_FRAME_WIDTH, H = TR_FRAME_HEIGHT };
    unsigned *plain = malloc(W * H * sizeof *plain);
    tr_draw_biaxial(canvas, &view);
    memcpy(plain, tr_canvas_pixels(canvas), W * H * sizeof *plain);
    for (int open = 0; open < 2; open++) {
        go(&p, (tr_path_point){.P = open ? 0 : P}, 1);
        view.inset = tr_half_plane_state(p.inset.solver), view.inset_pair = &p.inset.pair, view.inset_b = 1;
        tr_draw_biaxial(canvas, &view);
        const unsigned *with = (const void *)tr_canvas_pixels(canvas);
        int in_panel = 0, in_picture = 0, elsewhere = 0;
        for (int k = 0; k < W * H; k++) {
            if (with[k] == plain[k]) continue;
            bool panel = k % W > 845, between = k / W > 270 && k / W < 545;
            *(panel && between ? &in_panel : panel ? &elsewhere : &in_picture) += 1;
        }
        assert_true(in_panel > 1000);
        assert_true(open ? in_picture == 0 : in_picture > 300);
        assert_int_equal(elsewhere, 0);
    }
    free(plain), tr_canvas_free(canvas), close_pair(&p);
}

/* Read by a leak-checking build: fontconfig keeps its caches to the end. */
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void) {
    return "leak:libfontconfig\n";
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(carter),          cmocka_unit_test(transient),
                                       cmocka_unit_test(far_in_one_step), cmocka_unit_test(cattaneo_and_open),
                                       cmocka_unit_test(who_has_one),     cmocka_unit_test(in_the_frame)};
    return cmocka_run_group_tests_name("inset", tests, NULL, NULL);
}
