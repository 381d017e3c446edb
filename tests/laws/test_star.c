/* SPDX-License-Identifier: MIT */
/* The three rolling laws of STAR-CCM+ against closed forms. A disk of I = m R^2/2 on a floor, N = m g:
 *
 *   spinning in place, no friction    w = w0 - c (2 g/R) mu_r t   until it stops, and stays; c = R_eq/R: 1 or 2
 *   coasting                          decelerates with c (2/3) mu_r g, stops after 3 v0^2/(4 c mu_r g) (+ R theta_max/2
 *                                     where a spring loads first)
 *   torsional swing                   damped with omega^2 = k_r/I, zeta = damping_factor sqrt(I_r/I), I_r = 3 I
 *
 * then a disk on a turning one, which shows what is objective, and one squeezed between walls, with and without the
 * moment limiter. */
#include "base/random.h"
#include "core/ledger.h"
#include "core/pipeline.h"
#include "core/record.h"
#include "core/worlds.h"

static const double RADIUS = 0.01, DENSITY = 1000, G = 10, K = 1e7;

static double mass(void) {
    return DENSITY * M_PI * RADIUS * RADIUS;
}
static double inertia(void) {
    return 0.5 * mass() * RADIUS * RADIUS;
}

typedef struct star {
    const char *name;
    double mu_r, theta_max, damping_factor, damping_multiplier;
    int half;
    bool limiter, damping;
} star;

static void set_option(tr_scene_law *law, const char *key, int value) {
    const tr_param_table *t = &tr_laws_rolling[law->law]->table;
    for (int i = 0; i < t->n; i++)
        if (!strcmp(t->params[i].key, key)) {
            void *at = (char *)law->par + t->params[i].offset;
            if (t->params[i].type == TR_CHOICE) *(int *)at = value;
            if (t->params[i].type == TR_SWITCH) *(bool *)at = value;
            return;
        }
    fail_msg("no option %s", key);
}

static bool is(star s, const char *what) {
    return strstr(s.name, what) != NULL;
}

static void set_star(tr_world *w, double mu, star s, unsigned sinks) {
    tr_scene_contact c = contact_of((test_laws){.k_n = K, .damping_ratio = 0.3, .mu = mu, .k_t = K});
    const tr_param_catalog *catalog = tr_laws_catalog();
    c.rolling = law_named(tr_laws_rolling, catalog->n_rolling, s.name);
    const tr_param_table *t = &tr_laws_rolling[c.rolling.law]->table;
    set_parameter(&c.rolling, t, "mu_r", s.mu_r);
    if (!is(s, "proportional")) set_option(&c.rolling, "R_eq", s.half);
    if (is(s, "constant"))
        set_option(&c.rolling, "limiter", s.limiter), set_parameter(&c.rolling, t, "limiter_factor", 0.08);
    if (is(s, "damping")) {
        set_parameter(&c.rolling, t, "theta_max", s.theta_max);
        set_parameter(&c.rolling, t, "damping_factor", s.damping_factor);
        set_parameter(&c.rolling, t, "damping_multiplier", s.damping_multiplier);
        set_option(&c.rolling, "damping", s.damping);
    }
    tr_status st = {0};
    if (!tr_world_set_laws(w, &c, false, sinks, &st)) fail_msg("%s", st.text);
}

/* At the overlap that carries its weight. */
static void on_floor(tr_world *w, double mu, star s) {
    new_world(w, 1);
    w->wall[0] = (tr_wall){.ny = 1}, w->n_walls = 1;
    tr_world_set_disk(w, 0, &(tr_disk_start){0, RADIUS - mass() * G / K, 0, RADIUS, DENSITY, false});
    set_gravity(w, 0, -G);
    set_star(w, mu, s, TR_SINK_LEDGER);
    w->dt = 0.1 / sqrt(3 * K / mass());
}

#define FP "star-force-proportional"
#define CT "star-constant-torque"
#define DD "star-displacement-damping"

