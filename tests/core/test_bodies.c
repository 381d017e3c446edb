/* SPDX-License-Identifier: MIT */
/* kind: bodies. Each motion against its closed form: circles and rolling on them, spins under a torque, gravity that
 * turns, friction that brings a pinned disk up to the speed of its neighbour; and the bound on the step where a part of
 * the motion is prescribed, against the modes of the part that is left.
 *
 * EPS: one rounding; a number after k steps has k of them at most, each of its largest value on the way. */
#include "core/bodies.h"
#include "core/convergence.h"
#include "core/pipeline.h"
#include "core/record.h"
#include "core/worlds.h"

static const double EPS = 1.1e-16, DENSITY = 1000, G = 10;

static double mass(double R) {
    return DENSITY * M_PI * R * R;
}
static double inertia(double R) {
    return mass(R) * R * R / 2;
}

/* Frictionless unless said; dt 0: from the bound. */
typedef struct show {
    tr_scene scene;
    tr_scene_disk disk[2];
    tr_scene_wall wall[1];
    tr_bodies b;
} show;

static const test_laws smooth = {.k_n = 1e7};

static void start(show *s, int disks, test_laws laws, double dt) {
    tr_status st = {0};
    s->scene.kind = TR_KIND_BODIES, s->scene.contact = contact_of(laws);
    s->scene.step = (tr_scene_step){.safety = 0.2, .dt = dt};
    s->scene.time_end = 1;
    s->scene.disks = s->disk, s->scene.n_disks = disks;
    s->scene.walls = s->wall;
    for (int i = 0; i < disks; i++) s->disk[i].density = DENSITY;
    if (!tr_bodies_init(&s->b, &s->scene, &st)) fail_msg("%s", st.text);
    forces(&s->b.world);
}

/* n steps on; the forces of the new instant are made. */
static void go(show *s, int n) {
    for (int k = 0; k < n; k++) tr_bodies_advance(&s->b), forces(&s->b.world);
}

static double now(const show *s) {
    return (double)s->b.world.steps * s->b.world.dt;
}

static const double *position(const show *s, int i) {
    return s->b.world.disks.pos + 4 * (size_t)i;
}

static double velocity(const show *s, int i, int lane) {
    double v[3];
    tr_bodies_velocity(&s->b.world, i, v);
    return v[lane];
}

static double spin(const show *s, int i) {
    return velocity(s, i, 2);
}

/* The one contact there is. */
static tr_record contact(show *s) {
    tr_record *records = NULL;
    int capacity = 0;
    tr_status st = {0};
    assert_int_equal(tr_record_all(&s->b.world, &records, &capacity, &st), 1);
    tr_record r = records[0];
    free(records);
    return r;
}

static double sliding_by(const tr_record *r, const char *name) {
    for (int v = 0; v < tr_n_sliding_velocities; v++)
        if (!strcmp(tr_sliding_velocities[v].name, name)) return r->v_s_by[v];
    fail_msg("no sliding velocity is called %s", name);
    return NAN;
}

/* ---- orbits */

/* Two overlapping disks that turn as one body about a point beside them: nothing slides, rolls or approaches, at any
 * step; with whole radii they slide by overlap times rate. The chords of the step would give V_s = L W (W dt)^2/6, here
 * 1.5e-4 of L W, and v_n = L W (W dt)/2. */
static void test_rigid_rotation_by_two_orbits(void **state) {
    (void)state;
    const double W = -3, R1 = 0.02, R2 = 0.01, lap = 1e-3, L = R1 + R2 - lap, x = 0.5, y = -0.2, dt = 0.01;
    show s = {.disk = {{.radius = R1, .x = x + 0.02, .y = y + 0.01},
                       {.radius = R2, .x = x + 0.02 + 0.6 * L, .y = y + 0.01 + 0.8 * L}}};
    for (int i = 0; i < 2; i++)
        s.disk[i].motion = TR_ORBIT, s.disk[i].orbit = s.disk[i].spin = W, s.disk[i].orbit_x = x, s.disk[i].orbit_y = y;
    start(&s, 2, (test_laws){.k_n = 1e7, .damping_ratio = 0.3, .mu = 0.5, .k_t = 1e7}, dt);
    for (int k = 0; k < 200; k++) {
        tr_record r = contact(&s);
        double a = 20 * EPS * fabs(W) * (x + fabs(y)); /* positions are of the size of x, y */
        assert_close(r.v_s, 0, 0, a);
        assert_close(r.v_r, 0, 0, a);
        assert_close(r.v_n, 0, 0, a);
        assert_close(r.s1, 0, 0, a);
        assert_close(sliding_by(&r, "full-radius"), lap * W, 0, a);
        assert_close(r.delta, lap, 0, 20 * EPS * (x + fabs(y)));
        assert_close(r.f_n, 1e7 * lap, 0, 1e7 * 20 * EPS * (x + fabs(y)) + 1e5 * a); /* and the dashpot's c < 1e5 */
        assert_close(r.f_t, 0, 0, 1e7 * dt * a * (k + 1));
        go(&s, 1);
    }
    tr_bodies_free(&s.b);
}

