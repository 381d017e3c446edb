/* SPDX-License-Identifier: MIT */
/* cattaneo-mindlin against closed forms (the exact contact of cylinders, Mindlin's of spheres), against Masing's rule,
 * and, for the path in both directions, against a bed of many separate sliders. */
#include "base/random.h"
#include "bed_rig.h"

static const char *const normals[] = {"linear", "hertz-line", "hertz-sphere", "quadratic"};
enum { NORMALS = 4 };

static rig r, other;

static void set_up(const char *normal) {
    rig_init(&r, "cattaneo-mindlin", normal, 0.02, 0.01);
}

/* ---- virgin loading: forces from displacements that the theory of elasticity gives for them */

static const double shares[] = {1e-6, 0.01, 0.1, 0.3, 0.5, 0.8, 0.95, 0.999};

/* Cylinders: u = (2 mu P/(pi E*)) (q (Lambda + 1/2) + (1 - q) ln(1 - q)/2), delta = (2P/(pi E*)) (Lambda + 1/2). In one
 * step or in seven, to both sides. */
static void test_exact_line_contact(void **state) {
    (void)state;
    static const double lambdas[] = {0.8, 1.5, 2, 4, 6, 10};
    for (int wall = 0; wall < 2; wall++)
        for (int l = 0; l < 6; l++)
            for (int k = 0; k < 8; k++) {
                rig_init(&r, "cattaneo-mindlin", "hertz-line", wall ? 0 : 0.02, 0.01);
                double a = 2 * DEPTH * exp(-lambdas[l]), q = shares[k], sign = k % 2 ? -1 : 1;
                double P = M_PI * E_STAR * a * a / (4 * rig_R_star(&r));
                double delta = 2 * P / (M_PI * E_STAR) * (lambdas[l] + 0.5);
                double u = 2 * MU * P / (M_PI * E_STAR) * (q * (lambdas[l] + 0.5) + 0.5 * (1 - q) * log1p(-q));
                int n = l % 2 ? 7 : 1;
                rig_slide(&r, delta, 0);
                for (int i = 0; i < n; i++) rig_slide(&r, delta, sign * u / n);
                assert_close(r.tile.f_t[0], sign * q * MU * P, 1e-9, 1e-14 * MU * P); /* asked; and rounding of mu P */
            }
}

/* Equal spheres of shear modulus G: u = 3 (2 - nu) mu P/(8 G a) (1 - (1 - q)^(2/3)), E* = G/(1 - nu). */
static void test_mindlin(void **state) {
    (void)state;
    for (int k = 0; k < 8; k++) {
        rig_init(&r, "cattaneo-mindlin", "hertz-sphere", 0.01, 0.01);
        double a = 2e-4, G = E_STAR * (1 - NU), R = 0.005, q = shares[k];
        double P = 4 * E_STAR * a * a * a / (3 * R),
               u = 3 * (2 - NU) * MU * P / (8 * G * a) * (1 - cbrt((1 - q) * (1 - q)));
        rig_slide(&r, a * a / R, 0);
        assert_close(rig_slide(&r, a * a / R, u), q * MU * P, 1e-9, 0);
    }
}

/* ---- reversals at constant normal force: Masing's rule */

typedef struct turn {
    double u, Q;
} turn;

static double virgin(double delta, double u) {
    double left = fmax(0, delta - fabs(u) / (MU * rig_kappa(&r)));
    return copysign(MU * (curve(&r, delta).force - curve(&r, left).force), u);
}

/* Q at u after the turns so far. From a turn the branch is the virgin curve at twice the scale, up to the turn before
 * it; there the loop is closed, and both are forgotten. The first branch goes on to the mirror image of the first
 * turn. */
static double masing(const turn *turns, int *n, double delta, double u) {
    while (*n) {
        turn last = turns[*n - 1];
        double end = *n > 1 ? turns[*n - 2].u : -last.u;
        if ((u - last.u) / (end - last.u) < 1) return last.Q + 2 * virgin(delta, 0.5 * (u - last.u));
        *n -= *n > 1 ? 2 : 1;
    }
    return virgin(delta, u);
}

