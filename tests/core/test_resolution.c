/* SPDX-License-Identifier: MIT */
/* Places that cannot carry an overlap are told of, and what is not told of is right: by the closed form of an elastic
 * blow, in which equal disks exchange their velocities wherever they are. */
#include "assert_close.h"
#include "core/bodies.h"
#include "core/resolution.h"
#include "core/worlds.h"
#include <glob.h>

static tr_scene scene;
static tr_bodies b;

static bool try_text(const char *text, tr_status *st) {
    if (!tr_scene_read(&scene, &(tr_scene_source){"a", text, strlen(text), NULL, 0}, tr_laws_catalog(), st))
        fail_msg("%s", st->text);
    if (tr_bodies_init(&b, &scene, st)) return true;
    tr_scene_free(&scene);
    return false;
}

static void open_text(const char *text) {
    tr_status st = {0};
    if (!try_text(text, &st)) fail_msg("%s", st.text);
}

static void close_text(void) {
    tr_bodies_free(&b);
    tr_scene_free(&scene);
}

/* Disks of 1 um, one at rest, the other with 0.02 m/s, 0.01 R apart: at far places too, but for what they round. */
static double blow(double x, double y, double safety, bool *told) {
    char text[600];
    tr_status st = {0};
    tr_resolution r;
    snprintf(text, sizeof text,
             "kind: bodies\ntime_end: 2 us\nstep: {safety: %g}\n"
             "contact: {k_n: 1 MPa, damping_ratio: 0, friction: none, rolling: none}\n"
             "disks: [{radius: 1 um, x: %.17g, y: %.17g, vx: 0.02}, {radius: 1 um, x: %.17g, y: %.17g}]\n",
             safety, x, y, x + 2.01e-6, y);
    open_text(text);
    *told = tr_resolution_overlap(&b, &r);
    *told = tr_resolution_way(&b, &r) || *told;
    for (int64_t i = 0; i < b.steps; i++) {
        tr_bodies_advance(&b);
        if (!tr_step_forces(&b.world, &st)) fail_msg("%s", st.text);
    }
    double change = b.world.disks.vel[4];
    close_text();
    return change;
}

/* (w dt)^2 = (2 safety)^2: of the velocity, what the force of a contact that ends between two steps makes. What is not
 * told of differs from the blow at the origin by a few of the 1e-6 that rounding may take. */
static void a_blow_that_is_not_told_of_exchanges_the_velocities(void **state) {
    (void)state;
    const double safety = 0.005, bound = 4 * safety * safety;
    const double places[] = {0, 1e-3, 0.03, 0.1, 1, 10, 100, 1e3, 1e4, 3.1e4, 1e5};
    bool told;
    double here = blow(0, 0, safety, &told), worst = 0, limit = 0;
    for (size_t i = 0; i < sizeof places / sizeof *places; i++)
        for (int axis = 0; axis < 2; axis++) {
            double x = axis ? 0 : places[i], y = axis ? places[i] : 0, change = blow(x, y, safety, &told);
            if (!told) {
                assert_close(change, 0.02, bound, 0);
                assert_close(change, here, 1e-5, 0);
                limit = fmax(limit, places[i]);
            }
            worst = fmax(worst, fabs(change / 0.02 - 1));
            if (places[i] >= 1e3) assert_true(told);
        }
    print_message("not told of up to %g m; error at most %g\n", limit, worst);
    assert_true(limit >= 0.03);     /* it is no use to tell of everything */
    assert_true(worst > 5 * bound); /* and there was something to tell of */
}

#define HEAD "kind: bodies\ntime_end: 10 ms\ncontact: {k_n: 1 MPa, friction: none, rolling: none}\n"
#define DISK(more) "{radius: 10 mm, " more "}"

typedef struct row {
    const char *what, *text;
    bool overlap, way;
} row;

