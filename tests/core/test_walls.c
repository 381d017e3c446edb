/* SPDX-License-Identifier: MIT */
/* Walls with ends, with laws of their own, and belts, against closed forms. */
#include "base/checkpoint.h"
#include "core/bodies.h"
#include "core/checkpoint.h"
#include "core/record.h"
#include "core/worlds.h"
#include "laws/law.h"
#include "scene/scene.h"
#include "scene/write.h"
#include <unistd.h>

static const double G = 9.81, R = 0.02, DENSITY = 2700, K_N = 1e7;

typedef struct show {
    tr_scene scene;
    tr_bodies b;
} show;

/* rest: disks, walls, and what else there is of the case. */
static void start(show *s, double time, double gx, double gy, const char *contact, const char *rest) {
    static char text[12000];
    tr_status st = {0};
    snprintf(
        text, sizeof text,
        "kind: bodies\ntime_end: %.17g\ngravity: {x: %.17g, y: %.17g}\ncontact: {k_n: 1e7, damping_ratio: 0, %s}\n%s",
        time, gx, gy, contact, rest);
    if (!tr_scene_read(&s->scene, &(tr_scene_source){"case", text, strlen(text), NULL, 0}, tr_laws_catalog(), &st) ||
        !tr_bodies_init(&s->b, &s->scene, &st))
        fail_msg("%s", st.text);
}

static void go(show *s) {
    tr_bodies_advance(&s->b);
    forces(&s->b.world);
}

static void play(show *s) {
    while (s->b.world.steps < s->b.steps) go(s);
}

static void end(show *s) {
    tr_bodies_free(&s->b);
    tr_scene_free(&s->scene);
}

static double mass(void) {
    return DENSITY * M_PI * R * R;
}
static double weight(void) {
    return mass() * G;
}
static const double *at(const show *s) {
    return s->b.world.disks.pos;
}
static double velocity(const show *s, int lane) {
    double v[3];
    tr_bodies_velocity(&s->b.world, 0, v);
    return v[lane];
}

static int contacts(show *s, tr_record *first) {
    tr_record *records = NULL;
    int capacity = 0;
    tr_status st = {0};
    int n = tr_record_all(&s->b.world, &records, &capacity, &st);
    if (n) *first = records[0];
    free(records);
    return n;
}

/* Where walls in line meet a disk touches one of them, and as deep as everywhere: without friction it goes on as on an
 * endless floor. Bound: a rounding of the height in each step turns into a velocity, 1e4 steps of 1e-18 m at 1e4 1/s.
 */
static void joints_in_line_are_passed_without_a_bump(void **state) {
    (void)state;
    show s;
    char rest[600];
    snprintf(rest, sizeof rest,
             "disks: [{radius: 20 mm, x: -55 mm, y: %.17g, vx: 0.5}]\n"
             "walls: [{nx: 0, ny: 1, to: -30 mm}, {x: 7 mm, nx: 0, ny: 1, from: -37 mm, to: 3 mm}, "
             "{nx: 0, ny: -1, from: -50 mm, to: -10 mm}, {nx: 0, ny: 1, from: 50 mm}]\n",
             R - weight() / K_N);
    start(&s, 0.3, 0, -G, "mu: 0, mu_r: 0", rest);
    bool seen[4] = {false};
    while (s.b.world.steps < s.b.steps) {
        tr_record r = {0};
        go(&s);
        assert_int_equal(contacts(&s, &r), 1);
        seen[-1 - r.a] = true;
        assert_close(r.f_n, weight(), 1e-9, 0);
        assert_close(velocity(&s, 1), 0, 0, 1e-9);
    }
    assert_close(velocity(&s, 0), 0.5, 1e-12, 0);
    for (int k = 0; k < 4; k++) assert_true(seen[k]);
    end(&s);
}

/* Ice, then carpet: sliding decelerates by mu g of the wall below, and spins up by 2 mu g/R. From 1 m/s, 0.3 m of ice
 * take sqrt(1 - 2 mu g 0.3 m); then slip ends after (v + R w)/(3 mu' g), where v + R w is what is left of the sliding.
 */
