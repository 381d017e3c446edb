/* SPDX-License-Identifier: MIT */
/* What a body is, against closed forms: a hoop, a disk and a ball roll down a slope; a spool is pulled by its thread.
 */
#include "core/bodies.h"
#include "core/worlds.h"
#include "laws/law.h"
#include "scene/scene.h"

static const double G = 9.81, R = 0.02, DENSITY = 2700;

/* A scene by its text, run to its end. */
static void play(const char *text, tr_scene *scene, tr_bodies *b) {
    tr_status st = {0};
    if (!tr_scene_read(scene, &(tr_scene_source){"case", text, strlen(text), NULL, 0}, tr_laws_catalog(), &st) ||
        !tr_bodies_init(b, scene, &st))
        fail_msg("%s", st.text);
    for (int64_t k = 0; k < b->steps; k++) {
        tr_bodies_advance(b);
        forces(&b->world);
    }
}

static void end(tr_scene *scene, tr_bodies *b) {
    tr_bodies_free(b);
    tr_scene_free(scene);
}

/* The friction spring, without a dashpot, swings about the force of rolling that starts at once, with the frequency of
 * sliding: a speed that grows by a swings by a/w, seen at most as twice that. k_t is 5 MPa by default. */
static double swing(double acceleration, double m, double I) {
    return 2 * fabs(acceleration) / sqrt(5e6 * (1 / m + R * R / I));
}

/* On a slope of angle s, I = c m R^2, rolling: a = g sin(s)/(1 + c). */
static void a_body_rolls_down_by_its_inertia(void **state) {
    (void)state;
    const double factor[] = {1, 0.5, 0.4}, slope = 0.2;
    for (int k = 0; k < 3; k++) {
        char text[900];
        tr_scene scene;
        tr_bodies b;
        double v[3], m = DENSITY * M_PI * R * R, a = G * sin(slope) / (1 + factor[k]);
        snprintf(
            text, sizeof text,
            "kind: bodies\ntime_end: 0.5 s\ngravity: {x: %.17g, y: %.17g}\ncontact: {k_n: 10 MPa, mu: 0.6, mu_r: 0, "
            "damping_ratio: 0.3}\ndisks: [{radius: 20 mm, inertia: %.17g, x: 0, y: %.17g}]\n"
            "walls: [{nx: 0, ny: 1}]\n",
            G * sin(slope), -G * cos(slope), factor[k], R - m * G * cos(slope) / 1e7);
        play(text, &scene, &b);
        tr_bodies_velocity(&b.world, 0, v);
        assert_close(v[0], 0.5 * a, 0, swing(a, m, factor[k] * m * R * R));
        assert_close(-v[2] * R, v[0], 0, 2 * swing(a, m, factor[k] * m * R * R)); /* it rolls */
        end(&scene, &b);
    }
}

/* A spool on the floor, thread at the angle p on a hub of radius r: about the contact point the moment of the force is
 * F (r - R cos(p)), counter-clockwise, and I about it is 1.5 m R^2. Where cos(p) > r/R it rolls towards the pull. The
 * floor carries m g - F sin(p). */
static void a_spool_rolls_towards_or_away(void **state) {
    (void)state;
    const double F = 5, r = 0.01, m = DENSITY * M_PI * R * R, angle[] = {0, M_PI / 3 - 0.2, M_PI / 3 + 0.2, M_PI / 2};
    for (int k = 0; k < 4; k++) {
        char text[900];
        tr_scene scene;
        tr_bodies b;
        double v[3], T = 0.3;
        snprintf(text, sizeof text,
                 "kind: bodies\ntime_end: %.17g s\ngravity: {y: -%.17g}\ncontact: {k_n: 10 MPa, mu: 0.6, mu_r: 0, "
                 "damping_ratio: 0.3}\ndisks: [{radius: 20 mm, x: 0, y: 20 mm - (%.17g)/contact.k_n * 1 N/m, pull: "
                 "{force: %.17g, radius: %.17g, angle: %.17g}}]\nwalls: [{nx: 0, ny: 1}]\n",
                 T, G, m * G - F * sin(angle[k]), F, r, angle[k]);
        play(text, &scene, &b);
        tr_bodies_velocity(&b.world, 0, v);
        double spin = F * (r - R * cos(angle[k])) / (1.5 * m * R * R) * T;
        double swings = swing(spin / T, m, m * R * R / 2) + swing(F * r / (m * R * R / 2), m, m * R * R / 2);
        assert_close(v[2], spin, 0, swings);
        assert_close(v[0], -spin * R, 0, R * swings);
        end(&scene, &b);
    }
}

/* Gravity that turns makes the loads anew: the pull is still in them. Without contact: v = F/m T along the angle, and g
 * integrated over its turn. */
static void a_pull_stays_while_gravity_turns(void **state) {
    (void)state;
    const double F = 5, p = 0.3, W = 2, T = 0.5, m = DENSITY * M_PI * R * R;
    tr_scene scene;
    tr_bodies b;
    double v[3];
    play("kind: bodies\ntime_end: 0.5 s\ngravity: {y: -9.81, turn: 2}\ncontact: {k_n: 10 MPa, mu: 0, mu_r: 0}\n"
         "step: {dt: 1 ms}\ndisks: [{radius: 20 mm, x: 0, y: 0, pull: {force: 5, angle: 0.3}}]\n",
         &scene, &b);
    tr_bodies_velocity(&b.world, 0, v);
    /* the trapezoidal rule of the step: (W dt)^2/12 of each part of g T */
    double err = W * W * 1e-6 / 12 * G * T * 2;
    assert_close(v[0], F / m * cos(p) * T + G / W * (1 - cos(W * T)), 0, err);
    assert_close(v[1], F / m * sin(p) * T - G / W * sin(W * T), 0, err);
    end(&scene, &b);
}

/* tr_law_inertia is the one place of 1/2 and 2/5: int r^2 dm over int dm of thin shells, times R^2. */
static void inertia_of_whole_bodies(void **state) {
    (void)state;
    double disk = 0, sphere = 0, n = 100000;
    for (int i = 0; i < n; i++) {
        double x = (i + 0.5) / n; /* cylinder shells of height 1 and 2 sqrt(1 - x^2) */
        disk += x * x * 2 * x / n, sphere += x * x * 3 * x * sqrt(1 - x * x) / n;
    }
    assert_close(tr_law_inertia(TR_SHAPE_DISK), disk, 1e-6, 0);
    assert_close(tr_law_inertia(TR_SHAPE_SPHERE), sphere, 1e-6, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_body_rolls_down_by_its_inertia),
        cmocka_unit_test(a_spool_rolls_towards_or_away),
        cmocka_unit_test(a_pull_stays_while_gravity_turns),
        cmocka_unit_test(inertia_of_whole_bodies),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
