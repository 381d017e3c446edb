/* SPDX-License-Identifier: MIT */
/* The start for the test of a new law: what law_template.c says of itself, number by number. test_claims.c shows its
 * claims, as those of all laws. */
#include "assert_close.h"
#include "base/random.h"
#include "laws/law.h"
#include <stdlib.h>
#include <string.h>

extern const tr_law tr_law_template;

enum { N = 8, ROOM = 16 };
static const double MU_R = 0.3, K_R = 2e6, R1 = 0.5, R2 = 0.2, M1 = 3, M2 = 1;

/* Some contacts of two disks, or of a disk and a wall; each has the same motion. */
typedef struct bench {
    tr_tile tile;
    const tr_law *law;
    double par[ROOM], R1[N], R2[N], g1[N], hist[N], pair[N];
    tr_pair_bodies bodies;
    double R_eff, I; /* by hand */
} bench;

static bench A, B; /* static: aligned */

static void set_up(bench *b, const tr_law *law, bool wall, double damping) {
    memset(b, 0, sizeof *b);
    b->law = law;
    *tr_law_value(law, b->par, "mu_r") = MU_R, *tr_law_value(law, b->par, "k_r") = K_R;
    if (law == &tr_law_template) *tr_law_value(law, b->par, "rolling_damping") = damping;
    double I1 = M1 * R1 * R1 / 2, I2 = M2 * R2 * R2 / 2;
    b->bodies = (tr_pair_bodies){.R1 = wall ? 0 : R1, .R2 = R2, .m1 = wall ? INFINITY : M1, .m2 = M2,
                                 .I1 = wall ? INFINITY : I1, .I2 = I2};
    b->R_eff = wall ? R2 : 1 / (1 / R1 + 1 / R2), b->I = wall ? I2 : 1 / (1 / I1 + 1 / I2);
    b->tile.n = N, b->tile.R1 = b->R1, b->tile.R2 = b->R2, b->tile.g1 = b->g1;
    for (int i = 0; i < N; i++) {
        b->R1[i] = b->bodies.R1, b->R2[i] = R2, b->g1[i] = wall ? 1 : R1 / (R1 + R2);
        if (law->pair) law->pair(b->par, &b->bodies, &b->pair[i]);
    }
}

static tr_law_data data_of(bench *b) {
    static double *hist[1], *pair[1];
    hist[0] = b->hist, pair[0] = b->pair;
    return (tr_law_data){.par = b->par, .hist = hist, .pair = pair};
}

/* One step at this normal force and rolling velocity; returns T = M2/R_eff of all contacts. */
static double run(bench *b, double f_n, double V_r, double dt) {
    b->tile.dt = dt;
    for (int i = 0; i < N; i++) b->tile.f_n[i] = f_n, b->tile.v_r[i] = V_r;
    tr_law_data d = data_of(b);
    b->law->step(&b->tile, &d);
    for (int i = 0; i < N; i++) {
        assert_true(b->tile.m1[i] == -b->tile.m2[i]);
        assert_true(b->tile.m2[i] == b->tile.m2[0]);
    }
    return b->tile.m2[0] / b->R_eff;
}

/* Roundings of a few products. */
static const double ROUND = 1e-14;

static void one_step_is_the_formula(void **state) {
    (void)state;
    const double f = 1e5, bound = MU_R * f, dt = 1e-4, zeta = 0.4;
    for (int wall = 0; wall < 2; wall++) {
        set_up(&A, &tr_law_template, wall, zeta);
        double c = 2 * zeta * sqrt(K_R * A.I) / A.R_eff;
        assert_close(run(&A, f, 2, dt), K_R * 2 * dt + c * 2, ROUND, 0);                     /* below the bound */
        assert_close(run(&A, f, -1, dt), K_R * 1 * dt - c * 1, ROUND, ROUND * K_R * 2 * dt); /* back */
        assert_close(run(&A, f, 1e5, dt), bound, ROUND, 0); /* both at the bound */
        assert_close(run(&A, f, -1, 0), bound - c, ROUND, 0); /* dt = 0: the spring stays, the dashpot has the present
                                                               * velocity */
        assert_close(run(&A, f / 2, 0, 0), bound / 2, ROUND, 0); /* a lower f_n cuts the spring */
        assert_close(run(&A, f, 0, 0), bound / 2, ROUND, 0);     /* for good */
        assert_true(run(&A, 0, 3, dt) == 0 && A.hist[0] == 0);   /* apart: nothing is left */
    }
}

static void without_dashpot_it_is_wang_spring_bit_for_bit(void **state) {
    (void)state;
    const tr_law *const *wang = tr_laws_rolling;
    tr_random r = tr_random_seed(4, 1);
    int n = tr_laws_catalog()->n_rolling;
    while (n && strcmp((*wang)->table.name, "wang-spring")) wang++, n--;
    assert_true(n > 0);
    set_up(&A, &tr_law_template, false, 0), set_up(&B, *wang, false, 0);
    for (int k = 0; k < 10000; k++) {
        double f = 1e5 * fmax(0, tr_random_uniform(&r) - 0.1), V = 300 * (tr_random_uniform(&r) - 0.5);
        assert_true(run(&A, f, V, 1e-4) == run(&B, f, V, 1e-4));
        assert_true(A.hist[0] == B.hist[0]);
    }
}

