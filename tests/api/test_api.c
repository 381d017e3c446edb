/* SPDX-License-Identifier: MIT */
/* The public face: one contact against closed forms and against a world, what is refused, what is read. */
#include "assert_close.h"
#include "trundle.h"

#include <locale.h>
#include <stdlib.h>
#include <string.h>

static const char spring[] =
    "k_n: 1 MPa, damping_ratio: 0, friction: coulomb-spring, mu: 0.5, k_t: 1 MPa, rolling: none";
static const trundle_pair pair = {.R1 = 0.01, .R2 = 0.03, .density1 = 1000, .density2 = 1000};

static trundle_contact *contact_of(const char *laws, const trundle_pair *p) {
    trundle_error error;
    trundle_contact *c = trundle_contact_new(laws, p, &error);
    if (!c) fail_msg("%s", error.text);
    return c;
}

/* Overlap 1e-5 m, sliding 1e-6 m in ten steps: f_n = k_n delta, Q = k_t u on body 2 against its motion, torques by the
 * arms. */
static void spring_by_hand(void **state) {
    (void)state;
    trundle_contact *c = contact_of(spring, &pair);
    trundle_body one = {0}, two = {.x = 0.04 - 1e-5, .vy = 0.01};
    trundle_force f;
    for (int k = 0; k < 10; k++) assert_int_equal(trundle_contact_step(c, 1e-5, &one, &two, &f, NULL), TRUNDLE_OK);
    const double r1 = 0.01 * (0.04 - 1e-5) / 0.04, r2 = 3 * r1; /* the overlap is shared by the radii */
    assert_close(f.fx, 10, 1e-9, 0);
    assert_close(f.fy, -1, 1e-9, 0);
    assert_close(f.torque1, r1, 1e-9, 0);
    assert_close(f.torque2, r2, 1e-9, 0);
    trundle_touch t;
    assert_int_equal(trundle_contact_read(c, &t, NULL), TRUNDLE_OK);
    assert_close(t.overlap, 1e-5, 1e-9, 0);
    assert_close(t.mobilisation, 0.2, 1e-9, 0);
    assert_true(t.a == 0 && t.b == 1);
    trundle_contact_read(c, &t, NULL); /* reading is no step */
    assert_close(t.mobilisation, 0.2, 1e-9, 0);
    trundle_contact_reset(c);
    two.vy = 0;
    trundle_contact_step(c, 1e-5, &one, &two, &f, NULL);
    assert_close(f.fy, 0, 0, 1e-12);
    two.vy = 0.01;
    trundle_contact_step(c, 1e-5, &one, &two, &f, NULL);
    two.x = 0.05;
    trundle_contact_step(c, 1e-5, &one, &two, &f, NULL);
    assert_close(f.fx, 0, 0, 0);
    two.x = 0.04 - 1e-5, two.vy = 0;
    trundle_contact_step(c, 1e-5, &one, &two, &f, NULL);
    assert_close(f.fy, 0, 0, 1e-12); /* it has been open */
    trundle_contact_free(c);
}

/* A plane whose normal is tilted: the same as upright, turned. */
static void plane_turned(void **state) {
    (void)state;
    const double angle = 0.6, nx = -sin(angle), ny = cos(angle);
    const trundle_pair upright = {.R2 = 0.03, .density2 = 1000, .ny = 1},
                       tilted = {.R2 = 0.03, .density2 = 1000, .nx = nx, .ny = ny};
    trundle_contact *a = contact_of(spring, &upright), *b = contact_of(spring, &tilted);
    trundle_body floor = {0}, slope = {.x = 5 * ny, .y = -5 * nx}, disk = {.y = 0.02999, .vx = 0.02, .spin = 0.3},
                 turned = disk;
    turned.x = disk.y * nx, turned.y = disk.y * ny, turned.vx = disk.vx * ny, turned.vy = -disk.vx * nx;
    trundle_force f, g;
    for (int k = 0; k < 5; k++) {
        trundle_contact_step(a, 1e-5, &floor, &disk, &f, NULL);
        trundle_contact_step(b, 1e-5, &slope, &turned, &g, NULL);
    }
    assert_true(f.fx != 0 && f.fy > 0);
    assert_close(g.fx, f.fx * ny + f.fy * nx, 0, 1e-9); /* overlaps of 1e-5 from lengths of 5: 1e-15/1e-5 of 10 N/m */
    assert_close(g.fy, f.fy * ny - f.fx * nx, 0, 1e-9);
    assert_close(g.torque2, f.torque2, 0, 1e-9);
    assert_true(f.torque1 == 0 && g.torque1 == 0);
    trundle_touch t;
    trundle_contact_read(a, &t, NULL);
    assert_int_equal(t.a, -1);
    trundle_contact_free(a), trundle_contact_free(b);
}