static const row rows[] = {
    {"a weight on a floor", HEAD "gravity: {y: -10}\nwalls: [{nx: 0, ny: 1}]\ndisks: [" DISK("x: 0, y: 9.99 mm") "]", 0,
     0},
    {"far along a level floor",
     HEAD "gravity: {y: -10}\nwalls: [{nx: 0, ny: 1}]\ndisks: [" DISK("x: 5e5, y: 9.99 mm") "]", 0, 0},
    {"on a floor far up",
     HEAD "gravity: {y: -10}\nwalls: [{y: 5e5, nx: 0, ny: 1}]\ndisks: [" DISK("x: 0, y: 5e5 + 9.99e-3") "]", 1, 0},
    {"a level floor given by a point far away",
     HEAD "gravity: {y: -10}\nwalls: [{x: 1e6, nx: 0, ny: 1}]\ndisks: [" DISK("x: 0, y: 9.99 mm") "]", 0, 0},
    {"a slope given by a point far away",
     HEAD "gravity: {y: -10}\nwalls: [{x: 5e5, y: -5e5, nx: 1, ny: 1}]\ndisks: [" DISK("x: 10 mm, y: 4.13 mm") "]", 1,
     0},
    {"an overlap of 1e-12 m",
     HEAD "disks: [" DISK("x: 0, y: 0, motion: prescribed") ", " DISK("x: 0.02 - 1e-12, y: 0, motion: prescribed") "]",
     1, 0},
    {"an overlap of 1e-9 m",
     HEAD "disks: [" DISK("x: 0, y: 0, motion: prescribed") ", " DISK("x: 0.02 - 1e-9, y: 0, motion: prescribed") "]",
     0, 0},
    {"a grain on a disk of a kilometre",
     HEAD "disks: [{radius: 1000, x: 0, y: 0, motion: prescribed}, {radius: 1 um, x: 1000.000001, y: 0, vx: -1e-3}]", 1,
     1},
    {"hardly a weight",
     HEAD "step: {dt: 1e-9}\ngravity: {y: -1}\nwalls: [{nx: 0, ny: 1}]\ndisks: [{radius: 10 mm, x: 0, y: 10 mm, "
          "density: 1e-3}]",
     1, 0},
    {"carried far away",
     HEAD "disks: [" DISK("x: 0, y: 0, vx: 1e6, motion: prescribed") ", " DISK(
         "x: 19.9 mm, y: 0, vx: 1e6, motion: prescribed") "]\n"
                                                          "step: {dt: 1e-9}\n",
     0, 0},
    {"flown far away",
     "kind: bodies\ntime_end: 1e5 s\ncontact: {k_n: 1 MPa, friction: none, rolling: none}\nstep: {dt: 1 ms}\ndisks: "
     "[" DISK("x: 0, y: 0, vx: 1, motion: prescribed") ", " DISK("x: 19.999 mm, y: 0, vx: 1, motion: prescribed") "]",
     1, 0},
    {"two that never meet",
     HEAD "disks: [" DISK("x: 9e5, y: 0, motion: prescribed") ", " DISK("x: 9e5, y: 1, motion: prescribed") "]", 0, 0},
    {"an orbit about a far centre",
     HEAD "disks: [" DISK("x: 0, y: 0, motion: orbit, orbit: 1e-9, orbit_x: 5e5") ", " DISK(
         "x: 19.999 mm, y: 0, motion: prescribed") "]",
     1, 0},
    {"slower than numbers go", HEAD "disks: [" DISK("x: 1, y: 0, vx: 1e-9, motion: prescribed") "]\nstep: {dt: 1e-7}",
     0, 1},
    {"a slow wall", HEAD "walls: [{x: -1, nx: 1, ny: 0, vx: 1e-9}]\nstep: {dt: 1e-7}\ndisks: [" DISK("x: 1, y: 0") "]",
     0, 1},
    {"a slow orbit", HEAD "disks: [" DISK("x: 1, y: 0, motion: orbit, orbit: 1e-9") "]\nstep: {dt: 1e-7}", 0, 0},
};

static void scenes_whose_places_do_not_carry_are_told_of_and_no_others(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        tr_resolution r;
        open_text(rows[i].text);
        bool overlap = tr_resolution_overlap(&b, &r), way = tr_resolution_way(&b, &r);
        if (overlap != rows[i].overlap || way != rows[i].way)
            fail_msg("%s: overlap %d, way %d", rows[i].what, overlap, way);
        close_text();
    }
}

