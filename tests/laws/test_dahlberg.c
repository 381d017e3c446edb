/* SPDX-License-Identifier: MIT */
/* dahlberg-alfredsson against the differential equation itself, integrated here: a classical Runge-Kutta method of
 * fourth order with very many steps in z = sqrt(1 - q), where the equation is smooth up to full slip. Backward Euler
 * must converge to it with first order, and stay inside the cap for any step and any input. */
#include "assert_close.h"
#include "base/random.h"
#include "core/convergence.h"
#include "laws/dahlberg_bench.h"

/* ---- the differential equation */

/* dQ/dt at constant rates, by parts over which Q keeps its sign: |Q| = mu P (1 - z^2),
 * -2 mu P z z' = k (sgn(Q) v - F0 (1 - z) |r|). z' is smooth but at z = 0, where slip holds while the bracket is > 0.
 */
static double exact(double q0, double P, double R, double k, double v, double r, double time) {
    const int parts = 20000;
    double a = sqrt(4 * P * R / (M_PI * E_STAR)), F0 = MU * a / R, M = MU * P, h = time / parts;
    double q = q0; /* signed, of mu P */
    for (int i = 0; i < parts; i++) {
        double left = h;
        while (left > 0) {
            double s = q != 0 ? sign(q) : sign(v), z = sqrt(1 - fabs(q)), rate = k / M;
            /* in q: d|q|/dt = rate (s v - F0 (1 - z) |r|); in z it is smooth near full slip */
            if (z < 1e-4 && s * v - F0 * (1 - z) * fabs(r) > 0) { /* full slip */
                q = s;
                break;
            }
#define SLOPE(y) (-rate * (s * v - F0 * (1 - (y)) * fabs(r)) / (2 * (y)))
            double step = left;
            z = fmax(z, 1e-9);
            /* near z = 0 steps short against z itself */
            double slope = SLOPE(z);
            if (fabs(slope) * step > 0.02 * z) step = 0.02 * z / fabs(slope);
            double k1 = slope, k2 = SLOPE(z + 0.5 * step * k1), k3 = SLOPE(z + 0.5 * step * k2),
                   k4 = SLOPE(z + step * k3);
            double next = z + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
#undef SLOPE
            if (next > 1) { /* through zero: the rest of the step begins there */
                step *= (1 - z) / (next - z);
                next = 1;
                q = sign(v) * 1e-300;
            } else {
                q = s * (1 - next * next);
            }
            left -= fmax(step, 1e-12 * h);
        }
    }
    return q;
}

/* Legs of constant rates: sliding v, rolling r, load P, all over the same time. */
typedef struct leg {
    double v, r, P;
} leg;

static const leg path[] = {
    {1, 8, 5e5},  {1, -20, 5e5}, {-0.6, 15, 5e5}, {0, 0, 5e5},
    {0, 40, 5e5}, {0.8, 5, 9e5}, {-1.5, 3, 9e5},  {0.2, 60, 9e5},
};
enum { LEGS = sizeof path / sizeof *path };
static const double LEG_TIME = 4e-4;

/* Q/mu P at the end of each leg by the law in n steps per leg; lane 17 is read. */
static void by_law(int n, bool wall, double *q) {
    set_up(wall ? 0 : 0.02, 0.01);
    double dt = LEG_TIME / n;
    for (int l = 0; l < LEGS; l++) {
        for (int s = 0; s < n; s++) {
            for (int i = 0; i < TR_TILE; i++) {
                tile.f_n[i] = path[l].P, tile.v_s[i] = path[l].v;
                tile.s1[i] = path[l].r + 0.4, tile.s2[i] = path[l].r - 0.4; /* mean r */
            }
            tile.dt = dt;
            run();
        }
        q[l] = tile.f_t[17] / (MU * path[l].P);
    }
}

static void test_first_order(void **state) {
    (void)state;
    for (int wall = 0; wall < 2; wall++) {
        double R = wall ? 0.01 : 0.02 * 0.01 / 0.03, q = 0, want[LEGS], h[4], error[4];
        for (int l = 0; l < LEGS; l++) {
            if (l && path[l].P != path[l - 1].P) q *= path[l - 1].P / path[l].P; /* Q stays */
            q = want[l] = exact(q, path[l].P, R, K_T, path[l].v, path[l].r, LEG_TIME);
        }
        for (int m = 0; m < 4; m++) {
            double got[LEGS];
            int n = 100 << (2 * m);
            by_law(n, wall, got);
            h[m] = 1.0 / n, error[m] = 0;
            for (int l = 0; l < LEGS; l++) error[m] = fmax(error[m], fabs(got[l] - want[l]));
        }
        double order = observed_order(4, h, error);
        print_message("backward Euler%s: error in q %.1e, %.1e, %.1e, %.1e at 100, 400, 1600, 6400 steps a leg, order "
                      "%.2f\n",
                      wall ? " at a wall" : "", error[0], error[1], error[2], error[3], order);
        assert_true(error[3] < 2e-4);
        assert_true(order > 0.9 && order < 1.1);
        double spread = 0; /* the path visits both signs and partial slip */
        for (int l = 0; l < LEGS; l++) spread = fmax(spread, want[0] - want[l]);
        assert_true(spread > 0.5);
    }
}