/* Every law of friction and rolling: two bodies of a world, and a contact that is led along their motion, give the same
 * to 1e-9. */
static void as_in_a_world(void **state) {
    (void)state;
    static const char *const laws[] = {
        "k_n: 1 MPa, friction: dahlberg-alfredsson, mu: 0.3, k_t: 1 MPa, E_star: 2.5 MPa, mu_r: 0.01, k_r: 1 MPa",
        "normal: hertz-line, E_star: 2.5 MPa, friction: kuhn-creep, mu: 0.3, nu: 0.3, rolling: none",
        "k_n: 1 MPa, mu: 0.3, rolling: conjugate-spring, rolling_velocity: alonso-mean, mu_r: 0.1, k_r: 1 MPa",
        "k_n: 1 MPa, mu: 0.3, rolling: star-force-proportional, mu_r: 0.1"};
    for (size_t k = 0; k < sizeof laws / sizeof *laws; k++) {
        char text[800];
        trundle_error error;
        snprintf(text, sizeof text,
                 "kind: bodies\ntime_end: 1\ncontact: {%s}\ndisks:\n"
                 "  - {radius: 0.01, density: 1000, x: 0, y: 0, spin: 30}\n"
                 "  - {radius: 0.03, density: 1000, x: 0.039, y: 0.0089, vx: -0.3}\n",
                 laws[k]);
        trundle_scene *scene = trundle_scene_read("pair", text, NULL, 0, &error);
        trundle_world *world = scene ? trundle_world_new(scene, &error) : NULL;
        if (!world) fail_msg("%s", error.text);
        trundle_contact *c = contact_of(laws[k], &pair);
        int touched = 0;
        for (int n = 0; n < 2000; n++) {
            trundle_disk before[2], now[2];
            trundle_body body[2];
            trundle_force f;
            for (int i = 0; i < 2; i++) trundle_world_disk(world, i, &before[i], NULL);
            assert_int_equal(trundle_world_step(world, 1, &error), TRUNDLE_OK);
            for (int i = 0; i < 2; i++) {
                trundle_world_disk(world, i, &now[i], NULL);
                /* contacts see the velocities half a step behind */
                double kick = trundle_world_dt(world) / 2, I = before[i].mass * before[i].radius * before[i].radius / 2;
                body[i] = (trundle_body){now[i].x, now[i].y, before[i].vx + kick * before[i].fx / before[i].mass,
                                         before[i].vy + kick * before[i].fy / before[i].mass,
                                         before[i].spin + kick * before[i].torque / I};
            }
            assert_int_equal(trundle_contact_step(c, trundle_world_dt(world), &body[0], &body[1], &f, &error),
                             TRUNDLE_OK);
            double most = 1e-9 * (fabs(f.fx) + fabs(f.fy)); /* velocities go through two roundings more */
            assert_close(f.fx, now[1].fx, 1e-9, most);
            assert_close(f.fy, now[1].fy, 1e-9, most);
            assert_close(f.torque1, now[0].torque, 1e-9, 0.01 * most);
            assert_close(f.torque2, now[1].torque, 1e-9, 0.03 * most);
            touched += f.fx != 0;
        }
        assert_true(touched > 20);
        trundle_contact_free(c), trundle_world_free(world), trundle_scene_free(scene);
    }
}

