/* SPDX-License-Identifier: MIT */
/* The half-plane against the closed forms of sliding (Cattaneo, Masing), of steady rolling (Carter) and of oblique
 * loading, Kalker's transient between the two, the published error of Dahlberg and Alfredsson's law, and symmetries.
 * The closed forms are verified by themselves in test_closed_forms.c. */
#include "assert_close.h"
#include "core/convergence.h"
#include "patch/carter.h"
#include "patch/cattaneo.h"
#include "patch/half_plane.h"
#include <stdlib.h>

static const tr_patch_pair pair = {.R_star = 0.012, .E_star = 3e9, .d = 0.02, .mu = 0.35};
static const double P = 2e5;
static const double qs[] = {0.3, 0.6, 0.9};
static tr_status st;

static tr_half_plane *make(const tr_patch_pair *c, int n) {
    st.code = TR_OK;
    tr_half_plane *o = tr_half_plane_new(c, n, &st);
    assert_non_null(o);
    return o;
}

static void step(tr_half_plane *o, tr_patch_step k) {
    if (!tr_half_plane_step(o, &k, &st)) fail_msg("%s", st.text);
}
static void force(tr_half_plane *o, double q, double dr) {
    step(o, (tr_patch_step){.P = P, .dr = dr, .by_force = true, .Q = q * pair.mu * P});
}
static void slide(tr_half_plane *o, double du, double dr) {
    step(o, (tr_patch_step){.P = P, .dr = dr, .du = du});
}

/* roll = 0: Cattaneo */
static double closed(double q, double roll, double x) {
    return roll != 0 ? tr_carter_tau(&pair, P, q, roll, x) : tr_cattaneo_tau(&pair, P, q, x);
}

/* Errors of tau against the mean of the closed form over each element, of mu p0: the mean over the contact, and the
 * largest farther than `near` elements from where stick ends (tau has a root there that no element can follow). */
static void traction_error(const tr_patch_state *s, double q, double roll, double near, double *mean, double *most) {
    enum { POINTS = 200 };
    double c = sqrt(1 - fabs(q)),
           inner = roll > 0   ? 2 * c - 1
                   : roll < 0 ? 1 - 2 * c
                              : c,
           full = pair.mu * tr_patch_p0(&pair, P);
    *mean = *most = 0;
    for (int i = 0; i < s->n; i++) {
        double want = 0, from = fmin(fabs(s->x[i] - inner * s->a), roll == 0 ? fabs(s->x[i] + inner * s->a) : 9 * s->a);
        for (int k = 0; k < POINTS; k++) want += closed(q, roll, s->x[i] + ((k + 0.5) / POINTS - 0.5) * s->h) / POINTS;
        double error = fabs(s->tau[i] - want) / full;
        *mean += error / s->n;
        if (from > near * s->h) *most = fmax(*most, error);
    }
}

/* N = 200: the goals of accuracy. The stick zone ends in the middle of some element, hence the order below 2. */
static void test_cattaneo(void **state) {
    (void)state;
    tr_half_plane *o = make(&pair, 200);
    const tr_patch_state *s = tr_half_plane_state(o);
    for (int k = 0; k < 6; k++) {
        double q = k < 3 ? qs[k] : -qs[k - 3], mean, most;
        step(o, (tr_patch_step){.P = 0});
        force(o, q, 0);
        traction_error(s, q, 0, 3, &mean, &most);
        print_message("Cattaneo q = %4.1f: tau off by %.1e, %.1e in the mean; u by %.1e\n", q, most, mean,
                      s->du / tr_cattaneo_u(&pair, P, q) - 1);
        assert_true(most < 1e-3 && mean < 3e-4);
        assert_close(s->du, tr_cattaneo_u(&pair, P, q), 1e-4, 0);
        step(o, (tr_patch_step){.P = 0});
        slide(o, tr_cattaneo_u(&pair, P, q), 0);
        assert_close(s->Q, q * pair.mu * P, 1e-4, 0);
    }
    /* full slip: from the least du on, exactly */
    force(o, 1, 0);
    assert_close(s->Q, pair.mu * P, 1e-12, 0);
    step(o, (tr_patch_step){.P = 0});
    force(o, -1, 0);
    assert_close(s->du, tr_cattaneo_u(&pair, P, -1), 1e-4, 0);
    slide(o, -1e-6, 0);
    assert_close(s->Q, -pair.mu * P, 1e-12, 0);
    for (int i = 0; i < 200; i++) assert_close(s->slip[i], -1e-6, 1e-9, 0);
    tr_half_plane_free(o);
}