static void walls_have_laws_of_their_own(void **state) {
    (void)state;
    show s;
    char rest[600];
    snprintf(rest, sizeof rest,
             "disks: [{radius: 20 mm, x: -0.3, y: %.17g, vx: 1}]\n"
             "walls: [{nx: 0, ny: 1, to: 0}, {nx: 0, ny: 1, from: 0, contact: {mu: 0.5}}]\n",
             R - weight() / K_N);
    start(&s, 1, 0, -G, "mu: 0.02, mu_r: 0", rest);
    while (at(&s)[0] < 0) go(&s);
    double v = sqrt(1 - 2 * 0.02 * G * 0.3), w = -2 * (1 - v) / R;
    /* the friction spring takes mu f_n/k_t = 0.1 um of the way; the step may end on the carpet */
    assert_close(velocity(&s, 0), v, 1e-5, 0.5 * G * s.b.world.dt);
    assert_close(velocity(&s, 2), w, 1e-4, 2 * 0.5 * G / R * s.b.world.dt);
    double slip = v + R * w, time = (double)s.b.world.steps * s.b.world.dt, ends = time + slip / (3 * 0.5 * G);
    while (velocity(&s, 0) + R * velocity(&s, 2) > 0) go(&s);
    assert_close((double)s.b.world.steps * s.b.world.dt - time, ends - time, 5e-3, 0); /* 150 steps */
    assert_close(velocity(&s, 0), v - slip / 3, 1e-3, 0);
    end(&s);
}

/* A disk that rolls off an edge without slipping turns about it, and leaves where N = m g cos(p) - m R p'^2 = 0: from
 * rest at p0, p'^2 = (4g/3R)(cos(p0) - cos(p)), so cos(p) = 4/7 cos(p0) and v^2 = (4/7) g R cos(p0). Rolling resistance
 * does nothing at a corner, where R_eff = 0. The springs store 1e-3 of the fall, and swing. */
static void a_disk_leaves_a_corner_at_four_sevenths(void **state) {
    (void)state;
    static const char *const laws[] = {"mu: 100, mu_r: 0", "mu: 100, mu_r: 0.5",
                                       "mu: 100, mu_r: 0.5, rolling: conjugate-spring",
                                       "mu: 100, mu_r: 0.5, rolling: star-constant-torque"};
    const double p0 = 0.1;
    for (int k = 0; k < 4; k++) {
        show s;
        char rest[600];
        double L = R - weight() * cos(p0) / K_N;
        tr_record r = {0};
        snprintf(
            rest, sizeof rest,
            "disks: [{radius: 20 mm, x: %.17g, y: %.17g}]\nwalls: [{nx: 0, ny: 1, to: 0}, {nx: 1, ny: 0, from: 0}]\n",
            L * sin(p0), L * cos(p0));
        start(&s, 1, 0, -G, laws[k], rest);
        while (contacts(&s, &r) > 0) {
            assert_true(r.m2 == 0);
            go(&s);
        }
        assert_close(hypot(velocity(&s, 0), velocity(&s, 1)), sqrt(4.0 / 7 * G * R * cos(p0)), 2e-3, 0);
        assert_close(at(&s)[1] / hypot(at(&s)[0], at(&s)[1]), 4.0 / 7 * cos(p0), 5e-3, 0);
        end(&s);
    }
}

/* A roof of two plates: the disk that balances on its edge touches it once, and as deep as on a floor. */
static void an_edge_of_two_walls_is_one_contact(void **state) {
    (void)state;
    show s;
    char rest[600];
    tr_record r = {0};
    snprintf(
        rest, sizeof rest,
        "disks: [{radius: 20 mm, x: 0, y: %.17g}]\nwalls: [{nx: 1, ny: 1, from: 0, to: 0.1}, {nx: -1, ny: 1, from: "
        "-0.1, to: 0}]\n",
        R - weight() / K_N);
    start(&s, 1e-3, 0, -G, "mu: 0.5, mu_r: 0", rest);
    assert_int_equal(contacts(&s, &r), 1);
    assert_int_equal(r.a, -1);
    assert_close(r.f_n, weight(), 1e-9, 0);
    assert_close(r.ny, 1, 1e-12, 0);
    assert_close(r.y, 0, 0, 1e-15);
    end(&s);
}