static void fast_rolling_is_at_the_bound_and_slow_rolling_is_the_spring(void **state) {
    (void)state;
    set_up(&A, &tr_law_template, false, 0.4);
    assert_close(run(&A, 1e5, 1e9, 1e-9), MU_R * 1e5, ROUND, 0);
    assert_close(run(&A, 1e5, -1e9, 1e-9), -MU_R * 1e5, ROUND, 0);
    set_up(&A, &tr_law_template, false, 0.4);
    assert_close(run(&A, 1e5, 1e-6, 1e3), K_R * 1e-3, 1e-5, 0); /* c V_r is 1e-6 of it, c of the size of K_R/1000 */
}

/* V_r' = -R_eff^2 T/I: from V0 at rest of the spring, V = V0 exp(-zeta w t) (cos(d t) - zeta w/d sin(d t)), w = R_eff
 * sqrt(k_r/I), d = w sqrt(1 - zeta^2). The step is explicit: its error is of first order, a few w dt. */
static void two_free_disks_swing_as_a_damped_oscillator(void **state) {
    (void)state;
    static const double zetas[] = {0.05, 0.3, 0.8};
    for (int k = 0; k < 3; k++) {
        double zeta = zetas[k], worst[2] = {0};
        for (int fine = 0; fine < 2; fine++) {
            set_up(&A, &tr_law_template, false, zeta);
            double w = A.R_eff * sqrt(K_R / A.I), d = w * sqrt(1 - zeta * zeta), V = 1e-3;
            double dt = (fine ? 0.5e-3 : 1e-3) / w;
            int n = (int)(10 / (w * dt));
            for (int i = 1; i <= n; i++) {
                V -= A.R_eff * A.R_eff / A.I * run(&A, 1e9, V, dt) * dt;
                double t = i * dt, want = exp(-zeta * w * t) * (cos(d * t) - zeta * w / d * sin(d * t));
                worst[fine] = fmax(worst[fine], fabs(V / 1e-3 - want));
            }
        }
        assert_true(worst[0] < 0.01);
        assert_close(worst[0] / worst[1], 2, 0.02, 0); /* first order */
    }
}

static void energy_and_bound_are_those_of_the_spring_and_of_coulomb(void **state) {
    (void)state;
    tr_lane energy, bound;
    set_up(&A, &tr_law_template, false, 0.4);
    run(&A, 1e5, 2, 1e-4);
    tr_law_data d = data_of(&A);
    A.law->state(&A.tile, &d, energy, bound);
    for (int i = 0; i < N; i++) {
        assert_close(energy[i], K_R * 2e-4 * 2e-4 / 2, ROUND, 0);
        assert_close(bound[i], MU_R * 1e5 * A.R_eff, ROUND, 0);
    }
}

/* dT/d(rolling distance) and dT/dV_r by differences, levers by V_r = R_eff (w1 - w2). */
static void stiffness_is_what_the_law_shows(void **state) {
    (void)state;
    for (int wall = 0; wall < 2; wall++) {
        set_up(&A, &tr_law_template, wall, 0.4);
        tr_stiffness s = A.law->stiffness(A.par, &A.bodies);
        double one = run(&A, 1e9, 1, 1e-4), two = run(&A, 1e9, 1, 1e-4), still = run(&A, 1e9, 0, 0);
        assert_close(s.k, (two - one) / 1e-4, 1e-10, 0); /* rounding of differences of 1e3 in 1e5 */
        assert_close(s.c, two - still, 1e-10, 0);
        assert_close(s.lever1, A.R_eff, ROUND, 0);
        assert_close(s.lever2, A.R_eff, ROUND, 0);
        assert_true(s.along == 0);
        *tr_law_value(A.law, A.par, "mu_r") = 0;
        s = A.law->stiffness(A.par, &A.bodies);
        assert_true(s.k == 0 && s.c == 0);
    }
}

static void given_spins_have_no_dashpot(void **state) {
    (void)state;
    set_up(&A, &tr_law_template, false, 0.4);
    A.bodies.I1 = A.bodies.I2 = INFINITY;
    A.law->pair(A.par, &A.bodies, A.pair);
    assert_true(A.pair[0] == 0 && A.law->stiffness(A.par, &A.bodies).c == 0);
}

static void the_template_is_not_in_the_registry(void **state) {
    (void)state;
    for (int i = 0; i < tr_laws_catalog()->n_rolling; i++) assert_true(tr_laws_rolling[i] != &tr_law_template);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_step_is_the_formula),
        cmocka_unit_test(without_dashpot_it_is_wang_spring_bit_for_bit),
        cmocka_unit_test(fast_rolling_is_at_the_bound_and_slow_rolling_is_the_spring),
        cmocka_unit_test(two_free_disks_swing_as_a_damped_oscillator),
        cmocka_unit_test(energy_and_bound_are_those_of_the_spring_and_of_coulomb),
        cmocka_unit_test(stiffness_is_what_the_law_shows),
        cmocka_unit_test(given_spins_have_no_dashpot),
        cmocka_unit_test(the_template_is_not_in_the_registry),
    };
    return cmocka_run_group_tests_name("law_template", tests, NULL, NULL);
}