/* R_eq/R at a wall */
static double lever(star s) {
    return is(s, "proportional") || s.half ? 1 : 2;
}

static const star capped[] = {
    {.name = FP, .mu_r = 0.1},
    {.name = CT, .mu_r = 0.1},
    {.name = CT, .mu_r = 0.1, .half = 1},
    {.name = DD, .mu_r = 0.1, .theta_max = 0.035},
    {.name = DD, .mu_r = 0.1, .theta_max = 0.2, .half = 1},
};
enum { CAPPED = sizeof capped / sizeof *capped };

/* ---- spinning in place */

static void test_spinning_disk(void **state) {
    (void)state;
    for (int k = 0; k < CAPPED; k++)
        for (int sense = -1; sense <= 1; sense += 2) {
            star s = capped[k];
            tr_world w;
            on_floor(&w, 0, s);
            double w0 = 40, slow = lever(s) * s.mu_r * 2 * G / RADIUS, *spin = &w.disks.vel[2];
            set_velocity(&w, 0, 0, 0, sense * w0);
            forces(&w), tr_ledger_begin(&w);
            /* the moment is on from the second step; the spring needs theta_max to load, a moment half as large
             * before */
            double load = s.theta_max / w0, t = 0;
            while (sense * *spin > 0.2 * w0) {
                tr_step_advance(&w), forces(&w), t += w.dt;
                if (t > 2 * load)
                    assert_close(sense * *spin, w0 - slow * t, 0,
                                 slow * (0.51 * load * (1 + load * slow / w0) + 3 * w.dt));
            }
            assert_true(s.theta_max > 0 || t > 0.8 * w0 / slow);
            if (is(s, "damping")) {
                tr_world_free(&w);
                continue;
            }
            while (sense * *spin > 0) tr_step_advance(&w), forces(&w), t += w.dt;
            assert_close(t, w0 / slow, 0, 3 * w.dt);
            for (int n = 0; n < 1000; n++) { /* it stays, without chatter */
                tr_step_advance(&w), forces(&w);
                assert_close(*spin, 0, 0, 1e-14 * w0);
            }
            tr_energy e = tr_ledger_read(&w); /* all of it lost to rolling: the steps at both ends */
            assert_close(e.rolling, 0.5 * inertia() * w0 * w0, 4 * w.dt * slow / w0, 0);
            assert_true(e.elastic_rolling == 0);
            tr_world_free(&w);
        }
}

/* ---- coasting */

static void test_coasting_disk(void **state) {
    (void)state;
    const double v0 = 0.1;
    for (int k = 0; k < CAPPED; k++)
        for (int sense = -1; sense <= 1; sense += 2) {
            star s = capped[k];
            tr_world w;
            on_floor(&w, 0.8, s);
            set_velocity(&w, 0, sense * v0, 0, -sense * v0 / RADIUS);
            double c = lever(s), load = RADIUS * s.theta_max, stop = 3 * v0 * v0 / (4 * c * s.mu_r * G) + load / 2;
            double t1 = 0, v1 = 0, slope = 0;
            while (sense * w.disks.vel[0] > 0) {
                steps(&w, 1);
                double x = sense * w.disks.pos[0], t = (double)w.steps * w.dt;
                if (t1 == 0 && x > 2 * load + 0.05 * stop) t1 = t, v1 = w.disks.vel[0];
                if (x < 0.9 * stop && t1 > 0 && t > t1) slope = (w.disks.vel[0] - v1) / (t - t1);
            }
            /* The swing of the spring k_t takes g/w_t of speed, 6e-5 of v0; the overlap shortens the radius by 3e-5 */
            assert_close(sense * w.disks.pos[0], stop, 1e-3, 0);
            assert_close(slope, -sense * c * 2.0 / 3 * s.mu_r * G, 3e-3, 0);
            if (!is(s, "damping")) { /* it stays: what is left is the swing of k_t, without spin */
                double x = w.disks.pos[0], left = 4 * G / sqrt(3 * K / mass());
                for (int n = 0; n < 5000; n++) {
                    steps(&w, 1);
                    assert_close(w.disks.vel[0], 0, 0, left);
                    assert_close(RADIUS * w.disks.vel[2], 0, 0, left);
                }
                assert_close(w.disks.pos[0], x, 0, 1e-3 * stop);
            }
            tr_world_free(&w);
        }
}