/* At rest on a belt of speed U: friction mu m g until V_s = U - v - (-R w) is gone, at U/(3 mu g) with v = U/3. On the
 * back of a plate the surface goes the other way: the third has its face below, where t points to the left. */
static void a_belt_takes_a_disk_along(void **state) {
    (void)state;
    static const char *const walls[] = {"{nx: 0, ny: 1, belt: 0.6}", "{nx: 0, ny: 1, belt: 0.6, from: -1, to: 1}",
                                        "{nx: 0, ny: -1, belt: 0.6, from: -1, to: 1}"};
    for (int k = 0; k < 3; k++) {
        show s;
        char rest[600];
        snprintf(rest, sizeof rest, "disks: [{radius: 20 mm, x: 0, y: %.17g}]\nwalls: [%s]\n", R - weight() / K_N,
                 walls[k]);
        start(&s, 0.6 / (3 * 0.1 * G) * 1.5, 0, -G, "mu: 0.1, mu_r: 0", rest);
        while ((double)s.b.world.steps * s.b.world.dt < 0.6 / (3 * 0.1 * G) * 0.9) go(&s);
        assert_close(velocity(&s, 0), 0.1 * G * (double)s.b.world.steps * s.b.world.dt, 2e-3, 0);
        play(&s);
        /* afterwards the friction spring swings: mu g over the frequency of sliding */
        assert_close(velocity(&s, 0), 0.2, 0, 0.1 * G / sqrt(3 * 5e6 / mass()));
        assert_true(s.b.world.wall[0].x == 0);
        end(&s);
    }
}

/* A wall that moves takes its ends along: a disk that lay near the end of it has lost its floor. */
static void a_wall_that_moves_takes_its_end_along(void **state) {
    (void)state;
    show s;
    char rest[600];
    tr_record r = {0};
    snprintf(rest, sizeof rest,
             "disks: [{radius: 20 mm, x: 0, y: %.17g}]\nwalls: [{nx: 0, ny: 1, from: -0.5, to: 0.03, vx: -0.1}]\n",
             R - weight() / K_N);
    start(&s, 0.31, 0, -G, "mu: 0, mu_r: 0", rest);
    while (at(&s)[1] > R - 3 * weight() / K_N && s.b.world.steps < s.b.steps) go(&s);
    /* the corner is below the disk at 0.3 s; it has fallen by d = 2 m g/k_n when the corner is sqrt(2 R d) further */
    assert_close((double)s.b.world.steps * s.b.world.dt, 0.3 + sqrt(4 * R * weight() / K_N) / 0.1, 2e-3, 0);
    assert_true(contacts(&s, &r) == 1 && r.nx > 0);
    end(&s);
}

/* Rolling over laws and corners, then on from a checkpoint: the same bits. */
static void a_world_of_such_walls_goes_on_from_a_checkpoint(void **state) {
    (void)state;
    char dir[] = "/tmp/trundle-walls-XXXXXX";
    const char *rest =
        "disks: [{radius: 20 mm, x: -0.1, y: 19.9 mm, vx: 1}, {radius: 10 mm, x: 0.15, y: 9.9 mm}]\n"
        "walls: [{nx: 0, ny: 1, to: 0}, {nx: 0, ny: 1, from: 0, to: 0.2, belt: 0.3, contact: {mu: 0.1}}]\n";
    show s, t;
    tr_checkpoint c;
    tr_status st = {0}, instead = {0};
    assert_non_null(mkdtemp(dir));
    start(&s, 0.5, 0, -G, "mu: 0.5, mu_r: 0.1", rest);
    start(&t, 0.5, 0, -G, "mu: 0.5, mu_r: 0.1", rest);
    while (s.b.world.steps < s.b.steps / 3) go(&s);
    tr_bodies_advance(&s.b); /* a checkpoint is between a step and its forces, which it does not have */
    tr_checkpoint_begin(&c, "case", &st);
    tr_world_checkpoint(&s.b.world, &c);
    if (!tr_checkpoint_write(&c, dir, TR_CHECKPOINT)) fail_msg("%s", st.text);
    assert_true(tr_checkpoint_open(&c, dir, TR_CHECKPOINT, "case", &instead, &st));
    tr_world_checkpoint(&t.b.world, &c);
    if (!tr_checkpoint_close(&c)) fail_msg("%s", st.text);
    forces(&t.b.world), forces(&s.b.world);
    play(&s), play(&t);
    assert_same_bits(&s.b.world, &t.b.world);
    assert_int_equal(s.b.world.n_groups, 4);
    tr_checkpoint_remove(dir);
    assert_int_equal(rmdir(dir), 0);
    end(&s), end(&t);
}