/* Steady rolling at constant creepage xi = F0 (1 - sqrt(1 - q)) is Carter's: q = 1 - (1 - xi/F0)^2, exactly the fixed
 * point of the step, whatever its size; above F0 full slip. */
static void test_carter_is_the_steady_state(void **state) {
    (void)state;
    static const double ratios[] = {0.05, 0.3, 0.9, 0.999, 1.2};
    for (int sense = -1; sense <= 1; sense += 2)
        for (int k = 0; k < 5; k++) {
            set_up(0.02, 0.01);
            double P = 4e5, R = 0.02 * 0.01 / 0.03, F0 = MU * sqrt(4 * P / (M_PI * E_STAR * R)), x = ratios[k];
            tile.dt = 1e-3;
            for (int s = 0; s < 3000; s++) {
                for (int i = 0; i < TR_TILE; i++)
                    tile.f_n[i] = P, tile.s1[i] = tile.s2[i] = sense * 2, tile.v_s[i] = 2 * x * F0 * (i % 2 ? 1 : -1);
                run();
            }
            double want = x < 1 ? 1 - (1 - x) * (1 - x) : 1;
            for (int i = 0; i < TR_TILE; i++) assert_close(tile.f_t[i], (i % 2 ? 1 : -1) * want * MU * P, 1e-12, 0);
        }
}

/* By hand: Q above the present cap enters uncut. q_n = 1.5, A = -0.6, no rolling: 0.9, not 0.4. With rolling: the root
 * of q = 0.9 - B (1 - sqrt(1 - q)). */
static void test_one_step_by_hand(void **state) {
    (void)state;
    set_up(0.02, 0.01);
    double P = 1e5, M = MU * P, R = 0.02 * 0.01 / 0.03, F0 = MU * sqrt(4 * P / (M_PI * E_STAR * R));
    tile.dt = 1e-4;
    for (int i = 0; i < TR_TILE; i++) {
        double side = i % 2 ? 1 : -1, B = i / 2 * 0.05;
        Q[i] = side * 1.5 * M, tile.f_n[i] = P, tile.v_s[i] = -side * 0.6 * M / (K_T * tile.dt);
        tile.s1[i] = tile.s2[i] = (i % 4 < 2 ? 1 : -1) * B * M / (K_T * F0 * tile.dt);
    }
    run();
    for (int i = 0; i < TR_TILE; i++) {
        double side = i % 2 ? 1 : -1, B = i / 2 * 0.05, low = 0, high = 1;
        for (int k = 0; k < 60; k++) {
            double q = 0.5 * (low + high);
            if (q + B * (1 - sqrt(1 - q)) < 0.9)
                low = q;
            else
                high = q;
        }
        assert_close(tile.f_t[i], side * low * M, 1e-13, 0);
        if (i < 2) assert_close(tile.f_t[i], side * 0.9 * M, 1e-14, 0);
    }
}

/* Rolling without sliding relaxes Q and never turns it over; kuhn and wang differ where the disks slide. */
static void test_creep_roll(void **state) {
    (void)state;
    double end[2];
    for (int choice = 0; choice < 2; choice++) {
        set_up(0.02, 0.01);
        set("creep_roll", choice);
        tile.dt = 1e-5;
        for (int i = 0; i < TR_TILE; i++) tile.f_n[i] = 4e5, Q[i] = 5e4, tile.s1[i] = 3, tile.s2[i] = 1;
        run();
        end[choice] = tile.f_t[3];
        /* dQ = -k F(q) |r| dt to first order; r = 2, and R2 s1 + R1 s2 over R1 + R2 = 5/3 */
        double R = 0.02 / 3, P = 4e5, q = 5e4 / (MU * P),
               F = MU * sqrt(4 * P / (M_PI * E_STAR * R)) * (1 - sqrt(1 - q));
        assert_close(5e4 - end[choice], K_T * F * (choice ? 5.0 / 3 : 2) * tile.dt, 2e-2, 0);
        double before = end[choice];
        for (int s = 0; s < 2000; s++) {
            run();
            assert_true(tile.f_t[3] <= before && tile.f_t[3] >= 0);
            before = tile.f_t[3];
        }
        assert_true(before < 0.5 * end[choice]);
    }
    assert_true(end[0] != end[1]);
}

