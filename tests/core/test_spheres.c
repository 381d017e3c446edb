/* SPDX-License-Identifier: MIT */
/* Worlds of spheres and of Hertz contacts, against closed forms (sphere: m = 4/3 pi R^3 rho, I = 2/5 m R^2;
 * P = K delta^(3/2), K = 4/3 E_star sqrt(R_star)).
 *
 * Impact without damping: the speed is v^2 - (4K/5m) delta^(5/2), m the effective mass, so that
 *   delta_max = (5 m v^2/(4K))^(2/5),
 *   duration = (2 delta_max/v) int_0^1 dx/sqrt(1 - x^(5/2)) = 4 sqrt(pi) Gamma(2/5)/(5 Gamma(9/10)) delta_max/v =
 *   2.9432...
 * With damping, s = delta^(5/4) makes v(s) that of a linear spring and dashpot of ratio sin q = sqrt(6/5) zeta, and the
 * contact ends with the force: e = exp(-(pi - 2q) tan q), at every speed.
 * Slip to roll on a floor: Vs slows by 7/2 mu g: t = 2 v0/(7 mu g), v = 5/7 v0, and 2/7 of the energy is lost. */
#include "core/convergence.h"
#include "core/ledger.h"
#include "core/pipeline.h"
#include "core/worlds.h"

static const double RADIUS = 0.01, DENSITY = 1000, E_STAR = 1e8, G = 10;

static double mass(double R) {
    return 4.0 / 3 * M_PI * R * R * R * DENSITY;
}

static double strength(double R) { /* K */
    return 4.0 / 3 * E_STAR * sqrt(R);
}

/* laws but for the normal one. */
static tr_scene_contact hertz(const char *normal, test_laws laws) {
    const tr_param_catalog *catalog = tr_laws_catalog();
    tr_scene_contact c = contact_of(laws);
    c.normal = law_named(tr_laws_normal, catalog->n_normal, normal);
    set_parameter(&c.normal, catalog->normal[c.normal.law], "E_star", E_STAR);
    set_parameter(&c.normal, catalog->normal[c.normal.law], "damping_ratio", laws.damping_ratio);
    return c;
}

static void set_hertz(tr_world *w, const char *normal, test_laws laws, unsigned sinks) {
    tr_scene_contact c = hertz(normal, laws);
    tr_status st = {0};
    if (!tr_world_set_laws(w, &c, false, sinks, &st)) fail_msg("%s", st.text);
}

/* ---- impact */

typedef struct impact {
    double e, duration, deepest;
} impact;

/* Spheres of radius RADIUS and ratio RADIUS, or (ratio 0) one against a wall, meet at v; time and overlap in units of
 * the closed forms. phase: where between two steps the contact begins. Before and after, no force acts, so that the
 * instants at which the overlap is 0 follow from straight lines; the deepest point from a parabola through three. */
static impact strike(double ratio, double zeta, double v, int steps_per_contact, double phase) {
    tr_world w;
    bool wall = ratio == 0;
    double R2 = ratio * RADIUS, m = wall ? mass(RADIUS) : 1 / (1 / mass(RADIUS) + 1 / mass(R2));
    double R = wall ? RADIUS : 1 / (1 / RADIUS + 1 / R2), depth = pow(5 * m * v * v / (4 * strength(R)), 0.4);
    double time = 4 * sqrt(M_PI) * tgamma(0.4) / (5 * tgamma(0.9)) * depth / v, gap;
    new_world_of(&w, wall ? 1 : 2, TR_SHAPE_SPHERE);
    w.dt = time / steps_per_contact, w.allow_unstable = true;
    gap = (phase + 0.5) * v * w.dt;
    tr_world_set_disk(&w, 0, &(tr_disk_start){RADIUS + gap, 0, 0, RADIUS, DENSITY, false});
    if (wall)
        w.wall[0] = (tr_wall){.nx = 1}, w.n_walls = 1;
    else
        tr_world_set_disk(&w, 1, &(tr_disk_start){-R2, 0, 0, R2, DENSITY, false});
    set_hertz(&w, "hertz-sphere", (test_laws){.damping_ratio = zeta}, 0);
    set_velocity(&w, 0, wall ? -v : -v * m / mass(RADIUS), 0, 0);
    if (!wall) set_velocity(&w, 1, v * m / mass(R2), 0, 0);
    impact r = {0};
    double before = -gap, last = -gap, out = 0;
    for (int k = 0; k < 2 * steps_per_contact; k++) {
        steps(&w, 1);
        double now = wall ? RADIUS - w.disks.pos[0] : RADIUS + R2 - w.disks.pos[0] + w.disks.pos[4];
        out = w.disks.vel[0] - (wall ? 0 : w.disks.vel[4]);
        if (last > before && last >= now && r.deepest == 0)
            r.deepest = last + (now - before) * (now - before) / (8 * (2 * last - before - now));
        before = last, last = now;
    }
    r.e = out / v;
    /* it flies at `out` now: overlap 0 was last/out after; the start was gap/v after time 0 */
    r.duration = (2 * steps_per_contact * w.dt + last / out - gap / v) / time;
    r.deepest /= depth;
    tr_world_free(&w);
    return r;
}