/* ---- the torsional spring and its dashpot */

static void test_swing(void **state) {
    (void)state;
    static const double factors[] = {0, 0.1, 0.5, 1 / 1.7320508075688772, 2};
    for (int k = 0; k < 5; k++) {
        star s = {.name = DD,
                  .mu_r = 0.1,
                  .theta_max = 0.035,
                  .damping_factor = factors[k],
                  .damping_multiplier = 0.2,
                  .damping = k > 0};
        tr_world w;
        on_floor(&w, 0, s);
        double k_r = s.mu_r * 2 * RADIUS * mass() * G / s.theta_max, omega = sqrt(k_r / inertia()),
               z = factors[k] * sqrt(3);
        double w0 = 0.3 * s.theta_max * omega;
        set_velocity(&w, 0, 0, 0, w0);
        int n = (int)(12 / omega / w.dt);
        forces(&w);
        double from = 0.5 * w.dt; /* the first step has no spring; spins are those half a step before */
        for (int i = 1; i < n; i++) {
            tr_step_advance(&w), forces(&w);
            double t = i * w.dt - from, want;
            if (z < 0.999) {
                double d = omega * sqrt(1 - z * z);
                want = exp(-z * omega * t) * (cos(d * t) - z * omega / d * sin(d * t));
            } else if (z < 1.001) {
                want = exp(-omega * t) * (1 - omega * t);
            } else {
                double d = omega * sqrt(z * z - 1), a = z * omega - d, b = z * omega + d;
                want = (b * exp(-b * t) - a * exp(-a * t)) / (b - a);
            }
            assert_close(w.disks.vel[2] / w0, want, 0, 4 * omega * w.dt * (1 + 2 * z));
        }
        tr_world_free(&w);
    }
}

/* The bound on the step uses the spring at the present overlap, here a large one, and its dashpot. */
static void test_bound_on_the_step(void **state) {
    (void)state;
    for (int damping = 0; damping < 2; damping++) {
        star s = {.name = DD, .mu_r = 1, .theta_max = 0.035, .damping_factor = 0.4, .damping = damping};
        tr_world w;
        on_floor(&w, 0, s);
        w.disks.pos[1] = 0.71 * RADIUS;
        forces(&w);
        double k_r = 2 * RADIUS * K * 0.29 * RADIUS / s.theta_max, omega2 = k_r / inertia();
        double d = damping * 0.4 * 2 * sqrt(3 * inertia() * k_r) / inertia();
        assert_close(tr_timestep_contacts(&w).dt, (sqrt(d * d + 4 * omega2) - d) / omega2, 1e-12, 0);
        tr_world_free(&w);
    }
}

/* ---- one step by hand: pairs of unequal disks, all options */

typedef struct one_step {
    double m1, m2, bound, memory;
} one_step;

