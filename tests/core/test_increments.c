/* SPDX-License-Identifier: MIT */
/* What contacts did over an interval. References: disks whose motion is prescribed, so that sliding, rolling, a and
 * forces are closed forms; Carter's and Kalker's steady state, where creep takes off all of the sliding; the virial of
 * the cell. */
#include "core/pipeline.h"
#include "core/record.h"
#include "core/worlds.h"

enum { MOST = 8 };
static const double R1 = 1e-3, R2 = 2e-3, K = 1e8, E_STAR = 2e8, DEPTH = 2e-6, DT = 1e-7;

typedef struct scene {
    tr_world world;
    tr_increments increments;
} scene;

/* Pairs far from each other, disks 2i and 2i + 1 at an angle, which turn and stay where they are. */
static void begin(scene *s, tr_shape shape, const char *friction, int pairs, double angle) {
    const tr_param_catalog *catalog = tr_laws_catalog();
    tr_scene_contact c = contact_of((test_laws){.k_n = K, .mu = 0.5, .k_t = 0.5 * K});
    tr_status st = {0};
    c.friction = law_named(tr_laws_friction, catalog->n_friction, friction);
    const tr_param_table *t = catalog->friction[c.friction.law];
    set_parameter(&c.friction, t, "mu", 0.5);
    if (strcmp(friction, "coulomb-spring") && strcmp(friction, "dahlberg-alfredsson"))
        set_parameter(&c.friction, t, "nu", 0.3);
    if (strcmp(friction, "cattaneo-mindlin") && strcmp(friction, "coulomb-spring"))
        set_parameter(&c.friction, t, "E_star", E_STAR);
    if (!strcmp(friction, "coulomb-spring") || !strcmp(friction, "dahlberg-alfredsson"))
        set_parameter(&c.friction, t, "k_t", 0.5 * K);
    new_world_of(&s->world, 2 * pairs, shape);
    for (int i = 0; i < pairs; i++) {
        double L = R1 + R2 - DEPTH, x = 0.02 * i;
        tr_world_set_disk(&s->world, 2 * i, &(tr_disk_start){x, 0, 0, R1, 2700, true});
        tr_world_set_disk(&s->world, 2 * i + 1,
                          &(tr_disk_start){x + L * cos(angle), L * sin(angle), 0, R2, 2700, true});
    }
    s->world.dt = DT, s->world.allow_unstable = true;
    if (!tr_world_set_laws(&s->world, &c, false, 0, &st)) fail_msg("%s", st.text);
    tr_increments_attach(&s->world, &s->increments);
    forces(&s->world); /* the first moves no history */
}

/* The spins at which a pair slides and rolls with these velocities. */
static void turn(scene *s, int pair, double slide, double roll) {
    double share = (R1 + R2 - DEPTH) / (R1 + R2); /* arms over radii */
    double s1 = -roll + 0.5 * slide / share, s2 = -roll - 0.5 * slide / share;
    set_velocity(&s->world, 2 * pair, 0, 0, s1 / R1);
    set_velocity(&s->world, 2 * pair + 1, 0, 0, -s2 / R2);
}

static tr_increments_state read_after(scene *s, int n) {
    tr_status st = {0};
    tr_increments_state state;
    for (int k = 0; k < n; k++) tr_step_advance(&s->world), forces(&s->world);
    if (!tr_increments_read(&s->increments, &state, &st)) fail_msg("%s", st.text);
    return state;
}

/* Of the only contact between 2 pair and 2 pair + 1, as contacts.csv lists it. */
static tr_increment increment_of(scene *s, int pair) {
    tr_status st = {0};
    tr_record *records = NULL;
    int capacity = 0, n = tr_record_all(&s->world, &records, &capacity, &st), i = 0;
    while (i < n && records[i].a != 2 * pair) i++;
    assert_true(i < n);
    tr_increment increment = records[i].increment;
    free(records);
    return increment;
}

static void assert_listed(scene *s, int pair, double slide, double roll, bool followed) {
    tr_increment u = increment_of(s, pair);
    /* Sums of equal terms; arms, differences of millimetres, have ten digits of the overlap. */
    assert_close(u.slide, slide, 1e-12, 0);
    assert_close(u.roll, roll, 1e-12, 0);
    assert_int_equal(u.followed, followed);
}

