/* SPDX-License-Identifier: MIT */
/* One disk on a floor, against the closed forms of a rigid disk (I = m R^2/2) with Coulomb friction mu and a rolling
 * moment of at most mu_r N R:
 *
 *   slip to roll   starts at v0 without spin: rolls from t = v0/(3 mu g) with 2/3 v0; a third of the energy is lost
 *   incline        rolls from tan a = mu_r with (2/3) g (sin a - mu_r cos a); slips from tan a = 3 mu - 2 mu_r with
 *                  g (sin a - mu cos a)
 *   coasting       decelerates with (2/3) mu_r g and stops after 3 v0^2/(4 mu_r g) + x_c/2, x_c = mu_r m g/k_r: the
 *                  rolling spring takes x_c to load
 *
 * The tangential spring is not rigid: Vs swings with w_t = sqrt(3 k_t/m), and a velocity may be off by g/w_t. */
#include "core/convergence.h"
#include "core/pipeline.h"
#include "core/worlds.h"

static const double RADIUS = 0.01, DENSITY = 1000, G = 10;

static double mass(void) {
    return DENSITY * M_PI * RADIUS * RADIUS;
}

/* On the floor y = 0 at the overlap that carries the weight, in a field turned by `slope` (downhill is +x). dt is a
 * twentieth of the period of the stiffest mode over 2 pi. */
static void put_on_floor(tr_world *w, test_laws laws, double slope) {
    new_world(w, 1);
    w->wall[0] = (tr_wall){.ny = 1}, w->n_walls = 1;
    double gy = G * cos(slope);
    tr_world_set_disk(w, 0, &(tr_disk_start){0, RADIUS - mass() * gy / laws.k_n, 0, RADIUS, DENSITY, false});
    set_gravity(w, G * sin(slope), -gy);
    set_laws(w, laws, TR_SINK_LEDGER);
    w->dt = 0.1 / sqrt(3 * fmax(laws.k_n, fmax(laws.k_t, laws.k_r)) / mass());
}

static double energy(const tr_world *w) {
    const double *v = w->disks.vel;
    return 0.5 * mass() * (v[0] * v[0] + 0.5 * RADIUS * RADIUS * v[2] * v[2]);
}

static double sliding(const tr_world *w) {
    return w->disks.vel[0] + RADIUS * w->disks.vel[2];
}

typedef struct rolling_start {
    double t, v, lost;
} rolling_start;

/* v averaged over the swings after the start of rolling; lost: share of the energy. */
static rolling_start slip_to_roll(double k, double v0, double mu) {
    tr_world w;
    put_on_floor(&w, (test_laws){.k_n = k, .damping_ratio = 0.3, .mu = mu, .k_t = k}, 0);
    set_velocity(&w, 0, v0, 0, 0);
    double e0 = energy(&w), sum = 0, lost = 0;
    rolling_start r = {0};
    while (sliding(&w) > 0) steps(&w, 1);
    r.t = (double)w.steps * w.dt;
    int periods = (int)ceil(20 * 2 * M_PI / sqrt(3 * k / mass()) / w.dt);
    for (int i = 0; i < periods; i++) steps(&w, 1), sum += w.disks.vel[0], lost += 1 - energy(&w) / e0;
    r.v = sum / periods, r.lost = lost / periods;
    tr_world_free(&w);
    return r;
}

/* Stiffness times 4 is a step of half the length: the rigid disk is the limit. */
static void test_slip_to_roll(void **state) {
    (void)state;
    double v0 = 0.3, mu = 0.2, h[4], error[3][4];
    for (int i = 0; i < 4; i++) {
        double k = 1e5 * pow(4, i);
        rolling_start r = slip_to_roll(k, v0, mu);
        h[i] = 0.1 / sqrt(3 * k / mass());
        error[0][i] = r.t - v0 / (3 * mu * G), error[1][i] = r.v - 2 * v0 / 3, error[2][i] = r.lost - 1.0 / 3;
    }
    double order = observed_order(4, h, error[0]);
    print_message("slip to roll: time %.1e of %.3g s, order %.2f in dt (k dt^2 kept); speed %.1e of %.2g; lost %.1e\n",
                  error[0][0], v0 / (3 * mu * G), order, error[1][0], 2 * v0 / 3, error[2][0]);
    assert_true(order > 0.8); /* theory 1: the moment is found to one step; loading the spring takes dt^2 */
    for (int i = 0; i < 4; i++) {
        assert_close(error[0][i], 0, 0, 2 * h[i]);
        /* Friction is on from the second step; spring swings average out but for mu g/w_t over 20 periods. */
        assert_close(error[1][i], 0, 0, 2 * mu * G * h[i]);
        assert_close(error[2][i], 0, 0, 4 * mu * G * h[i] / v0);
    }
}