/* Mean over nine forces, because the error of one depends on where in an element the stick zone ends. */
static void test_convergence(void **state) {
    (void)state;
    double h[4], u[4], tau[4], steady[4];
    for (int m = 0; m < 4; m++) {
        int n = 25 << m;
        tr_half_plane *o = make(&pair, n);
        const tr_patch_state *s = tr_half_plane_state(o);
        h[m] = 1.0 / n, u[m] = tau[m] = steady[m] = 0;
        for (int k = 1; k < 10; k++) {
            double q = 0.1 * k, mean, most;
            step(o, (tr_patch_step){.P = 0});
            force(o, q, 0);
            traction_error(s, q, 0, 1, &mean, &most);
            u[m] += fabs(s->du / tr_cattaneo_u(&pair, P, q) - 1) / 9, tau[m] += mean / 9;
            for (int i = 0; i < 2 * n; i++) force(o, q, s->h);
            traction_error(s, q, 1, 1, &mean, &most);
            steady[m] += mean / 9;
        }
        tr_half_plane_free(o);
    }
    double order[] = {observed_order(4, h, u), observed_order(4, h, tau), observed_order(4, h, steady)};
    print_message("order in 1/n: %.2f Cattaneo's u, %.2f its tau in the mean, %.2f Carter's\n", order[0], order[1],
                  order[2]);
    /* one kink of size root(h) over one element: h^1.5 in the mean of tau; u better by a root */
    assert_true(order[0] > 1.5 && order[1] > 1.2 && order[2] > 0.8);
}

/* Steady rolling in steps of h and of a part of it, by creepage and by force. */
static void test_carter(void **state) {
    (void)state;
    for (int k = 0; k < 3; k++)
        for (int roll = -1; roll <= 1; roll += 2) {
            double q = qs[k], xi = tr_carter_creepage(&pair, P, q), by_n[3], mean, most;
            for (int m = 0; m < 3; m++) {
                tr_half_plane *o = make(&pair, 50 << m);
                const tr_patch_state *s = tr_half_plane_state(o);
                double h = 2 * tr_patch_a(&pair, P) / s->n;
                for (int i = 0; i < 12 * s->n; i++) slide(o, xi * h, roll * h);
                by_n[m] = s->Q / (pair.mu * P);
                if (m == 2) {
                    traction_error(s, q, roll, 3, &mean, &most);
                    force(o, q, roll * h);
                    for (int i = 0; i < 3 * s->n; i++) force(o, q, roll * h);
                    print_message("Carter q = %.1f: off by %.1e; tau by %.1e, %.1e in the mean; creepage by %.1e\n", q,
                                  by_n[m] - q, most, mean, s->du / (xi * h) - 1);
                    /* stick ends up to an element off: with the root in tau 0.25 root(h/3) or so, three elements on */
                    assert_true(mean < 2e-3 && most < 2.5e-2);
                    assert_close(s->du, xi * h, 1e-2, 0);
                    /* as much slip as Carter's, of which a step of h shows the mean over h */
                    double slip = 0, want = 0;
                    for (int i = 0; i < s->n; i++)
                        slip += s->slip[i] / h, want += tr_carter_slip(&pair, P, q, roll, s->x[i] - 0.5 * roll * h);
                    assert_close(slip, want, 2e-2, 0);
                    /* shorter steps, which read u between the middles: off by a part of h/a more */
                    for (int i = 0; i < 4 * s->n; i++) slide(o, 0.3 * xi * h, 0.3 * roll * h);
                    assert_close(s->Q / (pair.mu * P), q, 0, 0.5 * h / s->a);
                }
                tr_half_plane_free(o);
            }
            /* first order: the value for n -> infinity from the last two is Carter's, and n = 200 is within 3e-3 of
             * it */
            assert_close(2 * by_n[2] - by_n[1], q, 0, 1e-3);
            assert_close(by_n[2], 2 * by_n[2] - by_n[1], 0, 3e-3);
        }
}

/* From Cattaneo to Carter at constant Q [Kalker1971]: after a roll of 2a 6, 3 and less than 0.3 % of the first distance
 * from the steady state remain at q = 0.3, 0.6, 0.9. The steady state of the same grid is reached after 10a. */