static void test_impact(void **state) {
    (void)state;
    static const double ratios[] = {1, 3, 0};
    for (int i = 0; i < 3; i++) {
        double h[4], error[3][4] = {{0}}, order[3];
        for (int k = 0; k < 4; k++) {
            h[k] = 0.02 / (1 << k);
            for (int p = 0; p < 8; p++) {
                /* overlap 4e-5 of the radius: the force has 1e-11 of its digits left */
                impact r = strike(ratios[i], 0, 0.01, 50 << k, p / 8.0);
                error[0][k] = fmax(error[0][k], fabs(r.e - 1));
                error[1][k] = fmax(error[1][k], fabs(r.duration - 1));
                error[2][k] = fmax(error[2][k], fabs(r.deepest - 1));
            }
        }
        for (int q = 0; q < 3; q++) order[q] = observed_order(4, h, error[q]);
        print_message("radius ratio %g: errors at 1/50 of the contact time: e %.1e, duration %.1e, depth %.1e; orders "
                      "%.2f, %.2f, %.2f\n",
                      ratios[i], error[0][0], error[1][0], error[2][0], order[0], order[1], order[2]);
        for (int q = 0; q < 3; q++) {
            assert_true(order[q] > 1.8); /* leapfrog: 2; what the kinks at the ends do to e is of higher order */
            assert_close(error[q][0], 0, 0, 2 * h[0] * h[0]);
        }
        assert_true(order[1] < 2.3 && order[2] < 2.3);
    }
}

static void test_restitution(void **state) {
    (void)state;
    static const double zeta[] = {0.1, 0.3, 0.7};
    for (int z = 0; z < 3; z++) {
        double q = asin(sqrt(1.2) * zeta[z]), e = exp(-(M_PI - 2 * q) * tan(q)), first = 0;
        double h[3], error[3] = {0};
        for (int k = 0; k < 3; k++) {
            h[k] = 0.005 / (1 << k);
            for (int p = 0; p < 4; p++)
                error[k] = fmax(error[k], fabs(strike(1, zeta[z], 0.01, 200 << k, p / 4.0).e - e));
        }
        double order = observed_order(3, h, error);
        print_message("damping ratio %.1f: e = %.4f, its error at 1/200 of the contact time %.1e, order %.2f\n",
                      zeta[z], e, error[0], order);
        assert_close(error[0], 0, 0,
                     2 * M_PI * zeta[z] * e * h[0]); /* the velocity of the dashpot is half a step old */
        assert_true(order > 0.8);
        /* four decades of speed, overlaps of 1e-6 to 2e-3 of the radius: the same steps of the same shape, but for the
         * digits of the smallest overlap */
        for (double v = 1e-4; v < 2; v *= 10) {
            double now = strike(1, zeta[z], v, 200, 0.3).e;
            if (first == 0) first = now;
            assert_close(now, first, 1e-7, 0);
        }
    }
}

/* ---- a sphere on a floor */

