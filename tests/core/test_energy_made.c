/* SPDX-License-Identifier: MIT */
/* Energy that a contact law makes, as the ledger books it: what contacts lost below zero, apart from the net.
 *
 * References: closed forms of two disks that are led along paths on which the spring of rolling ends as it began.
 * With x = T/k_r a step takes k_r (x dW - x dx), where dW is how far the moments' own velocity, R_eff (w1 - w2), has
 * gone, and dx how far V_r has. wang: dW = dx, nothing. On a straight path dW = c dx it loses
 * k_r (c - 1) (x1^2 - x0^2)/2: below zero, and so made, where c < 1 and the spring is loaded, or c > 1 and it gives
 * back.
 */
#include "core/checkpoint.h"
#include "core/ledger.h"
#include "core/pipeline.h"
#include "core/worlds.h"
#include <unistd.h>

enum { STEPS = 50 };
static const double k_n = 1e6, k_r = 1e5, overlap = 1e-6, turn = 1e-4; /* so small that the pair stays where it is */

typedef struct pair {
    tr_world world;
    double R1, R2, L;
    tr_energy energy;
} pair;

/* mu_r is so high that the spring is never cut. rolling NULL: wang-spring. */
static void new_pair(pair *p, double R1, double R2, const char *rolling, const char *velocity) {
    tr_status st = {0};
    *p = (pair){.R1 = R1, .R2 = R2, .L = R1 + R2 - overlap};
    new_world(&p->world, 2);
    tr_world_set_disk(&p->world, 0, &(tr_disk_start){0, 0, 0, R1, 1000, true});
    tr_world_set_disk(&p->world, 1, &(tr_disk_start){0, p->L, 0, R2, 1000, true});
    tr_scene_contact c = contact_of((test_laws){.k_n = k_n, .mu_r = 100, .k_r = k_r, .rolling_velocity = velocity});
    if (rolling) {
        const tr_param_catalog *catalog = tr_laws_catalog();
        c.rolling = law_named(tr_laws_rolling, catalog->n_rolling, rolling);
        set_parameter(&c.rolling, catalog->rolling[c.rolling.law], "mu_r", 100);
        set_parameter(&c.rolling, catalog->rolling[c.rolling.law], "k_r", k_r);
    }
    if (!tr_world_set_laws(&p->world, &c, false, TR_SINK_LEDGER, &st)) fail_msg("%s", st.text);
    p->world.dt = 1e-3, p->world.allow_unstable = true;
    forces(&p->world), tr_ledger_begin(&p->world);
}

/* Turns 1 and 2 by angles, and moves 2 by u along t = (1, 0). */
static void lead(pair *p, double angle1, double angle2, double u) {
    double per = 1 / (STEPS * p->world.dt);
    set_velocity(&p->world, 0, 0, 0, angle1 * per), set_velocity(&p->world, 1, u * per, 0, angle2 * per);
    for (int k = 0; k < STEPS; k++) tr_step_advance(&p->world), forces(&p->world);
    p->energy = tr_ledger_read(&p->world);
}

/* figures/README.md: slide disk 2 by u, spin disk 1, undo both in this order. backwards: the other way round. */
static void slide_and_spin(pair *p, bool backwards) {
    double u = turn * p->L;
    if (backwards) {
        lead(p, turn, 0, 0), lead(p, 0, 0, u), lead(p, -turn, 0, 0), lead(p, 0, 0, -u);
    } else {
        lead(p, 0, 0, u), lead(p, turn, 0, 0), lead(p, 0, 0, -u), lead(p, -turn, 0, 0);
    }
}

static double below(double lost) {
    return lost < 0 ? -lost : 0;
}

/* x is (R1 - R2)/(2L) of the slide and R1/2 of the turn; W is R_eff of the turn alone. The pair turns by u/L =
 * 1e-4 as it slides: the sines and the length are out by 1e-8, the radii's shares in the arms by overlap/L =
 * 1e-4. */