static void test_from_cattaneo_to_carter(void **state) {
    (void)state;
    enum { N = 200 };
    for (int k = 0; k < 3; k++) {
        tr_half_plane *o = make(&pair, N);
        const tr_patch_state *s = tr_half_plane_state(o);
        double begin[N], middle[N], first = 0, left = 0;
        force(o, qs[k], 0);
        for (int i = 0; i < N; i++) begin[i] = s->tau[i];
        for (int i = 0; i < N; i++) force(o, qs[k], s->h);
        for (int i = 0; i < N; i++) middle[i] = s->tau[i];
        for (int i = 0; i < 4 * N; i++) force(o, qs[k], s->h);
        for (int i = 0; i < N; i++) first += fabs(begin[i] - s->tau[i]), left += fabs(middle[i] - s->tau[i]);
        print_message("q = %.1f: %.2f %% left after 2a\n", qs[k], 100 * left / first);
        static const double want[] = {0.06, 0.03, 0.0015};
        assert_close(left / first, want[k], 0, k < 2 ? 0.005 : 0.0015); /* the digits that are known */
        tr_half_plane_free(o);
    }
}

/* Reversals of sliding at constant P repeat Cattaneo's curve at twice its scale (Masing), and close. */
static void test_reversals_of_sliding(void **state) {
    (void)state;
    tr_half_plane *o = make(&pair, 200);
    const tr_patch_state *s = tr_half_plane_state(o);
    static const double turns[] = {0.8, -0.5, 0.4, -0.5, 0.8}, middle = 0.5;
    double u = 0, at[5], from = 0, scale = fabs(tr_cattaneo_u(&pair, P, 1));
    for (int k = 0; k < 5; k++) {
        double begin = u;
        for (int half = 1; half <= 2; half++) {
            double q = half == 1 ? from + middle * (turns[k] - from) : turns[k];
            force(o, q, 0);
            u += s->du;
            if (k == 4 && half == 1) continue; /* passes the inner loop, which is known at its end */
            double want = k == 0 ? tr_cattaneo_u(&pair, P, q) : begin + 2 * tr_cattaneo_u(&pair, P, (q - from) / 2);
            assert_close(u, want, 0, 2e-4 * scale);
        }
        at[k] = u, from = turns[k];
    }
    assert_close(at[3], at[1], 0, 1e-9 * scale);
    assert_close(at[4], at[0], 0, 1e-9 * scale);
    tr_half_plane_free(o);
}

/* Rolling back at constant Q ends in the mirrored steady state, with the creepage of the same sign. */
static void test_reversal_of_rolling(void **state) {
    (void)state;
    enum { N = 100 };
    tr_half_plane *o = make(&pair, N);
    const tr_patch_state *s = tr_half_plane_state(o);
    double there[N], du;
    for (int i = 0; i < 6 * N; i++) force(o, -0.6, i ? s->h : 0);
    for (int i = 0; i < N; i++) there[i] = s->tau[i];
    du = s->du;
    force(o, -0.6, -s->h);
    assert_true(fabs(s->du - du) > 0.01 * fabs(du)); /* not at once */
    for (int i = 0; i < 6 * N; i++) force(o, -0.6, -s->h);
    for (int i = 0; i < N; i++) assert_close(s->tau[N - 1 - i], there[i], 0, 1e-6 * pair.mu * tr_patch_p0(&pair, P));
    assert_close(s->du, du, 1e-5, 0);
    assert_true(du < 0);
    tr_half_plane_free(o);
}

/* Any path mirrored, turned over, and in other units. Only rounding differs. */
static void test_symmetries(void **state) {
    (void)state;
    enum { N = 60 };
    static const double big = 7, stiff = 0.3; /* lengths, E_star */
    tr_patch_pair other = pair;
    other.R_star *= big, other.d *= big, other.E_star *= stiff;
    tr_half_plane *o[4] = {make(&pair, N), make(&pair, N), make(&pair, N), make(&other, N)};
    const tr_patch_state *s[4];
    for (int v = 0; v < 4; v++) s[v] = tr_half_plane_state(o[v]);
    for (int n = 0; n < 200; n++) {
        double load = P * (1 + 0.5 * sin(0.05 * n)), a = tr_patch_a(&pair, load), scale = pair.mu * a * a / pair.R_star;
        tr_patch_step k = {.P = load, .dr = 0.07 * a * sin(0.11 * n), .du = 0.05 * scale * cos(0.19 * n)};
        k.by_force = n % 3 == 0, k.Q = 0.7 * pair.mu * load * sin(0.3 * n);
        for (int v = 0; v < 4; v++) {
            tr_patch_step m = k;
            if (v == 1) m.dr = -m.dr;
            if (v == 2) m.du = -m.du, m.Q = -m.Q;
            if (v == 3) m.P *= big * stiff, m.Q *= big * stiff, m.dr *= big, m.du *= big;
            step(o[v], m);
        }
        double full = pair.mu * tr_patch_p0(&pair, load);
        for (int i = 0; i < N; i++) {
            assert_close(s[1]->tau[N - 1 - i], s[0]->tau[i], 0, 1e-9 * full);
            assert_close(s[2]->tau[i], -s[0]->tau[i], 0, 1e-9 * full);
            assert_close(s[3]->tau[i], stiff * s[0]->tau[i], 0, 1e-9 * stiff * full);
        }
        assert_close(s[3]->du, big * s[0]->du, 0, 1e-9 * big * scale);
        assert_close(s[3]->dissipated, big * big * stiff * s[0]->dissipated, 0,
                     1e-8 * big * big * stiff * full * a * scale);
    }
    for (int v = 0; v < 4; v++) tr_half_plane_free(o[v]);
}

