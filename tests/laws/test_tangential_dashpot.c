/* SPDX-License-Identifier: MIT */
/* The dashpot beside the spring of coulomb-spring: one step by hand, a damped oscillator in closed form, the bound, and
 * that it never gives energy. */
#include "assert_close.h"
#include "base/random.h"
#include "laws/law.h"
#include "scene/scene.h"
#include <stdlib.h>
#include <string.h>

extern const tr_law tr_friction_coulomb_spring;

enum { ROOM = 16 };
static const double MU = 0.4, K_T = 3e6, R1 = 0.5, R2 = 0.2, M1 = 3, M2 = 1;

static tr_tile tile; /* static: aligned */
static double par[ROOM], hist[1], pair[1], radius[2], g1 = 1;

static double start(double ratio) {
    const tr_law *law = &tr_friction_coulomb_spring;
    const tr_pair_bodies b = {.R1 = R1, .R2 = R2, .m1 = M1, .m2 = M2, .I1 = M1 * R1 * R1 / 2, .I2 = M2 * R2 * R2 / 2};
    *tr_law_value(law, par, "mu") = MU, *tr_law_value(law, par, "k_t") = K_T;
    *tr_law_value(law, par, "tangential_damping_ratio") = ratio;
    memset(&tile, 0, sizeof tile);
    tile.n = 1, tile.R1 = radius, tile.R2 = radius + 1, tile.g1 = &g1, hist[0] = 0;
    law->pair(par, &b, pair);
    return law->stiffness(par, &b).c;
}

static tr_law_data data(void) {
    static double *const h[1] = {hist}, *const p[1] = {pair};
    return (tr_law_data){.par = par, .hist = h, .pair = p};
}

static double run(double f_n, double v, double dt) {
    tr_law_data d = data();
    tile.dt = dt, tile.f_n[0] = f_n, tile.v_s[0] = v;
    tr_friction_coulomb_spring.step(&tile, &d);
    return tile.f_t[0];
}

static double stored(void) {
    tr_law_data d = data();
    double energy[TR_TILE], bound[TR_TILE];
    tr_friction_coulomb_spring.state(&tile, &d, energy, bound);
    return energy[0];
}

static const double ROUND = 1e-14; /* a few products */

static void one_step_is_the_formula(void **state) {
    (void)state;
    const double f = 1e5, cap = MU * f, dt = 1e-4, ratio = 0.3;
    const double c = 2 * ratio * sqrt(K_T * M1 * M2 / (M1 + M2));
    assert_close(start(ratio), c, ROUND, 0);
    assert_close(run(f, 2, dt), K_T * 2 * dt + c * 2, ROUND, 0); /* 600 + 1800 of 40,000 */
    assert_close(hist[0], K_T * 2 * dt, ROUND, 0);
    hist[0] = 0.9 * cap;
    assert_close(run(f, 10, 0), cap, ROUND, 0);    /* 36,000 + 9000 */
    assert_close(hist[0], cap - c * 10, ROUND, 0); /* the spring gives way: together they are the bound */
    hist[0] = 0.9 * cap;
    assert_close(run(f, 1e4, 0), cap, ROUND, 0); /* the dashpot is far above the bound */
    assert_true(hist[0] == 0);                   /* and the spring gives way to 0, not beyond */
    hist[0] = -0.5 * cap;
    assert_close(run(f, 1e4, 0), cap, ROUND, 0);
    assert_close(hist[0], -0.5 * cap, ROUND, 0);     /* a spring that pulls the other way is not stretched */
    assert_true(run(0, 5, dt) == 0 && hist[0] == 0); /* apart: nothing is left */
}

/* V_s' = -f_t/m, 1/m = 1/m1 + 1/m2 + R1^2/I1 + R2^2/I2: from V at rest of the spring
 * V exp(-g t) (cos(d t) - g/d sin(d t)), g = c/(2m), d^2 = k_t/m - g^2. The step is explicit, its error of first order.
 */
