/* SPDX-License-Identifier: MIT */
/* Sliding and rolling velocities of pure motions, of every definition, on pairs and floors. References: the definitions
 * of the pure motions [Wang2015 eqs. 1-6], algebra by hand, and rigid disks advanced by a small finite motion whose
 * material points are followed. All to 1e-12 of the velocity scale: some ten roundings of 1e-16, and a cancellation of
 * up to 100 by the observer's own motion. */
#include "core/convergence.h"
#include "laws/measures.h"

static const double TIGHT = 1e-12;

typedef struct expected {
    double v_s, wang, bagi_kuhn, alonso_min, alonso_mean;
} expected;

static void check(measured m, expected e, double scale) {
    assert_close(m.v_s, e.v_s, 0, TIGHT * scale);
    assert_close(m.wang, e.wang, 0, TIGHT * scale);
    assert_close(m.bagi_kuhn, e.bagi_kuhn, 0, TIGHT * scale);
    assert_close(m.alonso_min, e.alonso_min, 0, TIGHT * scale);
    assert_close(m.alonso_mean, e.alonso_mean, 0, TIGHT * scale);
    /* Sliding by author: Wang's is what the kinematics say; Iwashita and Oda have half of Alonso's, which is Wang's but
     * for the overlap, (R1+R2)/|X21|; at a wall, where r1 = R1 = 0, the overlap does not count. */
    double stretch = m.r1 > 0 ? (m.r1 + m.r2 + m.delta) / (m.r1 + m.r2) : 1;
    assert_close(m.slide_wang, e.v_s, 0, TIGHT * scale);
    assert_close(m.slide_alonso, e.v_s * stretch, 0, TIGHT * scale);
    assert_close(m.slide_iwashita_oda, e.v_s * stretch / 2, 0, TIGHT * scale);
}

/* A pair whose branch vector has length L and angle a and whose centres rest; spins w1, w2 as in Wang's figures. Then
 * an observer: everything moves with (ux, uy) and turns with W about the origin, which no measure may see. */
static motion seen(double R1, double R2, double L, double a, double w1, double w2, double ux, double uy, double W) {
    motion p = {.R1 = R1, .R2 = R2, .x1 = 0.7, .y1 = -0.4, .w1 = w1 + W, .w2 = w2 + W};
    p.x2 = p.x1 + L * cos(a), p.y2 = p.y1 + L * sin(a);
    p.vx1 = ux - W * p.y1, p.vy1 = uy + W * p.x1, p.vx2 = ux - W * p.y2, p.vy2 = uy + W * p.x2;
    return p;
}

static const double ratios[][2] = {{1, 1}, {2, 1}, {1, 2}, {10, 1}, {1, 10}};
static const double overlaps[] = {0, 0.01, 0.2};          /* of the smaller radius */
static const double angles[] = {0, 0.3, 1.9, -2.4, M_PI}; /* of the branch vector */
static const double observers[][3] = {{0, 0, 0}, {3, -2, 0}, {0, 0, 1.7}, {-1, 4, -0.9}};

typedef void each_run(double R1, double R2, double L, double a, const double *u);

static void for_each_pair(each_run *run) {
    for (int r = 0; r < 5; r++)
        for (int o = 0; o < 3; o++)
            for (int a = 0; a < 5; a++)
                for (int u = 0; u < 4; u++) {
                    double R1 = ratios[r][0], R2 = ratios[r][1];
                    run(R1, R2, R1 + R2 - overlaps[o] * fmin(R1, R2), angles[a], observers[u]);
                }
}

static double scale_of(double R1, double R2, double w, const double *u) {
    return (R1 + R2 + 2) * (fabs(w) + fabs(u[2])) + fabs(u[0]) + fabs(u[1]);
}

static void rigid_rotation(double R1, double R2, double L, double a, const double *u) {
    check(measure(seen(R1, R2, L, a, 0, 0, u[0], u[1], u[2] + 0.37)), (expected){0, 0, 0, 0, 0},
          scale_of(R1, R2, 0.37, u));
}