static void bagi_kuhn_makes_energy_in_a_cycle(void **state) {
    (void)state;
    static const double R2[] = {0.002, 0.005, 0.02, 0.1};
    for (int i = 0; i < 4; i++)
        for (int backwards = 0; backwards < 2; backwards++) {
            pair p;
            double R1 = 0.01, R_eff = R1 * R2[i] / (R1 + R2[i]), made = 0, net = 0;
            new_pair(&p, R1, R2[i], NULL, "bagi-kuhn");
            slide_and_spin(&p, backwards);
            double slide = turn * (R1 - R2[i]) / 2, spin = turn * R1 / 2, W = turn * R_eff, x = 0;
            for (int leg = 0; leg < 4; leg++) {
                bool spins = (leg % 2 == 1) != backwards;
                double way = leg < 2 ? 1 : -1, dx = way * (spins ? spin : slide), dW = spins ? way * W : 0;
                /* x may change its sign on the way, and with it what is lost its own */
                double zero = x * (x + dx) < 0 ? -x / dx : 1;
                for (int part = 0; part < 2; part++) {
                    double share = part ? 1 - zero : zero, mean = x + share * dx / 2;
                    double lost = k_r * mean * (dW - dx) * share;
                    net += lost, made += below(lost), x += share * dx;
                }
            }
            /* The closed form of the whole cycle, in the other direction of the account. */
            double cycle = k_r * R_eff * (R2[i] - R1) / (2 * p.L) * (turn * p.L) * turn * (backwards ? -1 : 1);
            assert_close(-net, cycle, 1e-3, 0);
            assert_close(p.energy.rolling, net, 1e-3, 0);
            /* a step in which x changes its sign is booked whole: 1/STEPS of the leg, at an x that is as small */
            assert_close(p.energy.made[TR_ROLLING], made, 1e-3, 1e-6 * fabs(net));
            assert_true(made > 0.5 * k_r * slide * slide || (backwards && R2[i] > R1)); /* where it only takes */
            assert_close(p.energy.elastic_rolling, 0, 0, 1e-6 * fabs(net));
            tr_world_free(&p.world);
        }
}

/* Both rims run by s loads the spring by s and W by s. The second leg has the rims run by -s' and -m s', with s'
 * such that V_r goes back by s. alonso-min: s' = s; alonso-mean: s' = 2 s/(1 + m). On the way W goes back by s'
 * (R2 + m R1)/(R1 + R2). */
static void alonso_makes(const char *velocity, double share) {
    double R1 = 0.02, R2 = 0.01, m = 3, s = turn * R1, back = share * s;
    pair p;
    new_pair(&p, R1, R2, NULL, velocity);
    lead(&p, s / R1, -s / R2, 0);
    tr_energy loaded = p.energy;
    assert_close(loaded.elastic_rolling, k_r * s * s / 2, 1e-9, 0);
    assert_close(loaded.rolling, 0, 0, 1e-12 * loaded.elastic_rolling);
    assert_close(loaded.made[TR_ROLLING], 0, 0, 1e-12 * loaded.elastic_rolling);
    lead(&p, -back / R1, m * back / R2, 0);
    double c = back * (R2 + m * R1) / (R1 + R2) / s;
    double gain = (c - 1) * k_r * s * s / 2;
    print_message("%s: made %.9g of the %.3g in the spring\n", velocity, gain / loaded.elastic_rolling,
                  loaded.elastic_rolling);
    assert_true(gain > 0);
    /* rounding of sums of some hundred terms; s is exact, for nothing slides */
    assert_close(p.energy.made[TR_ROLLING], gain, 1e-9, 0);
    assert_close(p.energy.rolling, -gain, 1e-9, 0);
    assert_close(p.energy.elastic_rolling, 0, 0, 1e-12 * loaded.elastic_rolling);
    /* and the other way round it takes as much, and makes nothing more */
    lead(&p, back / R1, -m * back / R2, 0), lead(&p, -s / R1, s / R2, 0);
    assert_close(p.energy.made[TR_ROLLING], gain, 1e-9, 0);
    assert_close(p.energy.rolling, 0, 0, 1e-9 * gain);
    tr_world_free(&p.world);
}

static void alonso_min_makes_energy_and_the_ledger_says_how_much(void **state) {
    (void)state;
    alonso_makes("alonso-min", 1);
}

static void alonso_mean_makes_energy_and_the_ledger_says_how_much(void **state) {
    (void)state;
    alonso_makes("alonso-mean", 0.5);
}

/* Wang's moments fit its velocity, and so do those of conjugate-spring every one: along the same paths nothing is
 * made. Rounding: of 200 steps, each of the energy in the spring. */
static void laws_with_fitting_forces_make_none(void **state) {
    (void)state;
    static const char *const rolling[] = {NULL, "conjugate-spring"};
    for (int law = 0; law < 2; law++)
        for (int backwards = 0; backwards < 2; backwards++) {
            pair p;
            new_pair(&p, 0.01, 0.03, rolling[law], law ? "bagi-kuhn" : "wang");
            slide_and_spin(&p, backwards);
            lead(&p, turn, -3 * turn, 1e-7), lead(&p, -2 * turn, turn, -2e-7);
            double in_spring = p.energy.elastic_rolling;
            assert_true(in_spring > 0);
            /* the arms of conjugate-spring follow the pair as it turns: a share of 1e-8 of (u/L) */
            assert_close(p.energy.made[TR_ROLLING], 0, 0, (law ? 1e-7 : 1e-13) * in_spring);
            tr_world_free(&p.world);
        }
}