/* Disk 1 of radius 2R, 2 of radius R; spins w1, w2, normal force f, friction Q, step dt. */
static one_step single(star s, double w1, double w2, double f, double Q, double dt, double before) {
    static tr_tile t;
    memset(&t, 0, sizeof t);
    tr_world w;
    new_world(&w, 2);
    tr_world_set_disk(&w, 0, &(tr_disk_start){0, 0, 0, 2 * RADIUS, DENSITY, false});
    tr_world_set_disk(&w, 1, &(tr_disk_start){1, 0, 0, RADIUS, DENSITY, false});
    set_star(&w, 0, s, 0);
    const tr_group_law *slot = &w.group[0].laws[TR_ROLLING];
    double R1[1] = {2 * RADIUS}, R2[1] = {RADIUS}, g1[1] = {2.0 / 3}, h[2] = {before, before}, p[TR_MAX_PAIR] = {0};
    tr_pair_bodies bodies = tr_world_pair(&w, &w.group[0], 0, 1);
    slot->law->pair(slot->par, &bodies, p);
    if (is(s, "damping")) { /* what the bound on the step is told: per radian */
        bodies.f_n = f;
        double k_r = s.mu_r * (s.half ? 1 : 2) * 2 * RADIUS / 3 * f / s.theta_max;
        tr_stiffness k = slot->law->stiffness(slot->par, &bodies);
        assert_close(k.k, k_r, 1e-14, 0);
        assert_close(k.c, s.damping ? s.damping_factor * 2 * sqrt(p[0] * k_r) : 0, 1e-14, 0);
        assert_true(k.lever1 == 1 && k.lever2 == 1 && k.along == 0);
    }
    t.n = 1, t.dt = dt, t.R1 = R1, t.R2 = R2, t.g1 = g1;
    t.r1[0] = 1.9 * RADIUS, t.r2[0] = 0.95 * RADIUS;
    t.w1[0] = w1, t.w2[0] = w2, t.f_n[0] = f, t.f_t[0] = Q;
    tr_law_data data = {.par = slot->par, .hist = (double *[]){h, h + 1}, .pair = (double *[]){p, p + 1, p + 2, p + 3}};
    tr_lane energy, bound;
    slot->law->step(&t, &data);
    slot->law->state(&t, &data, energy, bound);
    tr_world_free(&w);
    return (one_step){t.m1[0], t.m2[0], bound[0], h[0]};
}

static void test_force_proportional_by_hand(void **state) {
    (void)state;
    star s = {.name = FP, .mu_r = 0.01};
    double f = 300, I2 = inertia(), I1 = 16 * I2, dt = 1e-5;
    one_step o = single(s, 50, -70, f, 0, dt, 0);
    assert_close(o.m1, -0.01 * f * 1.9 * RADIUS, 1e-14, 0);
    assert_close(o.m2, 0.01 * f * 0.95 * RADIUS, 1e-14, 0);
    assert_close(o.bound, 0.01 * f * 1.9 * RADIUS, 1e-14, 0);
    o = single(s, 0.001, -0.002, f, 0.4, dt, 0); /* slow: stops the spin that friction leaves */
    assert_close(o.m1, -(I1 * 0.001 / dt - 1.9 * RADIUS * 0.4), 1e-13, 0);
    assert_close(o.m2, -(I2 * -0.002 / dt - 0.95 * RADIUS * 0.4), 1e-13, 0);
    o = single(s, 0, 0, f, 0, dt, 0);
    assert_true(o.m1 == 0 && o.m2 == 0);
    o = single(s, 0, 5, f, 0, 0, 1e-4); /* dt = 0: the moments of the step before */
    assert_true(o.m1 == 1e-4 && o.m2 == 1e-4);
}

