/* SPDX-License-Identifier: MIT */
/* hertz-line and hertz-sphere. References: the printed formulas solved here in long double; pressures under which the
 * surfaces of half-spaces and the inside of a disk move as the laws say, integrated here; P for its energy, its
 * differences for its stiffness. */
#include "assert_close.h"
#include "base/random.h"
#include "core/convergence.h"
#include "laws/law.h"
#include "scene/scene.h"
#include <string.h>

static const double E_STAR = 7e9, ZETA = 0.25;
static const double radii[][2] = {{0.01, 0.01}, {0.01, 0.001}, {0.001, 0.01}, {0, 0.02}}; /* R1 = 0: a wall */
enum { RADII = sizeof radii / sizeof *radii };

static double par[TR_LAW_PAR];

static void set(const tr_law *law, const char *key, double value) {
    for (int i = 0; i < law->table.n; i++)
        if (!strcmp(law->table.params[i].key, key)) {
            memcpy((char *)par + law->table.params[i].offset, &value, sizeof value);
            return;
        }
    fail_msg("no parameter %s", key);
}

static const tr_law *law_named(const char *name) {
    const tr_law *law = NULL;
    for (int i = 0; i < tr_laws_catalog()->n_normal; i++)
        if (!strcmp(tr_laws_normal[i]->table.name, name)) law = tr_laws_normal[i];
    assert_non_null(law);
    memset(par, 0, sizeof par);
    set(law, "E_star", E_STAR), set(law, "damping_ratio", ZETA);
    return law;
}

static double R_star(const double *R) {
    return R[0] > 0 ? 1 / (1 / R[0] + 1 / R[1]) : R[1];
}

/* Ten points of Gauss over [a, b]; the integrands are smooth over each panel. */
static long double gauss(long double (*f)(long double, const void *), const void *data, long double a, long double b) {
    static const long double x[] = {0.148874338981631210885L, 0.433395394129247190799L, 0.679409568299024406234L,
                                    0.865063366688984510732L, 0.973906528517171720078L},
                             w[] = {0.295524224714752870174L, 0.269266719309996355091L, 0.219086362515982043996L,
                                    0.149451349150580593146L, 0.066671344308688137594L};
    long double sum = 0, mid = (a + b) / 2, half = (b - a) / 2;
    for (int i = 0; i < 5; i++) sum += w[i] * (f(mid - half * x[i], data) + f(mid + half * x[i], data));
    return sum * half;
}

/* From 0 to b, where f or its slopes may be singular at 0: panels that halve. */
static long double gauss_from_0(long double (*f)(long double, const void *), const void *data, long double b) {
    long double sum = 0;
    for (int k = 0; k < 70; k++, b /= 2) sum += gauss(f, data, b / 2, b);
    return sum;
}

/* ---- the forces, by themselves */

typedef struct reference {
    double R, d; /* R_star [m]; d of the line contact [m], 0: spheres */
} reference;

static long double approach(long double P, const reference *r) { /* of lines */
    long double a = sqrtl(4 * P * (long double)r->R / ((long double)M_PIl * E_STAR));
    return 2 * P / ((long double)M_PIl * E_STAR) * (logl(2 * (long double)r->d / a) + 0.5L);
}

static double largest_P(const reference *r) { /* a = d */
    return M_PI * E_STAR * r->d * r->d / (4 * r->R);
}

static long double force(long double delta, const void *reference_) {
    const reference *r = reference_;
    if (r->d == 0) return 4.0L / 3 * (long double)E_STAR * sqrtl((long double)r->R) * delta * sqrtl(delta);
    long double low = 1e-30L * largest_P(r), high = 1.000001L * largest_P(r);
    for (int i = 0; i < 90; i++) { /* geometric: all digits at small P too */
        long double P = sqrtl(low * high);
        *(approach(P, r) < delta ? &low : &high) = P;
    }
    return low;
}

/* ---- both laws */

typedef void with_reference(const tr_law *law, const double *R, const reference *r, double largest);

/* Each law with each pair of radii, the line at its default depth and at a given one. largest: of the overlap. */
static void for_both(with_reference *check) {
    for (int k = 0; k < RADII; k++) {
        const double *R = radii[k];
        reference sphere = {R_star(R), 0};
        check(law_named("hertz-sphere"), R, &sphere, 0.3 * R[1]);
        static const double depths[] = {0, 0.05};
        for (int i = 0; i < 2; i++) {
            const tr_law *law = law_named("hertz-line");
            set(law, "depth", depths[i]);
            /* from 2 P (ln(2d/a) + 1/2) = P (ln(4 R1/a) + ln(4 R2/a) - 1) */
            double by_default = 2 * exp(-1) * (R[0] > 0 ? sqrt(R[0] * R[1]) : R[1]);
            reference line = {R_star(R), depths[i] > 0 ? depths[i] : by_default};
            check(law, R, &line, (double)approach((long double)largest_P(&line), &line));
        }
    }
}