/* Gears: R1 w1 = -R2 w2. The rims run at s = R1 w1 and every definition says so. With overlap the arms are shorter than
 * the radii in the same ratio, so nothing slides. */
static void pure_rolling(double R1, double R2, double L, double a, const double *u) {
    double s = 0.8;
    check(measure(seen(R1, R2, L, a, s / R1, -s / R2, u[0], u[1], u[2])), (expected){0, s, s, s, s},
          scale_of(R1, R2, s / fmin(R1, R2), u));
    check(measure(seen(R1, R2, L, a, -s / R1, s / R2, u[0], u[1], u[2])), (expected){0, -s, -s, -s, -s},
          scale_of(R1, R2, s / fmin(R1, R2), u));
}

/* Equal spins w: the material points at the contact pass at L w. By Wang's definition nothing rolls; the mean flow of
 * material through the contact is (R1 - R2) w/2. */
static void pure_sliding(double R1, double R2, double L, double a, const double *u) {
    double w = -0.6;
    check(measure(seen(R1, R2, L, a, w, w, u[0], u[1], u[2])), (expected){L * w, 0, 0.5 * (R1 - R2) * w, 0, 0},
          scale_of(R1, R2, w, u));
}

/* Equal rim speeds, s2 = -s1: what Iwashita and Oda call pure sliding. Wang sees R1R2/(R1+R2)(w1 - w2) of rolling. */
static void equal_arcs(double R1, double R2, double L, double a, const double *u) {
    double s = 0.8;
    check(measure(seen(R1, R2, L, a, s / R1, s / R2, u[0], u[1], u[2])),
          (expected){2 * s * L / (R1 + R2), (R2 - R1) * s / (R1 + R2), 0, 0, 0}, scale_of(R1, R2, s / fmin(R1, R2), u));
}

/* Both run the same way at different speeds: the two readings of Wang's model 2 part. */
static void unequal_rims(double R1, double R2, double L, double a, const double *u) {
    double s1 = 0.9, s2 = 0.4, wang = (R2 * s1 + R1 * s2) / (R1 + R2);
    double scale = scale_of(R1, R2, s1 / fmin(R1, R2), u);
    expected e = {(s1 - s2) * L / (R1 + R2), wang, 0.65, 0.4, 0.65};
    check(measure(seen(R1, R2, L, a, s1 / R1, -s2 / R2, u[0], u[1], u[2])), e, scale);
    wang = -(R2 * s2 + R1 * s1) / (R1 + R2);
    e = (expected){(s1 - s2) * L / (R1 + R2), wang, -0.65, -0.4, -0.65};
    check(measure(seen(R1, R2, L, a, -s2 / R1, s1 / R2, u[0], u[1], u[2])), e, scale);
}

static void test_rigid_rotation(void **state) {
    (void)state, for_each_pair(rigid_rotation);
}
static void test_pure_rolling(void **state) {
    (void)state, for_each_pair(pure_rolling);
}
static void test_pure_sliding(void **state) {
    (void)state, for_each_pair(pure_sliding);
}
static void test_equal_arcs(void **state) {
    (void)state, for_each_pair(equal_arcs);
}
static void test_unequal_rims(void **state) {
    (void)state, for_each_pair(unequal_rims);
}

/* PR + RBR [Wang2015 eq. 3]: disk 2 rolls over disk 1, which rests, with betadot = B: V_r = -R1 B, w2 = B (R1+R2)/R2.
 * PS + RBR [eq. 6]: disk 2 is carried round without turning: V_s = -L B, nothing rolls. Without rotating observer. */
static void test_motions_around_a_resting_disk(void **state) {
    (void)state;
    for (int r = 0; r < 5; r++)
        for (int o = 0; o < 3; o++)
            for (int k = 0; k < 5; k++) {
                double R1 = ratios[r][0], R2 = ratios[r][1], L = R1 + R2 - overlaps[o] * fmin(R1, R2), B = 0.45;
                double c = cos(angles[k]), s = sin(angles[k]);
                motion p = {.R1 = R1, .R2 = R2, .x2 = L * c, .y2 = L * s, .vx2 = -B * L * s, .vy2 = B * L * c};
                check(measure(p), (expected){-L * B, 0, 0.5 * (R2 - R1) * B, 0, 0}, (R1 + R2) * B);
                p.w2 = B * (R1 + R2) / R2;
                check(measure(p), (expected){0, -R1 * B, -R1 * B, -R1 * B, -R1 * B}, (R1 + R2) * B);
            }
}