static void what_is_refused(void **state) {
    (void)state;
    trundle_error error;
    trundle_pair odd = pair;
    trundle_body body = {0};
    trundle_force f;
    assert_null(trundle_contact_new("k_n: 1 MPa, friction: coulom-spring, mu: 0.5, rolling: none", &pair, &error));
    assert_int_equal(error.code, TRUNDLE_BAD_CASE);
    assert_non_null(strstr(error.text, "coulom-spring"));
    static const char *const no_laws[] = {
        "",
        "}",
        "{",
        "k_n: 1 MPa, friction: none, rolling: none}, walls: [{nx: 0, ny: 1}], gravity: {y: -9.81",
        "k_n: 1 MPa, friction: none, rolling: none}}\n---\n{kind: bodies, x: {",
        "k_n: disks.0.radius*1 MPa/m, friction: none, rolling: none",
        "k_n: 1 MPa, friction: none, rolling: none, gravity: 1"};
    for (size_t i = 0; i < sizeof no_laws / sizeof *no_laws; i++) {
        if (trundle_contact_new(no_laws[i], &pair, &error)) fail_msg("taken: %s", no_laws[i]);
        assert_int_equal(error.code, TRUNDLE_BAD_CASE);
    }
    trundle_contact_free(contact_of("k_n: 1 MPa, friction: none, rolling: none # the least", &pair));
    odd.R2 = 0;
    assert_null(trundle_contact_new(spring, &odd, &error));
    odd = (trundle_pair){.R2 = 1, .density2 = 1, .nx = 1, .ny = 1};
    assert_null(trundle_contact_new(spring, &odd, NULL));
    trundle_contact *c = contact_of(spring, &pair);
    assert_int_equal(trundle_contact_step(c, 0, &body, &body, &f, &error), TRUNDLE_BAD_CASE);
    assert_int_equal(trundle_contact_step(c, NAN, &body, &body, &f, &error), TRUNDLE_BAD_CASE);
    trundle_body nowhere = {.x = 0.04, .vy = NAN};
    nowhere.x -= 1e-5;
    assert_int_equal(trundle_contact_step(c, 1e-5, &body, &nowhere, &f, &error), TRUNDLE_NUMERICAL);
    /* It is as it was, and goes on; so it does where both centres coincide. */
    trundle_body sound = {.x = 0.04 - 1e-5}, together = {0}, far = {.x = 0.2, .vx = INFINITY};
    assert_int_equal(trundle_contact_step(c, 1e-5, &body, &sound, &f, &error), TRUNDLE_OK);
    assert_close(f.fx, 10, 1e-9, 0);
    assert_int_equal(trundle_contact_step(c, 1e-5, &body, &together, &f, &error), TRUNDLE_NUMERICAL);
    assert_int_equal(trundle_contact_step(c, 1e-5, &body, &far, &f, &error), TRUNDLE_NUMERICAL);
    assert_close(f.fx, 0, 0, 0);
    assert_int_equal(trundle_contact_step(c, 1e-5, &body, &sound, &f, &error), TRUNDLE_OK);
    assert_close(f.fx, 10, 1e-9, 0);
    /* A force beyond all numbers: the history is gone, the contact is not. */
    trundle_contact *damped = contact_of("k_n: 1 MPa, damping_ratio: 0.9, mu: 0.5, k_t: 1 MPa, rolling: none", &pair);
    sound.vx = -1e308;
    assert_int_equal(trundle_contact_step(damped, 1e-5, &body, &sound, &f, &error), TRUNDLE_NUMERICAL);
    assert_close(f.fx, 0, 0, 0);
    sound.vx = 0;
    assert_int_equal(trundle_contact_step(damped, 1e-5, &body, &sound, &f, &error), TRUNDLE_OK);
    assert_close(f.fx, 10, 1e-9, 0);
    trundle_contact_free(damped);
    trundle_contact_free(c), trundle_contact_free(NULL), trundle_world_free(NULL), trundle_scene_free(NULL);

    assert_null(trundle_scene_read_file("no/such/file.yaml", NULL, 0, &error));
    assert_int_equal(error.code, TRUNDLE_FILE);
    const char *sets[] = {"time_end=2"};
    trundle_scene *scene = trundle_scene_read(
        "a",
        "{kind: bodies, time_end: 1, gravity: {y: -9.81}, contact: {k_n: 1 MPa, friction: none, rolling: none}, "
        "disks: [{radius: 1, x: 0, y: 0, vx: 1}]}",
        sets, 1, &error);
    if (!scene) fail_msg("%s", error.text);
    trundle_world *world = trundle_world_new(scene, &error);
    trundle_disk disk;
    trundle_biaxial state_of;
    if (!world) fail_msg("%s", error.text);
    assert_int_equal(trundle_world_disk(world, 1, &disk, &error), TRUNDLE_BAD_CASE);
    assert_int_equal(trundle_world_disk(world, -1, &disk, NULL), TRUNDLE_BAD_CASE);
    assert_int_equal(trundle_world_biaxial(world, &state_of, &error), TRUNDLE_BAD_CASE);
    assert_int_equal(trundle_world_set_threads(world, 0, &error), TRUNDLE_BAD_CASE);
    assert_int_equal(trundle_world_set_velocity(world, 0, NAN, 0, 0, &error), TRUNDLE_BAD_CASE);
    assert_int_equal(trundle_world_set_velocity(world, 0, 2, 0, 0, &error), TRUNDLE_OK);
    assert_int_equal(trundle_world_disk(world, 0, &disk, &error), TRUNDLE_OK);
    assert_close(disk.vy, 0, 0, 1e-15); /* of this instant, though it falls */
    assert_int_equal(trundle_world_step(world, -1, &error), TRUNDLE_BAD_CASE);
    assert_int_equal(trundle_world_step(world, 0, &error), TRUNDLE_OK);
    assert_int_equal(trundle_world_step(world, 7, &error), TRUNDLE_OK);
    assert_int_equal(trundle_world_disk(world, 0, &disk, &error), TRUNDLE_OK);
    assert_close(disk.x, 2 * trundle_world_time(world), 1e-12, 0);
    trundle_world_free(world), trundle_scene_free(scene);
}

