/* SPDX-License-Identifier: MIT */
/* Share of rolling, and fraction of contacts with s1 s2 < 0, of clusters that move as they are told: Wang's pure
 * motions, their combinations by hand, any observer. */
#include "core/measures.h"
#include "core/worlds.h"

enum { N = 3 };
static const double R[N] = {1, 2, 1.5}, OVERLAP = 1e-3;

/* Disks 0-1-2 touch in a bent row, 0 and 2 do not. */
static void cluster(tr_world *world) {
    new_world(world, N);
    double x = 0, y = 0;
    for (int i = 0; i < N; i++) {
        double angle = 0.4 * i, way = i ? R[i - 1] + R[i] - OVERLAP : 0;
        x += way * cos(angle), y += way * sin(angle);
        tr_world_set_disk(world, i, &(tr_disk_start){x, y, 0, R[i], 2700, false});
    }
    world->dt = 1e-9;
    world->allow_unstable = true;
    set_laws(world, (test_laws){.k_n = 1e6, .mu = 0.5, .k_t = 1e6}, 0);
}

static tr_measures measure(tr_world *world, tr_record record[2]) {
    tr_record *records = NULL;
    tr_status st = {0};
    int capacity = 0;
    forces(world);
    int n = tr_record_all(world, &records, &capacity, &st);
    tr_measures m = tr_measures_of(world, records, n);
    assert_int_equal(n, 2);
    memcpy(record, records, 2 * sizeof *record);
    free(records);
    return m;
}

/* Spins alone, the centres at rest: s_1 = R1 w1, s_2 = -R2 w2 on each contact. Arms r_i = R_i (1 - overlap/(R1 +
 * R2)). */
static void test_pure_motions(void **state) {
    (void)state;
    static const struct {
        double w[N], rolled[2], slid[2], opposed;
    } motion[] = {
        {{6, -3, 4}, {6, 6}, {0, 0}, 0},                 /* gears: R w alternates; |V_r| = R w */
        {{5, 5, 5}, {0, 0}, {15, 17.5}, 1},              /* equal spins: |V_s| = (R1 + R2) w */
        {{6, -3, -3}, {6, 0}, {0, 10.5}, 0.5},           /* one rolls, the other slides */
        {{6, 0, 0}, {4, 0}, {6, 0}, 0},                  /* s2 = 0: not opposed; |V_r| = R1 R2 w/(R1 + R2) */
        {{6, 1, 0}, {10.0 / 3, 6.0 / 7}, {8, 2}, 0.5},   /* s1 = 6, s2 = -2; s1 = 2, s2 = 0 */
        {{-6, -1, 0}, {10.0 / 3, 6.0 / 7}, {8, 2}, 0.5}, /* the other way round */
        {{0, 0, 0}, {0, 0}, {0, 0}, 0},                  /* at rest: no share of nothing */
    };
    for (size_t k = 0; k < sizeof motion / sizeof *motion; k++) {
        tr_world world;
        tr_record record[2];
        double rolled = 0, slid = 0;
        cluster(&world);
        for (int i = 0; i < N; i++) set_velocity(&world, i, 0, 0, motion[k].w[i]);
        tr_measures m = measure(&world, record);
        for (int c = 0; c < 2; c++)
            rolled += motion[k].rolled[c], slid += motion[k].slid[c] * (1 - OVERLAP / (R[c] + R[c + 1]));
        /* V_s of gears and V_r of equal spins are sums of terms of size 6 that vanish but for rounding */
        assert_close(m.rolling_share, rolled > 0 ? rolled / (rolled + slid) : 0, 0, 1e-14);
        assert_close(m.opposed_fraction, motion[k].opposed, 0, 0);
        tr_world_free(&world);
    }
}

/* Both are the same for an observer who moves and turns; a contact is opposed where it slides more than material flows
 * through it, |V_s| (R1 + R2)/|X21| > 2 |V_r| of bagi-kuhn. */
static void test_any_motion_any_observer(void **state) {
    (void)state;
    tr_random random = tr_random_seed(3, 1);
    int opposed = 0, bagi_kuhn = 0;
    while (strcmp(tr_rolling_velocities[bagi_kuhn].name, "bagi-kuhn") != 0) bagi_kuhn++;
    for (int k = 0; k < 200; k++) {
        double fraction = 0, first = 0;
        tr_world world;
        cluster(&world);
        for (int i = 0; i < 4 * N; i++) world.disks.vel[i] = i % 4 < 3 ? 2 * tr_random_uniform(&random) - 1 : 0;
        for (int observer = 0; observer < 2; observer++) {
            tr_record c[2];
            tr_measures m = measure(&world, c);
            double more = 0;
            for (int j = 0; j < 2; j++) {
                double length = c[j].R1 + c[j].R2 - c[j].delta;
                more += 0.5 * (fabs(c[j].v_s) * (c[j].R1 + c[j].R2) / length > 2 * fabs(c[j].v_r_by[bagi_kuhn]));
            }
            assert_close(m.opposed_fraction, more, 0, 0);
            if (observer) {
                assert_close(m.opposed_fraction, fraction, 0, 0);
                /* speeds of the observer are 40 times those of the disks, and cancel */
                assert_close(m.rolling_share, first, 0, 1e-12);
            }
            fraction = m.opposed_fraction, first = m.rolling_share;
            for (int i = 0; i < N; i++) {
                double *v = world.disks.vel + 4 * i, *x = world.disks.pos + 4 * i;
                v[0] += 7 - 5 * x[1], v[1] += -3 + 5 * x[0], v[2] += 5;
            }
        }
        opposed += (int)(2 * fraction);
        tr_world_free(&world);
    }
    assert_in_range(opposed, 40, 360); /* of 400: there are both kinds */
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_pure_motions),
                                       cmocka_unit_test(test_any_motion_any_observer)};
    return cmocka_run_group_tests_name("shares", tests, NULL, NULL);
}