/* Disk 1 rolls round disk 0, which rests: betadot = B, w2 = B (R1+R2)/R2 with any overlap; equal arcs of opposite
 * sense, da = -R1 B t = -db. */
static void test_rolling_over_a_fixed_disk(void **state) {
    (void)state;
    const double B = 2, R1 = 0.03, R2 = 0.01, L = R1 + R2 - 5e-4;
    show s = {.disk = {{.radius = R1, .motion = TR_PRESCRIBED},
                       {.radius = R2, .x = L, .motion = TR_ORBIT, .orbit = B, .spin = B * (R1 + R2) / R2}}};
    start(&s, 2, (test_laws){.k_n = 1e7, .mu = 0.5, .k_t = 1e7}, 0.01);
    for (int k = 0; k < 1000; k++) {
        tr_record r = contact(&s);
        double t = now(&s), a = 20 * EPS * B * (R1 + R2);
        assert_close(r.v_s, 0, 0, a);
        assert_close(r.v_r, -R1 * B, 0, a);
        assert_close(r.da, -R1 * B * t, 0, a * t + k * EPS * R1 * B * t);
        assert_close(r.db, R1 * B * t, 0, a * t + k * EPS * R1 * B * t);
        go(&s, 1);
    }
    tr_bodies_free(&s.b);
}

/* A thousand turns of 40 steps. cos and sin of an angle A are off by A EPS for each rounding in it, of which there are
 * three; the radius has no angle in it. A centre that adds up its chords would walk off by sqrt(40000) roundings. */
static void test_orbit_for_long(void **state) {
    (void)state;
    const double W = 7, dt = 2 * M_PI / W / 40, r = hypot(0.3, 0.4), cx = 0.25, cy = -1;
    show s = {.disk = {{.radius = 0.3,
                        .x = cx + 0.3,
                        .y = cy + 0.4,
                        .spin = 0.5,
                        .vx = 9,
                        .motion = TR_ORBIT,
                        .orbit = W,
                        .orbit_x = cx,
                        .orbit_y = cy}}};
    start(&s, 1, smooth, dt);
    const double angle0 = atan2(0.4, 0.3);
    double walked = 0;
    for (int k = 0; k <= 40000; k++) {
        double A = W * now(&s) + angle0, rounding = 4 * EPS * (1 + r), phase = rounding + 4 * EPS * r * A;
        const double *x = position(&s, 0);
        assert_close(x[0], cx + r * cos(A), 0, phase);
        assert_close(x[1], cy + r * sin(A), 0, phase);
        walked = fmax(walked, fabs(hypot(x[0] - cx, x[1] - cy) - r));
        assert_close(hypot(x[0] - cx, x[1] - cy), r, 0, rounding);
        assert_close(velocity(&s, 0, 0), -W * r * sin(A), 0, W * phase);
        assert_close(velocity(&s, 0, 1), W * r * cos(A), 0, W * phase);
        assert_true(spin(&s, 0) == 0.5);
        go(&s, 1);
    }
    print_message("orbit: after 1000 turns the radius is off by %.1e m at most\n", walked);
    tr_bodies_free(&s.b);
}

/* ---- torque, pinned and driven disks */

/* w = w0 + M t/I and the angle w0 t + M t^2/2I: leapfrog is exact, if it starts from half a step back. A pinned centre
 * keeps its velocity against gravity, a free one falls and turns alike; no torque turns what keeps its spin. */