static void a_biaxial_test(void **state) {
    (void)state;
    trundle_error error;
    const char *sets[] = {"sample.disks=50", "shear.inertial_number=1e-2", "shear.strain_end=0.01"};
    trundle_scene *scene = trundle_scene_read_file("cases/biaxial.yaml", sets, 3, &error);
    trundle_world *world = scene ? trundle_world_new(scene, &error) : NULL;
    if (!world) fail_msg("%s", error.text);
    trundle_biaxial s;
    trundle_touch touch[400];
    assert_int_equal(trundle_world_count(world), 50);
    assert_int_equal(trundle_world_step(world, 2000, &error), TRUNDLE_OK);
    assert_int_equal(trundle_world_biaxial(world, &s, &error), TRUNDLE_OK);
    assert_close(s.stress_2, 160e3, 0.1, 0); /* held by the pistons */
    assert_true(s.stress_1 > s.stress_2 && s.strain > 0);
    int n = trundle_world_contacts(world, touch, 400, &error);
    assert_true(n > 60 && n < 400);
    touch[1].a = -77; /* behind the room for one */
    assert_int_equal(trundle_world_contacts(world, touch, 1, &error), n);
    assert_int_equal(touch[1].a, -77);
    assert_int_equal(trundle_world_contacts(world, NULL, 0, &error), n);
    assert_int_equal(trundle_world_contacts(world, touch, 400, &error), n);
    trundle_biaxial again;
    assert_int_equal(trundle_world_biaxial(world, &again, &error), TRUNDLE_OK);
    assert_memory_equal(&again, &s, sizeof s); /* no step between */
    for (int i = 0; i < n; i++) {
        assert_true(touch[i].f_n >= 0 && touch[i].overlap > 0 && touch[i].mobilisation <= 1 + 1e-12);
        assert_close(hypot(touch[i].nx, touch[i].ny), 1, 1e-12, 0);
    }
    trundle_world_free(world), trundle_scene_free(scene);
}

/* Gears of radii 1 and 3: rims of the same speed; and a rigid rotation, which is neither. */
static void definitions(void **state) {
    (void)state;
    const trundle_body one = {.spin = 3}, gear = {.x = 4, .spin = -1}, rigid = {.x = 4, .vy = 12, .spin = 3};
    assert_true(trundle_definition_count(TRUNDLE_ROLLING) >= 7 && trundle_definition_count(TRUNDLE_SLIDING) >= 4);
    assert_string_equal(trundle_definition_name(TRUNDLE_ROLLING, 0), "wang");
    assert_null(trundle_definition_name(TRUNDLE_ROLLING, trundle_definition_count(TRUNDLE_ROLLING)));
    for (int i = 0; i < trundle_definition_count(TRUNDLE_ROLLING); i++) {
        const char *name = trundle_definition_name(TRUNDLE_ROLLING, i);
        double v = trundle_definition_value(TRUNDLE_ROLLING, i, 1, 3, &one, &gear);
        assert_close(fabs(v), strcmp(name, "tordesillas") ? 3 : 4, 1e-12, 0); /* the rim's speed; an angle: w1 - w2 */
        assert_close(trundle_definition_value(TRUNDLE_ROLLING, i, 1, 3, &one, &rigid), 0, 0, 1e-12);
    }
    for (int i = 0; i < trundle_definition_count(TRUNDLE_SLIDING); i++)
        assert_close(trundle_definition_value(TRUNDLE_SLIDING, i, 1, 3, &one, &gear), 0, 0, 1e-12);
    /* in a ring that stands, the disk rolls: at the contact, 4 m from the ring's centre, its material rests */
    trundle_body ring = {0}, in = {.x = 3, .vy = 3, .spin = -3};
    assert_close(trundle_definition_value(TRUNDLE_SLIDING, 0, -4, 1, &ring, &in), 0, 0, 1e-12);
    assert_close(trundle_definition_value(TRUNDLE_ROLLING, 0, -4, 1, &ring, &in), 4, 1e-12, 0); /* 1 rad/s of 4 m */
    assert_true(isnan(trundle_definition_value(TRUNDLE_ROLLING, 0, -1, 1, &ring, &in)));
    assert_true(isnan(trundle_definition_value(TRUNDLE_ROLLING, 99, 1, 3, &one, &gear)));
    assert_true(isnan(trundle_definition_value(TRUNDLE_ROLLING, 0, 1, 3, &one, &one)));
}

