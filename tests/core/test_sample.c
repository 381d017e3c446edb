/* SPDX-License-Identifier: MIT */
/* Thrown samples: whatever the seed, every disk has a place, inside of the box and without overlap. Checked pair by
 * pair, without the grid that the throw uses. */
#include "core/sample.h"
#include "assert_close.h"

/* The shortest distance of two centres in one coordinate, in a box that repeats. */
static double apart(double a, double b, double side, bool periodic) {
    double d = fabs(a - b);
    return periodic ? fmin(d, side - d) : d;
}

/* The side over that of solid fraction 0.4, or of two large disks in a row. */
static double check_throw(int n, double ratio, bool periodic, uint64_t seed) {
    const tr_scene_sample sample = {.disks = n, .r_min = 2e-3 / ratio, .r_max = 2e-3, .density = 2700};
    tr_world world;
    tr_status st = {0};
    double side = 0, area = 0;
    assert_true(tr_world_init(&world, n, TR_SHAPE_DISK, &st));
    if (!tr_sample_throw(&world, &sample, periodic, seed, &side, &st))
        fail_msg("%d disks, ratio %g, seed %d: %s", n, ratio, (int)seed, st.text);
    for (int i = 0; i < n; i++) {
        const double *p = world.disks.pos + 4 * i, edge = periodic ? 0 : p[3] * (1 - 1e-15);
        area += M_PI * p[3] * p[3];
        assert_true(p[3] >= sample.r_min && p[3] <= sample.r_max);
        assert_true(fmin(p[0], p[1]) >= edge && fmax(p[0], p[1]) <= side - edge);
        for (int j = 0; j < i; j++) {
            const double *q = world.disks.pos + 4 * j; /* to rounding of the squares */
            double d = hypot(apart(p[0], q[0], side, periodic), apart(p[1], q[1], side, periodic));
            assert_true(d >= (p[3] + q[3]) * (1 - 1e-14));
        }
    }
    tr_world_free(&world);
    return side / fmax(sqrt(area / 0.4), 4 * sample.r_max);
}

/* Seeds 1, 17 and 29 of 3 disks, 5 and 8 of 5, 3 of 10 leave no room for the last one in the box of solid fraction
 * 0.4. */
static void every_seed_finds_room(void **state) {
    (void)state;
    static const int sizes[] = {2, 3, 5, 10, 20, 30};
    int wider = 0;
    for (int k = 0; k < 6; k++)
        for (uint64_t seed = 1; seed <= 5; seed++) {
            check_throw(sizes[k], seed == 1 ? 10 : 2, true, seed);
            wider += check_throw(sizes[k], 2, false, seed) > 1;
        }
    assert_true(wider >= 3);
}

/* Most seeds need no wider box, and a box is never wider than it must be by much: 1.25 once for all that are known. */
static void the_box_is_dense_where_it_can_be(void **state) {
    (void)state;
    for (uint64_t seed = 1; seed <= 20; seed++) assert_true(check_throw(200, 2, seed % 2, seed) == 1);
    assert_close(check_throw(3, 2, false, 17), 1.25, 1e-12, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_seed_finds_room),
        cmocka_unit_test(the_box_is_dense_where_it_can_be),
    };
    return cmocka_run_group_tests_name("sample", tests, NULL, NULL);
}