static double worst;

static void check_force(const tr_law *law, const double *R, const reference *r, double largest) {
    for (double u = 1e-14; u < 1; u *= 1.37) {
        double delta = u * largest, want = (double)force(delta, r), got = law->elastic(par, R[0], R[1], delta).force;
        worst = fmax(worst, fabs(got / want - 1));
        assert_close(got, want, 2e-15, 0); /* w and its logarithm rounded: some units in the last place */
        assert_close(law->overlap(par, R[0], R[1], got), delta, 4e-15, 0);
        if (r->d > 0) assert_close(law->overlap(par, R[0], R[1], want), (double)approach(want, r), 4e-15, 0);
    }
    assert_true(law->elastic(par, R[0], R[1], 0).force == 0 && law->overlap(par, R[0], R[1], 0) == 0);
}

static void test_force(void **state) {
    (void)state;
    worst = 0;
    for_both(check_force);
    print_message("force: %.1e from the printed formulas at most\n", worst);
}

static void check_stiffness(const tr_law *law, const double *R, const reference *r, double largest) {
    for (double u = 1e-12; u < 1; u *= 7.3) {
        double delta = u * largest / 1.3, P = (double)force(delta, r),
               k = law->elastic(par, R[0], R[1], delta).stiffness;
        double h[4], error[4], a = sqrt(4 * P * r->R / (M_PI * E_STAR));
        assert_close(k, r->d > 0 ? M_PI * E_STAR / (2 * log(2 * r->d / a)) : 1.5 * P / delta, 1e-14, 0);
        for (int i = 0; i < 4; i++) {
            h[i] = 0.2 / (1 << i);
            error[i] =
                (double)((force(delta * (1 + h[i]), r) - force(delta * (1 - h[i]), r)) / (2 * h[i] * delta)) / k - 1;
        }
        double order = observed_order(4, h, error);
        assert_true(order > 1.95 && order < 2.05);     /* central differences: 2 */
        assert_close(error[3], 0, 0, h[3] * h[3] / 6); /* delta^2 P'''/(6 P'), less than 1/6 for both laws */
        /* and their extrapolation, which leaves the fourth order */
        assert_close((4 * error[3] - error[2]) / 3, 0, 0, h[2] * h[2] * h[2] * h[2]);
        tr_pair_bodies bodies = {.R1 = R[0], .R2 = R[1], .m1 = R[0] > 0 ? 3 : INFINITY, .m2 = 5, .delta = delta};
        tr_stiffness bound = law->stiffness(par, &bodies);
        assert_true(bound.k == k);
        assert_close(bound.c, 2 * ZETA * sqrt(k * (R[0] > 0 ? 15.0 / 8 : 5)), 1e-15, 0);
    }
}

static void test_stiffness(void **state) {
    (void)state;
    for_both(check_stiffness);
}

static void check_energy(const tr_law *law, const double *R, const reference *r, double largest) {
    static const double parts[] = {1e-9, 0.02, 1};
    for (int i = 0; i < 3; i++) {
        double delta = parts[i] * largest, want = (double)gauss_from_0(force, r, delta);
        assert_close(law->elastic(par, R[0], R[1], delta).energy, want, 1e-14, 0);
    }
}

static void test_energy(void **state) {
    (void)state;
    for_both(check_energy);
}

/* The pass over a tile agrees with the curve, and the dashpot is 2 zeta sqrt(k m_eff) v_n while the sum does not
 * pull. */