static void test_masing(void **state) {
    (void)state;
    /* Of full slip. Loops in loops, closed one by one and passed; full slip; again. */
    static const double path[] = {0.6, -0.4,  0.5, -0.35, 0.3, -0.2, 0.1, -0.05, 0.1, -0.2, 0.3, -0.35,
                                  0.5, -0.45, 0.7, -0.9,  1.3, 0.2,  0.8, -1.1,  0.4, -0.3, 0.9};
    enum { N = sizeof path / sizeof *path, PARTS = 7 };
    for (int k = 0; k < NORMALS; k++) {
        set_up(normals[k]);
        double full = MU * rig_kappa(&r) * DELTA, u = 0, P = curve(&r, DELTA).force;
        turn turns[N];
        int n = 0, points[N];
        rig_slide(&r, DELTA, 0);
        for (int leg = 0; leg < N; leg++) {
            double from = u, part = (path[leg] * full - from) / PARTS;
            for (int i = 1; i <= PARTS; i++) {
                u = fmax(-full, fmin(full, from + part * i));
                assert_close(rig_slide(&r, DELTA, part), masing(turns, &n, DELTA, u), 0, 1e-9 * MU * P); /* asked */
            }
            points[leg] = rig_points(&r);
            double Q = masing(turns, &n, DELTA, u);
            turns[n++] = (turn){u, Q};
        }
        /* Closed loops leave nothing behind. */
        for (int leg = 1; leg <= 5 && k; leg++) assert_int_equal(points[7 + leg], points[7 - leg]);
        assert_int_equal(rig_merged(&r), 0);
    }
}

/* ---- any path: many separate sliders */

enum { SLIDERS = 20000 };

/* Slider i stands for the overlaps from i h to (i + 1) h: its weight is the rise of P' over them, its place the mean of
 * s by that weight, so that every e(s) linear over the cell is integrated exactly; a kink in it costs O(h^2). */
typedef struct sliders {
    double s[SLIDERS], weight[SLIDERS], e[SLIDERS], first; /* first: strain of the spring P'(0) */
    double delta, P0, heat;                                /* heat: work of slip */
} sliders;

static sliders bed;

static void sliders_init(double deepest) {
    memset(&bed, 0, sizeof bed);
    double h = deepest / SLIDERS;
    tr_elastic a = curve(&r, 0);
    bed.P0 = a.stiffness;
    for (int i = 0; i < SLIDERS; i++) {
        tr_elastic b = curve(&r, (i + 1) * h);
        bed.weight[i] = b.stiffness - a.stiffness;
        double moment = (i + 1) * h * b.stiffness - i * h * a.stiffness - (b.force - a.force);
        bed.s[i] = bed.weight[i] > 0 ? moment / bed.weight[i] : (i + 0.5) * h;
        a = b;
    }
}

static void sliders_release(void) {
    memset(bed.e, 0, sizeof bed.e), bed.first = bed.delta = 0;
}

/* One slider moves by du; what the cap takes back is slip, against a force of weight times the cap of meanwhile. */
static double slid(double *e, double du, double s, double delta, double weight) {
    double kappa = rig_kappa(&r), now = *e + du, cap = MU * kappa * (delta - s),
           old = MU * kappa * fmax(0, bed.delta - s);
    double inside = fmax(-cap, fmin(cap, now));
    bed.heat += weight / kappa * 0.5 * (cap + old) * fabs(now - inside);
    *e = inside;
    return weight / kappa * inside;
}

/* Q after one small part of a straight path. A slider that joins moves from then on. */
static double sliders_move(double delta, double du) {
    double Q = slid(&bed.first, du, 0, delta, bed.P0);
    for (int i = 0; i < SLIDERS; i++) {
        if (bed.s[i] >= delta) {
            if (bed.s[i] >= bed.delta) break;
            slid(&bed.e[i], du, fmin(bed.s[i], bed.delta), bed.s[i], bed.weight[i]);
            continue;
        }
        double part = bed.s[i] > bed.delta ? (delta - bed.s[i]) / (delta - bed.delta) : 1;
        Q += slid(&bed.e[i], part * du, bed.s[i], delta, bed.weight[i]);
    }
    bed.delta = delta;
    return Q;
}

