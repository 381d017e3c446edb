/* SPDX-License-Identifier: MIT */
/* The brush against its closed form: constant creepage from rest at constant P. The material that is at x after the
 * roll L came from x - L or, if it entered since, from the edge; it has been stretched by xi min(L, x + a) if it stuck
 * all the way. The bound mu p/k_w is a concave function of x and not negative: a straight line that starts at or below
 * it passes it once at most, and after that slips and stays on it. So at any L
 *   tau = min(mu p, k_w xi min(L, x + a)) */
#include "assert_close.h"
#include "base/random.h"
#include "core/convergence.h"
#include "patch/brush.h"
#include "patch/quadrature.h"
#include <string.h>

static const tr_patch_pair pair = {.R_star = 0.012, .E_star = 3e9, .d = 0.02, .mu = 0.35};
static const double P = 2e5;
static tr_status st;

static tr_brush *make(int n) {
    st.code = TR_OK;
    tr_brush *o = tr_brush_new(&pair, n, 0, &st);
    assert_non_null(o);
    return o;
}
static void step(tr_brush *o, tr_patch_step k) {
    if (!tr_brush_step(o, &k, &st)) fail_msg("%s", st.text);
}

/* Lengths over a, tractions over mu p0: k_w xi a/(mu p0) = (pi/2) xi/F0 for the default k_w. */
typedef struct roll {
    double beta, L;
} roll;
static double tau_of(double X, double from_low, double from_high, const void *with) {
    const roll *r = with;
    (void)from_low, (void)from_high;
    return fmin(sqrt(fmax(0, 1 - X * X)), r->beta * fmin(r->L, 1 + X));
}
static double exact_q(double ratio, double L) { /* xi/F0, roll over a */
    roll r = {0.5 * M_PI * ratio, L};
    double flat = r.beta * L < 1 ? sqrt(1 - r.beta * r.beta * L * L) : 0,
           ramp = (1 - r.beta * r.beta) / (1 + r.beta * r.beta);
    double cut[] = {-1, -flat, flat, fmin(1, L - 1), ramp, 1}, sum = 0;
    for (int i = 0; i < 6; i++)
        for (int j = i + 1; j < 6; j++)
            if (cut[j] < cut[i]) {
                double keep = cut[i];
                cut[i] = cut[j], cut[j] = keep;
            }
    for (int i = 0; i < 5; i++) sum += integral(tau_of, &r, cut[i], cut[i + 1]);
    return sum / (0.5 * M_PI);
}

static double F0_of(void) {
    return pair.mu * tr_patch_a(&pair, P) / pair.R_star;
}

/* Steps of h, which read the deflection where it is stored, and of 0.7 h, between. */
static void test_from_rest(void **state) {
    (void)state;
    static const double ratios[] = {0.1, 0.5, 1, 3}, parts[] = {1, 0.7};
    double a = tr_patch_a(&pair, P), full = pair.mu * tr_patch_p0(&pair, P);
    for (int part = 0; part < 2; part++) {
        double h[4], force[4] = {0}, traction[4] = {0};
        for (int m = 0; m < 4; m++) {
            int n = 50 << m;
            h[m] = 1.0 / n;
            for (int k = 0; k < 4; k++)
                for (int way = -1; way <= 1; way += 2) {
                    tr_brush *o = make(n);
                    const tr_patch_state *s = tr_brush_state(o);
                    double dr = parts[part] * 2 * a / n;
                    for (int i = 1; i * dr < 3 * a; i++) {
                        step(o, (tr_patch_step){.P = P, .dr = way * dr, .du = -ratios[k] * F0_of() * dr});
                        force[m] = fmax(force[m], fabs(-s->Q / (pair.mu * P) - exact_q(ratios[k], i * dr / a)));
                        roll r = {0.5 * M_PI * ratios[k], i * dr / a};
                        double off = 0;
                        for (int e = 0; e < n; e++)
                            off += fabs(-s->tau[e] / full - tau_of(way * s->x[e] / a, 0, 0, &r));
                        traction[m] = fmax(traction[m], off / n);
                    }
                    tr_brush_free(o);
                }
        }
        double order[] = {observed_order(4, h, force), observed_order(4, h, traction)};
        print_message(
            "brush in steps of %.1f h, n = 400: q off by up to %.1e, order %.2f; tau by %.1e in the mean, %.2f\n",
            parts[part], force[3], order[0], traction[3], order[1]);
        /* at h only the kink of tau, and the root at the edges, are less than second order */
        if (part == 0) assert_true(order[0] > 1.3 && order[1] > 1.3 && force[3] < 1e-4 && traction[3] < 2e-4);
        assert_true(order[0] > 0.9 && order[1] > 0.9 && force[3] < 1e-3 && traction[3] < 2e-3);
    }
}