static void check_step(const tr_law *law, const double *R, const reference *r, double largest) {
    static tr_tile tile;
    static double constants[TR_MAX_PAIR][TR_TILE];
    double *at[TR_MAX_PAIR], m_eff = R[0] > 0 ? 15.0 / 8 : 5;
    tr_lane energy, bound;
    tr_random random = tr_random_seed(4, 1);
    int pulled = 0, pushed = 0;
    for (int i = 0; i < TR_TILE; i++) {
        double c[TR_MAX_PAIR] = {0};
        law->pair(par, &(tr_pair_bodies){.R1 = R[0], .R2 = R[1], .m1 = R[0] > 0 ? 3 : INFINITY, .m2 = 5}, c);
        for (int k = 0; k < TR_MAX_PAIR; k++) constants[k][i] = c[k], at[k] = constants[k];
        tile.delta[i] = i % 4 ? 1.2 * largest * pow(10, -9 * tr_random_uniform(&random)) : -1e-3 * i * largest;
        double k = law->elastic(par, R[0], R[1], fmax(tile.delta[i], 0)).stiffness;
        double P = law->elastic(par, R[0], R[1], fmax(tile.delta[i], 0)).force;
        tile.v_n[i] = i % 4 ? 2 * (tr_random_uniform(&random) - 0.5) * P / (ZETA * sqrt(k * m_eff)) : 10;
    }
    tile.delta[1] = 1.2 * largest; /* past a = d */
    tile.n = TR_TILE - 1;          /* the last lane is not this group's */
    tile.f_n[TR_TILE - 1] = 17;
    tr_law_data data = {.par = par, .pair = at};
    law->step(&tile, &data);
    law->state(&tile, &data, energy, bound);
    for (int i = 0; i < tile.n; i++) {
        if (!(tile.delta[i] > 0)) {
            assert_true(tile.f_n[i] == 0 && tile.f_elastic[i] == 0 && energy[i] == 0);
            continue;
        }
        tr_elastic e = law->elastic(par, R[0], R[1], tile.delta[i]);
        double dashpot = 2 * ZETA * sqrt(e.stiffness * m_eff) * tile.v_n[i];
        assert_close(tile.f_elastic[i], e.force, 1e-15, 0);
        assert_close(energy[i], e.energy, 1e-14, 0);
        assert_close(tile.f_n[i], fmax(e.force + dashpot, 0), 0, 2e-15 * (e.force + fabs(dashpot)));
        pulled += e.force + dashpot<0, pushed += e.force + dashpot> 0;
    }
    assert_true(tile.f_n[TR_TILE - 1] == 17);
    assert_true(pulled > 5 && pushed > 20);
    (void)r;
}

static void test_step(void **state) {
    (void)state;
    for_both(check_step);
}

/* The stiffness from a force that is known is that of the curve, of every normal law; the line also past a = d. */
static void test_slope(void **state) {
    (void)state;
    for (int i = 0; i < tr_laws_catalog()->n_normal; i++) {
        const tr_law *law = tr_laws_normal[i];
        memset(par, 0, sizeof par);
        set(law, tr_law_value(law, par, "k_n") ? "k_n" : "E_star", E_STAR);
        for (double delta = 1e-15; delta < 0.02; delta *= 1.7) {
            tr_elastic e = law->elastic(par, 0.01, 0.03, delta);
            assert_close(law->slope(par, delta, e.force), e.stiffness, 1e-14, 0); /* rounding */
        }
    }
}

/* Past a = d the line goes on straight. */
static void test_past_the_depth(void **state) {
    (void)state;
    for (int k = 0; k < RADII; k++) {
        const double *R = radii[k];
        const tr_law *law = law_named("hertz-line");
        set(law, "depth", 0.03);
        reference r = {R_star(R), 0.03};
        double P = largest_P(&r), end = r.d * r.d / r.R * (M_LN2 + 0.5) / 2, slope = M_PI * E_STAR / (2 * M_LN2);
        double energy = (double)gauss_from_0(force, &r, end);
        for (int side = -1; side <= 1; side++) {
            /* one that is 1e-9 off moves the force by 1.7e-9 (its logarithmic slope), the stiffness by less */
            tr_elastic e = law->elastic(par, R[0], R[1], end * (1 + side * 1e-9));
            assert_close(e.force, P, 2e-9, 0);
            assert_close(e.stiffness, slope, 2e-9, 0);
            assert_close(e.energy, energy, 4e-9, 0);
        }
        for (double more = 1; more < 1e9; more *= 30) {
            tr_elastic e = law->elastic(par, R[0], R[1], end * (1 + more));
            double x = more * end;
            assert_close(e.force, P + slope * x, 1e-14, 0);
            assert_close(e.energy, energy + P * x + slope * x * x / 2, 1e-14, 0);
            assert_close(e.stiffness, slope, 1e-15, 0);
            assert_close(law->overlap(par, R[0], R[1], e.force), end * (1 + more), 1e-14, 0);
        }
    }
}

/* ---- from the pressure: the same numbers without the formulas */

/* p = sqrt(1 - X^2) on a strip, its potential -int p ln|x - s| ds at the middle, by S = s/a = sin(t). */
static long double potential(long double t, const void *none) {
    (void)none;
    return -2 * cosl(t) * cosl(t) * logl(sinl(t));
}

/* The curve of a line contact: a strip of half-width a under p0 sqrt(1 - X^2), P = pi a p0/2, sinks in its middle by
 * (2/(pi E_star)) int p ln(d/|s|) ds, and p0 = E_star a/(2 R) makes the gap vanish. */