static void test_torque(void **state) {
    (void)state;
    const double M = -0.02, w0 = 3, R = 0.02, dt = 1e-4, vx = 0.2, vy = -0.1;
    for (int shape = 0; shape < 2; shape++)
        for (int motion = TR_FREE; motion <= TR_DRIVEN; motion++) {
            if (motion == TR_ORBIT) continue;
            show s = {.scene = {.shape = (tr_shape)shape, .gravity = {.y = -G}},
                      .disk = {{.radius = R, .vx = vx, .vy = vy, .spin = w0, .torque = M, .motion = motion}}};
            start(&s, 1, smooth, dt);
            double I = shape == TR_SHAPE_SPHERE ? 0.4 * (DENSITY * 4 / 3 * M_PI * R * R * R) * R * R : inertia(R);
            double alpha = motion == TR_FREE || motion == TR_PINNED ? M / I : 0;
            double g = motion == TR_FREE || motion == TR_DRIVEN ? G : 0;
            for (int k = 0; k <= 1000; k++) {
                double t = now(&s), e = 2 * EPS * (k + 2), w = w0 + fabs(alpha) * t, v = vx - vy + G * t;
                assert_close(spin(&s, 0), w0 + alpha * t, 0, e * w);
                assert_close(velocity(&s, 0, 0), vx, 0, 0);
                assert_close(velocity(&s, 0, 1), vy - g * t, 0, e * v);
                assert_close(position(&s, 0)[0], vx * t, 0, e * v * t);
                assert_close(position(&s, 0)[1], vy * t - g * t * t / 2, 0, e * v * t);
                assert_close(position(&s, 0)[2], w0 * t + alpha * t * t / 2, 0, e * w * t);
                go(&s, 1);
            }
            tr_bodies_free(&s.b);
        }
}

/* A wheel that is driven up a slope: it slips with the acceleration g (mu cos - sin) up to R|w|, then climbs at that
 * speed with the friction m g sin. The spring k_t takes x = mu N/k_t of sliding to load and swings by mu N/sqrt(k_t m)
 * after. */
static void test_driven_disk_climbs(void **state) {
    (void)state;
    const double R = 0.01, w = -20, mu = 0.5, slope = 0.2, k = 1e7, m = mass(R), gx = -G * sin(slope),
                 N = m * G * cos(slope), a = mu * N / m + gx, late = R * fabs(w) / a;
    show s = {.scene = {.gravity = {.x = gx, .y = -G * cos(slope)}, .n_walls = 1},
              .disk = {{.radius = R, .y = R - N / k, .spin = w, .motion = TR_DRIVEN}},
              .wall = {{.ny = 1}}};
    start(&s, 1, (test_laws){.k_n = k, .damping_ratio = 0.3, .mu = mu, .k_t = k}, 0);
    const double swing = mu * N / sqrt(k * m), first = mu * N / k / (R * fabs(w)), dt = s.b.world.dt;
    while (now(&s) < 0.9 * late) {
        go(&s, 1);
        /* behind by what the loading of the spring took: half of mu N for the time `first`, and a step */
        assert_close(velocity(&s, 0, 0), a * now(&s), 1e-9, mu * N / m * (first + 2 * dt));
        assert_true(spin(&s, 0) == w);
    }
    while (now(&s) < 1.1 * late) go(&s, 1);
    int periods = (int)ceil(20 * 2 * M_PI / sqrt(k / m) / dt);
    double speed = 0, friction = 0, x = position(&s, 0)[0];
    for (int n = 0; n < periods; n++) {
        go(&s, 1);
        tr_record r = contact(&s);
        assert_close(velocity(&s, 0, 0), -R * w, 0, 1.1 * swing);
        speed += velocity(&s, 0, 0) / periods, friction += r.f_t / periods;
    }
    assert_close(speed, -R * w, 0, swing * 1e-2); /* twenty whole swings but for a step */
    assert_close(friction, m * gx, 0, mu * N * 1e-2);
    assert_close((position(&s, 0)[0] - x) / (periods * dt), -R * w, 0, swing * 1e-2);
    tr_bodies_free(&s.b);
}

/* A pinned disk at rest beside one that keeps the spin w1. The friction mu N on its arm r2 and the spring k_t in series
 * drive it: V_s = r1 w1 + r2 w2 is V0 cos(p t), p^2 = k_t r2^2/I, until the spring holds mu N, then falls by the rate
 * mu N r2^2/I to 0. From there on it rolls, w2 = -w1 r1/r2, and swings. */
