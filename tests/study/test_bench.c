/* SPDX-License-Identifier: MIT */
/* The arithmetic of trundle bench, on made-up data, and its packing of tiles. */
#include "assert_close.h"
#include "core/pipeline.h"
#include "core/record.h"
#include "core/step.h"
#include "laws/law.h"
#include "study/bench.h"
#include "study/bench_sizes.h"

#include <stdlib.h>
#include <string.h>

/* y = 3 x^1.25 exactly: only rounding is left. */
static void slope_of_a_power(void **state) {
    (void)state;
    double x[5] = {100, 400, 1e4, 1e5, 1e6}, y[5];
    for (int i = 0; i < 5; i++) y[i] = 3 * pow(x[i], 1.25);
    assert_close(tr_bench_slope(x, y, 5), 1.25, 1e-13, 0);
}

/* By hand, in decades: x = 0, 1, 2, y = 0, 1, 4 lies on no line; least squares gives (4 - 0)/2 = 2, a line through the
 * first two 1, the mean of the slopes from the first (1 + 2)/2. */
static void slope_is_least_squares(void **state) {
    (void)state;
    double x[3] = {1, 10, 100}, y[3] = {1, 10, 1e4}, even[4] = {1, 10, 100, 1000}, uneven[4] = {1, 1, 10, 1};
    assert_close(tr_bench_slope(x, y, 3), 2, 1e-13, 0);
    /* y = 0, 0, 1, 0: sum (x - 1.5) y / sum (x - 1.5)^2 = 0.5/5; the ends alone would give 0. */
    assert_close(tr_bench_slope(even, uneven, 4), 0.1, 1e-13, 0);
}

static void quartiles_of_any_order(void **state) {
    (void)state;
    double values[5] = {7, 1, 9, 3, 5};
    tr_quartiles q = tr_bench_quartiles(values, 5);
    assert_close(q.low, 3, 0, 0);
    assert_close(q.median, 5, 0, 0);
    assert_close(q.high, 7, 0, 0);
    q = tr_bench_quartiles(values,
                           3); /* 1, 7, 9: halfway between the neighbours, so that the two differ from the median */
    assert_close(q.low, 4, 0, 0);
    assert_close(q.median, 7, 0, 0);
    assert_close(q.high, 8, 0, 0);
    assert_close(values[0], 7, 0, 0); /* they stay as they were: row k of all columns is one repeat */
}

enum { WALLS = 4 };

/* Touching contacts now: disk-disk, and of each wall. */
static int count(tr_world *world, int of_wall[WALLS]) {
    tr_record *records = NULL;
    tr_status st = {0};
    int capacity = 0, disks = 0;
    memset(of_wall, 0, WALLS * sizeof *of_wall);
    assert_true(tr_step_forces(world, &st));
    int n = tr_record_all(world, &records, &capacity, &st);
    for (int i = 0; i < n; i++) *(records[i].a < 0 ? &of_wall[-1 - records[i].a] : &disks) += 1;
    free(records);
    return disks;
}

static void read_case(tr_scene *scene, int disks) {
    char text[300];
    tr_status st = {0};
    snprintf(text, sizeof text,
             "kind: biaxial\nsample: {disks: %d, r_min: 0.76 mm, r_max: 1.52 mm}\ncontact: {k_n: 160 MPa, mu: 0.5, "
             "mu_r: 0.5}\n"
             "compaction: {pressure: 160 kPa, inertial_number: 0.1, unbalanced: 1e-2}\n",
             disks);
    if (!tr_scene_read(scene, &(tr_scene_source){"a.yaml", text, strlen(text), NULL, 0}, tr_laws_catalog(), &st))
        fail_msg("%s", st.text);
}

/* What a scene does beside another one is what it does alone: the same contacts, to the last one. */
static void each_scene_has_its_sample(void **state) {
    (void)state;
    tr_scene scene[2];
    tr_status st = {0};
    tr_bench_report two[2], alone;
    for (int i = 0; i < 2; i++) read_case(&scene[i], 40), scene[i].shear.strain_end = 0.02;
    for (int k = 0; k < tr_laws_catalog()->n_rolling; k++)
        if (!tr_laws_rolling[k]->step) scene[1].contact.rolling.law = k;
    assert_true(tr_bench((const tr_scene *const[]){&scene[0], &scene[1]}, 2, 1, true, two, &st));
    assert_true(tr_bench((const tr_scene *const[]){&scene[1]}, 1, 1, true, &alone, &st));
    assert_true(two[1].touching == alone.touching && two[1].listed == alone.listed);
    assert_true(two[0].touching != alone.touching);
    tr_scene_free(&scene[0]), tr_scene_free(&scene[1]);
}