static void test_line_from_pressure(void **state) {
    (void)state;
    const tr_law *law = law_named("hertz-line");
    double I = (double)gauss_from_0(potential, NULL, M_PIl / 2); /* of -ln|S|, int sqrt(1 - S^2) dS = pi/2 */
    for (int k = 0; k < RADII; k++)
        for (double a = 1e-7; a < 1e-3; a *= 10) {
            double d = 0.04, R = R_star(radii[k]), p0 = E_STAR * a / (2 * R), P = M_PI * a * p0 / 2;
            set(law, "depth", d);
            double delta = 2 / (M_PI * E_STAR) * p0 * a * (M_PI / 2 * log(d / a) + I);
            assert_close(law->elastic(par, radii[k][0], radii[k][1], delta).force, P, 1e-14, 0);
        }
}

/* Strain along the loaded radius of a disk between two plates, at z below the contact: stresses of two point forces on
 * a disk, the near one spread by Hertz [Johnson1985 eqs. 5.55-5.56]; times E/P. */
typedef struct disk_under_load {
    double R, a, nu;
} disk_under_load;

static long double strain(long double z, const void *disk) {
    const disk_under_load *d = disk;
    long double R = d->R, a = d->a, nu = d->nu, root = sqrtl(a * a + z * z);
    long double across = 1 / R - 2 / (a * a) * ((a * a + 2 * z * z) / root - 2 * z);
    long double along = 1 / R - 2 / (2 * R - z) - 2 / root;
    return -((1 - nu * nu) * along - nu * (1 + nu) * across) / M_PIl;
}

/* The default depth: the centres of two disks approach by what their loaded radii shorten. At a wall the disk alone,
 * and the wall is rigid. */
static void test_default_depth(void **state) {
    (void)state;
    static const double nu[] = {0, 0.3, 0.5};
    for (int k = 0; k < RADII; k++)
        for (int i = 0; i < 3; i++) {
            const tr_law *law = law_named("hertz-line");
            const double *R = radii[k];
            /* of one material; at the wall all of 1/E_star is the disk's */
            double a = 1e-4 * R[1], E = (R[0] > 0 ? 2 : 1) * (1 - nu[i] * nu[i]) * E_STAR, delta = 0;
            if (R[0] > 0) a = 1e-4 * fmin(R[0], R[1]);
            double P = a * a * M_PI * E_STAR / (4 * R_star(R));
            for (int b = 0; b < 2; b++)
                if (R[b] > 0) delta += (double)gauss_from_0(strain, &(disk_under_load){R[b], a, nu[i]}, R[b]) * P / E;
            /* The half-space of Hertz and the disk differ by (a/R)^2. */
            assert_close(law->overlap(par, R[0], R[1], P), delta, 1e-8, 0);
        }
}

/* Sinking at r under p = sqrt(1 - r^2), radius 1: int p/s over the circle, by chords through the point; with s = c
 * sin(t) along a chord of half-length c, p = c cos(t), sums over equal angles are exact. Times pi E_star. */
static double sinking(double r) {
    enum { N = 64 };
    double sum = 0;
    for (int i = 0; i < N; i++) {
        double phi = M_PI * i / N, c2 = 1 - r * r * sin(phi) * sin(phi), chord = 0;
        for (int j = 0; j < N; j++) {
            double t = M_PI * ((j + 0.5) / N - 0.5);
            chord += c2 * cos(t) * cos(t) * M_PI / N;
        }
        sum += chord * M_PI / N;
    }
    return sum;
}

/* Spheres: p0 sqrt(1 - r^2/a^2) with p0 such that the surfaces fit at half the radius, u(0) - u(a/2) = (a/2)^2/(2R);
 * and then they fit at the edge. */
static void test_sphere_from_pressure(void **state) {
    (void)state;
    const tr_law *law = law_named("hertz-sphere");
    double bend = sinking(0) - sinking(0.5);
    assert_close(sinking(0) - sinking(1), 4 * bend, 1e-13, 0);
    for (int k = 0; k < RADII; k++)
        for (double a = 1e-6; a < 1e-3; a *= 10) {
            double R = R_star(radii[k]), p0 = M_PI * E_STAR / (a * bend) * (a * a / (8 * R));
            double P = 2 * M_PI * a * a * p0 / 3; /* half an ellipsoid */
            double delta = p0 * a * sinking(0) / (M_PI * E_STAR);
            assert_close(delta, a * a / R, 1e-13, 0); /* contact radius sqrt(R delta) */
            assert_close(law->elastic(par, radii[k][0], radii[k][1], delta).force, P, 1e-13, 0);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_force),
        cmocka_unit_test(test_stiffness),
        cmocka_unit_test(test_energy),
        cmocka_unit_test(test_slope),
        cmocka_unit_test(test_step),
        cmocka_unit_test(test_past_the_depth),
        cmocka_unit_test(test_line_from_pressure),
        cmocka_unit_test(test_default_depth),
        cmocka_unit_test(test_sphere_from_pressure),
    };
    return cmocka_run_group_tests_name("hertz", tests, NULL, NULL);
}