/* Velocity times time since the last read, or since it touched; signs are kept, and listing changes nothing. */
static void test_each_contact_has_its_sums(void **state) {
    (void)state;
    scene s;
    begin(&s, TR_SHAPE_DISK, "cattaneo-mindlin", 3, 0.4);
    turn(&s, 0, 0.1, -0.3), turn(&s, 1, -0.2, -0.5), turn(&s, 2, 0.7, 1.1);
    for (int k = 0; k < 4; k++) tr_step_advance(&s.world), forces(&s.world);
    assert_listed(&s, 0, 0.1 * 4 * DT, -0.3 * 4 * DT, false); /* not yet a whole interval */
    read_after(&s, 1);
    assert_listed(&s, 0, 0, 0, true);
    for (int k = 0; k < 7; k++) tr_step_advance(&s.world), forces(&s.world);
    double *opens = s.world.disks.pos + 4 * 5;
    opens[0] += 2 * DEPTH;
    tr_step_advance(&s.world), forces(&s.world);
    opens[0] -= 2 * DEPTH;
    for (int k = 0; k < 3; k++) tr_step_advance(&s.world), forces(&s.world);
    for (int again = 0; again < 2; again++) {
        assert_listed(&s, 0, 0.1 * 11 * DT, -0.3 * 11 * DT, true);
        assert_listed(&s, 1, -0.2 * 11 * DT, -0.5 * 11 * DT, true);
        assert_listed(&s, 2, 0.7 * 3 * DT, 1.1 * 3 * DT, false);
    }
    assert_close(increment_of(&s, 1).creep, 0, 0, 0); /* no law that creeps */
    tr_world_free(&s.world);
}

static double width(tr_shape shape) {
    double P = K * DEPTH, R = R1 * R2 / (R1 + R2);
    return shape == TR_SHAPE_SPHERE ? cbrt(3 * P * R / (4 * E_STAR)) : sqrt(4 * P * R / (M_PI * E_STAR));
}

/* Rolling over sliding of 1, 2, 3, 4, 10. A pair that opens and one that closes on the way are left out. */
static void test_quartiles(void **state) {
    static const double ratio[] = {4, 1, 10, 3, 2}; /* |roll|, against and along the sliding */
    (void)state;
    scene s;
    begin(&s, TR_SHAPE_DISK, "cattaneo-mindlin", 7, 0.4);
    for (int i = 0; i < 5; i++) turn(&s, i, 0.1 * (i - 2.5), 0.1 * (i - 2.5) * ratio[i] * (i % 2 ? 1 : -1));
    turn(&s, 5, 0.1, 5), turn(&s, 6, 0.1, 7);
    read_after(&s, 3);
    double *moved = s.world.disks.pos + 4 * 11, *closes = s.world.disks.pos + 4 * 13;
    moved[0] += 2 * DEPTH, closes[0] += 2 * DEPTH; /* opens, as both do; one is back for the second half */
    read_after(&s, 1);
    moved[0] -= 2 * DEPTH;
    read_after(&s, 1);
    moved[0] += 2 * DEPTH;
    for (int k = 0; k < 5; k++) tr_step_advance(&s.world), forces(&s.world);
    closes[0] -= 2 * DEPTH;
    tr_increments_state now = read_after(&s, 5);
    /* Sums of ten equal terms, and the division. */
    assert_close(now.roll.q1, 2, 1e-12, 0);
    assert_close(now.roll.median, 3, 1e-12, 0);
    assert_close(now.roll.q3, 4, 1e-12, 0);
    assert_close(now.roll.mean, 4, 1e-12, 0);
    assert_close(now.creep.mean, 0, 0, 0); /* no law that creeps */
    assert_close(now.followed, 5 / 5.5, 1e-12, 0);
    assert_close(now.width, 0, 0, 0); /* no E_star */
    tr_world_free(&s.world);
}

/* Rolling on at a constant creepage below F(1), Q stands still at the end: creep takes off what is slid. */
static void steady(tr_shape shape, const char *friction, double share) {
    scene s;
    double a = width(shape), F0 = 0.5 * a * (1 / R1 + 1 / R2);
    if (shape == TR_SHAPE_SPHERE) F0 *= 4 / ((1 - 0.3) * (4.12 + (5.20 - 4.12) * 0.05 / 0.25)); /* nu = 0.3 */
    begin(&s, shape, friction, 1, 0.4);
    double roll = 0.02 * a / DT;
    turn(&s, 0, -share * F0 * roll, roll);
    read_after(&s, 20000);
    for (int k = 0; k < 100; k++) tr_step_advance(&s.world), forces(&s.world);
    double slide = -share * F0 * roll * 100 * DT;
    assert_close(increment_of(&s, 0).slide, slide, 1e-9, 0);
    assert_close(increment_of(&s, 0).creep, slide, 1e-9, 0);
    tr_increments_state now = read_after(&s, 0);
    assert_close(now.roll.median, 1 / (share * F0), 1e-9, 0);
    assert_close(now.creep.median, 1, 1e-9, 0); /* what is left of the transient falls by e in a few a, of 400 */
    assert_close(now.width, a, 1e-9, 0);        /* the overlap, a difference of millimetres, has ten digits */
    tr_world_free(&s.world);
}

