/* SPDX-License-Identifier: MIT */
/* Which tangent bodies are told of, and with what overlap. Each scene is a row: what a teacher may write, and what is
 * meant by it. */
#include "assert_close.h"
#include "core/step.h"
#include "core/tangent.h"
#include <glob.h>
#include <string.h>

static tr_scene scene;
static tr_bodies b;

static void open_text(const char *text) {
    tr_status st = {0};
    if (!tr_scene_read(&scene, &(tr_scene_source){"a", text, strlen(text), NULL, 0}, tr_laws_catalog(), &st))
        fail_msg("%s", st.text);
    if (!tr_bodies_init(&b, &scene, &st)) fail_msg("%s", st.text);
}

static void close_text(void) {
    tr_bodies_free(&b);
    tr_scene_free(&scene);
}

#define HEAD                                                                                                           \
    "kind: bodies\ntime_end: 10 ms\ncontact: {k_n: 1 MPa, friction: coulomb-spring, mu: 0.5, k_t: 1 MPa, rolling: "    \
    "none}\n"
#define DOWN "gravity: {y: -10}\n"
#define FLOOR "walls: [{nx: 0, ny: 1}]\n"
#define BIG(more) "{radius: 20 mm, x: 0, y: 0, " more "}"
#define SMALL(more) "{radius: 10 mm, " more "}"

typedef struct row {
    const char *what, *text;
    int pairs;
} row;

static const row rows[] = {
    {"a driver and a pinned disk",
     HEAD "disks: [" BIG("spin: 1, motion: prescribed") ", " SMALL("x: 30 mm, y: 0, motion: pinned") "]", 1},
    {"the same, the other way about",
     HEAD "disks: [" SMALL("x: 30 mm, y: 0, motion: pinned") ", " BIG("spin: 1, motion: prescribed") "]", 1},
    {"two pinned disks, to be turned",
     HEAD "disks: [" BIG("motion: pinned") ", " SMALL("x: 30 mm, y: 0, motion: pinned") "]", 1},
    {"given spins",
     HEAD "disks: [" BIG("motion: prescribed, spin: 1") ", " SMALL("x: 30 mm, y: 0, motion: prescribed") "]", 1},
    {"an orbit", HEAD "disks: [" BIG("motion: prescribed") ", " SMALL("x: 30 mm, y: 0, motion: orbit, orbit: 1") "]",
     1},
    {"a gap of digits, in a direction",
     HEAD "disks: [" BIG("spin: 1, motion: prescribed") ", " SMALL("x: 21.214 mm, y: 21.214 mm, motion: pinned") "]",
     1},
    {"on a given floor", HEAD FLOOR "disks: [" SMALL("x: 0, y: radius, vx: 1, motion: prescribed") "]", 1},
    {"a free disk that spins on a held one",
     HEAD "disks: [" BIG("motion: prescribed") ", " SMALL("x: 30 mm, y: 0, spin: 3") "]", 1},
    {"a weight on a floor", HEAD DOWN FLOOR "disks: [" SMALL("x: 0, y: radius") "]", 1},
    {"a weight above a floor, by less than it will press", HEAD DOWN FLOOR "disks: [" SMALL("x: 0, y: 10.005 mm") "]",
     1},
    {"a weight pressed by half of what it needs", HEAD DOWN FLOOR "disks: [" SMALL("x: 0, y: 9.996 mm") "]", 0},
    {"a weight that rolls", HEAD DOWN FLOOR "disks: [" SMALL("x: 0, y: radius, vx: 1, spin: -vx/radius") "]", 1},
    {"a weight on a held disk", HEAD DOWN "disks: [" BIG("motion: pinned") ", " SMALL("x: 0, y: 30 mm") "]", 1},
    {"a stack, both tangent", HEAD DOWN FLOOR "disks: [" SMALL("x: 0, y: 10 mm") ", " SMALL("x: 0, y: 30 mm") "]", 2},
    {"pressed enough",
     HEAD "disks: [" BIG("spin: 1, motion: prescribed") ", " SMALL("x: 29.999 mm, y: 0, motion: pinned") "]", 0},
    {"pressed by its weight",
     HEAD DOWN FLOOR "disks: [" SMALL("x: 0, y: radius - density*pi*radius^2*10 m/s^2/contact.k_n") "]", 0},
    {"about to collide", HEAD "disks: [" BIG("vx: 1") ", " SMALL("x: 30 mm, y: 0, vx: -1") "]", 0},
    {"moved onto each other",
     HEAD "disks: [" BIG("vx: 1, motion: prescribed") ", " SMALL("x: 30 mm, y: 0, motion: prescribed") "]", 0},
    {"thrown off a floor", HEAD DOWN FLOOR "disks: [" SMALL("x: 0, y: radius, vy: 1") "]", 0},
    {"Newton's cradle",
     HEAD "disks: [" SMALL("x: -50 mm, y: 0, vx: 1") ", " SMALL("x: 0, y: 0") ", " SMALL("x: 20 mm, y: 0") "]", 0},
    {"a bottom of fixed disks",
     HEAD "disks: [" BIG("motion: prescribed") ", " SMALL("x: 30 mm, y: 0, motion: prescribed") "]", 0},
    {"two that fall side by side", HEAD DOWN "disks: [" SMALL("x: 0, y: 0") ", " SMALL("x: 20 mm, y: 0") "]", 0},
    {"two that fall one above the other", HEAD DOWN "disks: [" SMALL("x: 0, y: 0") ", " SMALL("x: 0, y: 20 mm") "]", 0},
    {"apart", HEAD "disks: [" BIG("spin: 1, motion: prescribed") ", " SMALL("x: 31 mm, y: 0, motion: pinned") "]", 0},
    {"dropped", HEAD DOWN FLOOR "disks: [" SMALL("x: 0, y: 11 mm") "]", 0},
};

