/* SPDX-License-Identifier: MIT */
/* Threads change no bit: the same world moved by one thread, by two, by three and by a number that changes on the way,
 * as after a restart. Between walls and in a periodic cell, with ledger and arcs. One thread runs another code, which
 * stores nothing: the reference. */
#include "core/increments.h"
#include "core/paths.h"
#include "core/pipeline.h"
#include "core/worlds.h"
#include <string.h>

/* 4900 disks of a lattice that overlap by up to 2.5 % or not at all, numbered by rows: each share of the disks has
 * contacts with the next one, and in a cell the first with the last. In 60 steps the fastest disks move 0.2 mm, four
 * times half the thin skin: lists are renewed. */
enum { ROW = 70, STEPS = 60 };

static void set_threads(tr_world *world, int n) {
    tr_status st = {0};
    if (!tr_world_set_threads(world, n, &st)) fail_msg("%s", st.text);
}

static void move(tr_world *world, bool periodic, int threads, int threads_later) {
    const double pitch = 1.95e-3, side = ROW * pitch;
    tr_random random = tr_random_seed(7, 1);
    new_world(world, ROW * ROW);
    for (int i = 0; i < ROW * ROW; i++) {
        double x = (i % ROW + 0.5) * pitch - side / 2, y = (i / ROW + 0.5) * pitch - side / 2;
        tr_world_set_disk(world, i,
                          &(tr_disk_start){x, y, 0, 0.96e-3 + 0.04e-3 * tr_random_uniform(&random), 2700, false});
        set_velocity(world, i, 4 * tr_random_uniform(&random) - 2, 4 * tr_random_uniform(&random) - 2, 100);
    }
    if (periodic)
        world->cell = (tr_periodic_cell){.side = {side, side}, .rate = {-0.1, 0.1}};
    else
        world->wall[0] = (tr_wall){.y = -side / 2, .ny = 1}, world->wall[1] = (tr_wall){.x = -side / 2, .nx = 1},
        world->n_walls = 2;
    set_gravity(world, 0, -9.81);
    test_laws laws = sand;
    laws.arms = periodic ? "shared" : "midpoint";
    laws.rolling_velocity = "alonso-min"; /* which makes energy: another sum that must not depend on threads */
    set_laws(world, laws, TR_SINK_LEDGER | TR_SINK_ARCS);
    world->dt = 1e-6;
    for (int k = 0; k < 2; k++) {
        set_threads(world, k ? threads_later : threads);
        steps(world, STEPS / 2);
    }
    forces(world);
}

static void assert_same(const tr_world *p, const tr_world *q) {
    assert_same_bits(p, q);
    assert_memory_equal(p->disks.force, q->disks.force, 4 * (size_t)p->disks.n * sizeof(double));
    assert_memory_equal(p->ledger, q->ledger, sizeof *p->ledger);
    assert_memory_equal(&p->cell, &q->cell, sizeof p->cell);
    assert_int_equal(p->contact_updates, q->contact_updates);
    for (int k = 0; k < 2; k++) {
        const tr_group *g = &p->group[k], *h = &q->group[k];
        assert_int_equal(g->n, h->n);
        for (int i = 0; i < g->n_hist; i++) assert_memory_equal(g->hist[i], h->hist[i], (size_t)g->n * sizeof(double));
    }
}

/* Sinks that sum over contacts, or number them, get the same too. */
typedef struct watched {
    tr_world world;
    tr_increments increments;
    tr_paths paths;
} watched;

static void watch(watched *w, int threads) {
    move(&w->world, true, 1, 1);
    test_laws laws = sand;
    set_laws(&w->world, laws, 0);
    w->paths = (tr_paths){.all = true};
    tr_paths_attach(&w->world, &w->paths);
    tr_increments_attach(&w->world, &w->increments);
    set_threads(&w->world, threads);
    steps(&w->world, STEPS);
    forces(&w->world);
}

static void threads_change_no_sum(void **state) {
    (void)state;
    static watched one, more;
    watch(&one, 1);
    assert_true(one.paths.lives > ROW * ROW && one.increments.since.touching > STEPS * ROW * ROW / 2);
    for (int threads = 2; threads <= 3; threads++) {
        watch(&more, threads);
        assert_same_bits(&one.world, &more.world);
        assert_memory_equal(&one.increments.since, &more.increments.since, sizeof one.increments.since);
        assert_int_equal(one.paths.lives, more.paths.lives);
        const tr_group *g = &one.world.group[0], *h = &more.world.group[0];
        assert_int_equal(g->n, h->n);
        for (int i = 0; i < g->n_hist; i++) assert_memory_equal(g->hist[i], h->hist[i], (size_t)g->n * sizeof(double));
        tr_world_free(&more.world);
    }
    tr_world_free(&one.world);
}

static void threads_change_no_bit(void **state) {
    (void)state;
    static const int threads[][2] = {{2, 2}, {3, 3}, {3, 2}, {2, 1}};
    for (int periodic = 0; periodic < 2; periodic++) {
        tr_world one, more;
        move(&one, periodic, 1, 1);
        assert_null(one.parallel); /* of the threads: not made for one */
        assert_true(one.refreshes > 2 && one.contact_updates > STEPS * ROW * ROW / 2);
        assert_true(one.ledger->made[TR_ROLLING] > 0);
        for (int k = 0; k < 4; k++) {
            move(&more, periodic, threads[k][0], threads[k][1]);
            assert_true((more.parallel != NULL) == (threads[k][0] > 1 || threads[k][1] > 1));
            assert_same(&one, &more);
            tr_world_free(&more);
        }
        tr_world_free(&one);
    }
}

/* Nothing of the laws before stays in the lanes of the threads. */
static void threads_forget_other_laws(void **state) {
    (void)state;
    const test_laws frictionless = {.k_n = sand.k_n, .damping_ratio = sand.damping_ratio};
    const test_laws slides = {.k_n = sand.k_n, .mu = 0.5, .k_t = sand.k_n / 2};
    tr_world world[2];
    for (int k = 0; k < 2; k++) {
        move(&world[k], false, k + 1, k + 1);
        for (int law = 0; law < 2; law++) {
            set_laws(&world[k], law ? frictionless : slides, 0);
            set_threads(&world[k], k + 1);
            steps(&world[k], STEPS / 2);
        }
    }
    assert_same_bits(&world[0], &world[1]);
    tr_world_free(&world[0]), tr_world_free(&world[1]);
}

/* Two pairs are crushed: the first of the list is named, whoever lists it. */
static void first_failure_is_named(void **state) {
    (void)state;
    char said[3][sizeof(tr_status)];
    for (int threads = 1; threads <= 3; threads++) {
        tr_world world;
        tr_status st = {0};
        move(&world, false, 1, 1);
        for (int k = 1; k < 3; k++) {
            double *p = world.disks.pos + 4 * (size_t)(k * 2000);
            p[0] = p[4], p[1] = p[5] + 0.1e-3;
        }
        world.stale = true;
        set_threads(&world, threads);
        assert_false(tr_step_forces(&world, &st));
        snprintf(said[threads - 1], sizeof *said, "%s", st.text);
        tr_world_free(&world);
    }
    assert_non_null(strstr(said[0], "2000"));
    assert_string_equal(said[0], said[1]);
    assert_string_equal(said[0], said[2]);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(threads_change_no_bit), cmocka_unit_test(threads_change_no_sum),
                                       cmocka_unit_test(threads_forget_other_laws),
                                       cmocka_unit_test(first_failure_is_named)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