static void test_creep_is_the_sliding_in_steady_rolling(void **state) {
    (void)state;
    static const double share[] = {0.1, 0.5, 0.9};
    for (int i = 0; i < 3; i++) {
        steady(TR_SHAPE_DISK, "kuhn-creep", share[i]);
        steady(TR_SHAPE_DISK, "dahlberg-alfredsson", share[i]);
        steady(TR_SHAPE_SPHERE, "kuhn-creep", share[i]);
    }
}

/* Rolls by units of a at a hundredth of it per step. */
static tr_increments_state way(scene *s, double units) {
    turn(s, 0, 0, copysign(0.01 * width(s->world.shape) / DT, units));
    return read_after(s, (int)round(fabs(units) / 0.01));
}

/* Bins are 20 a decade: a median is within half of one, 6 %, of runs that are all alike. */
static const double BIN = 0.13;

static void runs(tr_shape shape) {
    scene s;
    begin(&s, shape, "kuhn-creep", 1, 0.4);
    tr_increments_state now = way(&s, 4);
    assert_close(now.run, 0, 0, 0);                             /* not over */
    for (int k = 0; k < 40; k++) way(&s, -0.05), way(&s, 0.05); /* too little back: the run goes on, to 7 */
    now = way(&s, 3);
    assert_close(now.run, 0, 0, 0);
    now = way(&s, -0.5);
    assert_close(now.run, 7, BIN, 0);
    assert_close(now.long_runs, 1, 0, 0);
    /* A run of 0.5 back, one of 0.5, one of 2.5: half are longer than 0.5, half of the way is in that of 2.5. */
    turn(&s, 0, 0, 0.01 * width(shape) / DT);
    for (int k = 0; k < 50; k++) tr_step_advance(&s.world), forces(&s.world);
    turn(&s, 0, 0, -0.01 * width(shape) / DT);
    for (int k = 0; k < 250; k++) tr_step_advance(&s.world), forces(&s.world);
    s.world.disks.pos[4] += 2 * DEPTH; /* it opens */
    now = read_after(&s, 1);
    assert_close(now.run, 0.5, BIN, 0);
    assert_close(now.run_by_length, 2.5, BIN, 0);
    assert_close(now.long_runs, 2.5 / 3.5, 0.01, 0); /* a step more or less of each run */
    s.world.disks.pos[4] -= 2 * DEPTH;
    now = read_after(&s, 5); /* 0.05 a, and it opens: no run */
    s.world.disks.pos[4] += 2 * DEPTH;
    now = read_after(&s, 1);
    assert_close(now.run, 0, 0, 0);
    tr_world_free(&s.world);
}

static void test_runs_end_where_a_contact_turns_or_opens(void **state) {
    (void)state;
    runs(TR_SHAPE_DISK);
    runs(TR_SHAPE_SPHERE);
}

/* One contact at an angle: f_n L (sin^2 - cos^2) and 2 f_t L sin cos. */
static void test_share_of_friction(void **state) {
    (void)state;
    scene s;
    double angle = 1.2, c = cos(angle), d = sin(angle), v = 0.3;
    begin(&s, TR_SHAPE_DISK, "coulomb-spring", 1, angle);
    turn(&s, 0, v, 0);
    read_after(&s, 9);
    tr_increments_state now = read_after(&s, 1);
    double f_n = K * DEPTH, f_t = 0.5 * K * v * 10 * DT, normal = f_n * (d * d - c * c), tangential = 2 * f_t * c * d;
    assert_close(now.tangential, tangential / (normal + tangential), 1e-8, 0); /* the overlap has ten digits */
    tr_world_free(&s.world);
}

/* In a packing both parts together are the virial of the cell. */
static void test_parts_add_up_to_the_stress(void **state) {
    (void)state;
    test_laws laws = sand;
    laws.mu_r = 0;
    tr_scene scene = biaxial_scene(100, 1, laws);
    scene.boundary = TR_PERIODIC;
    tr_biaxial b;
    tr_increments increments;
    compact(&b, &scene);
    begin_shear(&b);
    tr_increments_attach(&b.world, &increments);
    double sum = 0;
    for (int k = 0; k < 300; k++) {
        shear_forces(&b);
        sum += b.world.cell.virial[1] - b.world.cell.virial[0];
        tr_step_advance(&b.world);
    }
    assert_close(increments.since.normal + increments.since.tangential, sum, 1e-11, 0); /* rounding of 5e4 terms */
    assert_true(fabs(increments.since.tangential) > 1e-3 * fabs(sum));
    tr_biaxial_free(&b);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_each_contact_has_its_sums),
        cmocka_unit_test(test_quartiles),
        cmocka_unit_test(test_creep_is_the_sliding_in_steady_rolling),
        cmocka_unit_test(test_runs_end_where_a_contact_turns_or_opens),
        cmocka_unit_test(test_share_of_friction),
        cmocka_unit_test(test_parts_add_up_to_the_stress),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