/* Friction that sticks and slides while the normal force rises and falls, in closed loops. A lower bound lets go
 * of what is in the spring: that is lost. A higher one gives nothing back. */
static void friction_makes_none_while_the_normal_force_changes(void **state) {
    (void)state;
    tr_world w;
    new_world(&w, 2);
    tr_world_set_disk(&w, 0, &(tr_disk_start){0, 0, 0, 0.01, 1000, true});
    tr_world_set_disk(&w, 1, &(tr_disk_start){0, 0.02 - 2e-5, 0, 0.01, 1000, true});
    set_laws(&w, (test_laws){.k_n = k_n, .mu = 0.5, .k_t = 0.5 * k_n}, TR_SINK_LEDGER);
    w.dt = 1e-4, w.allow_unstable = true;
    forces(&w), tr_ledger_begin(&w);
    for (int k = 0; k < 4000; k++) {
        double phase = 2 * M_PI * k / 500, spin = 2e-3 * cos(phase + 1) / w.dt / 500;
        set_velocity(&w, 0, 0, 0, spin);
        set_velocity(&w, 1, 0, 0.9 * 2e-5 * 2 * M_PI / 500 * sin(2 * phase) / w.dt, spin);
        tr_step_advance(&w), forces(&w);
    }
    tr_energy e = tr_ledger_read(&w);
    assert_true(e.friction > 1e-5);
    /* 4000 steps, each rounded at the size of what is in the spring, which is below what was lost */
    assert_close(e.made[TR_FRICTION], 0, 0, 1e-12 * e.friction);
    assert_true(e.made[TR_NORMAL] == 0);
    tr_world_free(&w);
}

/* STAR's force-proportional law brakes each spin against the room: a pair that turns as one body by an angle
 * loses mu_r f_n (r1 + r2) angle, though nothing moves in the contact. To the ledger, which stands in the room,
 * it makes nothing; an observer who turns with the pair sees moments, and no work. */
static void a_rigid_turn_costs_star_force_proportional_and_makes_nothing(void **state) {
    (void)state;
    const tr_param_catalog *catalog = tr_laws_catalog();
    double R = 0.01, L = 2 * R - 1e-5, spin = 3, mu_r = 0.1;
    tr_status st = {0};
    tr_world w;
    new_world(&w, 2);
    tr_world_set_disk(&w, 0, &(tr_disk_start){0, 0, 0, R, 1000, true});
    tr_world_set_disk(&w, 1, &(tr_disk_start){0, L, 0, R, 1000, true});
    tr_scene_contact c = contact_of((test_laws){.k_n = k_n});
    c.rolling = law_named(tr_laws_rolling, catalog->n_rolling, "star-force-proportional");
    set_parameter(&c.rolling, catalog->rolling[c.rolling.law], "mu_r", mu_r);
    if (!tr_world_set_laws(&w, &c, false, TR_SINK_LEDGER, &st)) fail_msg("%s", st.text);
    w.dt = 1e-5, w.allow_unstable = true;
    set_velocity(&w, 0, 0, 0, spin), set_velocity(&w, 1, 0, 0, spin);
    forces(&w), tr_step_advance(&w), forces(&w), tr_ledger_begin(&w); /* the moments are there */
    double net = 0;
    for (int k = 0; k < 1000; k++) {
        const double *x = w.disks.pos + 4;
        set_velocity(&w, 1, -spin * x[1], spin * x[0], spin);
        double delta = 2 * R - hypot(x[0], x[1]);
        tr_step_advance(&w), forces(&w);
        net += mu_r * k_n * delta * (2 * R - delta) * spin * w.dt;
    }
    tr_energy e = tr_ledger_read(&w);
    /* explicit steps along the circle let L grow by (spin dt)^2/2 = 4.5e-10 a step, of which 2e3 make a share of
     * the overlap; the first step has half the moment of none before: both below 1e-3 */
    assert_close(e.rolling, net, 1e-3, 0);
    assert_true(e.made[TR_ROLLING] == 0);
    tr_world_free(&w);
}

/* ---- assemblies */