/* Normal force alone leaves nothing; nothing moves: nothing changes; an open contact forgets. */
static void test_nothing_from_nothing(void **state) {
    (void)state;
    tr_half_plane *o = make(&pair, 80);
    const tr_patch_state *s = tr_half_plane_state(o);
    for (int n = 0; n < 100; n++) {
        step(o, (tr_patch_step){.P = P * (1.1 + sin(0.2 * n)), .dr = n % 2 ? 1e-5 : 0});
        for (int i = 0; i < 80; i++) assert_true(s->tau[i] == 0 && s->slip[i] == 0);
    }
    force(o, 0.7, 0);
    double Q = s->Q;
    for (int n = 0; n < 10; n++) slide(o, 0, 0);
    assert_close(s->Q, Q, 1e-11, 0);
    step(o, (tr_patch_step){.P = 0, .du = 1e-5});
    force(o, 0, 0);
    for (int i = 0; i < 80; i++) assert_true(fabs(s->tau[i]) <= 1e-12 * s->p[40]);
    tr_half_plane_free(o);
}

/* Q = beta P rising together from rest, beta < mu: no slip, tau = beta p, and du/ddelta = beta: every ring that comes
 * into contact shares the strain of the pressure [Johnson1985 sec. 7.3]. In n steps of equal growth of a, with n
 * elements: first order, because no ring is told more finely than an element. */
static void test_oblique_loading(void **state) {
    (void)state;
    double beta = 0.6 * pair.mu, tau[3], motion[3], h[3];
    for (int m = 0; m < 3; m++) {
        int n = 40 << m;
        tr_half_plane *o = make(&pair, n);
        const tr_patch_state *s = tr_half_plane_state(o);
        double u = 0, dissipated = 0;
        for (int k = 1; k <= n; k++) {
            double load = P * k * k / n / n;
            step(o, (tr_patch_step){.P = load, .by_force = true, .Q = beta * load});
            u += s->du, dissipated += s->dissipated;
        }
        double delta = 2 * P / (M_PI * pair.E_star) * (log(2 * pair.d / s->a) + 0.5);
        h[m] = 1.0 / n, tau[m] = 0, motion[m] = u / (beta * delta) - 1;
        for (int i = 0; i < n; i++) tau[m] += fabs(s->tau[i] / beta - s->p[i]) / tr_patch_p0(&pair, P) / n;
        assert_true(dissipated < 1e-4 * u * beta * P); /* the first steps only */
        tr_half_plane_free(o);
    }
    double order[] = {observed_order(3, h, tau), observed_order(3, h, motion)};
    print_message("oblique loading, n = 160: tau off by %.1e in the mean, order %.2f; u by %.1e, order %.2f\n", tau[2],
                  order[0], motion[2], order[1]);
    assert_true(tau[2] < 3e-3 && fabs(motion[2]) < 1e-3 && order[0] > 0.8 && order[1] > 0.8);
}

/* Dahlberg and Alfredsson's law, dq = (k/mu P)(xi - F0 (1 - sqrt(1 - q))) dr with k = pi E_star/(2 Lambda), is known
 * to be off from the exact contact by these amounts in q at constant creepage from rest, xi/F0 from 0.1 to 1.5. The law
 * is integrated here; only the contact comes from the code under test. */