static void test_constant_torque_by_hand(void **state) {
    (void)state;
    double f = 300, I2 = inertia(), I1 = 16 * I2, dt = 1e-5;
    for (int half = 0; half < 2; half++) {
        star s = {.name = CT, .mu_r = 0.01, .half = half};
        double R_eq = (half ? 1 : 2) * 2 * RADIUS / 3, cap = 0.01 * R_eq * f;
        one_step o = single(s, 50, -70, f, 0, dt, 0), p = single(s, 50, 70, f, 0, dt, 0);
        assert_close(o.m1, -cap, 1e-14, 0);
        assert_close(p.m1, cap, 1e-14, 0);
        assert_true(o.m2 == -o.m1 && p.m2 == -p.m1);
        assert_close(o.bound, cap, 1e-14, 0);
        /* slow: both spins are equal after the step */
        double w1 = 0.001, w2 = -0.002, Q = 0.4;
        o = single(s, w1, w2, f, Q, dt, 0);
        assert_true(fabs(o.m1) < cap);
        double end1 = w1 + dt * (o.m1 - 1.9 * RADIUS * Q) / I1, end2 = w2 + dt * (o.m2 - 0.95 * RADIUS * Q) / I2;
        assert_close(end1, end2, 0, 1e-12 * 0.002);
        o = single(s, 1, 1, f, 0, dt, 0);
        assert_true(o.m1 == 0 && o.m2 == 0);
        o = single(s, 0, 5, f, 0, 0, -1e-4);
        assert_true(o.m1 == -1e-4 && o.m2 == 1e-4);
        s.limiter = true; /* I1 = 16 I2: disk 2 has the lesser rotation until it is 16 times faster */
        o = single(s, 0.03, -0.02, f, 0, dt, 0);
        assert_close(o.m1, -0.08 * I2 * 0.02 / dt, 1e-13, 0);
        o = single(s, 0.001, -0.02, f, 0, dt, 0);
        assert_close(o.m1, -0.08 * I1 * 0.001 / dt, 1e-13, 0);
        o = single(s, 50, 0, f, 0, dt, 0); /* beside a disk at rest: nothing */
        assert_true(o.m1 == 0);
        o = single(s, 0, 5, f, 0, 0, -1e-4);
        assert_true(o.m1 == -1e-4);
    }
}

static void test_displacement_damping_by_hand(void **state) {
    (void)state;
    double f = 300, I2 = 3 * inertia(), I1 = 16 * I2, I_r = I1 * I2 / (I1 + I2), dt = 1e-5;
    for (int half = 0; half < 2; half++)
        for (int damping = 0; damping < 2; damping++) {
            star s = {.name = DD,
                      .mu_r = 0.01,
                      .theta_max = 0.02,
                      .half = half,
                      .damping_factor = 0.4,
                      .damping_multiplier = 0.25,
                      .damping = damping};
            double cap = 0.01 * (half ? 1 : 2) * 2 * RADIUS / 3 * f, k_r = cap / 0.02,
                   C = damping * 2 * sqrt(I_r * k_r);
            one_step o = single(s, 8, -20, f, 0, dt, 0.1 * cap);
            assert_close(o.memory, 0.1 * cap - k_r * 28 * dt, 1e-13, 0);
            assert_close(o.m1, o.memory - 0.4 * C * 28, 1e-13, 0);
            assert_true(o.m2 == -o.m1 && fabs(o.m1) <= o.bound * (1 + 1e-15));
            o = single(s, 8, -20, f, 0, dt, -0.999 * cap); /* reaches the bound */
            assert_close(o.memory, -cap, 1e-14, 0);
            assert_close(o.m1, -cap - 0.25 * 0.4 * C * 28, 1e-13, 0);
            o = single(s, 8, -20, 0.5 * f, 0, 0, 0.9 * cap); /* a lower bound cuts the store, dt = 0 or not */
            assert_close(o.memory, 0.5 * cap, 1e-14, 0);
            o = single(s, 8, -20, 0, 0, dt, 0.9 * cap);
            assert_true(o.m1 == 0 && o.memory == 0 && o.bound == 0);
        }
}

/* ---- a disk on a turning disk: objective or not */

static void test_on_a_turning_disk(void **state) {
    (void)state;
    static const char *names[] = {CT, FP};
    for (int k = 0; k < 2; k++) {
        star s = {.name = names[k], .mu_r = 0.05, .half = 1};
        tr_world w;
        new_world(&w, 2);
        tr_world_set_disk(&w, 0, &(tr_disk_start){0, 0, 0, RADIUS, DENSITY, true});
        tr_world_set_disk(&w, 1, &(tr_disk_start){0, 2 * RADIUS - mass() * G / K, 0, RADIUS, DENSITY, false});
        set_gravity(&w, 0, -G);
        set_star(&w, 0, s, 0);
        w.dt = 0.1 / sqrt(3 * K / mass());
        double W = 30, M = s.mu_r * mass() * G * RADIUS * (k ? 1 : 0.5); /* arm R, or R_eq = R/2 */
        set_velocity(&w, 0, 0, 0, W), set_velocity(&w, 1, 0, 0, -10);
        double t = 0.5 * 10 / (M / inertia());
        int n = (int)(t / w.dt);
        steps(&w, n);
        assert_close(w.disks.vel[6], -10 + M / inertia() * n * w.dt, 0, 3 * w.dt * M / inertia());
        steps(&w, 12 * n);
        assert_close(w.disks.vel[6], k ? 0 : W, 0, 1e-9); /* with the other disk, or at rest for the room */
        assert_true(w.disks.vel[2] == W);
        tr_world_free(&w);
    }
}

