/* SPDX-License-Identifier: MIT */
/* Marks on rims: a wheel that is moved by hand over a floor and past another disk leaves what geometry says. */
#include "assert_close.h"
#include "study/marks.h"
#include <math.h>
#include <string.h>

enum { STEPS = 2000 };

static const double R = 0.1;

/* A wheel that goes by v and turns by w for a time of 1, in steps; from where it stands. */
typedef struct wheel {
    tr_world world;
    double pos[4];
    tr_record record;
    tr_marks marks;
    tr_rim_mark mark[TR_MARKS_MOST];
    int n;
} wheel;

static void start(wheel *h) {
    memset(h, 0, sizeof *h);
    h->world.disks.n = h->world.n_walls = 1;
    h->world.disks.pos = h->pos;
    h->pos[1] = h->pos[3] = R;
    h->world.wall[0].ny = 1;
    h->record = (tr_record){.a = -1, .b = 0, .ny = 1, .R2 = R};
    h->marks.range = 1;
    tr_marks_take(&h->marks, &h->world, &h->record, 1);
}

/* On a floor s1 = v and s2 = -R w: da = int s1 dt, db = -int s2 dt. */
static void go(wheel *h, double v, double w, double time) {
    for (int k = 0; k < STEPS; k++) {
        double dt = time / STEPS;
        h->record.v_s_by[0] = v + R * w, h->record.v_r_by[0] = -R * w;
        h->pos[0] += v * dt, h->pos[2] += w * dt, h->record.x = h->pos[0];
        h->record.da += v * dt, h->record.db += R * w * dt;
        tr_marks_take(&h->marks, &h->world, &h->record, 1);
    }
    h->n = tr_marks_all(&h->marks, h->mark);
}

/* Where a place of the rim is now, in the direction of the contact: 0. */
static double from_contact(const wheel *h, double at) {
    return remainder(at + h->pos[2] + M_PI / 2, 2 * M_PI);
}

static void test_ticks_of_a_rolling_wheel_mesh(void **state) {
    (void)state;
    static wheel h;
    for (int way = -1; way <= 1; way += 2) {
        start(&h);
        const double v = 0.3 * way, apart = 2 * M_PI * R / 10;
        go(&h, v, -v / R, 1);
        int last = (int)(0.3 / apart), ticks = 0;
        assert_int_equal(last, 4);
        for (int i = 0; i < h.n; i++) {
            if (!h.mark[i].number) fail_msg("a wheel that rolls has rubbed");
            ticks++;
            /* the number tells where: so far along the floor, and around the rim. A first step is not yet rolled. */
            double along = way * h.mark[i].number * apart, first = way * 0.3 / STEPS;
            if (h.mark[i].body < 0)
                assert_close(h.mark[i].to, along, 0, 1.01 * fabs(first));
            else
                assert_close(from_contact(&h, h.mark[i].to), (along - 0.3 * way) / R, 0, 1.01 * fabs(first) / R);
        }
        assert_int_equal(ticks, 2 * last);
    }
}

/* As long as what has passed the contact: on the floor the way, on the rim R times the turn. */
static void test_trace_of_a_sliding_wheel_is_as_long_as_what_passed(void **state) {
    (void)state;
    static wheel h;
    const double vw[][2] = {{0.3, 0}, {0.3, 2}, {0.3, 5}, {0, 2}, {-0.2, -3}};
    for (int k = 0; k < 5; k++) {
        start(&h);
        go(&h, vw[k][0], vw[k][1], 1);
        assert_int_equal(h.n, 2);
        for (int i = 0; i < 2; i++) {
            assert_int_equal(h.mark[i].number, 0);
            double length = h.mark[i].to - h.mark[i].from, way = fabs(h.mark[i].body < 0 ? vw[k][0] : vw[k][1]);
            assert_close(length, way, 0, 1.01 * way / STEPS); /* the state of a step is that of its beginning */
        }
    }
}

static void test_slip_then_roll_leaves_a_trace_then_ticks(void **state) {
    (void)state;
    static wheel h;
    start(&h);
    go(&h, 0.3, 0, 1);
    go(&h, 0.3, -3, 1);
    double rubbed_to = 0, first_tick = INFINITY;
    for (int i = 0; i < h.n; i++) {
        if (h.mark[i].body >= 0) continue;
        if (h.mark[i].number)
            first_tick = fmin(first_tick, h.mark[i].to);
        else
            rubbed_to = h.mark[i].to;
    }
    assert_close(rubbed_to, 0.3, 0, 2 * 0.3 / STEPS);
    assert_close(first_tick, 0.3 + 2 * M_PI * R / 10, 0, 3 * 0.3 / STEPS);
}

static void test_rigid_rotation_and_rest_leave_nothing(void **state) {
    (void)state;
    static wheel h;
    start(&h);
    go(&h, 0, 0, 1);
    assert_int_equal(h.n, 0);
    h.marks.range = 0; /* the range is not yet known */
    go(&h, 1, 0, 1);
    assert_int_equal(h.n, 0);
}

/* Many turns: what is left is less than a turn, and the last. */
static void test_only_the_last_turn_is_kept(void **state) {
    (void)state;
    static wheel h;
    start(&h);
    go(&h, 10, -10 / R, 1);
    assert_int_equal(h.n, 2 * TR_MARKS_TICKS);
    int highest = 0, lowest = 1 << 30;
    for (int i = 0; i < h.n; i++) {
        highest = h.mark[i].number > highest ? h.mark[i].number : highest;
        lowest = h.mark[i].number < lowest ? h.mark[i].number : lowest;
    }
    assert_int_equal(highest - lowest, TR_MARKS_TICKS - 1);
    assert_close(highest * 2 * M_PI * R / 10, 10, 0, 2 * M_PI * R / 10 + 0.02);
}

/* After a gap arcs begin anew; marks stay, and nothing is rubbed in between. */
static void test_a_contact_that_opens_leaves_a_gap(void **state) {
    (void)state;
    static wheel h;
    start(&h);
    go(&h, 0.3, 0, 1);
    tr_marks_take(&h.marks, &h.world, &h.record, 0);
    h.pos[0] += 1, h.record.x += 1, h.record.da = h.record.db = 0;
    tr_marks_take(&h.marks, &h.world, &h.record, 1);
    go(&h, 0.3, 0, 1);
    int rubs = 0;
    for (int i = 0; i < h.n; i++) {
        if (h.mark[i].body >= 0) continue;
        rubs++;
        assert_close(h.mark[i].to - h.mark[i].from, 0.3, 0, 1e-3);
    }
    assert_int_equal(rubs, 2);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_ticks_of_a_rolling_wheel_mesh),
        cmocka_unit_test(test_trace_of_a_sliding_wheel_is_as_long_as_what_passed),
        cmocka_unit_test(test_slip_then_roll_leaves_a_trace_then_ticks),
        cmocka_unit_test(test_rigid_rotation_and_rest_leave_nothing),
        cmocka_unit_test(test_only_the_last_turn_is_kept),
        cmocka_unit_test(test_a_contact_that_opens_leaves_a_gap),
    };
    return cmocka_run_group_tests_name("marks", tests, NULL, NULL);
}