/* Rolling without sliding: all definitions v. Sliding without spin: bagi-kuhn half the speed, the others nothing.
 * Spinning in place: wang -R w, bagi-kuhn half of it. The floor has any direction and moves. */
static void test_floor(void **state) {
    (void)state;
    for (int k = 0; k < 5; k++)
        for (int o = 0; o < 3; o++)
            for (int u = 0; u < 2; u++) {
                double R = 1.3, d = R * (1 - overlaps[o]), nx = cos(angles[k]), ny = sin(angles[k]);
                double tx = ny, ty = -nx, wx = observers[u][0], wy = observers[u][1], v = 0.7, w = 0.5;
                double scale = 8;
                measured m = measure_wall(R, d, nx, ny, wx, wy, wx + v * tx, wy + v * ty, -v / R);
                check(m, (expected){0, v, v, v, v}, scale);
                m = measure_wall(R, d, nx, ny, wx, wy, wx + v * tx, wy + v * ty, 0);
                check(m, (expected){v, 0, v / 2, 0, 0}, scale);
                m = measure_wall(R, d, nx, ny, wx, wy, wx, wy, w);
                check(m, (expected){R * w, -R * w, -R * w / 2, 0, 0}, scale);
                assert_close(m.slide_full_radius, m.v_s, 0, TIGHT * scale); /* a wall has no radius */
                m = measure_wall(R, d, nx, ny, wx, wy, wx - 0.3 * nx, wy - 0.3 * ny, 0);
                check(m, (expected){0, 0, 0, 0, 0}, scale);
                assert_close(m.v_n, 0.3, 0, TIGHT * scale);
                assert_close(m.delta, R * overlaps[o], 0, TIGHT * R);
                assert_close(m.r1, 0, 0, 0);
                assert_close(m.r2, R, 0, 0);
            }
}

/* ---- any motion */

static double random_unit(unsigned *seed) {
    *seed = *seed * 1664525u + 1013904223u;
    return *seed / 4294967296.0 * 2 - 1;
}

static motion any_motion(unsigned *seed) {
    double R1 = pow(10, 0.5 * random_unit(seed)), R2 = pow(10, 0.5 * random_unit(seed)), a = M_PI * random_unit(seed);
    double L = R1 + R2 - 0.1 * (1 + random_unit(seed)) * fmin(R1, R2);
    motion p = {.R1 = R1, .R2 = R2, .x1 = random_unit(seed), .y1 = random_unit(seed)};
    p.x2 = p.x1 + L * cos(a), p.y2 = p.y1 + L * sin(a);
    p.vx1 = random_unit(seed), p.vy1 = random_unit(seed), p.w1 = random_unit(seed);
    p.vx2 = random_unit(seed), p.vy2 = random_unit(seed), p.w2 = random_unit(seed);
    return p;
}

static void test_identities(void **state) {
    (void)state;
    unsigned seed = 1;
    for (int k = 0; k < 1000; k++) {
        motion p = any_motion(&seed);
        measured m = measure(p);
        double L = hypot(p.x2 - p.x1, p.y2 - p.y1), scale = p.R1 + p.R2 + 3, R1 = p.R1, R2 = p.R2;
        double closing = ((p.vx1 - p.vx2) * (p.x2 - p.x1) + (p.vy1 - p.vy2) * (p.y2 - p.y1)) / L;
        assert_close(m.r1 + m.r2, L, 4e-16, 0);
        assert_close(m.r1 / m.r2, R1 / R2, TIGHT, 0);
        assert_close(m.delta, R1 + R2 - L, 0, TIGHT * scale);
        assert_close(m.nx * L, p.x2 - p.x1, 0, TIGHT * scale);
        assert_close(m.ny * L, p.y2 - p.y1, 0, TIGHT * scale);
        assert_close(m.v_n, closing, 0, TIGHT * scale);
        assert_close(m.wang, R1 * R2 / (R1 + R2) * (p.w1 - p.w2), 0, TIGHT * scale);
        assert_close(m.wang, (R2 * m.s1 + R1 * m.s2) / (R1 + R2), 0, TIGHT * scale);
        assert_close(m.wang, m.bagi_kuhn - (R1 - R2) / (2 * L) * m.v_s, 0, TIGHT * scale);
        assert_close(m.s1 - m.s2, m.v_s * (R1 + R2) / L, 0, TIGHT * scale);
        /* whole radii for arms: each is longer by its share of the overlap */
        double longer = (R1 + R2 - L) * (R1 * p.w1 + R2 * p.w2) / (R1 + R2);
        assert_close(m.slide_full_radius, m.v_s + longer, 0, TIGHT * scale);
    }
}