/* All material is new after one long step: each piece has the stretch of its own way through the contact. */
static void test_one_long_step(void **state) {
    (void)state;
    enum { N = 50 };
    tr_brush *o = make(N);
    const tr_patch_state *s = tr_brush_state(o);
    double a = tr_patch_a(&pair, P), full = pair.mu * tr_patch_p0(&pair, P);
    for (int way = -1; way <= 1; way += 2) {
        step(o, (tr_patch_step){.P = P, .dr = way * 5 * a, .du = 0.5 * F0_of() * 5 * a});
        for (int i = 0; i < N;
             i++) { /* the bound is a mean over the element, hence the few parts in 100 at its edges */
            double X = way * s->x[i] / a, want = tau_of(X, 0, 0, &(roll){0.25 * M_PI, 5});
            assert_close(s->tau[i] / full, want, s->side[i] ? 0.07 : 1e-12, 0);
        }
    }
    tr_brush_free(o);
}

static void test_steady_after_2a(void **state) {
    (void)state;
    enum { N = 200 };
    tr_brush *o = make(N);
    const tr_patch_state *s = tr_brush_state(o);
    double h = 2 * tr_patch_a(&pair, P) / N, worst = 0, late = 0, last = 0;
    for (int i = 0; i < N + 10; i++) {
        if (i == 9 * N / 10) late = s->Q;
        if (i == N) last = s->Q;
        step(o, (tr_patch_step){.P = P, .dr = h, .du = 0.1 * F0_of() * h});
    }
    assert_true(last - late > 1e-3 * last);
    assert_close(s->Q, last, 1e-13, 0);
    /* against Carter's q = w (2 - w), w = xi/F0: equal slope at 0, up to 0.08 less */
    for (double w = 0.02; w <= 1; w += 0.02) worst = fmax(worst, w * (2 - w) - exact_q(w, 2));
    assert_close(worst, 0.08, 0, 5e-3);
    assert_close(exact_q(1e-6, 2), 2e-6, 1e-5, 0);
    for (int i = 0; i < 2 * N; i++) step(o, (tr_patch_step){.P = P, .dr = h, .du = F0_of() * h});
    assert_close(s->Q / (pair.mu * P), exact_q(1, 2), 0, 5e-3);
    tr_brush_free(o);
}