static double sliders_energy(void) {
    double sum = bed.P0 * bed.first * bed.first;
    for (int i = 0; i < SLIDERS; i++) sum += bed.weight[i] * bed.e[i] * bed.e[i];
    return sum / (2 * rig_kappa(&r));
}

/* Overlap and sliding, of DELTA and of full slip there. */
typedef struct point {
    double delta, u;
} point;

/* 1 load, then slide. 2 obliquely up, unload with the sliding held. 3 slide, load, slide back, load. 4 obliquely up and
 * down, either way, down to little and up again. */
static const point paths[][8] = {
    {{0.5, 0}, {0.5, 0.3}, {0.8, 0.3}, {0.8, 0.1}, {1, 0.1}, {1, 0.9}, {0.3, 0.9}, {1, 0.9}},
    {{0.4, 0.1}, {1, 0.5}, {0.6, 0.5}, {0.3, 0.5}, {0.7, 0.6}, {0.9, 0.3}, {0.5, 0.2}, {1, 0.2}},
    {{0.6, 0.2}, {0.9, 0.2}, {0.9, -0.1}, {1, -0.1}, {1, 0.2}, {0.7, -0.2}, {0.8, -0.21}, {0.8, 0.6}},
    {{1, 0.7}, {0.5, 0.8}, {0.6, 0.75}, {0.4, 0.3}, {0.02, 0.31}, {0.03, 0.32}, {0.9, -0.5}, {0.2, -0.4}},
};
enum { PATHS = sizeof paths / sizeof *paths };

static void test_any_path(void **state) {
    (void)state;
    enum { PARTS = 5 };
    for (int k = 0; k < NORMALS; k++) {
        set_up(normals[k]);
        sliders_init(DELTA);
        for (int p = 0; p < PATHS; p++) {
            set_up(normals[k]);
            sliders_release();
            double full = MU * rig_kappa(&r) * DELTA, P = curve(&r, DELTA).force;
            point at = {0, 0};
            for (int leg = 0; leg < 8; leg++) {
                point to = paths[p][leg];
                for (int i = 1; i <= PARTS; i++) {
                    double delta = DELTA * (at.delta + (to.delta - at.delta) * i / PARTS),
                           du = full * (to.u - at.u) / PARTS;
                    double Q = rig_slide(&r, delta, du);
                    /* asked 1e-5; a kink in one of N cells: 1/N^2 */
                    assert_close(Q, sliders_move(delta, du), 0, 1e-7 * MU * P);
                    assert_close(rig_energy(&r), sliders_energy(), 0, 1e-7 * MU * P * full);
                }
                at = to;
            }
            assert_int_equal(rig_merged(&r), 0);
        }
    }
}

/* A straight path is one step or many; loading in a constant ratio below mu kappa is without slip, Q = (u/delta)
 * P/kappa. */
static void test_straight_path(void **state) {
    (void)state;
    for (int k = 0; k < NORMALS; k++)
        for (int p = 0; p < PATHS; p++) {
            set_up(normals[k]);
            other = r;
            for (int i = 0; i < r.law->n_hist; i++) other.at[i] = other.hist[i];
            double kappa = rig_kappa(&r), full = MU * kappa * DELTA, P = curve(&r, DELTA).force;
            point at = {0, 0};
            for (int leg = 0; leg < 8; leg++) {
                point to = paths[p][leg];
                for (int i = 1; i <= 100; i++)
                    rig_slide(&r, DELTA * (at.delta + (to.delta - at.delta) * i / 100), full * (to.u - at.u) / 100);
                rig_slide(&other, DELTA * to.delta, full * (to.u - at.u));
                /* 800 steps may each lose 1e-12 mu P by what they drop; measured 1e-13 */
                assert_close(r.tile.f_t[0], other.tile.f_t[0], 0, 1e-11 * MU * P);
                assert_close(rig_energy(&r), rig_energy(&other), 0, 1e-11 * MU * P * full);
                if (leg == 0 && to.u < to.delta)
                    assert_close(r.tile.f_t[0], MU * to.u / to.delta * curve(&r, DELTA * to.delta).force, 1e-11, 0);
                at = to;
            }
        }
}