/* A wheel that rolls on a floor, one that skids, one that spins on the spot [Wang2015 eqs. 14, 15]: V_s = R w + V,
 * V_r = -R w by Wang, half of the way of the contact over both surfaces by Bagi and Kuhn. Then the same for an observer
 * who moves and turns with the floor. */
static void definitions_on_a_floor(void **state) {
    (void)state;
    const struct { double v, w, slides, wang, mean; } rows[] = {{2, -4, 0, 2, 2}, {2, 0, 2, 0, 1}, {0, -4, -2, 2, 1}};
    for (int i = 0; i < 6; i++) {
        const double v = rows[i % 3].v, w = rows[i % 3].w, W = i / 3 ? 3 : 0, ux = i / 3 ? 0.7 : 0;
        const trundle_body floor = {.x = 1, .y = 0, .vx = ux, .vy = W * 1, .spin = W};
        const trundle_body disk = {.x = 1, .y = 0.5, .vx = v + ux - W * 0.5, .vy = W * 1, .spin = w + W};
        assert_close(trundle_definition_value(TRUNDLE_SLIDING, 0, INFINITY, 0.5, &floor, &disk), rows[i % 3].slides,
                     1e-14, 1e-14);
        assert_close(trundle_definition_value(TRUNDLE_ROLLING, 0, INFINITY, 0.5, &floor, &disk), rows[i % 3].wang,
                     1e-14, 1e-14);
        assert_close(trundle_definition_value(TRUNDLE_ROLLING, 1, INFINITY, 0.5, &floor, &disk), rows[i % 3].mean,
                     1e-14, 1e-14);
    }
}

static const char sled[] =
    "{kind: bodies, time_end: 1, gravity: {x: 0, y: -9.81}, contact: {k_n: 1e8, damping_ratio: 0.3, "
    "mu: %g, %s}, disks: [{radius: 0.05, density: 1200, x: 0, y: radius + "
    "density*pi*radius^2*gravity.y/contact.k_n, vx: %g}], walls: [{nx: 0, ny: 1}]}";

static trundle_scene *sled_of(double mu, const char *rolling, double vx) {
    char text[400];
    trundle_error error;
    snprintf(text, sizeof text, sled, mu, rolling, vx);
    trundle_scene *scene = trundle_scene_read("sled", text, NULL, 0, &error);
    if (!scene) fail_msg("%s", error.text);
    return scene;
}

/* A disk slides on a floor: dv/dt = -mu g, with the mu of before, then that of after. Swings of the contact spring, at
 * most mu g/w_t with w_t = sqrt(3 k_t/m) = 5600/s, 1e-3 of the speed that is lost in 0.1 s. */