/* At the overlap that carries the weight. */
static void put_on_floor(tr_world *w, test_laws laws) {
    new_world_of(w, 1, TR_SHAPE_SPHERE);
    w->wall[0] = (tr_wall){.ny = 1}, w->n_walls = 1;
    double delta = pow(mass(RADIUS) * G / strength(RADIUS), 2.0 / 3);
    tr_world_set_disk(w, 0, &(tr_disk_start){0, RADIUS - delta, 0, RADIUS, DENSITY, false});
    set_gravity(w, 0, -G);
    set_hertz(w, "hertz-sphere", laws, 0);
}

/* The tangential spring is not rigid: Vs swings with w_t = sqrt(7 k_t/(2m)), and a velocity may be off by mu g/w_t;
 * stiffness times 4 is a step of half the length, and the rigid sphere is the limit. */
static void test_slip_to_roll(void **state) {
    (void)state;
    double v0 = 0.3, mu = 0.2, h[3], error[3];
    for (int i = 0; i < 3; i++) {
        tr_world w;
        double k_t = 4e4 * pow(4, i), m = mass(RADIUS), lost = 0, v = 0;
        put_on_floor(&w, (test_laws){.damping_ratio = 0.3, .mu = mu, .k_t = k_t});
        h[i] = w.dt = 0.1 / sqrt(3.5 * k_t / m);
        set_velocity(&w, 0, v0, 0, 0);
        const double *u = w.disks.vel;
        while (u[0] + RADIUS * u[2] > 0) steps(&w, 1);
        error[i] = (double)w.steps * w.dt - 2 * v0 / (7 * mu * G);
        int swings = (int)ceil(20 * 2 * M_PI / 0.1);
        for (int k = 0; k < swings; k++) {
            steps(&w, 1), v += u[0] / swings;
            lost += (1 - (u[0] * u[0] + 0.4 * RADIUS * RADIUS * u[2] * u[2]) / (v0 * v0)) / swings;
        }
        assert_close(error[i], 0, 0, 2 * h[i]);
        assert_close(v, 5 * v0 / 7, 0, 2 * mu * G * h[i]);
        assert_close(lost, 2.0 / 7, 0, 4 * mu * G * h[i] / v0);
        tr_world_free(&w);
    }
    double order = observed_order(3, h, error);
    print_message("slip to roll: time %.1e of %.3g s, order %.2f\n", error[0], 2 * v0 / (7 * mu * G), order);
    assert_true(order > 0.8); /* the moment is found to one step */
}

/* What laws are told of two bodies: one whose motion is given is infinitely heavy. */
static void test_inertia(void **state) {
    (void)state;
    tr_world w;
    new_world_of(&w, 2, TR_SHAPE_SPHERE);
    tr_world_set_disk(&w, 0, &(tr_disk_start){0, 0, 0, RADIUS, DENSITY, true});
    tr_world_set_disk(&w, 1, &(tr_disk_start){1, 0, 0, 3 * RADIUS, DENSITY, false});
    double m2 = mass(3 * RADIUS);
    tr_pair_bodies two = tr_world_pair(&w, &w.group[0], 0, 1), one = tr_world_pair(&w, &w.group[1], 0, 1);
    assert_true(two.R1 == RADIUS && isinf(two.m1) && isinf(two.I1));
    assert_close(two.m2, m2, 1e-15, 0);
    assert_close(two.I2, 3.6 * m2 * RADIUS * RADIUS, 1e-15, 0);
    assert_true(one.R1 == 0 && isinf(one.m1) && isinf(one.I1) && one.R2 == two.R2 && one.I2 == two.I2);
    tr_world_free(&w);
}

/* ---- a cluster */