/* ---- energy */

/* What work leaves beyond the store is the heat of the separate sliders, leg by leg, and never negative. Work and heat
 * by the trapezoidal rule in parts of a leg: 1/PARTS^2 of it. */
static void test_dissipation(void **state) {
    (void)state;
    enum { PARTS = 40 };
    for (int k = 0; k < NORMALS; k++) {
        set_up(normals[k]);
        sliders_init(DELTA);
        for (int p = 0; p < PATHS; p++) {
            set_up(normals[k]);
            sliders_release();
            double full = MU * rig_kappa(&r) * DELTA, unit = curve(&r, DELTA).force * MU * full, store = 0, Q = 0;
            point at = {0, 0};
            for (int leg = 0; leg < 8; leg++) {
                point to = paths[p][leg];
                double work = bed.heat = 0, du = full * (to.u - at.u) / PARTS;
                for (int i = 1; i <= PARTS; i++) {
                    double before = Q;
                    Q = rig_slide(&r, DELTA * (at.delta + (to.delta - at.delta) * i / PARTS), du);
                    sliders_move(r.tile.delta[0], du);
                    work += 0.5 * (before + Q) * du;
                }
                double heat = work - (rig_energy(&r) - store);
                assert_close(heat, bed.heat, 0, 1e-4 * unit);
                assert_true(heat >= -1e-14 * unit);
                store = rig_energy(&r);
                at = to;
            }
        }
    }
}

/* A cycle of sliding at constant force leaves the store as it was; its heat is the area between Masing's two branches,
 * 8 int_0^u Q du - 4 u Q(u) of the virgin curve, for spheres Q = mu P (1 - (1 - x)^(3/2)), x = u/(mu kappa delta). */
static void test_cycle(void **state) {
    (void)state;
    enum { PARTS = 1000 };
    static const double amplitudes[] = {0.05, 0.3, 0.7, 1};
    for (int k = 0; k < 4; k++) {
        set_up("hertz-sphere");
        double x = amplitudes[k], full = MU * rig_kappa(&r) * DELTA, unit = MU * curve(&r, DELTA).force * full,
               heat = 0;
        rig_slide(&r, DELTA, 0), rig_slide(&r, DELTA, x * full);
        double store = rig_energy(&r);
        for (int i = 0; i < 2 * PARTS; i++) {
            double du = (i < PARTS ? -2 : 2) * x * full / PARTS, before = r.tile.f_t[0];
            heat += 0.5 * (before + rig_slide(&r, DELTA, du)) * du;
        }
        double want = 8 * (x - 0.4 * (1 - pow(1 - x, 2.5))) - 4 * x * (1 - pow(1 - x, 1.5));
        assert_close(rig_energy(&r), store, 0, 1e-11 * unit); /* 2000 steps of rounding */
        assert_close(heat, want * unit, 3e-5, 0);             /* trapezoidal rule, 1/PARTS^2 over the small heat */
    }
}

/* ---- more breakpoints than room: the overlap grows, and its ratio to sliding changes all the time */