/* Friction on every step of random paths; mirrored and turned-over paths. */
static void test_law_and_symmetries(void **state) {
    (void)state;
    enum { N = 41 };
    tr_random r = tr_random_seed(8, 1);
    tr_brush *o[3] = {make(N), make(N), make(N)};
    const tr_patch_state *s[3];
    for (int v = 0; v < 3; v++) s[v] = tr_brush_state(o[v]);
    int slipping = 0;
    double load = P;
    for (int n = 0; n < 2000; n++) {
        double v = 2 * tr_random_uniform(&r) - 1, w = 2 * tr_random_uniform(&r) - 1;
        if (n % 4 == 0) load = P * (0.5 + tr_random_uniform(&r));
        if (n % 97 == 0) load = 0;
        double a = tr_patch_a(&pair, load);
        tr_patch_step k = {.P = load, .dr = a * w * w * w, .du = pair.mu * a * a / pair.R_star * v * v * v};
        k.by_force = n % 3 == 0, k.Q = n % 15 ? pair.mu * load * w : pair.mu * load;
        step(o[0], k);
        k.dr = -k.dr, step(o[1], k);
        k.dr = -k.dr, k.du = -k.du, k.Q = -k.Q, step(o[2], k);
        if (k.by_force) assert_close(s[2]->Q, k.Q, 0, 1e-12 * pair.mu * load);
        double k_w = M_PI * pair.E_star / (4 * a), full = pair.mu * tr_patch_p0(&pair, load);
        for (int i = 0; load > 0 && i < N; i++) {
            double bound = pair.mu * s[0]->p[i], tau = s[0]->tau[i], slip = s[0]->slip[i];
            assert_true(fabs(tau) <= bound * (1 + 1e-15));
            assert_true(s[0]->side[i] ? tau == s[0]->side[i] * bound && tau * slip >= 0 : slip == 0);
            assert_close(s[1]->tau[N - 1 - i], tau, 0, 1e-9 * full);
            assert_close(s[2]->tau[i], -tau, 0, 1e-9 * full);
            slipping += s[0]->side[i] != 0;
        }
        assert_true(s[0]->dissipated >= 0);
        if (!k.by_force && n % 50 == 1 && load > 0) { /* no roll, a small slide: a spring */
            double before[N];
            for (int i = 0; i < N; i++) before[i] = s[0]->tau[i];
            step(o[0], (tr_patch_step){.P = load, .du = 1e-12});
            for (int i = 0; i < N; i++)
                if (!s[0]->side[i]) assert_close(s[0]->tau[i] - before[i], k_w * 1e-12, 0, 1e-13 * full);
            step(o[1], (tr_patch_step){.P = load, .du = 1e-12});
            step(o[2], (tr_patch_step){.P = load, .du = -1e-12});
        }
    }
    assert_true(slipping > 2000 && slipping < 2000 * N - 2000);
    for (int v = 0; v < 3; v++) tr_brush_free(o[v]);
}

/* When P changes, a point that sticks keeps its deflection, and k_w follows a. */
static void test_load_changes(void **state) {
    (void)state;
    enum { N = 101 };
    tr_brush *o = make(N);
    const tr_patch_state *s = tr_brush_state(o);
    double u = 1e-8;
    step(o, (tr_patch_step){.P = P, .du = u});
    for (int k = 1; k < 5; k++) {
        double load = P * (1 + 0.5 * (k % 3));
        step(o, (tr_patch_step){.P = load});
        assert_close(s->tau[N / 2], M_PI * pair.E_star / (4 * tr_patch_a(&pair, load)) * u, 1e-12, 0);
    }
    /* a contact that shrinks: what is in it now was in it before, however it rolled */
    step(o, (tr_patch_step){.P = 0});
    step(o, (tr_patch_step){.P = 4 * P, .du = u});
    double a = tr_patch_a(&pair, P);
    step(o, (tr_patch_step){.P = P, .dr = 0.5 * a, .du = u});
    for (int i = 3; i < N - 3; i++) assert_close(s->tau[i], M_PI * pair.E_star / (4 * a) * 2 * u, 1e-12, 0);
    step(o, (tr_patch_step){.P = 0});
    step(o, (tr_patch_step){.P = P});
    assert_true(s->Q == 0);
    st.code = TR_OK;
    assert_false(tr_brush_step(o, &(tr_patch_step){.P = P, .by_force = true, .Q = 1.1 * pair.mu * P}, &st));
    assert_true(strstr(st.text, "slides") && st.code == TR_NUMERICAL && s->a == 0);
    st.code = TR_OK;
    assert_null(tr_brush_new(&pair, N, -1, &st));
    assert_int_equal(st.code, TR_BAD_CASE);
    tr_brush_free(o);
    st.code = TR_OK;
    o = tr_brush_new(&pair, N, 1e12, &st);
    step(o, (tr_patch_step){.P = P, .du = u});
    assert_close(tr_brush_state(o)->tau[N / 2], 1e12 * u, 1e-12, 0);
    tr_brush_free(o);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_from_rest),       cmocka_unit_test(test_one_long_step),
        cmocka_unit_test(test_steady_after_2a), cmocka_unit_test(test_law_and_symmetries),
        cmocka_unit_test(test_load_changes),
    };
    return cmocka_run_group_tests_name("brush", tests, NULL, NULL);
}