/* What a wall does not say is as in the root's contact, with its own numbers: k_t = 0.5 k_n of its own k_n. The
 * resolved case reads back to itself. */
static void a_wall_fills_in_what_it_does_not_say(void **state) {
    (void)state;
    show s;
    tr_scene again;
    tr_status st = {0};
    start(&s, 1, 0, 0, "mu: 0.3, mu_r: 0.1, k_t: 0.5*k_n, k_r: 1e6",
          "disks: [{radius: 20 mm, x: 0, y: 1}]\nwalls: [{nx: 0, ny: 1, contact: {k_n: 4e6, mu: 0.1}}, {x: -9, nx: 1, "
          "ny: 0}]\n");
    const tr_scene_contact *own = &s.scene.walls[0].contact;
    const tr_law *friction = tr_laws_friction[own->friction.law], *rolling = tr_laws_rolling[own->rolling.law];
    assert_true(s.scene.walls[0].own && !s.scene.walls[1].own);
    assert_true(*tr_law_value(friction, own->friction.par, "k_t") == 2e6);
    assert_true(*tr_law_value(friction, own->friction.par, "mu") == 0.1);
    assert_true(*tr_law_value(rolling, own->rolling.par, "k_r") == 1e6);
    char *text = tr_scene_write(&s.scene, tr_laws_catalog(), &st);
    if (!tr_scene_read(&again, &(tr_scene_source){"again", text, strlen(text), NULL, 0}, tr_laws_catalog(), &st))
        fail_msg("%s", st.text);
    char *twice = tr_scene_write(&again, tr_laws_catalog(), &st);
    assert_string_equal(text, twice);
    free(text), free(twice);
    tr_scene_free(&again);
    end(&s);
}

/* As many laws as walls: each deceleration is mu g of its wall. A ring beside them has a group of its own. */
static void every_wall_may_have_laws_of_its_own(void **state) {
    (void)state;
    enum { WALLS = 100 };
    static char rest[9000];
    show s;
    int n = snprintf(
        rest, sizeof rest,
        "disks: [{radius: 0.3, ring: 0.01, x: -3, y: 3, motion: prescribed}, {radius: 20 mm, x: 5 mm, y: %.17g, "
        "vx: 3}, {radius: 20 mm, x: -3, y: 2.71999}]\nwalls:\n",
        R - weight() / K_N);
    for (int i = 0; i < WALLS; i++)
        n += snprintf(rest + n, sizeof rest - (size_t)n, " - {nx: 0, ny: 1, from: %g, to: %g, contact: {mu: %g}}\n",
                      0.01 * i, 0.01 * (i + 1), 1e-3 * (i + 1));
    start(&s, 0.4, 0, -G, "mu: 0, mu_r: 0", rest);
    assert_int_equal(s.b.world.n_groups, WALLS + 3);
    double energy = 0.5 * 9;
    while (s.b.world.steps < s.b.steps && s.b.world.disks.pos[4] < 0.895) go(&s);
    for (int i = 0; i < 90; i++) energy -= (i == 0 || i == 89 ? 0.005 : 0.01) * 1e-3 * (i + 1) * G;
    double v[3];
    tr_bodies_velocity(&s.b.world, 1, v);
    assert_close(v[0], sqrt(2 * energy), 1e-4, 0);
    assert_close(s.b.world.disks.pos[9], 2.72, 1e-4, 0); /* the other one lies in its ring */
    end(&s);
}