static void test_overflow(void **state) {
    (void)state;
    enum { STEPS = 600 };
    for (int k = 1; k < NORMALS; k++)
        for (int noisy = 0; noisy < 2; noisy++) {
            set_up(normals[k]);
            sliders_init(DELTA);
            tr_random random = tr_random_seed(4, 1);
            double full = MU * rig_kappa(&r) * DELTA, P = curve(&r, DELTA).force;
            double worst = 0, store = 0, gain = 0, Q = 0, energy = 0;
            for (int i = 1; i <= STEPS; i++) {
                double x = (double)i / STEPS, phase = noisy ? 2 * tr_random_uniform(&random) - 1 : sin(40 * x);
                double delta = DELTA * (0.1 + 0.9 * x - 0.3 * fmax(0, x - 0.7)), du = 0.8 * phase * full / STEPS;
                double before = Q, energy_before = energy;
                Q = rig_slide(&r, delta, du), energy = rig_energy(&r);
                worst = fmax(worst, fabs(Q - sliders_move(delta, du)) / (MU * curve(&r, delta).force));
                store = fmax(store, fabs(energy - sliders_energy()) / (MU * P * full));
                gain = fmax(gain, (energy - energy_before - 0.5 * (before + Q) * du) / (MU * P * full));
            }
            print_message("%s, %s: of %d steps %d did not fit; off by %.1e mu P, store %.1e, gain in a step %.1e\n",
                          normals[k], noisy ? "noise" : "smooth", STEPS, rig_merged(&r), worst, store, gain);
            assert_true(rig_merged(&r) > STEPS / 2); /* the test tests something */
            /* what bed.h states for this path */
            assert_true(worst < 1e-2);
            assert_true(store < 2e-4 && gain < 1e-5);
        }
}

/* ---- limits */

static void test_limits(void **state) {
    (void)state;
    for (int k = 0; k < NORMALS; k++) {
        set_up(normals[k]);
        rig_slide(&r, DELTA, 1e-6);
        assert_true(r.tile.f_t[0] > 0 && rig_energy(&r) > 0);
        for (int opening = 0; opening < 2; opening++) { /* apart; or pulled to nothing by a dashpot */
            other = r;
            for (int i = 0; i < r.law->n_hist; i++) other.at[i] = other.hist[i];
            other.data.hist = other.at;
            if (opening)
                other.tile.f_n[0] = 0, other.law->step(&other.tile, &other.data);
            else
                rig_slide(&other, -DELTA, 1e-6);
            assert_true(other.tile.f_t[0] == 0 && rig_energy(&other) == 0);
            for (int i = 0; i < r.law->n_hist; i++) assert_true(other.hist[i][CONTACT] == 0);
        }
        /* P -> 0: nothing but finite numbers, inside the cap (rig_roll looks) */
        for (int exponent = -5; exponent > -320; exponent -= 5) rig_slide(&r, pow(10, exponent), 1e-7 * (exponent % 2));
        assert_true(fabs(r.tile.f_t[0]) < 1e-100);
        set_up(normals[k]);
        rig_set(r.law, r.par, "mu", 0);
        for (int i = 1; i < 5; i++) assert_true(rig_slide(&r, DELTA * i, 1e-6) == 0);
    }
}

/* Any steps, small and large: rig_roll looks at the cap and at dt = 0. */
static void test_any_input(void **state) {
    (void)state;
    tr_random random = tr_random_seed(7, 1);
    int partial = 0;
    for (int k = 0; k < NORMALS; k++) {
        set_up(normals[k]);
        for (int i = 0; i < 20000; i++) {
            double scale = pow(10, -12 * tr_random_uniform(&random)), x = tr_random_uniform(&random);
            double delta =
                x < 0.5 && i ? r.tile.delta[0] * (1 + scale * (tr_random_uniform(&random) - 0.5)) : DELTA * x;
            double u = x < 0.2 ? 0 : scale * 1e-5 * (tr_random_uniform(&random) - 0.5);
            double Q = rig_slide(&r, delta, u);
            assert_true(rig_energy(&r) >= 0);
            partial += Q != 0 && fabs(Q) < 0.999 * MU * r.tile.f_elastic[0];
        }
    }
    assert_true(partial > 10000);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_exact_line_contact),
        cmocka_unit_test(test_mindlin),
        cmocka_unit_test(test_masing),
        cmocka_unit_test(test_any_path),
        cmocka_unit_test(test_straight_path),
        cmocka_unit_test(test_overflow),
        cmocka_unit_test(test_dissipation),
        cmocka_unit_test(test_cycle),
        cmocka_unit_test(test_limits),
        cmocka_unit_test(test_any_input),
    };
    return cmocka_run_group_tests_name("cattaneo_mindlin", tests, NULL, NULL);
}