/* No rolling: the spring of coulomb-spring, bit for bit; so a look with dt = 0 changes nothing. */
static void test_without_rolling(void **state) {
    (void)state;
    set_up(0.02, 0.01);
    tr_random random = tr_random_seed(5, 1);
    double spring = 0;
    tile.dt = 1e-4;
    for (int s = 0; s < 2000; s++) {
        double v = 4 * tr_random_uniform(&random) - 2, P = 1e5 * (1 + tr_random_uniform(&random));
        for (int i = 0; i < TR_TILE; i++) tile.f_n[i] = P, tile.v_s[i] = v;
        run();
        spring = fmin(fmax(spring + K_T * tile.dt * v, -MU * P), MU * P);
        assert_true(tile.f_t[9] == spring);
    }
}

static void test_inside_the_cap_for_any_input(void **state) {
    (void)state;
    tr_random random = tr_random_seed(6, 1);
    int partial = 0;
    set_up(0.02, 0.01);
    for (int step = 0; step < 20000; step++) {
        tile.dt = pow(10, -9 + 12 * tr_random_uniform(&random));
        for (int i = 0; i < TR_TILE; i++) {
            double u = tr_random_uniform(&random);
            tile.f_n[i] = u < 0.1 ? 0 : pow(10, -300 + 320 * u);
            tile.v_s[i] =
                u < 0.3 ? 0 : (tr_random_uniform(&random) - 0.5) * pow(10, 30 * tr_random_uniform(&random) - 20);
            tile.s1[i] = (tr_random_uniform(&random) - 0.5) * pow(10, 30 * tr_random_uniform(&random) - 20);
            tile.s2[i] = u > 0.8 ? 0 : tile.s1[i];
        }
        run();
        for (int i = 0; i < TR_TILE; i++) {
            assert_true(isfinite(tile.f_t[i]) && tile.f_t[i] == Q[i]);
            assert_true(fabs(tile.f_t[i]) <= MU * tile.f_n[i]);
            if (tile.f_n[i] == 0) assert_true(Q[i] == 0);
            partial += fabs(Q[i]) < MU * tile.f_n[i] && Q[i] != 0;
        }
    }
    assert_true(partial > 10000);
    set("mu", 0);
    for (int i = 0; i < TR_TILE; i++) tile.f_n[i] = 1e5 * i;
    run();
    for (int i = 0; i < TR_TILE; i++) assert_true(Q[i] == 0);
}

/* What the law says that creep took is what did not go into the spring: k (Vs dt - creep) = dQ, below the cap. */
static void test_creep_is_what_the_spring_misses(void **state) {
    (void)state;
    set_up(0.02, 0.01);
    tr_law_data data = {.par = par, .hist = (double *[]){Q}};
    tr_random r = tr_random_seed(8, 1);
    double before[TR_TILE];
    tr_lane took;
    tile.dt = 1e-6;
    for (int n = 0; n < 200; n++) {
        for (int i = 0; i < TR_TILE; i++) {
            tile.f_n[i] = 1e5, before[i] = Q[i];
            tile.v_s[i] = tr_random_uniform(&r) - 0.5;
            tile.s1[i] = 100 * (tr_random_uniform(&r) - 0.5), tile.s2[i] = tile.s1[i];
        }
        run();
        law->creep(&tile, &data, took);
        for (int i = 0; i < TR_TILE; i++) { /* rounding of Q, which is below mu P */
            assert_true(fabs(Q[i]) < MU * tile.f_n[i]);
            assert_close(K_T * (tile.v_s[i] * tile.dt - took[i]), Q[i] - before[i], 0, 1e-14 * MU * tile.f_n[i]);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_first_order),
        cmocka_unit_test(test_carter_is_the_steady_state),
        cmocka_unit_test(test_one_step_by_hand),
        cmocka_unit_test(test_creep_roll),
        cmocka_unit_test(test_without_rolling),
        cmocka_unit_test(test_inside_the_cap_for_any_input),
        cmocka_unit_test(test_creep_is_what_the_spring_misses),
    };
    return cmocka_run_group_tests_name("dahlberg", tests, NULL, NULL);
}