/* The spacing at 1e5 m is 2^-36 m. The overlap of a blow is v sqrt(m_eff/k_n). */
static void spacing_and_overlap_are_those_worked_out_by_hand(void **state) {
    (void)state;
    tr_resolution r;
    open_text("kind: bodies\ntime_end: 1 us\ncontact: {k_n: 1 MPa, friction: none, rolling: none}\n"
              "disks: [{radius: 1 um, x: 1e5, y: 0, vx: 0.2}, {radius: 1 um, x: 1e5 + 2.01e-6, y: 0}]\n");
    assert_true(tr_resolution_overlap(&b, &r) && r.a == 0 && r.b == 1);
    assert_close(r.spacing, 0x1p-36, 0, 0);
    assert_close(r.size, 0.2 * sqrt(0.5 * 2700 * M_PI * 1e-12 / 1e6), 1e-9, 0);
    close_text();
}

static void where_no_overlap_is_carried_a_case_is_refused(void **state) {
    (void)state;
    tr_status st = {0};
    assert_false(try_text(HEAD "disks: [{radius: 1e-9, x: 1e5, y: 0, vx: 1}, {radius: 1e-9, x: 1e5, y: 5e-9}]\n", &st));
    assert_int_equal(st.code, TR_BAD_CASE);
    assert_non_null(strstr(st.text, "disks 0 and 1: numbers near 1e+05 m are 1.5e-11 m apart"));
}

/* k_n 1e3 and 6e9 times the pressure, between walls and in a cell. The overlap is 2 R p/k_n of the mean radius, 1.14 mm
 * but for the 2 % by which the mean of 60 radii scatters. */
static void too_stiff_a_biaxial_sample_is_told_of(void **state) {
    (void)state;
    for (int k = 0; k < 4; k++) {
        test_laws laws = sand;
        tr_status st = {0};
        tr_resolution r;
        laws.k_n = k % 2 ? 1e15 : 160e6;
        tr_scene s = biaxial_scene(60, 3, laws);
        s.boundary = k / 2;
        s.compaction.inertial_number = 1; /* or so stiff a sample takes too many steps, which is refused */
        tr_biaxial *biaxial = calloc(1, sizeof *biaxial);
        if (!tr_biaxial_init(biaxial, &s, &st)) fail_msg("%s", st.text);
        assert_int_equal(tr_resolution_biaxial(biaxial, &r), k % 2);
        assert_close(r.size, 2 * 1.14e-3 * 160e3 / laws.k_n, 0.05, 0);
        tr_biaxial_free(biaxial);
        free(biaxial);
    }
}

static void no_shipped_case_is_told_of(void **state) {
    (void)state;
    glob_t files;
    assert_int_equal(glob("cases/*.yaml", 0, NULL, &files), 0);
    for (size_t i = 0; i < files.gl_pathc; i++) {
        tr_status st = {0};
        tr_resolution r;
        tr_scene all;
        if (strstr(files.gl_pathv[i], "/sweep")) continue;
        if (!tr_scene_read_file(&all, files.gl_pathv[i], NULL, 0, tr_laws_catalog(), &st)) fail_msg("%s", st.text);
        for (int k = 0; k <= all.n_more && all.kind == TR_KIND_BODIES; k++) {
            if (!tr_bodies_init(&b, k ? &all.more[k - 1] : &all, &st)) fail_msg("%s", st.text);
            if (tr_resolution_overlap(&b, &r) || tr_resolution_way(&b, &r)) fail_msg("%s", files.gl_pathv[i]);
            tr_bodies_free(&b);
        }
        tr_scene_free(&all);
    }
    globfree(&files);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_blow_that_is_not_told_of_exchanges_the_velocities),
        cmocka_unit_test(scenes_whose_places_do_not_carry_are_told_of_and_no_others),
        cmocka_unit_test(spacing_and_overlap_are_those_worked_out_by_hand),
        cmocka_unit_test(too_stiff_a_biaxial_sample_is_told_of),
        cmocka_unit_test(where_no_overlap_is_carried_a_case_is_refused),
        cmocka_unit_test(no_shipped_case_is_told_of),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