static void spin_up(double k_t, double dt, double *error) {
    const double R1 = 0.02, R2 = 0.01, lap = 1e-5, k_n = 1e7, mu = 0.3, w1 = 20, I = inertia(R2);
    const double r1 = R1 * (1 - lap / (R1 + R2)), r2 = R2 * (1 - lap / (R1 + R2)), V0 = r1 * w1, rate = r2 * r2 / I;
    const double p = sqrt(k_t * rate), load = asin(mu * k_n * lap / k_t * p / V0) / p,
                 stop = load + V0 * cos(p * load) / (mu * k_n * lap * rate);
    show s = {.disk = {{.radius = R1, .spin = w1, .motion = TR_PRESCRIBED},
                       {.radius = R2, .y = R1 + R2 - lap, .motion = TR_PINNED}}};
    start(&s, 2, (test_laws){.k_n = k_n, .damping_ratio = 0.3, .mu = mu, .k_t = k_t}, dt);
    double before = V0, after = V0;
    while (after > 0 && now(&s) < 2 * stop) go(&s, 1), before = after, after = r1 * w1 + r2 * spin(&s, 1);
    double t = now(&s) - dt * after / (after - before);
    *error = (t - stop) / stop;
    /* Within the step in which the spring meets the bound friction is off by at most k_t V0 dt, for dt. */
    assert_close(t, stop, 0, k_t * V0 * dt * dt / (mu * k_n * lap));
    double half = M_PI / p, mean = 0;
    int n = (int)round(40 * half / dt); /* twenty swings */
    for (int k = 0; k < n; k++) go(&s, 1), mean += spin(&s, 1) / n;
    /* a swing has the amplitude mu N/k_t p; what is left of it is a step out of the n */
    assert_close(mean, -w1 * r1 / r2, 0, mu * k_n * lap / k_t * p / r2 * 7 / n);
    tr_bodies_free(&s.b);
}

static void test_pinned_disk_spins_up(void **state) {
    (void)state;
    double error[3];
    for (int i = 0; i < 3; i++) spin_up(2e6, 1e-5 / (1 << i), &error[i]);
    print_message("spin up: time off by %.1e, %.1e, %.1e of itself\n", error[0], error[1], error[2]);
}

/* ---- gravity that turns */

/* g = G (cos A, sin A), A = a + W t, without contact: v = v0 + (G/W) (sin A - sin a, cos a - cos A) and its integral.
 * The kicks are the trapezoid rule, the drifts the midpoint rule: second order, at most (W dt)^2/12 of G/W and G/W^2
 * for each radian; twice that is allowed. */
static void turn(double dt, int n, double *error) {
    const double W = -2.5, a = 0.7, vx = 0.3, vy = -0.2;
    show s = {.scene = {.gravity = {.x = G * cos(a), .y = G * sin(a), .turn = W}},
              .disk = {{.radius = 1, .vx = vx, .vy = vy}, {.radius = 1, .x = 50, .vx = vx, .motion = TR_PINNED}}};
    start(&s, 2, (test_laws){.k_n = 1}, dt);
    *error = 0;
    for (int k = 0; k < n; k++) {
        double t = now(&s), A = a + W * t, c = cos(a), d = sin(a), g[2], limit = pow(W * dt, 2) / 6 * (1 + fabs(W) * t);
        tr_bodies_gravity(&s.b, g);
        assert_close(g[0], G * cos(A), 0, 20 * EPS * G);
        assert_close(g[1], G * sin(A), 0, 20 * EPS * G);
        double ex = position(&s, 0)[0] - (vx * t + G / (W * W) * (c - cos(A)) - G / W * d * t);
        double ey = position(&s, 0)[1] - (vy * t + G / (W * W) * (d - sin(A)) + G / W * c * t);
        assert_close(velocity(&s, 0, 0), vx + G / W * (sin(A) - d), 0, G / fabs(W) * limit);
        assert_close(velocity(&s, 0, 1), vy + G / W * (c - cos(A)), 0, G / fabs(W) * limit);
        assert_close(ex, 0, 0, G / (W * W) * limit);
        assert_close(ey, 0, 0, G / (W * W) * limit);
        assert_close(velocity(&s, 1, 0), vx, 0, 0);
        *error = fmax(*error, hypot(ex, ey));
        go(&s, 1);
    }
    tr_bodies_free(&s.b);
}