/* 2 x 2 tiles, mirrored at the right and at the top wall of the first: a contact with either becomes one of a disk with
 * its image, in both rows (columns); the contacts with the left and the bottom wall are there twice, at either end. All
 * contacts of disks are there four times. Tiles that are only shifted meet wrong neighbours, and miss these numbers. */
static void tiles_are_mirror_images(void **state) {
    (void)state;
    tr_scene scene[2];
    tr_biaxial tile, four;
    tr_status st = {0};
    int of_tile[WALLS], of_four[WALLS];
    read_case(&scene[0], 60), read_case(&scene[1], 240);
    assert_true(tr_biaxial_init(&tile, &scene[0], &st) && tr_bench_compact(&tile, &st) &&
                tr_biaxial_init(&four, &scene[1], &st));
    assert_true(tr_bench_tile(&four, &tile, &st));
    tr_biaxial *samples[] = {&tile, &four};
    for (int i = 0; i < 2; i++) assert_true(tr_world_set_laws(&samples[i]->world, &scene[i].contact, true, 0, &st));
    int disks = count(&tile.world, of_tile), all = count(&four.world, of_four);
    assert_true(of_tile[TR_TOP_WALL] > 2 && of_tile[TR_RIGHT_WALL] > 2);
    assert_int_equal(all, 4 * disks + 2 * of_tile[TR_TOP_WALL] + 2 * of_tile[TR_RIGHT_WALL]);
    assert_int_equal(of_four[TR_BOTTOM_WALL], 2 * of_tile[TR_BOTTOM_WALL]);
    assert_int_equal(of_four[TR_TOP_WALL], 2 * of_tile[TR_BOTTOM_WALL]);
    assert_int_equal(of_four[TR_LEFT_WALL], 2 * of_tile[TR_LEFT_WALL]);
    assert_int_equal(of_four[TR_RIGHT_WALL], 2 * of_tile[TR_LEFT_WALL]);
    tr_biaxial_free(&tile), tr_biaxial_free(&four);
    tr_scene_free(&scene[0]), tr_scene_free(&scene[1]);
}

/* Disks whose numbers differ by k are no more than sqrt(6 k) mean distances apart, the bound of Hilbert's curve (|x(s)
 * - x(t)|^2 <= 6 |s - t| in the unit square); 10 more for the disks that a stretch of the curve lacks. Rows of 46 break
 * it, where two follow each other that are 45 apart, and so does any order of quarters that leaps. */
static void assert_by_place(const tr_world *world, double width, double height) {
    int n = world->disks.n;
    const double *q = world->disks.pos;
    for (int k = 1; k <= 625; k *= 5)
        for (int i = 0; i < n - k; i++) {
            double dx = q[4 * (i + k)] - q[4 * i], dy = q[4 * (i + k) + 1] - q[4 * i + 1];
            assert_true((dx * dx + dy * dy) / (width * height / n) < 6 * (k + 10));
        }
}

static void numbers_are_by_place(void **state) {
    (void)state;
    tr_scene scene[2];
    tr_biaxial tile, many;
    tr_status st = {0};
    read_case(&scene[0], 60), read_case(&scene[1], 2160);
    assert_true(tr_biaxial_init(&tile, &scene[0], &st) && tr_biaxial_init(&many, &scene[1], &st));
    const tr_wall *w = many.world.wall;
    double area = 0, tiles = 0, of_tile = 0;
    for (int i = 0; i < 2160; i++) area += many.world.disks.mass[i] / scene[1].sample.density;
    assert_close(area / (w[TR_RIGHT_WALL].x * w[TR_TOP_WALL].y), 0.4, 1e-12, 0); /* the fraction of the loose sample */
    assert_by_place(&many.world, w[TR_RIGHT_WALL].x, w[TR_TOP_WALL].y);
    assert_true(tr_bench_tile(&many, &tile, &st));
    for (int i = 0; i < 2160; i++) tiles += many.world.disks.mass[i];
    for (int i = 0; i < 60; i++) of_tile += tile.world.disks.mass[i];
    assert_close(tiles, 36 * of_tile, 1e-12, 0);
    assert_by_place(&many.world, w[TR_RIGHT_WALL].x, w[TR_TOP_WALL].y);
    tr_biaxial_free(&tile), tr_biaxial_free(&many);
    tr_scene_free(&scene[0]), tr_scene_free(&scene[1]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(slope_of_a_power),        cmocka_unit_test(slope_is_least_squares),
        cmocka_unit_test(quartiles_of_any_order),  cmocka_unit_test(each_scene_has_its_sample),
        cmocka_unit_test(tiles_are_mirror_images), cmocka_unit_test(numbers_are_by_place),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