/* Naming the other body first: n and t turn round, so what slides along t stays and what rolls along t flips. */
static void test_swapping_the_bodies(void **state) {
    (void)state;
    unsigned seed = 2;
    for (int k = 0; k < 1000; k++) {
        motion p = any_motion(&seed);
        motion q = {p.R2, p.R1, p.x2, p.y2, p.vx2, p.vy2, p.w2, p.x1, p.y1, p.vx1, p.vy1, p.w1};
        measured m = measure(p), o = measure(q);
        double scale = p.R1 + p.R2 + 3;
        check(o, (expected){m.v_s, -m.wang, -m.bagi_kuhn, -m.alonso_min, -m.alonso_mean}, scale);
        assert_close(o.v_n, m.v_n, 0, TIGHT * scale);
        assert_close(o.r1, m.r2, 0, TIGHT * scale);
        assert_close(o.s1, -m.s2, 0, TIGHT * scale);
    }
}

/* ---- material points followed through a small finite motion */

static double angle_between(double ax, double ay, double bx, double by) {
    return atan2(ax * by - ay * bx, ax * bx + ay * by);
}

/* The state of the motion at time h, velocities kept. */
static motion at_time(motion p, double h) {
    p.x1 += h * p.vx1, p.y1 += h * p.vy1, p.x2 += h * p.vx2, p.y2 += h * p.vy2;
    return p;
}

static void turn(double angle, double *x, double *y) {
    double c = cos(angle), s = sin(angle), x0 = *x;
    *x = c * x0 - s * *y, *y = s * x0 + c * *y;
}

/* From -h/2 to h/2: arcs between the point of a rim that touched at the start and the one that touches at the end,
 * seen along t (rim 1: clockwise, rim 2: counter-clockwise); and how far the two material points that meet at the
 * contact point at time 0 move past each other along t. */
static void follow(motion p, double h, double *s1, double *s2, double *v_s) {
    motion b = at_time(p, -h / 2), e = at_time(p, h / 2);
    double nx0 = b.x2 - b.x1, ny0 = b.y2 - b.y1, nx1 = e.x2 - e.x1, ny1 = e.y2 - e.y1;
    double mx = nx0, my = ny0; /* mark on rim 1, turned with disk 1 */
    turn(p.w1 * h, &mx, &my);
    *s1 = -p.R1 * angle_between(mx, my, nx1, ny1) / h;
    mx = -nx0, my = -ny0;
    turn(p.w2 * h, &mx, &my);
    *s2 = p.R2 * angle_between(mx, my, -nx1, -ny1) / h;

    double L = hypot(p.x2 - p.x1, p.y2 - p.y1), nx = (p.x2 - p.x1) / L, ny = (p.y2 - p.y1) / L;
    double r1 = L * p.R1 / (p.R1 + p.R2), past = 0;
    for (int end = -1; end <= 1; end += 2) {
        double ax = r1 * nx, ay = r1 * ny, bx = -(L - r1) * nx, by = -(L - r1) * ny;
        motion q = at_time(p, end * h / 2);
        turn(end * p.w1 * h / 2, &ax, &ay), turn(end * p.w2 * h / 2, &bx, &by);
        past += end * ((q.x2 + bx - q.x1 - ax) * ny - (q.y2 + by - q.y1 - ay) * nx);
    }
    *v_s = past / h;
}