/* ---- squeezed by three walls: together they stop the spin */

static double squeezed_spin(bool limiter, int n, double w0) {
    tr_world w;
    new_world(&w, 1);
    double squeeze = 0.01 * RADIUS;
    for (int k = 0; k < 3; k++) {
        double a = 2 * M_PI * k / 3;
        w.wall[k] =
            (tr_wall){.x = -(RADIUS - squeeze) * cos(a), .y = -(RADIUS - squeeze) * sin(a), .nx = cos(a), .ny = sin(a)};
    }
    w.n_walls = 3;
    tr_world_set_disk(&w, 0, &(tr_disk_start){0, 0, 0, RADIUS, DENSITY, false});
    set_star(&w, 0, (star){.name = CT, .mu_r = 0.1, .limiter = limiter}, 0);
    w.dt = 0.1 / sqrt(3 * K / mass());
    set_velocity(&w, 0, 0, 0, w0);
    steps(&w, 1); /* the first step has no moments */
    steps(&w, n);
    double spin = w.disks.vel[2];
    assert_true(w.contact_updates == 3 * (n + 1));
    tr_world_free(&w);
    return spin;
}

static void test_moment_limiter(void **state) {
    (void)state;
    double w0 = 1e-3, I = inertia(), dt = 0.1 / sqrt(3 * K / mass()), cap = 0.1 * 2 * RADIUS * K * 0.01 * RADIUS;
    for (int n = 1; n <= 20; n++) {
        assert_close(squeezed_spin(true, n, w0), w0 * pow(1 - 3 * 0.08, n), 1e-12, 0);
        assert_true(w0 * I / dt < 3 * cap);
        assert_close(squeezed_spin(false, n, w0), 0, 0, 1e-15 * w0); /* without: each wall stops its third */
        double fast = 10 * 3 * cap * dt / I, left = fmax(fast - n * 3 * cap * dt / I, 0); /* the caps bind: ten steps */
        assert_close(squeezed_spin(false, n, fast), left, 0, 1e-12 * fast);
    }
}

/* 4 x 4 disks squeezed in a box, with spins so small that one step stops any of them. If each of a disk's four contacts
 * stopped it, the step would turn it back threefold until the caps bind: the compact would spin by itself, at a rate
 * set by the step. With their shares no mode of spins turns over. The limiter lets a contact take 8 % of the lesser
 * spin at most, four of them 32 % of a disk's own. */
static double compact_spin(bool limiter, int n, double w0) {
    enum { SIDE = 4 };
    const double squeeze = 0.01 * RADIUS, pitch = 2 * RADIUS - squeeze, side = SIDE * pitch;
    tr_random r = tr_random_seed(8, 1);
    tr_world w;
    new_world(&w, SIDE * SIDE);
    const tr_wall box[] = {{.nx = 1}, {.x = side, .nx = -1}, {.ny = 1}, {.y = side, .ny = -1}};
    for (int k = 0; k < 4; k++) w.wall[k] = box[k];
    w.n_walls = 4;
    for (int i = 0; i < SIDE * SIDE; i++)
        tr_world_set_disk(
            &w, i, &(tr_disk_start){pitch * (0.5 + i % SIDE), pitch * (0.5 + i / SIDE), 0, RADIUS, DENSITY, false});
    set_star(&w, 0, (star){.name = CT, .mu_r = 0.1, .limiter = limiter}, 0);
    w.dt = 0.1 / sqrt(3 * K / mass());
    for (int i = 0; i < SIDE * SIDE; i++) w.disks.vel[4 * i + 2] = w0 * (tr_random_uniform(&r) - 0.5);
    steps(&w, n);
    double most = 0;
    for (int i = 0; i < SIDE * SIDE; i++) most = fmax(most, fabs(w.disks.vel[4 * i + 2]));
    tr_world_free(&w);
    return most;
}

