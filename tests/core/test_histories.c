/* SPDX-License-Identifier: MIT */
/* What a scene leaves out has no history array, counted by hand: per contact coulomb-spring and wang-spring keep
 * one number each (Q, T), conjugate-spring three (T and two derivatives), star-force-proportional two; the ledger keeps
 * two of the normal force (dashpot, overlap), two of friction (Q, energy), two of rolling (moment, energy), of a law
 * with a force its couple too, and of one whose moments are not opposite the other moment. */
#include "core/ledger.h"
#include "core/worlds.h"

enum { DISKS = 60 };

static tr_scene scene_of(test_laws laws, const char *rolling, bool ledger, bool rough) {
    tr_scene scene = biaxial_scene(DISKS, 1, laws);
    const tr_param_catalog *catalog = tr_laws_catalog();
    if (rolling) {
        scene.contact.rolling = law_named(tr_laws_rolling, catalog->n_rolling, rolling);
        set_parameter(&scene.contact.rolling, catalog->rolling[scene.contact.rolling.law], "mu_r", laws.mu_r);
        if (strncmp(rolling, "star", 4) != 0)
            set_parameter(&scene.contact.rolling, catalog->rolling[scene.contact.rolling.law], "k_r", laws.k_r);
    }
    scene.compaction.unbalanced = 1e-2;
    scene.shear.walls = rough;
    scene.output.energy = ledger;
    return scene;
}

/* Arrays of the disks' and the walls' contacts, and that there are none behind them. */
static void assert_arrays(const tr_world *world, int disks, int walls) {
    const int wanted[2] = {disks, walls};
    for (int k = 0; k < 2; k++) {
        const tr_group *g = &world->group[k];
        assert_true(g->n > 0);
        for (int h = 0; h < TR_GROUP_HIST; h++) assert_int_equal(g->hist[h] != NULL, h < wanted[k]);
    }
    assert_int_equal(tr_world_histories(world), disks + walls);
}

static void assert_case(test_laws laws, const char *rolling, bool ledger, bool rough, int disks, int walls) {
    tr_scene scene = scene_of(laws, rolling, ledger, rough);
    tr_biaxial b;
    compact(&b, &scene);
    assert_arrays(&b.world, 0, 0); /* frictionless, without ledger */
    begin_shear(&b);
    shear_steps(&b, 10);
    assert_arrays(&b.world, disks, walls);
    tr_biaxial_free(&b);
}

static const test_laws bare = {.k_n = 160e6, .damping_ratio = 0.3},
                       slides = {.k_n = 160e6, .damping_ratio = 0.3, .mu = 0.5, .k_t = 80e6},
                       rolls = {.k_n = 160e6, .damping_ratio = 0.3, .mu_r = 0.5, .k_r = 80e6};

static void test_no_array_of_an_unused_history(void **state) {
    (void)state;
    assert_case(bare, NULL, false, false, 0, 0);
    assert_case(slides, NULL, false, false, 1, 0);
    assert_case(rolls, NULL, false, false, 1, 0);
    assert_case(sand, NULL, false, false, 2, 0);
    assert_case(sand, NULL, false, true, 2, 2);
}

static void test_the_ledger_keeps_what_the_laws_need(void **state) {
    (void)state;
    assert_case(bare, NULL, true, false, 2, 2);
    assert_case(slides, NULL, true, false, 1 + 2 + 2, 2);
    assert_case(rolls, NULL, true, false, 1 + 2 + 2, 2);
    assert_case(sand, NULL, true, true, 2 + 2 + 2 + 2, 2 + 2 + 2 + 2);
    assert_case(sand, "conjugate-spring", true, false, 4 + 2 + 2 + 3, 2);
    assert_case(sand, "star-force-proportional", true, false, 3 + 2 + 2 + 3, 2);
}

/* A ledger of a single slot is no other account of it: with rolling resistance that never acts (k_r, mu_r tiny) the
 * energies of normal force and friction are those of the scene without the law. Tolerance: the share of the tiny
 * spring. */
static void test_accounts_do_not_depend_on_their_places(void **state) {
    (void)state;
    tr_energy e[2][2];
    for (int with = 0; with < 2; with++)
        for (int rough = 0; rough < 2; rough++) {
            test_laws laws = slides;
            if (with) laws.mu_r = laws.k_r = 1e-9;
            tr_scene scene = scene_of(laws, NULL, true, rough);
            tr_biaxial b;
            compact(&b, &scene);
            begin_shear(&b);
            shear_steps(&b, 200);
            shear_forces(&b);
            e[with][rough] = tr_ledger_read(&b.world);
            tr_biaxial_free(&b);
        }
    for (int rough = 0; rough < 2; rough++) {
        const tr_energy *p = &e[0][rough], *q = &e[1][rough];
        assert_true(p->friction > 0 && p->elastic_friction > 0 && p->elastic_normal > 0 && p->elastic_rolling == 0);
        assert_close(q->elastic_normal, p->elastic_normal, 1e-9, 0);
        assert_close(q->elastic_friction, p->elastic_friction, 1e-9, 0);
        assert_close(q->friction, p->friction, 1e-9, 0);
        assert_close(q->damped, p->damped, 1e-9, 0);
    }
}

/* Bytes: an array of n numbers is there twice, for the list and for the one before its renewal. */
static void test_bytes_of_the_arrays(void **state) {
    (void)state;
    size_t bytes[2];
    int capacity[2];
    for (int k = 0; k < 2; k++) {
        tr_scene scene = scene_of(k ? sand : slides, NULL, false, false);
        tr_biaxial b;
        compact(&b, &scene);
        begin_shear(&b);
        shear_forces(&b); /* the same list in both: the step is the same, and nothing has moved yet */
        bytes[k] = tr_world_bytes(&b.world);
        capacity[k] = b.world.group[0].capacity;
        tr_biaxial_free(&b);
    }
    assert_true(capacity[0] >= DISKS && capacity[0] == capacity[1]);
    assert_int_equal(bytes[1] - bytes[0], sizeof(double) * (size_t)capacity[0]); /* T; no pair constants */
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_no_array_of_an_unused_history),
        cmocka_unit_test(test_the_ledger_keeps_what_the_laws_need),
        cmocka_unit_test(test_accounts_do_not_depend_on_their_places),
        cmocka_unit_test(test_bytes_of_the_arrays),
    };
    return cmocka_run_group_tests_name("histories", tests, NULL, NULL);
}