static void test_gravity_that_turns(void **state) {
    (void)state;
    double h[3], error[3];
    for (int i = 0; i < 3; i++) {
        h[i] = 0.02 / (1 << i);
        turn(h[i], 150 << i, &error[i]);
    }
    double order = observed_order(3, h, error);
    print_message("gravity that turns: off by %.1e m after 3 s at dt = 0.02 s, order %.2f\n", error[0], order);
    assert_true(order > 1.95 && order < 2.05); /* theory 2 */
}

/* ---- the bound on the step */

/* Largest eigenvalue of K x = lambda diag(m) x, K = [a b; b c]. */
static double largest(double a, double b, double c, double m1, double m2) {
    double p = a / m1, q = c / m2;
    return 0.5 * (p + q + sqrt((p - q) * (p - q) + 4 * b * b / (m1 * m2)));
}

/* Two disks; what is free of the tangential motion: the spin of a pinned one, the way u of a driven one along t.
 * Sliding V_s = R1 w1 + R2 w2 + u, rolling V_r = R_eff (w1 - w2). */
static void test_bound_on_the_step(void **state) {
    (void)state;
    const double R1 = 0.02, R2 = 0.01, R = R1 * R2 / (R1 + R2), lap = 1e-9, I1 = inertia(R1), I2 = inertia(R2);
    static const double k_t[] = {1e6, 3e7}, k_r[] = {0, 2e7};
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            const double t = k_t[i], r = k_r[j] * R * R, n = 1e6, m1 = mass(R1), m2 = mass(R2);
            const struct {
                int one, two;
                double lambda;
            } pair[] = {
                {TR_PRESCRIBED, TR_PINNED, (t * R2 * R2 + r) / I2},
                {TR_PINNED, TR_ORBIT, (t * R1 * R1 + r) / I1},
                {TR_PINNED, TR_PINNED, largest(t * R1 * R1 + r, t * R1 * R2 - r, t * R2 * R2 + r, I1, I2)},
                {TR_PRESCRIBED, TR_DRIVEN, fmax(n, t) / m2},
                {TR_DRIVEN, TR_DRIVEN, fmax(n, t) * (1 / m1 + 1 / m2)},
                {TR_DRIVEN, TR_PINNED, fmax(n / m1, largest(t, t * R2, t * R2 * R2 + r, m1, I2))},
                {TR_ORBIT, TR_PRESCRIBED, 0},
            };
            for (int p = 0; p < 7; p++) {
                show s = {.disk = {{.radius = R1, .motion = pair[p].one},
                                   {.radius = R2, .x = R1 + R2 - lap, .motion = pair[p].two}}};
                test_laws laws = {.k_n = n, .mu = 1, .k_t = t, .mu_r = k_r[j] > 0, .k_r = k_r[j]};
                start(&s, 2, laws, 0);
                double exact = pair[p].lambda > 0 ? 2 / sqrt(pair[p].lambda) : INFINITY;
                tr_timestep_limit limit = tr_timestep_contacts(&s.b.world);
                /* ten roundings, of the overlap too */
                if (isinf(exact))
                    assert_true(isinf(limit.dt) && isinf(s.b.dt_bound) && s.b.world.dt == 1e-4);
                else {
                    assert_close(limit.dt, exact, 1e-14, 0);
                    /* before the contacts are known: also between two like disk 1, or like disk 2 */
                    assert_true(s.b.dt_bound <= exact * (1 + 1e-14) && s.b.dt_bound >= 0.5 * exact);
                    assert_close(s.b.world.dt, 0.2 * s.b.dt_bound, 1e-2, 0); /* time_end is a whole number of steps */
                }
                tr_bodies_free(&s.b);
            }
        }
}