static void changed_laws(void **state) {
    (void)state;
    trundle_error error;
    trundle_scene *rough = sled_of(0.3, "rolling: none", 3), *smooth = sled_of(0.1, "rolling: none", 3);
    trundle_world *world = trundle_world_new(rough, &error);
    const int steps = (int)(0.1 / trundle_world_dt(world));
    trundle_disk a, b, c;
    assert_int_equal(trundle_world_step(world, steps, &error), TRUNDLE_OK);
    trundle_world_disk(world, 0, &a, &error);
    assert_int_equal(trundle_world_change_laws(world, smooth, &error), TRUNDLE_OK);
    assert_int_equal(trundle_world_step(world, steps, &error), TRUNDLE_OK);
    trundle_world_disk(world, 0, &b, &error);
    const double lost = 9.81 * steps * trundle_world_dt(world);
    assert_close(3 - a.vx, 0.3 * lost, 2e-3, 0);
    assert_close(a.vx - b.vx, 0.1 * lost, 2e-3, 0);
    trundle_scene *ball = trundle_scene_read("ball",
                                             "{kind: bodies, shape: sphere, time_end: 1, contact: {k_n: 1e6, mu: 0.1, "
                                             "rolling: none}, disks: [{radius: 1, x: 0, y: 0}]}",
                                             NULL, 0, &error);
    assert_int_equal(trundle_world_change_laws(world, ball, &error), TRUNDLE_BAD_CASE);
    trundle_world_disk(world, 0, &c, &error);
    assert_true(c.vx == b.vx);
    trundle_world_free(world), trundle_scene_free(rough), trundle_scene_free(smooth), trundle_scene_free(ball);
}

/* A change to the same laws changes nothing: both springs of the contact go on, bit for bit. The disk
 * slides for 0.03 s and rolls then, so neither spring is at its limit all the time. */
static void laws_changed_to_themselves(void **state) {
    (void)state;
    trundle_error error;
    trundle_scene *scene = sled_of(0.3, "k_t: 1e8, mu_r: 0.2, k_r: 1e7", 0.3),
                  *same = sled_of(0.3, "k_t: 1e8, mu_r: 0.2, k_r: 1e7", 0.3);
    trundle_disk disk[2];
    for (int k = 0; k < 2; k++) {
        trundle_world *world = trundle_world_new(scene, &error);
        assert_non_null(world);
        for (int i = 0; i < 400; i++) {
            if (k && i % 50 == 17) assert_int_equal(trundle_world_change_laws(world, same, &error), TRUNDLE_OK);
            assert_int_equal(trundle_world_step(world, 20, &error), TRUNDLE_OK);
        }
        trundle_world_disk(world, 0, &disk[k], &error);
        trundle_world_free(world);
    }
    assert_memory_equal(&disk[0], &disk[1], sizeof disk[0]);
    trundle_scene_free(scene), trundle_scene_free(same);
}

/* Two disks are thrown at each other so fast that they meet within a step: that ends the world. */
static void a_world_that_failed(void **state) {
    (void)state;
    trundle_error error;
    trundle_disk disk;
    trundle_scene *scene = trundle_scene_read(
        "fast",
        "{kind: bodies, time_end: 1, step: {dt: 1e-5}, contact: {k_n: 1 MPa, friction: none, rolling: none}, disks: "
        "[{radius: 0.01, x: 0, y: 0, vx: 250}, {radius: 0.01, x: 0.022, y: 0}]}",
        NULL, 0, &error);
    trundle_world *world = scene ? trundle_world_new(scene, &error) : NULL;
    if (!world) fail_msg("%s", error.text);
    assert_int_equal(trundle_world_step(world, 100, &error), TRUNDLE_NUMERICAL);
    double time = trundle_world_time(world);
    assert_int_equal(trundle_world_step(world, 1, &error), TRUNDLE_BAD_CASE);
    assert_close(trundle_world_time(world), time, 0, 0);
    assert_int_equal(trundle_world_disk(world, 1, &disk, &error), TRUNDLE_OK);
    trundle_world_free(world), trundle_scene_free(scene);

    const char *two = "kind: bodies\ntime_end: 1\ncontact: {k_n: 1 MPa, friction: none, rolling: none}\ndisks: "
                      "[{radius: 1, x: 0, y: 0}]\n---\nlabel: more\n";
    scene = trundle_scene_read("two", two, NULL, 0, &error);
    if (!scene) fail_msg("%s", error.text);
    assert_null(trundle_world_new(scene, &error));
    assert_int_equal(error.code, TRUNDLE_BAD_CASE);
    trundle_scene_free(scene);
}