static void test_error_of_dahlberg_and_alfredsson(void **state) {
    (void)state;
    enum { N = 100, SUB = 50 };
    static const double Lambdas[] = {1.5, 2, 4, 6}, want[] = {0.075, 0.059, 0.033, 0.023};
    double a = tr_patch_a(&pair, P), F0 = pair.mu * a / pair.R_star, h = 2 * a / N;
    for (int l = 0; l < 4; l++) {
        tr_patch_pair c = pair;
        c.d = 0.5 * a * exp(Lambdas[l]);
        double worst = 0, rate = M_PI * c.E_star / (2 * Lambdas[l]) * h / SUB / (c.mu * P), at = 0;
        tr_half_plane *o = make(&c, N);
        for (double ratio = 0.1; ratio < 1.55; ratio += 0.1) {
            double q = 0, xi = ratio * F0;
            step(o, (tr_patch_step){.P = 0});
            for (int n = 0; n < 2 * N; n++) {
                slide(o, xi * h, h);
                for (int k = 0; k < SUB; k++) { /* midpoint rule; |q| <= 1 */
                    double half = fmin(1, q + 0.5 * rate * (xi - F0 * (1 - sqrt(1 - q))));
                    q = fmin(1, q + rate * (xi - F0 * (1 - sqrt(1 - half))));
                }
                double off = fabs(q - tr_half_plane_state(o)->Q / (c.mu * P));
                if (off > worst) worst = off, at = ratio;
            }
        }
        print_message("Lambda = %.1f: Dahlberg-Alfredsson off by up to %.4f, at xi/F0 = %.1f\n", Lambdas[l], worst, at);
        assert_close(worst, want[l], 0, 1.5e-3); /* the printed digits, and n = 100 */
        tr_half_plane_free(o);
    }
}

static void assert_same_bits(const tr_patch_state *s, const tr_patch_state *t) {
    size_t n = (size_t)s->n * sizeof(double);
    const double *const p[] = {s->x, s->p, s->tau, s->slip}, *const q[] = {t->x, t->p, t->tau, t->slip};
    for (int k = 0; k < 4; k++) assert_memory_equal(p[k], q[k], n);
    assert_memory_equal(s->side, t->side, (size_t)s->n);
    assert_true(s->P == t->P && s->a == t->a && s->h == t->h);
    assert_true(s->Q == t->Q && s->du == t->du && s->dissipated == t->dissipated);
}

/* A step of a path with all that there is: loading, sliding, rolling, prescribed forces, an open contact. */
static void wander(tr_half_plane *o, int k) {
    if (k == 9)
        step(o, (tr_patch_step){.P = 0});
    else if (k % 4 >= 2) /* the second one after another begins with the sliding of the first */
        step(o, (tr_patch_step){.P = P, .dr = k * 1e-6, .by_force = true, .Q = 0.005 * k * P});
    else
        step(o, (tr_patch_step){.P = P * (1 + 0.1 * (k % 3)), .dr = (k - 8) * 2e-6, .du = (k % 5 - 1) * 1e-6});
}

/* Saved after any step and loaded into a new one, it goes on bit for bit. */
static void test_checkpoint(void **state) {
    (void)state;
    enum { STEPS = 20, N = 40 };
    for (int saved = 0; saved < STEPS; saved++) {
        tr_checkpoint c;
        tr_half_plane *o = make(&pair, N), *loaded = make(&pair, N);
        for (int k = 0; k < saved; k++) wander(o, k);
        tr_checkpoint_begin(&c, "", &st);
        size_t first = c.size;
        tr_half_plane_checkpoint(o, &c);
        c.loading = true, c.at = first;
        tr_half_plane_checkpoint(loaded, &c);
        if (!tr_checkpoint_close(&c)) fail_msg("%s", st.text);
        for (int k = saved; k < STEPS; k++) {
            assert_same_bits(tr_half_plane_state(o), tr_half_plane_state(loaded));
            wander(o, k), wander(loaded, k);
        }
        assert_same_bits(tr_half_plane_state(o), tr_half_plane_state(loaded));
        tr_half_plane_free(o), tr_half_plane_free(loaded);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_cattaneo),
        cmocka_unit_test(test_convergence),
        cmocka_unit_test(test_carter),
        cmocka_unit_test(test_from_cattaneo_to_carter),
        cmocka_unit_test(test_reversals_of_sliding),
        cmocka_unit_test(test_reversal_of_rolling),
        cmocka_unit_test(test_symmetries),
        cmocka_unit_test(test_nothing_from_nothing),
        cmocka_unit_test(test_oblique_loading),
        cmocka_unit_test(test_error_of_dahlberg_and_alfredsson),
        cmocka_unit_test(test_checkpoint),
    };
    return cmocka_run_group_tests_name("half-plane", tests, NULL, NULL);
}