/* Spheres that fly together and turn; some collide obliquely. */
static void new_cluster(tr_world *w, test_laws laws, double safety) {
    enum { N = 16 };
    tr_random r = tr_random_seed(8, 1);
    new_world_of(w, N, TR_SHAPE_SPHERE);
    for (int i = 0; i < N; i++) {
        double x = 0.02 * (i % 4 - 1.5) + 0.001 * tr_random_uniform(&r), y = 0.02 * (i / 4 - 1.5);
        tr_world_set_disk(w, i, &(tr_disk_start){x, y, 0, 0.006 + 0.004 * tr_random_uniform(&r), DENSITY, false});
        set_velocity(w, i, -10 * x - 5 * y, -10 * y + 5 * x, 40 * (tr_random_uniform(&r) - 0.3));
    }
    set_hertz(w, "hertz-sphere", laws, TR_SINK_LEDGER);
    w->dt = safety * tr_timestep_worst(w);
}

typedef struct sums {
    double px, py, L, p_scale, L_scale, energy;
} sums;

/* Momenta of the velocities as they are (between steps); kinetic energy at the time of the positions. */
static sums sums_of(const tr_world *w) {
    sums s = {0};
    for (int i = 0; i < w->disks.n; i++) {
        const double *x = w->disks.pos + 4 * i, *v = w->disks.vel + 4 * i, *f = w->disks.force + 4 * i;
        double m = mass(x[3]), I = 0.4 * m * x[3] * x[3], orbit = m * (x[0] * v[1] - x[1] * v[0]);
        s.px += m * v[0], s.py += m * v[1], s.L += I * v[2] + orbit;
        s.p_scale += m * hypot(v[0], v[1]), s.L_scale += fabs(I * v[2]) + m * hypot(v[0], v[1]) * hypot(x[0], x[1]);
        s.energy += 0.5 * v[0] * (m * v[0] + w->dt * f[0]) + 0.5 * v[1] * (m * v[1] + w->dt * f[1]) +
                    0.5 * v[2] * (I * v[2] + w->dt * f[2]);
    }
    return s;
}

static double collide(test_laws laws, double safety) {
    tr_world w;
    new_cluster(&w, laws, safety);
    forces(&w), tr_ledger_begin(&w);
    sums s0 = sums_of(&w), s = s0;
    double start = w.ledger->start, residual = 0;
    int n = (int)(0.06 / w.dt);
    for (int k = 1; k <= n; k++) {
        tr_step_advance(&w);
        forces(&w), tr_ledger_walls(&w);
        residual = fmax(residual, fabs(tr_ledger_read(&w).residual) / start);
        if (k % 500) continue;
        s = sums_of(&w);
        double eps =
            1.1e-16 * 8 * k; /* each step rounds every velocity and position once, every force some six times */
        assert_close(s.px, s0.px, 0, eps * s0.p_scale);
        assert_close(s.py, s0.py, 0, eps * s0.p_scale);
        assert_close(s.L, s0.L, 0, eps * (s0.L_scale + s.L_scale));
    }
    s = sums_of(&w);
    tr_energy e = tr_ledger_read(&w);
    assert_close(e.kinetic, s.energy, 1e-13, 0); /* I of the sphere, here by itself */
    assert_true(w.contact_updates > n / 5 && (laws.mu > 0 ? e.friction > 0.02 * start : e.friction == 0));
    assert_true(laws.damping_ratio > 0 ? e.damped > 0.02 * start : fabs(e.damped) < 1e-12 * start);
    tr_world_free(&w);
    return residual;
}

static void test_cluster(void **state) {
    (void)state;
    static const test_laws laws[] = {
        {.k_t = 2e4}, {.k_t = 2e4, .mu = 0.4}, {.k_t = 2e4, .mu = 0.4, .damping_ratio = 0.3}};
    for (int l = 0; l < 3; l++) {
        double h[4], residual[4];
        for (int i = 0; i < 4; i++) h[i] = 0.4 / (1 << i), residual[i] = collide(laws[l], h[i]);
        double order = observed_order(4, h, residual);
        print_message("cluster, mu %.1f, damping ratio %.1f: residual over energy %.1e, %.1e, %.1e, %.1e, order %.2f\n",
                      laws[l].mu, laws[l].damping_ratio, residual[0], residual[1], residual[2], residual[3], order);
        /* Springs alone: leapfrog swings by (w dt)^2/16 of the energy in a spring, order 2; w dt = 0.3 at 0.4, a fifth
         * of the energy in springs. Friction takes as much, and the books are out by the first or last of the 20 steps
         * of a contact: 0.01, first order. */
        bool slides = laws[l].mu > 0;
        for (int i = 0; i < 4; i++) assert_close(residual[i], 0, 0, slides ? 0.025 * h[i] : 0.01 * h[i] * h[i]);
        assert_true(order > (slides ? 0.8 : 1.8));
    }
}