static void test_compact(void **state) {
    (void)state;
    double w0 = 1e-3, without = compact_spin(false, 2000, w0), with = compact_spin(true, 2000, w0);
    print_message("16 disks, started at %.0e rad/s: %.2g rad/s after 2000 steps without limiter, %.0e with\n", w0,
                  without, with);
    assert_true(without <
                1e-12 * w0); /* the slowest mode, of relative spin at four contacts, falls by tenths in a step */
    assert_true(with < 1e-3 * w0);
}

/* The share of a body's inertia that a contact has follows the number of its contacts, also where the contact is an old
 * one: disk 2 comes to disk 1, and leaves it. */
static void test_shares_follow_the_contacts(void **state) {
    (void)state;
    tr_world w;
    new_world(&w, 3);
    for (int i = 0; i < 3; i++)
        tr_world_set_disk(&w, i, &(tr_disk_start){1.99 * RADIUS * i + (i == 2), 0, 0, RADIUS, DENSITY, false});
    set_star(&w, 0.5, (star){.name = "star-force-proportional", .mu_r = 0.1}, 0);
    w.dt = 1e-7;
    for (int k = 0; k < 3; k++) {
        w.disks.pos[4 * 2] = 1.99 * RADIUS * 2 + (k != 1), w.stale = true;
        forces(&w);
        const tr_group *g = &w.group[0];
        int i = listed(g, 0, 1), of_law = g->laws[TR_ROLLING].pair;
        assert_int_equal(g->n, k == 1 ? 2 : 1);
        assert_close(g->pair[of_law][i], inertia(), 1e-15, 0);
        assert_close(g->pair[of_law + 1][i], inertia() / (k == 1 ? 2 : 1), 1e-15, 0);
    }
    tr_world_free(&w);
}

/* ---- records: an unbalanced law's mobilisation is that of its larger moment */

static void test_record(void **state) {
    (void)state;
    tr_world w;
    on_floor(&w, 0.5, capped[0]);
    set_velocity(&w, 0, 0, 0, 40);
    steps(&w, 10), forces(&w);
    tr_record *records = NULL;
    int capacity = 0;
    tr_status st = {0};
    double torque = w.disks.force[2];
    assert_int_equal(tr_record_all(&w, &records, &capacity, &st), 1);
    assert_true(records[0].m1 == 0 && records[0].m2 < 0 && records[0].f_r == 0);
    assert_close(records[0].rolling_mobilisation, 1, 1e-15, 0);
    assert_close(records[0].m2 - RADIUS * records[0].f_t, torque, 1e-15, 0);
    free(records);
    tr_world_free(&w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_spinning_disk),
        cmocka_unit_test(test_coasting_disk),
        cmocka_unit_test(test_swing),
        cmocka_unit_test(test_bound_on_the_step),
        cmocka_unit_test(test_force_proportional_by_hand),
        cmocka_unit_test(test_constant_torque_by_hand),
        cmocka_unit_test(test_displacement_damping_by_hand),
        cmocka_unit_test(test_on_a_turning_disk),
        cmocka_unit_test(test_moment_limiter),
        cmocka_unit_test(test_compact),
        cmocka_unit_test(test_shares_follow_the_contacts),
        cmocka_unit_test(test_record),
    };
    return cmocka_run_group_tests_name("star", tests, NULL, NULL);
}