static void test_material_points(void **state) {
    (void)state;
    static const double h[] = {0.04, 0.02, 0.01};
    unsigned seed = 3;
    double worst = 9;
    for (int k = 0; k < 50; k++) {
        motion p = any_motion(&seed);
        measured m = measure(p);
        double error[3][3];
        for (int i = 0; i < 3; i++) {
            double s1, s2, v_s;
            follow(p, h[i], &s1, &s2, &v_s);
            error[0][i] = s1 - m.s1, error[1][i] = s2 - m.s2, error[2][i] = v_s - m.v_s;
            /* |third derivative| h^2/24 of an arc: spins up to 1, branch rate up to 2 sqrt(2)/L, L >= 0.6: below 100 */
            for (int j = 0; j < 3; j++) assert_close(error[j][i], 0, 0, 5 * h[i] * h[i] * (p.R1 + p.R2));
        }
        for (int j = 0; j < 3; j++)
            if (fabs(error[j][2]) > 1e-9) worst = fmin(worst, observed_order(3, h, error[j]));
    }
    print_message("material points: lowest observed order %.3f (centred differences: 2)\n", worst);
    assert_true(worst > 1.9);
}

/* ---- what the paper prints and does not mean */

static void test_errata_of_the_paper(void **state) {
    (void)state;
    /* Rigid rotation w about disk 1, branch along x: n = (1,0), the paper's t = n x k = (0,-1), V2 - V1 = (0, w L). */
    double R1 = 2, R2 = 0.75, w = 0.37, L = R1 + R2, Vt = -w * L;
    double eq16 = 0.5 * (R1 * w - R2 * w - (R2 - R1) / (R1 + R2) * -Vt);
    double eq16_other_t = 0.5 * (R1 * w - R2 * w - (R2 - R1) / (R1 + R2) * Vt);
    double eq23 = R1 * w - R1 / (R1 + R2) * Vt, eq24 = -R2 * w + R2 / (R1 + R2) * Vt;
    assert_close(eq16, 0.4625, TIGHT, 0); /* a rolling velocity of a rigid body */
    assert_close(eq16_other_t, 0, 0, TIGHT);
    assert_close(eq23, 2 * R1 * w, TIGHT, 0);
    assert_close(eq24, -2 * R2 * w, TIGHT, 0);
    measured m = measure((motion){.R1 = R1, .R2 = R2, .w1 = w, .w2 = w, .x2 = L, .vy2 = w * L});
    check(m, (expected){0, 0, 0, 0, 0}, w * L);
    assert_close(m.s1, 0, 0, TIGHT);
    assert_close(m.s2, 0, 0, TIGHT);
    /* Eq. 12 has full radii: with overlap a rigid rotation slides by overlap w. */
    double delta = 0.1;
    m = measure((motion){.R1 = R1, .R2 = R2, .w1 = w, .w2 = w, .x2 = L - delta, .vy2 = w * (L - delta)});
    assert_close(m.slide_full_radius, delta * w, TIGHT, 0);
    assert_close(m.v_s, 0, 0, TIGHT);
    /* Below eq. 16: a disk that slides on a floor has V_r = V_2/2 in size, not V_2. */
    m = measure_wall(R2, R2, 0, 1, 0, 0, 1, 0, 0);
    assert_close(fabs(m.bagi_kuhn), 0.5, TIGHT, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_rigid_rotation),
        cmocka_unit_test(test_pure_rolling),
        cmocka_unit_test(test_pure_sliding),
        cmocka_unit_test(test_equal_arcs),
        cmocka_unit_test(test_unequal_rims),
        cmocka_unit_test(test_motions_around_a_resting_disk),
        cmocka_unit_test(test_floor),
        cmocka_unit_test(test_identities),
        cmocka_unit_test(test_swapping_the_bodies),
        cmocka_unit_test(test_material_points),
        cmocka_unit_test(test_errata_of_the_paper),
    };
    return cmocka_run_group_tests_name("measures", tests, NULL, NULL);
}