/* ---- oscillation about an overlap, and the bound on the step */

/* A body pressed to the overlap `delta`: between two that are held (spheres, disks), or by gravity on a floor. The
 * stiffness that it swings with is `sides` times dP/ddelta, here by the closed forms; the line is given by its P. */
typedef struct rest {
    bool sphere, floor;
    double delta, frequency;
} rest;

static void press(tr_world *w, rest *r, double zeta) {
    double m = r->sphere ? mass(RADIUS) : M_PI * RADIUS * RADIUS * DENSITY, R = r->floor ? RADIUS : RADIUS / 2, P, k;
    if (r->sphere) {
        r->delta = 1e-3 * RADIUS;
        P = strength(R) * pow(r->delta, 1.5), k = 1.5 * P / r->delta;
    } else {
        P = 2e-3 * E_STAR * RADIUS;
        double a = sqrt(4 * P * R / (M_PI * E_STAR)), d = 2 * RADIUS / exp(1), Lambda = log(2 * d / a);
        r->delta = 2 * P / (M_PI * E_STAR) * (Lambda + 0.5), k = M_PI * E_STAR / (2 * Lambda);
    }
    r->frequency = sqrt((r->floor ? 1 : 2) * k / m);
    new_world_of(w, r->floor ? 1 : 3, r->sphere ? TR_SHAPE_SPHERE : TR_SHAPE_DISK);
    w->allow_unstable = true;
    tr_world_set_disk(w, 0, &(tr_disk_start){0, RADIUS - r->delta, 0, RADIUS, DENSITY, false});
    if (r->floor) {
        w->wall[0] = (tr_wall){.ny = 1}, w->n_walls = 1;
        set_gravity(w, 0, -P / m);
    } else {
        tr_world_set_disk(w, 1, &(tr_disk_start){0, -RADIUS, 0, RADIUS, DENSITY, true});
        tr_world_set_disk(w, 2, &(tr_disk_start){0, 3 * (RADIUS - r->delta) + r->delta, 0, RADIUS, DENSITY, true});
    }
    set_hertz(w, r->sphere ? "hertz-sphere" : "hertz-line", (test_laws){.damping_ratio = zeta}, 0);
}

/* How far a swing of 1e-6 of the overlap gets in 300 steps of share*bound, in its own units; 1e4 is enough. */
static double growth(rest r, double zeta, double share) {
    tr_world w;
    press(&w, &r, zeta);
    /* Two contacts with what is held: k and c = 2 zeta sqrt(k m) both double, and c/(2 sqrt(k m)) has the root of
     * it. */
    double ratio = (r.floor ? 1 : sqrt(2)) * zeta, bound = 2 / r.frequency * (sqrt(1 + ratio * ratio) - ratio), y0;
    forces(&w);
    assert_close(tr_timestep_contacts(&w).dt, bound, 1e-9, 0); /* digits of the overlap */
    w.dt = share * bound, y0 = w.disks.pos[1];
    w.disks.pos[1] += 1e-6 * r.delta;
    double largest = 0;
    for (int k = 0; k < 300 && largest < 1e4; k++) {
        steps(&w, 1);
        largest = fmax(largest, fabs(w.disks.pos[1] - y0) / (1e-6 * r.delta));
    }
    tr_world_free(&w);
    return largest;
}

static void test_bound_on_the_step(void **state) {
    (void)state;
    for (int i = 0; i < 4; i++) {
        rest r = {.sphere = i & 1, .floor = i & 2};
        for (int z = 0; z < 2; z++) {
            double zeta = 0.3 * z, below = growth(r, zeta, 0.99), above = growth(r, zeta, 1.01);
            print_message("%s %s, damping ratio %.1f: a swing grows to %.2g below the bound, to %.2g above\n",
                          r.sphere ? "sphere" : "disk", r.floor ? "on a floor" : "between two", zeta, below, above);
            assert_true(below < 10);  /* undamped at 0.99: at most 1/sqrt(1 - 0.99^2) = 7 */
            assert_true(above > 1e4); /* 1.3^300 */
        }
    }
}