/* A second document that changes the root's contact changes what its walls take from it. */
static void documents_fill_in_their_own(void **state) {
    (void)state;
    tr_scene scene;
    tr_status st = {0};
    const char *text = "kind: bodies\ntime_end: 1\ncontact: {k_n: 1e7, mu: 0.3, mu_r: 0}\n"
                       "disks: [{radius: 20 mm, x: 0, y: 1}]\nwalls: [{nx: 0, ny: 1, contact: {k_n: 2e7}}]\n"
                       "---\ncontact: {mu: 0.7}\n";
    if (!tr_scene_read(&scene, &(tr_scene_source){"case", text, strlen(text), NULL, 0}, tr_laws_catalog(), &st))
        fail_msg("%s", st.text);
    const double expected[] = {0.3, 0.7};
    for (int k = 0; k < 2; k++) {
        const tr_scene_contact *own = &(k ? scene.more : &scene)->walls[0].contact;
        assert_true(*tr_law_value(tr_laws_friction[own->friction.law], own->friction.par, "mu") == expected[k]);
    }
    tr_scene_free(&scene);
}

static void what_is_no_wall_is_told_where(void **state) {
    (void)state;
    static const char *const rows[][2] = {
        {"{nx: 0, ny: 1, from: 3, to: 3}",
         "case:4:37: error: `walls.0` has no length: it begins at `from`, 3 m, and ends"},
        {"{nx: 0, ny: 1, from: 2e6}", "case:4:30: error: `from` is 2000000, allowed is -1e+06 to 1e+06 m"},
        {"{nx: 0, ny: 1}, {x: 5, nx: 0, ny: -1, from: -2, to: 2}", "`walls.1` lies on `walls.0` over 4 m"},
        {"{nx: 0, ny: 1, contact: 3}", "`walls.0.contact` must be a mapping"},
        {"{nx: 0, ny: 1, contact: {mux: 3}}", "unknown key `walls.0.contact.mux` (did you mean `mu`?)"},
        {"{nx: 0, ny: 1, contact: {normal: hertz-sphere, E_star: 1e9}}", "the law hertz-sphere is for spheres"},
        {"{nx: 0, ny: 1, length: 3}",
         "unknown key `walls.0.length`; allowed here: x, y, nx, ny, vx, vy, from, to, belt"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char text[600];
        tr_scene scene;
        tr_status st = {0};
        snprintf(text, sizeof text,
                 "kind: bodies\ntime_end: 1\ndisks: [{radius: 1, x: 0, y: 9}]\nwalls: [%s]\ncontact: {k_n: 1e7, mu: 0, "
                 "mu_r: 0}\n",
                 rows[i][0]);
        assert_false(
            tr_scene_read(&scene, &(tr_scene_source){"case", text, strlen(text), NULL, 0}, tr_laws_catalog(), &st));
        if (!strstr(st.text, rows[i][1])) fail_msg("no \"%s\" in: %s", rows[i][1], st.text);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(joints_in_line_are_passed_without_a_bump),
        cmocka_unit_test(walls_have_laws_of_their_own),
        cmocka_unit_test(a_disk_leaves_a_corner_at_four_sevenths),
        cmocka_unit_test(an_edge_of_two_walls_is_one_contact),
        cmocka_unit_test(a_belt_takes_a_disk_along),
        cmocka_unit_test(a_wall_that_moves_takes_its_end_along),
        cmocka_unit_test(a_world_of_such_walls_goes_on_from_a_checkpoint),
        cmocka_unit_test(a_wall_fills_in_what_it_does_not_say),
        cmocka_unit_test(every_wall_may_have_laws_of_its_own),
        cmocka_unit_test(documents_fill_in_their_own),
        cmocka_unit_test(what_is_no_wall_is_told_where),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