/* Accelerations over the second half of the given time, from rest. */
static void incline(double slope, double mu, double mu_r, double time, double *a, double *spin_up, double *v_s) {
    tr_world w;
    put_on_floor(&w, (test_laws){.k_n = 1e7, .damping_ratio = 0.3, .mu = mu, .k_t = 1e7, .mu_r = mu_r, .k_r = 1e7},
                 slope);
    int n = (int)(time / w.dt) / 2;
    steps(&w, n);
    double v = w.disks.vel[0], spin = w.disks.vel[2];
    steps(&w, n);
    *a = (w.disks.vel[0] - v) / (n * w.dt), *spin_up = -RADIUS * (w.disks.vel[2] - spin) / (n * w.dt);
    *v_s = sliding(&w);
    tr_world_free(&w);
}

static void test_incline(void **state) {
    (void)state;
    const double mu = 0.4, mu_r = 0.15, time = 0.2, w_t = sqrt(3 * 1e7 / mass());
    const double swing = 4 * G / w_t / (time / 2); /* of the spring, at both ends of the interval */
    const double start = mu_r, slip = 3 * mu - 2 * mu_r;
    static const double shares[] = {0.05, 0.5, 0.95};
    double a, spin_up, v_s;
    for (int i = 0; i < 3; i++) {
        double slope = atan(start + shares[i] * (slip - start)), c = cos(slope), s = sin(slope);
        incline(slope, mu, mu_r, time, &a, &spin_up, &v_s);
        assert_close(a, 2.0 / 3 * G * (s - mu_r * c), 1e-3, swing);
        assert_close(spin_up, 2.0 / 3 * G * (s - mu_r * c), 1e-3, swing);
        assert_close(v_s, 0, 0, 2 * G / w_t); /* it rolls */
    }
    static const double above[] = {1.02, 1.3};
    for (int i = 0; i < 2; i++) {
        double slope = atan(above[i] * slip), c = cos(slope), s = sin(slope);
        incline(slope, mu, mu_r, time, &a, &spin_up, &v_s);
        assert_close(a, G * (s - mu * c), 1e-3, swing);
        assert_close(spin_up, 2 * G * (mu - mu_r) * c, 1e-3, swing);
        double slides = G * (s - mu * c) - 2 * G * (mu - mu_r) * c;
        assert_true(v_s > 0.5 * slides * time);
    }
    /* Below the threshold it rests: after the swing of the sudden load, no speed grows. */
    double slope = atan(0.95 * start);
    incline(slope, mu, mu_r, time, &a, &spin_up, &v_s);
    assert_close(a, 0, 0, swing);
    slope = atan(1.05 * start);
    incline(slope, mu, mu_r, time, &a, &spin_up, &v_s);
    assert_true(a > 0.5 * 2.0 / 3 * G * 0.05 * start * cos(slope));
    /* mu_r > mu: above tan a = mu it slides without spinning. */
    slope = atan(1.2 * mu);
    incline(slope, mu, 2 * mu, time, &a, &spin_up, &v_s);
    assert_close(a, G * (sin(slope) - mu * cos(slope)), 1e-3, swing);
    assert_close(spin_up, 0, 0, 2 * swing);
}

static void test_coasting(void **state) {
    (void)state;
    const double mu = 0.5, mu_r = 0.1, v0 = 0.1, k_r = 600, k = 1e7;
    double N = mass() * G, x_c = mu_r * N / k_r, stop = 3 * v0 * v0 / (4 * mu_r * G) + x_c / 2;
    assert_true(x_c / 2 > 0.01 * stop); /* a spring that is seen */
    for (int sign = -1; sign <= 1; sign += 2) {
        tr_world w;
        put_on_floor(&w, (test_laws){.k_n = k, .damping_ratio = 0.3, .mu = mu, .k_t = k, .mu_r = mu_r, .k_r = k_r}, 0);
        set_velocity(&w, 0, sign * v0, 0, -sign * v0 / RADIUS);
        double t1 = 0, v1 = 0, slope = 0;
        while (sign * w.disks.vel[0] > 0) {
            steps(&w, 1);
            double x = sign * w.disks.pos[0], t = (double)w.steps * w.dt;
            if (t1 == 0 && x > 2 * x_c) t1 = t, v1 = w.disks.vel[0];
            if (x < 0.9 * stop && t > t1) slope = (w.disks.vel[0] - v1) / (t - t1);
        }
        /* The rolling swing of the spring k_t takes g/w_t of speed, 4e-5 of v0, and the stop is v0 dt exact. */
        assert_close(sign * w.disks.pos[0], stop, 5e-4, 0);
        assert_close(slope, -sign * 2.0 / 3 * mu_r * G, 2e-3, 0);
        tr_world_free(&w);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_slip_to_roll),
        cmocka_unit_test(test_incline),
        cmocka_unit_test(test_coasting),
    };
    return cmocka_run_group_tests_name("rolling", tests, NULL, NULL);
}