static void tangent_pairs_that_cannot_be_meant_are_found_and_no_others(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        tr_tangent t = {0};
        open_text(rows[i].text);
        int pairs = tr_tangent_find(&b, &t) ? 1 + t.more : 0;
        if (pairs != rows[i].pairs) fail_msg("%s: %d pairs, expected %d", rows[i].what, pairs, rows[i].pairs);
        close_text();
    }
}

/* m g/k_n, worked out here; on a slope of 30 degrees cos(30 deg) of it. 1e-9: the place is moved by 1e-5 of itself. */
static void the_overlap_is_what_the_weight_needs_and_the_place_gives_it(void **state) {
    (void)state;
    const double weight = 2700 * M_PI * 1e-4 * 10, k_n = 1e6;
    tr_tangent t;
    open_text(HEAD DOWN FLOOR "disks: [" SMALL("x: 0, y: radius") "]");
    assert_true(tr_tangent_find(&b, &t) && t.weight && t.a == -1 && t.b == 0 && t.moved == 0);
    assert_close(t.overlap, weight / k_n, 1e-12, 0);
    assert_close(0.01 - t.y, weight / k_n, 1e-9, 0);
    assert_close(t.x, 0, 0, 1e-18);
    close_text();
    open_text(HEAD DOWN
              "walls: [{nx: -0.5, ny: 0.86602540378443865}]\ndisks: [" SMALL("x: -5 mm, y: 8.6602540378443865 mm") "]");
    assert_true(tr_tangent_find(&b, &t) && t.weight);
    assert_close(t.overlap, weight * cos(M_PI / 6) / k_n, 1e-12, 0);
    close_text();
    /* the lower one is held: the free one is moved, up here */
    open_text(HEAD "gravity: {y: 10}\ndisks: [" SMALL("x: 0, y: -30 mm") ", " BIG("motion: pinned") "]");
    assert_true(tr_tangent_find(&b, &t) && t.weight && t.moved == 0);
    assert_close(t.y + 0.03, weight / k_n, 1e-9, 0);
    close_text();
}

/* Tangent, a pinned disk hardly turns beside a driven one; with the overlap of the note, friction mu P on its rim
 * speeds it up by mu P R/I while it slides, P = k_n overlap. 1e-3: the first of 10,000 steps has no friction yet, the
 * last half a kick to come, and the spring of friction is wound up after mu P/(k_t V_s) = 2.5 of them. */
static void with_that_overlap_friction_turns_the_disk(void **state) {
    (void)state;
    static const char text[] = "kind: bodies\ntime_end: 10 ms\nstep: {dt: 1 us}\n"
                               "contact: {k_n: 1 MPa, friction: coulomb-spring, mu: 0.5, k_t: 1 MPa, rolling: none}\n"
                               "disks:\n"
                               "  - {radius: 20 mm, x: 0, y: 0, spin: 10, motion: prescribed}\n"
                               "  - {radius: 10 mm, x: %.12g, y: 0, motion: pinned}\n";
    char moved[600];
    tr_tangent t;
    tr_status st = {0};
    double x = 0.03, spin[2];
    for (int k = 0; k < 2; k++) {
        snprintf(moved, sizeof moved, text, x);
        open_text(moved);
        assert_int_equal(tr_tangent_find(&b, &t), k == 0);
        x = t.x;
        for (int64_t i = 0; i < b.steps; i++) {
            tr_bodies_advance(&b);
            if (!tr_step_forces(&b.world, &st)) fail_msg("%s", st.text);
        }
        spin[k] = b.world.disks.vel[6];
        close_text();
    }
    const double m = 2700 * M_PI * 1e-4, P = 1e6 * 1e-4 * 0.01, expected = 0.5 * P * 0.01 / (0.5 * m * 1e-4) * 0.01;
    assert_close(spin[1], -expected, 1e-3, 0);
    assert_true(fabs(spin[0]) < 1e-6 * expected);
}

static void no_shipped_case_has_tangent_bodies(void **state) {
    (void)state;
    glob_t files;
    assert_int_equal(glob("cases/*.yaml", 0, NULL, &files), 0);
    for (size_t i = 0; i < files.gl_pathc; i++) {
        tr_status st = {0};
        tr_tangent t;
        tr_scene all;
        if (strstr(files.gl_pathv[i], "/sweep")) continue;
        if (!tr_scene_read_file(&all, files.gl_pathv[i], NULL, 0, tr_laws_catalog(), &st)) fail_msg("%s", st.text);
        for (int k = 0; k <= all.n_more && all.kind == TR_KIND_BODIES; k++) {
            if (!tr_bodies_init(&b, k ? &all.more[k - 1] : &all, &st)) fail_msg("%s", st.text);
            if (tr_tangent_find(&b, &t)) fail_msg("%s: %d and %d are tangent", files.gl_pathv[i], t.a, t.b);
            tr_bodies_free(&b);
        }
        tr_scene_free(&all);
    }
    globfree(&files);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tangent_pairs_that_cannot_be_meant_are_found_and_no_others),
        cmocka_unit_test(the_overlap_is_what_the_weight_needs_and_the_place_gives_it),
        cmocka_unit_test(with_that_overlap_friction_turns_the_disk),
        cmocka_unit_test(no_shipped_case_has_tangent_bodies),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