/* A program whose numbers have a comma: the case keeps its points, and the program its comma. */
static void comma_locale(void **state) {
    (void)state;
    trundle_error error;
    trundle_disk disk;
    const char *found = NULL, *const names[] = {"de_DE.UTF-8", "fr_FR.UTF-8"};
    /* Where the system has none, it may have what one is made of. */
    if (!system("mkdir -p /tmp/trundle-locale && localedef -i de_DE -f UTF-8 /tmp/trundle-locale/de_DE.UTF-8 "
                ">/dev/null 2>&1"))
        setenv("LOCPATH", "/tmp/trundle-locale", 1);
    for (size_t i = 0; i < sizeof names / sizeof *names && !found; i++) found = setlocale(LC_ALL, names[i]);
    if (system("rm -rf /tmp/trundle-locale") || !found) skip();
    assert_string_equal(localeconv()->decimal_point, ",");
    trundle_scene *scene =
        trundle_scene_read("a",
                           "{kind: bodies, time_end: 0.5, contact: {k_n: 1.5 MPa, friction: none, rolling: none}, "
                           "disks: [{radius: 1.75, x: 0.5, y: 0}]}",
                           NULL, 0, &error);
    trundle_world *world = scene ? trundle_world_new(scene, &error) : NULL;
    if (!world) fail_msg("%s", error.text);
    assert_int_equal(trundle_world_disk(world, 0, &disk, &error), TRUNDLE_OK);
    assert_true(disk.radius == 1.75 && disk.x == 0.5);
    assert_string_equal(localeconv()->decimal_point, ",");
    trundle_contact_free(contact_of("k_n: 1.5 MPa, friction: none, rolling: none", &pair));
    trundle_world_free(world), trundle_scene_free(scene);
    setlocale(LC_ALL, "C");
}

/* A disk pressed into a ring: pushed to its middle by k_n delta; friction and rolling turn both, and no angular
 * momentum is made: torque1 + torque2 + X21 x F = 0. Back in the middle the contact has forgotten. */
static void test_contact_in_a_ring(void **state) {
    (void)state;
    trundle_error error;
    trundle_force f;
    trundle_touch touch;
    trundle_pair pair = {.R1 = -0.1, .R2 = 0.02, .density1 = 1000, .density2 = 1000};
    trundle_contact *c = contact_of("k_n: 1 MPa, damping_ratio: 0, mu: 0.5, k_t: 1 MPa, mu_r: 0.1, k_r: 1 MPa", &pair);
    trundle_body ring = {.spin = 1}, disk = {.x = 0.06, .y = -0.0801 * 0.6612, .vx = 0.3, .spin = 2};
    disk.y = -sqrt(0.0801 * 0.0801 - 0.06 * 0.06);
    assert_int_equal(trundle_contact_step(c, 1e-6, &ring, &disk, &f, &error), TRUNDLE_OK);
    double inward = -(f.fx * disk.x + f.fy * disk.y) / 0.0801;
    assert_close(inward, 1e6 * 1e-4, 1e-9, 0);
    assert_close(f.torque1 + f.torque2 + disk.x * f.fy - disk.y * f.fx, 0, 0, 1e-13);
    assert_true(f.torque1 != 0 && f.torque2 != 0);
    assert_int_equal(trundle_contact_read(c, &touch, &error), TRUNDLE_OK);
    assert_true(touch.a == 0 && touch.b == 1 && touch.overlap > 0);
    disk.x = 0, disk.y = 1e-3;
    assert_int_equal(trundle_contact_step(c, 1e-6, &ring, &disk, &f, &error), TRUNDLE_OK);
    assert_true(f.fx == 0 && f.fy == 0 && f.torque1 == 0 && f.torque2 == 0);
    trundle_contact_free(c);
    pair.R1 = -0.02;
    assert_null(trundle_contact_new("k_n: 1 MPa, friction: none, rolling: none", &pair, &error));
    assert_non_null(strstr(error.text, "a ring, which holds smaller disks"));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(spring_by_hand),
                                       cmocka_unit_test(plane_turned),
                                       cmocka_unit_test(test_contact_in_a_ring),
                                       cmocka_unit_test(as_in_a_world),
                                       cmocka_unit_test(what_is_refused),
                                       cmocka_unit_test(a_biaxial_test),
                                       cmocka_unit_test(a_world_that_failed),
                                       cmocka_unit_test(comma_locale),
                                       cmocka_unit_test(definitions),
                                       cmocka_unit_test(definitions_on_a_floor),
                                       cmocka_unit_test(changed_laws),
                                       cmocka_unit_test(laws_changed_to_themselves)};
    return cmocka_run_group_tests_name("api", tests, NULL, NULL);
}