/* How much a tiny spin of a pinned disk, pressed on by a driven one, grows in 20000 steps of share * bound. */
static double growth(double share) {
    const double R1 = 0.02, R2 = 0.01, tiny = 1e-9;
    show s = {.disk = {{.radius = R1, .motion = TR_DRIVEN}, {.radius = R2, .x = R1 + R2 - 1e-6, .motion = TR_PINNED}}};
    start(&s, 2, (test_laws){.k_n = 1e6, .mu = 1, .k_t = 1e7, .mu_r = 1, .k_r = 1e7}, 0);
    s.b.world.dt = share * tr_timestep_contacts(&s.b.world).dt, s.b.world.allow_unstable = true;
    s.b.world.disks.vel[4 + 2] = tiny;
    /* The centres hold their distance: the push along the line between them is taken off. */
    s.b.world.disks.inv[0] = 0;
    double largest = 0;
    for (int k = 0; k < 20000 && largest < 1e4 * tiny; k++) {
        go(&s, 1);
        largest = fmax(largest, fabs(s.b.world.disks.vel[4 + 2]));
    }
    tr_bodies_free(&s.b);
    return largest / tiny;
}

static void test_leapfrog_at_the_bound(void **state) {
    (void)state;
    double below = growth(0.99), above = growth(1.01);
    print_message("driven on pinned: growth %.1f at 0.99 of the bound, %.1g at 1.01\n", below, above);
    assert_true(below < 8); /* a mode near the bound may swing to 1/sqrt(1 - 0.99^2) = 7 times of where it started */
    assert_true(above >= 1e4);
}

/* ---- sign laws know whose spin is prescribed */

static void set_star(show *s, double mu_r, double dt) {
    const tr_param_catalog *catalog = tr_laws_catalog();
    tr_scene_contact c = contact_of(smooth);
    tr_status st = {0};
    c.rolling = law_named(tr_laws_rolling, catalog->n_rolling, "star-constant-torque");
    set_parameter(&c.rolling, catalog->rolling[c.rolling.law], "mu_r", mu_r);
    if (!tr_world_set_laws(&s->b.world, &c, false, 0, &st)) fail_msg("%s", st.text);
    s->b.world.dt = dt;
    forces(&s->b.world);
}

/* A pinned disk under a torque below the rolling moment stays where it is beside one that does not turn, and turns
 * under what is above it; of two disks that keep their spins, however slow, each feels the whole moment. */
static void test_sign_law(void **state) {
    (void)state;
    const double R = 0.01, lap = 1e-5, mu_r = 0.1, dt = 1e-4, cap = mu_r * R * 1e7 * lap, w = 1e-12; /* R_eq = R */
    for (int k = 0; k < 2; k++) { /* which of them is pinned */
        show s = {.disk = {{.radius = R}, {.radius = R, .x = 2 * R - lap}}};
        s.disk[k].torque = 0.9 * cap, s.disk[k].motion = TR_PINNED, s.disk[1 - k].motion = TR_PRESCRIBED;
        start(&s, 2, smooth, 0);
        set_star(&s, mu_r, dt);
        go(&s, 200);
        /* the moment answers what it has seen, the spin that the torque gives in a step */
        double *w2 = &s.b.world.disks.vel[4 * k + 2], before = *w2;
        assert_close(before, 0.9 * cap * dt / inertia(R), 1e-9, 0);
        s.b.world.disks.load[4 * k + 2] = 1.5 * cap; /* more than it can hold */
        forces(&s.b.world);
        go(&s, 100);
        assert_close(*w2 - before, 100 * 0.5 * cap * dt / inertia(R), 0.05, 0); /* but for the first steps */
        tr_bodies_free(&s.b);
    }
    show s = {.disk = {{.radius = R, .spin = w, .motion = TR_DRIVEN},
                       {.radius = R, .x = 2 * R - lap, .motion = TR_PRESCRIBED}}};
    start(&s, 2, smooth, 0);
    set_star(&s, mu_r, 1e-4 * dt);
    go(&s, 2);
    assert_close(contact(&s).m1, -cap, 1e-4, 0); /* the driven one moves by 1e-5 of the overlap in a step */
    tr_bodies_free(&s.b);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_rigid_rotation_by_two_orbits),
        cmocka_unit_test(test_rolling_over_a_fixed_disk),
        cmocka_unit_test(test_orbit_for_long),
        cmocka_unit_test(test_torque),
        cmocka_unit_test(test_driven_disk_climbs),
        cmocka_unit_test(test_pinned_disk_spins_up),
        cmocka_unit_test(test_gravity_that_turns),
        cmocka_unit_test(test_bound_on_the_step),
        cmocka_unit_test(test_leapfrog_at_the_bound),
        cmocka_unit_test(test_sign_law),
    };
    return cmocka_run_group_tests_name("bodies", tests, NULL, NULL);
}