static tr_scene scene_of(test_laws laws) {
    tr_scene scene = biaxial_scene(60, 1, laws);
    scene.compaction.unbalanced = 1e-2;
    return scene;
}

static tr_energy sheared(test_laws laws) {
    tr_scene scene = scene_of(laws);
    tr_biaxial b;
    compact(&b, &scene);
    begin_shear(&b);
    shear_steps(&b, (int)b.shear_steps);
    shear_forces(&b);
    tr_energy e = tr_ledger_read(&b.world);
    tr_biaxial_free(&b);
    return e;
}

/* What is made can be no less than what the net is below zero. */
static void alonso_min_makes_more_than_the_work_of_the_walls(void **state) {
    (void)state;
    test_laws laws = sand;
    laws.rolling_velocity = "alonso-min", laws.mu_r = 2, laws.k_r = 10 * sand.k_t;
    tr_energy e = sheared(laws);
    print_message("alonso-min: made %.3g of the work, net %.3g\n", e.made[TR_ROLLING] / e.work, e.rolling / e.work);
    assert_true(e.work > 0 && e.made[TR_ROLLING] > e.work);
    assert_true(e.made[TR_ROLLING] >= -e.rolling);
    /* the balance of all holds with it: what was made is in the motion or was lost elsewhere */
    assert_true(e.damped + e.friction + e.kinetic > e.work);
    assert_close(e.made[TR_FRICTION], 0, 0, 1e-9 * e.work);
}

/* Rounding: each step of each contact errs by 1e-16 of what is in its spring; steps times contacts are some 1e7,
 * and what is in all springs is below the work. */
static void wang_makes_none(void **state) {
    (void)state;
    tr_energy e = sheared(sand);
    print_message("wang: made %.1e of the work, friction %.1e\n", e.made[TR_ROLLING] / e.work,
                  e.made[TR_FRICTION] / e.work);
    assert_true(e.rolling > 0.01 * e.work && e.friction > 0.01 * e.work && e.damped > 0);
    assert_close(e.made[TR_ROLLING], 0, 0, 1e-9 * e.work);
    assert_close(e.made[TR_FRICTION], 0, 0, 1e-9 * e.work);
    assert_true(e.made[TR_NORMAL] == 0);
}

static void restart_keeps_it(void **state) {
    (void)state;
    test_laws laws = sand;
    laws.rolling_velocity = "alonso-min";
    tr_scene scene = scene_of(laws);
    char dir[] = "/tmp/trundle-made-XXXXXX";
    tr_status st = {0}, instead = {0};
    tr_checkpoint c;
    tr_biaxial b, again;
    assert_non_null(mkdtemp(dir));
    compact(&b, &scene);
    begin_shear(&b);
    shear_steps(&b, 800);
    tr_checkpoint_begin(&c, "case", &st);
    tr_biaxial_checkpoint(&b, &c);
    if (!tr_checkpoint_write(&c, dir, TR_CHECKPOINT)) fail_msg("%s", st.text);
    double before = b.world.ledger->made[TR_ROLLING];
    assert_true(before > 0);
    if (!tr_biaxial_init(&again, &scene, &st)) fail_msg("%s", st.text);
    begin_shear(&again);
    assert_true(tr_checkpoint_open(&c, dir, TR_CHECKPOINT, "case", &instead, &st));
    tr_biaxial_checkpoint(&again, &c);
    if (!tr_checkpoint_close(&c)) fail_msg("%s", st.text);
    shear_steps(&b, 400), shear_steps(&again, 400);
    assert_true(b.world.ledger->made[TR_ROLLING] > before);
    assert_memory_equal(b.world.ledger, again.world.ledger, sizeof *b.world.ledger);
    tr_biaxial_free(&b), tr_biaxial_free(&again);
    tr_checkpoint_remove(dir);
    assert_int_equal(rmdir(dir), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bagi_kuhn_makes_energy_in_a_cycle),
        cmocka_unit_test(alonso_min_makes_energy_and_the_ledger_says_how_much),
        cmocka_unit_test(alonso_mean_makes_energy_and_the_ledger_says_how_much),
        cmocka_unit_test(laws_with_fitting_forces_make_none),
        cmocka_unit_test(friction_makes_none_while_the_normal_force_changes),
        cmocka_unit_test(a_rigid_turn_costs_star_force_proportional_and_makes_nothing),
        cmocka_unit_test(alonso_min_makes_more_than_the_work_of_the_walls),
        cmocka_unit_test(wang_makes_none),
        cmocka_unit_test(restart_keeps_it),
    };
    return cmocka_run_group_tests_name("energy made", tests, NULL, NULL);
}