static void test_frequency(void **state) {
    (void)state;
    for (int i = 0; i < 4; i++) {
        rest r = {.sphere = i & 1, .floor = i & 2};
        tr_world w;
        press(&w, &r, 0);
        w.dt = 0.01 / r.frequency;
        double y0 = w.disks.pos[1], last = 0, begin = 0, end = 0;
        int crossings = 0;
        w.disks.pos[1] += 1e-4 * r.delta;
        for (int k = 0; k < 8000; k++) {
            last = w.disks.pos[1] - y0;
            steps(&w, 1);
            double now = w.disks.pos[1] - y0;
            if (!(last < 0 && now >= 0)) continue;
            double t = ((double)w.steps - now / (now - last)) * w.dt;
            if (crossings++ == 0) begin = t;
            end = t;
        }
        assert_true(crossings > 10);
        /* leapfrog (w dt)^2/24 = 4e-6, the amplitude less */
        assert_close(2 * M_PI * (crossings - 1) / (end - begin), r.frequency, 1e-5, 0);
        tr_world_free(&w);
    }
}

/* Before contacts are known: an overlap of TR_EXPECTED_OVERLAP of the radius; and what is deeper is refused at its
 * own. */
static void test_expected_overlap(void **state) {
    (void)state;
    tr_world w;
    put_on_floor(&w, (test_laws){0});
    double delta = TR_EXPECTED_OVERLAP * RADIUS,
           bound = 2 * sqrt(mass(RADIUS) / (1.5 * strength(RADIUS) * sqrt(delta)));
    assert_close(tr_timestep_worst(&w), bound, 1e-12, 0);
    w.dt = 0.9 * bound;
    forces(&w);
    w.disks.pos[1] = RADIUS - 4 * delta; /* stiffer by 2 */
    w.stale = true;
    tr_status st = {0};
    assert_false(tr_step_forces(&w, &st));
    assert_int_equal(st.code, TR_NUMERICAL);
    tr_world_free(&w);
}

/* What a biaxial test calls its stiffness: dP/ddelta of two mean spheres under the force 2 R pressure. */
static void test_stiffness_of_a_sample(void **state) {
    (void)state;
    tr_scene scene = biaxial_scene(50, 1, sand);
    scene.shape = TR_SHAPE_SPHERE, scene.contact = hertz("hertz-sphere", sand);
    scene.compaction.pressure = scene.shear.lateral_pressure = 100;
    tr_biaxial b;
    tr_status st = {0};
    if (!tr_biaxial_init(&b, &scene, &st)) fail_msg("%s", st.text);
    double R = 0, m = 0;
    for (int i = 0; i < 50; i++) R += b.world.disks.pos[4 * i + 3] / 50;
    for (int i = 0; i < 50; i++) m += mass(b.world.disks.pos[4 * i + 3]) * 2.7 / 50;
    double P = 2 * R * 300, k = 1.5 * cbrt(P) * pow(strength(R / 2), 2.0 / 3); /* P = K x^3, x = sqrt(delta) */
    assert_close(tr_biaxial_stiffness(&b, 300), k, 1e-13, 0);
    assert_close(b.mean_mass, m, 1e-13, 0);
    tr_biaxial_free(&b);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_impact),
        cmocka_unit_test(test_restitution),
        cmocka_unit_test(test_slip_to_roll),
        cmocka_unit_test(test_inertia),
        cmocka_unit_test(test_cluster),
        cmocka_unit_test(test_bound_on_the_step),
        cmocka_unit_test(test_frequency),
        cmocka_unit_test(test_expected_overlap),
        cmocka_unit_test(test_stiffness_of_a_sample),
    };
    return cmocka_run_group_tests_name("spheres", tests, NULL, NULL);
}