static void two_free_disks_swing_as_a_damped_oscillator(void **state) {
    (void)state;
    const double m = 1 / (3 / M1 + 3 / M2), w = sqrt(K_T / m), t_end = 3 / w, V = 1e-3;
    double error[2];
    for (int fine = 0; fine < 2; fine++) {
        const double c = start(0.2), g = c / (2 * m), d = sqrt(w * w - g * g), dt = t_end / (fine ? 4000 : 2000);
        double v = V;
        for (int k = 0; k < (fine ? 4000 : 2000); k++) v -= run(1e9, v, dt) / m * dt;
        error[fine] = v / V - exp(-g * t_end) * (cos(d * t_end) - g / d * sin(d * t_end));
        assert_true(fabs(error[fine]) < 2 * w * dt);
    }
    assert_close(error[0] / error[1], 2, 0.02, 0); /* first order */
}

/* The spring takes what it stores, friction and dashpot only take: f_t V_s dt is at least the growth of the store in
 * every step, at any speed and any normal force, growing or falling. For a spring alone Q' V dt - (Q'^2 - Q^2)/(2k) = k
 * V^2 dt^2/2 >= 0, so the explicit step does not hide a gain. */
static void no_step_gives_energy(void **state) {
    (void)state;
    tr_random r = tr_random_seed(9, 1);
    double taken = 0, least = 0;
    for (int ratio = 0; ratio < 4; ratio++) {
        start((double[]){0, 0.1, 1, 10}[ratio]);
        for (int k = 0; k < 100000; k++) {
            double f = 1e5 * fmax(0, tr_random_uniform(&r) - 0.1), dt = 1e-5, before = stored();
            double v = (tr_random_uniform(&r) - 0.5) * pow(10, 6 * tr_random_uniform(&r) - 3);
            double f_t = run(f, v, dt), take = f_t * v * dt - (stored() - before);
            assert_true(fabs(f_t) <= MU * f * (1 + ROUND) && fabs(hist[0]) <= MU * f * (1 + ROUND));
            least = fmin(least, take), taken += take;
        }
    }
    assert_true(taken > 0);
    assert_true(least > -1e-12); /* N; the largest store is MU 1e5 squared/(2 K_T) = 267 N: rounding of 5e-14 */
}

static bool reads(const char *bodies, const char *time, tr_status *st) {
    char text[700];
    tr_scene scene;
    snprintf(text, sizeof text,
             "kind: contact\nbodies: {R1: 1 cm, R2: 1 cm, E: 1 GPa, nu: 0.3%s}\n"
             "laws: [{friction: coulomb-spring, mu: 0.3, k_t: 1 MPa, tangential_damping_ratio: 0.2}]\n"
             "path: [{force: 10 N/m, slide: 1 um, steps: 10%s}]\n",
             bodies, time);
    bool ok = tr_scene_read(&scene, &(tr_scene_source){"case", text, strlen(text), NULL, 0}, tr_laws_catalog(), st);
    if (ok) tr_scene_free(&scene);
    return ok;
}

/* A dashpot depends on the rate and on the masses, so a prescribed path must give both. */
static void a_path_without_times_or_masses_is_refused(void **state) {
    (void)state;
    tr_status st = {0};
    assert_true(reads(", density: 1000 kg/m^3", ", time: 1 ms", &st));
    assert_false(reads(", density: 1000 kg/m^3", "", &st));
    assert_non_null(strstr(st.text, "`path.0.time` is missing"));
    st = (tr_status){0};
    assert_false(reads("", ", time: 1 ms", &st));
    assert_non_null(strstr(st.text, "`bodies.density` is missing"));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_step_is_the_formula),
        cmocka_unit_test(two_free_disks_swing_as_a_damped_oscillator),
        cmocka_unit_test(no_step_gives_energy),
        cmocka_unit_test(a_path_without_times_or_masses_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
