/* SPDX-License-Identifier: MIT */
/* What every law of the registry must do, whatever its formula: nothing without overlap, bounds never exceeded, no
 * attraction, and what it claims: balanced moments, no dependence on the rate. Of springs, see is_spring(): force,
 * energy and bound against the formulas written out here; the closed cycle of a rolling spring against algebra; the
 * catalog against the registry. */
#include "base/random.h"
#include "laws/kinematics.h"
#include "laws/judged.h"
#include "scene/expression.h"
#include "scene/scene.h"
#include <string.h>

/* ---- a bench: one tile of pairs driven by given velocities and overlaps through the pipeline */

enum { FIRST = 128 }; /* the tile is not the first of its group */

typedef struct bench {
    tr_tile tile;
    double R1[TR_TILE], R2[TR_TILE], g1[TR_TILE], m1[TR_TILE], m2[TR_TILE];
    double hist_store[3][TR_MAX_HIST][FIRST + TR_TILE], pair_store[3][TR_MAX_PAIR][FIRST + TR_TILE];
    double *hist[3][TR_MAX_HIST], *pair[3][TR_MAX_PAIR]; /* of the first contact of the tile */
    double *hist_at[3][TR_MAX_HIST], *pair_at[3][TR_MAX_PAIR];
    double par[3][TR_LAW_PAR];
    const tr_law *law[3]; /* normal, friction, rolling */
    double dt;
} bench;

static bench B;
static tr_random R;

static double random_in(double a, double b) {
    return a + (b - a) * tr_random_uniform(&R);
}

static tr_law_data data_of(int slot) {
    for (int k = 0; k < TR_MAX_HIST; k++) B.hist_at[slot][k] = B.hist_store[slot][k];
    for (int k = 0; k < TR_MAX_PAIR; k++) B.pair_at[slot][k] = B.pair_store[slot][k];
    return (tr_law_data){.par = B.par[slot],
                         .hist = B.hist_at[slot],
                         .pair = B.pair_at[slot],
                         .normal = B.law[0],
                         .normal_par = B.par[0]};
}

static double parameter(int slot, const char *key) {
    const tr_param_table *t = &B.law[slot]->table;
    double value = NAN;
    for (int i = 0; i < t->n; i++)
        if (!strcmp(t->params[i].key, key)) memcpy(&value, (char *)B.par[slot] + t->params[i].offset, sizeof value);
    return value;
}

static tr_pair_bodies bodies_of(int i) {
    double R1 = B.R1[i], R2 = B.R2[i], m1 = B.m1[i], m2 = B.m2[i];
    double I1 = R1 > 0 ? m1 * R1 * R1 / 2 : INFINITY;
    return (tr_pair_bodies){.R1 = R1, .R2 = R2, .m1 = m1, .m2 = m2, .I1 = I1, .I2 = m2 * R2 * R2 / 2};
}

/* Any parameter: a stiffness 2e6, a number 0.3; what is off by default stays off. Lane 0 is a wall, the others pairs of
 * ratio up to 10. */
static void set_up(const tr_law *normal, const tr_law *friction, const tr_law *rolling) {
    memset(&B, 0, sizeof B);
    R = tr_random_seed(11, 1);
    B.law[0] = normal, B.law[1] = friction, B.law[2] = rolling;
    for (int s = 0; s < 3; s++) {
        for (int k = 0; k < TR_MAX_HIST; k++) B.hist[s][k] = B.hist_store[s][k] + FIRST;
        for (int k = 0; k < TR_MAX_PAIR; k++) B.pair[s][k] = B.pair_store[s][k] + FIRST;
    }
    B.tile.first = FIRST;
    B.tile.n = TR_TILE, B.tile.R1 = B.R1, B.tile.R2 = B.R2, B.tile.g1 = B.g1, B.dt = 1e-4;
    for (int s = 0; s < 3; s++)
        for (int i = 0; i < B.law[s]->table.n; i++) {
            const tr_param *p = &B.law[s]->table.params[i];
            if (p->type != TR_REAL || (p->fallback && !strcmp(p->fallback, "0"))) continue;
            double value = p->dim.kg ? 2e6 : 0.3;
            memcpy((char *)B.par[s] + p->offset, &value, sizeof value);
        }
    for (int i = 0; i < TR_TILE; i++) {
        B.R1[i] = i ? pow(10, random_in(-0.5, 0.5)) : 0, B.R2[i] = pow(10, random_in(-0.5, 0.5));
        B.g1[i] = i ? B.R1[i] / (B.R1[i] + B.R2[i]) : 1;
        B.m1[i] = i ? 10 * B.R1[i] * B.R1[i] : INFINITY, B.m2[i] = 10 * B.R2[i] * B.R2[i];
        tr_pair_bodies bodies = bodies_of(i);
        for (int s = 0; s < 3; s++) {
            double constants[TR_MAX_PAIR] = {0};
            if (!B.law[s]->n_pair) continue;
            B.law[s]->pair(B.par[s], &bodies, constants);
            for (int k = 0; k < B.law[s]->n_pair; k++) B.pair[s][k][i] = constants[k];
        }
    }
}

/* A rolling law on tile->v_r alone; conjugate-spring needs its derivatives too and has test_conjugate.c. */
static bool takes_v_r(const tr_law *law) {
    return law->needs & TR_NEEDS_V_R && !(law->needs & TR_NEEDS_PARTIALS);
}

/* The law is a spring of its parameter k_t or k_r, or on the straight curve of the normal law of k_n, capped at mu or
 * mu_r times the normal force: it has these parameters and claims what such a spring can claim. */
static bool is_spring(const tr_law *law) {
    const unsigned claims = TR_RATE_INDEPENDENT | TR_OBJECTIVE | TR_BALANCED | TR_ENERGY_CLOSED;
    const double none[TR_LAW_PAR] = {0};
    bool rolls = takes_v_r(law) && tr_law_value(law, none, "k_r") && tr_law_value(law, none, "mu_r");
    bool slides = (law->merged || tr_law_value(law, none, "k_t")) && tr_law_value(law, none, "mu");
    return law->step && (tr_law_claims(law) & claims) == claims && (rolls || slides);
}

/* For the rolling law both rims run at v_r, so it is the rolling velocity by every definition. For friction they stand
 * still: no creep. */
static void rims(bool run) {
    for (int i = 0; i < TR_TILE; i++) B.tile.s1[i] = B.tile.s2[i] = run ? B.tile.v_r[i] : 0;
}

static void run_laws(double dt) {
    B.tile.dt = dt;
    for (int s = 0; s < 3; s++) {
        tr_law_data d = data_of(s);
        if (s == 2) rims(true);
        if (B.law[s]->step) B.law[s]->step(&B.tile, &d);
    }
    rims(false);
}

/* Overlaps that come, go and fall faster than the dashpot likes; velocities of any sign. */
static void random_motion(void) {
    tr_tile *t = &B.tile;
    for (int i = 0; i < TR_TILE; i++) {
        double smaller = i ? fmin(B.R1[i], B.R2[i]) : B.R2[i];
        if (tr_random_uniform(&R) < 0.02) t->delta[i] = random_in(-0.02, 0.1) * smaller;
        t->delta[i] += random_in(-0.005, 0.005) * smaller;
        t->v_n[i] = random_in(-30, 30);
        t->v_s[i] = random_in(-1, 1) * pow(10, random_in(-2, 3));
        t->v_r[i] = random_in(-1, 1) * pow(10, random_in(-2, 3));
    }
}

typedef void with_laws(const tr_law *normal, const tr_law *friction, const tr_law *rolling);

/* With the linear normal law, the first: the others have tests of their own. */
static void for_all_laws(with_laws *run) {
    const tr_param_catalog *c = tr_laws_catalog();
    for (int f = 0; f < c->n_friction; f++)
        for (int r = 0; r < c->n_rolling; r++) {
            judged[0] = tr_laws_friction[f], judged[1] = tr_laws_rolling[r];
            run(tr_laws_normal[0], tr_laws_friction[f], tr_laws_rolling[r]);
        }
    judged[0] = judged[1] = NULL;
}

/* ---- without overlap */

static void apart(const tr_law *normal, const tr_law *friction, const tr_law *rolling) {
    set_up(normal, friction, rolling);
    for (int round = 0; round < 100; round++) {
        random_motion();
        for (int i = 0; i < TR_TILE; i++) B.tile.delta[i] = fabs(B.tile.delta[i]) + 1e-3;
        run_laws(B.dt);
        for (int i = 0; i < TR_TILE; i++) B.tile.delta[i] = i % 2 ? -random_in(0, 0.1) : 0;
        run_laws(B.dt);
        for (int i = 0; i < TR_TILE; i++) {
            assert_true(B.tile.f_n[i] == 0 && B.tile.f_elastic[i] == 0);
            assert_true(B.tile.f_t[i] == 0 && B.tile.m1[i] == 0 && B.tile.m2[i] == 0);
            for (int s = 0; s < 3; s++)
                for (int k = 0; k < B.law[s]->n_hist; k++) assert_true(B.hist[s][k][i] == 0);
        }
    }
}

static void test_nothing_without_overlap(void **state) {
    (void)state, for_all_laws(apart);
}

/* ---- caps, signs, balance and energy under random histories */

static void caps(const tr_law *normal, const tr_law *friction, const tr_law *rolling) {
    set_up(normal, friction, rolling);
    double mu = parameter(1, "mu"), mu_r = parameter(2, "mu_r"), k_n = parameter(0, "k_n"), k_t = parameter(1, "k_t"),
           k_r = parameter(2, "k_r"), zeta = parameter(0, "damping_ratio");
    tr_lane energy, bound;
    int at_bound = 0, below = 0, cut_by_falling = 0;
    double before[TR_TILE] = {0};
    for (int step = 0; step < 1600; step++) { /* of 64 contacts: 10^5 */
        random_motion();
        run_laws(B.dt);
        const tr_tile *t = &B.tile;
        for (int i = 0; i < TR_TILE; i++) {
            /* k delta + c v_n while both positive, c = 2 zeta sqrt(k m_eff) */
            double m = i ? B.m1[i] * B.m2[i] / (B.m1[i] + B.m2[i]) : B.m2[i];
            double spring = t->delta[i] > 0 ? k_n * t->delta[i] : 0;
            double force = spring > 0 ? fmax(0, spring + 2 * zeta * sqrt(k_n * m) * t->v_n[i]) : 0;
            assert_true(t->f_n[i] >= 0 && t->f_elastic[i] >= 0);
            assert_close(t->f_elastic[i], spring, 1e-15, 0);
            assert_close(t->f_n[i], force, 1e-13, 1e-15 * (spring + k_n)); /* roundings of a sum that may cancel */
        }
        if (friction->step) {
            tr_law_data d = data_of(1);
            friction->state(t, &d, energy, bound);
            for (int i = 0; i < TR_TILE; i++) {
                assert_true(fabs(t->f_t[i]) <= bound[i] && energy[i] >= 0);
                bool full = fabs(t->f_t[i]) == bound[i];
                at_bound += full && bound[i] > 0, below += !full;
                cut_by_falling += fabs(before[i]) > bound[i];
                before[i] = t->f_t[i];
                if (!is_spring(friction)) continue;
                /* a law on the curve of the normal force is capped by that curve, without the dashpot; on a straight
                 * one of disks it is a spring k_n */
                double force = !friction->merged ? t->f_n[i] : t->f_n[i] > 0 ? t->f_elastic[i] : 0;
                assert_close(bound[i], mu * force, 1e-15, 0);
                assert_close(energy[i], t->f_t[i] * t->f_t[i] / (2 * (friction->merged ? k_n : k_t)), 1e-14, 0);
            }
        }
        if (takes_v_r(rolling)) { /* the others: test_star.c, test_claims.c, test_conjugate.c */
            tr_law_data d = data_of(2);
            rolling->state(t, &d, energy, bound);
            for (int i = 0; i < TR_TILE; i++) {
                double lever = i ? B.R1[i] * B.R2[i] / (B.R1[i] + B.R2[i]) : B.R2[i];
                double T = t->m2[i] / lever;
                /* the bound's own rounding */
                assert_true(fmax(fabs(t->m1[i]), fabs(t->m2[i])) <= bound[i] * (1 + 4e-16));
                assert_true(energy[i] >= 0 && (t->m1[i] == -t->m2[i] || !(rolling->claims & TR_BALANCED)));
                if (!is_spring(rolling)) continue;
                assert_close(bound[i], mu_r * t->f_n[i] * lever, 1e-14, 0);
                assert_close(energy[i], T * T / (2 * k_r), 1e-14, 0);
            }
        }
        tr_law_data d = data_of(0);
        normal->state(t, &d, energy, bound);
        for (int i = 0; i < TR_TILE; i++)
            assert_close(energy[i], t->delta[i] > 0 ? 0.5 * k_n * t->delta[i] * t->delta[i] : 0, 1e-14, 0);
    }
    /* The histories did visit what they are meant to test. */
    if (is_spring(friction)) assert_true(at_bound > 1000 && below > 1000 && cut_by_falling > 1000);
}

static void test_caps_signs_and_energy(void **state) {
    (void)state, for_all_laws(caps);
}

/* ---- springs and sliders by hand: below the cap force = stiffness times path, with the sign of the path */

static void spring_and_slider(const tr_law *normal, const tr_law *friction, const tr_law *rolling) {
    if (!is_spring(friction) && !is_spring(rolling)) return;
    set_up(normal, friction, rolling);
    double path = 0;
    for (int step = 1; step <= 300; step++) {
        double v = step <= 100 ? 0.5 : step <= 150 ? -0.5 : 1e6 * (step <= 200 ? 1 : -1);
        path += v * B.dt;
        for (int i = 0; i < TR_TILE; i++)
            B.tile.delta[i] = 0.1 * B.R2[i], B.tile.v_n[i] = 0, B.tile.v_s[i] = v, B.tile.v_r[i] = -v;
        run_laws(B.dt);
        for (int i = 0; i < TR_TILE; i++) {
            double lever = B.g1[i] * B.R2[i], cap = 0.3 * B.tile.f_n[i];
            double Q = step <= 150 ? 2e6 * path : cap * (v > 0 ? 1 : -1);
            /* 300 sums */
            if (is_spring(friction)) assert_close(B.tile.f_t[i], Q, 1e-12, 1e-9);
            if (!is_spring(rolling)) continue;
            assert_close(B.tile.m2[i], -lever * Q, 1e-12, 1e-9);
            assert_close(B.tile.m1[i], lever * Q, 1e-12, 1e-9);
        }
    }
}

static void test_spring_and_slider(void **state) {
    (void)state, for_all_laws(spring_and_slider);
    assert_true(is_spring(tr_laws_friction[0]) && is_spring(tr_laws_rolling[0])); /* it was not for nothing */
}

/* ---- rate independence */

/* A path of sliding and rolling at constant overlap: amplitudes that slip and turn back. Each of its legs is walked in
 * `parts` steps of the time step dt. */
static void walk(double dt, int parts, double *Q, double *T) {
    for (int leg = 0; leg < 40; leg++) {
        double reach = ((leg * 7) % 11 - 5) * 0.02;
        for (int p = 0; p < parts; p++) {
            for (int i = 0; i < TR_TILE; i++) {
                B.tile.delta[i] = 0.1 * B.R2[i], B.tile.v_n[i] = 0;
                B.tile.v_s[i] = reach / (parts * dt), B.tile.v_r[i] = -1.5 * B.tile.v_s[i];
            }
            run_laws(dt);
        }
        for (int i = 0; i < TR_TILE; i++) Q[leg * TR_TILE + i] = B.tile.f_t[i], T[leg * TR_TILE + i] = B.tile.m2[i];
    }
}

static void rate(const tr_law *normal, const tr_law *friction, const tr_law *rolling) {
    enum { N = 40 * TR_TILE };
    static double Q[3][N], T[3][N];
    set_up(normal, friction, rolling);
    walk(1e-4, 8, Q[0], T[0]);
    set_up(normal, friction, rolling);
    walk(0.5e-4, 8, Q[1], T[1]); /* twice as fast: the same products, the same bits */
    set_up(normal, friction, rolling);
    walk(1e-4, 16, Q[2], T[2]); /* half the speed: steps of half the length, equal to rounding of 640 sums */
    for (int i = 0; i < N; i++) {
        if (tr_law_claims(friction) & TR_RATE_INDEPENDENT) {
            assert_true(Q[0][i] == Q[1][i]);
            assert_close(Q[2][i], Q[0][i], 1e-12, 1e-8); /* forces are 1e4 to 1e6 */
        }
        if (!(tr_law_claims(rolling) & TR_RATE_INDEPENDENT)) continue;
        assert_true(T[0][i] == T[1][i]);
        assert_close(T[2][i], T[0][i], 1e-12, 1e-8);
    }
}

static void test_rate_independence(void **state) {
    (void)state, for_all_laws(rate);
}

/* ---- the closed cycle +du, +dth1, -du, -dth1 */

/* Work of the rolling moments on the disks, in small steps below the cap. Only betadot and w1 change, the geometry is
 * held: r and s are those of the linear cycle, for which the algebra is exact. */
static double cycle_work(const char *velocity, double R1, double R2, double L, double du, double dth, int parts) {
    const tr_param_catalog *c = tr_laws_catalog();
    double work = 0;
    for (int r = 0; r < c->n_rolling; r++) {
        if (strcmp(tr_laws_rolling[r]->table.name, "wang-spring")) continue;
        set_up(tr_laws_normal[0], tr_laws_friction[0], tr_laws_rolling[r]);
        B.R1[5] = R1, B.R2[5] = R2, B.g1[5] = R1 / (R1 + R2);
        double big = 1e9; /* mu_r: never at the cap */
        for (int i = 0; i < B.law[2]->table.n; i++)
            if (!strcmp(B.law[2]->table.params[i].key, "mu_r"))
                memcpy((char *)B.par[2] + B.law[2]->table.params[i].offset, &big, sizeof big);
        double m_before = 0;
        for (int k = 0; k < 4 * parts; k++) {
            double Vt = (k / parts == 0) - (k / parts == 2), w1 = (k / parts == 1) - (k / parts == 3);
            Vt *= du / (parts * B.dt), w1 *= dth / (parts * B.dt);
            /* n = (1, 0), t = (0, -1) */
            for (int i = 0; i < TR_TILE; i++) B.tile.dx[i] = i == 5 ? L : 3;
            B.tile.dvy[5] = -Vt, B.tile.w1[5] = w1;
            tr_kinematics_pair(&B.tile, NULL);
            for (int v = 0; v < tr_n_rolling_velocities; v++)
                if (!strcmp(tr_rolling_velocities[v].name, velocity)) tr_rolling_velocities[v].step(&B.tile, NULL);
            run_laws(B.dt);
            work += 0.5 * (m_before + B.tile.m1[5]) * w1 * B.dt;
            m_before = B.tile.m1[5];
        }
    }
    return work;
}

static void test_closed_cycle(void **state) {
    (void)state;
    static const double radii[][2] = {{1, 1}, {2, 1}, {1, 2}, {1, 10}};
    const double du = 1e-3, dth = 2e-3, k_r = 2e6;
    for (int i = 0; i < 4; i++)
        for (int parts = 1; parts <= 100; parts *= 10) {
            double R1 = radii[i][0], R2 = radii[i][1], L = R1 + R2 - 0.05, R_eff = R1 * R2 / (R1 + R2);
            double made = k_r * R_eff * (R2 - R1) / (2 * L) * du * dth, scale = k_r * R_eff * R2 * dth * dth;
            /* sums of up to 400 terms of size scale */
            assert_close(cycle_work("bagi-kuhn", R1, R2, L, du, dth, parts), made, 0, 1e-13 * scale);
            assert_close(cycle_work("bagi-kuhn", R1, R2, L, -du, dth, parts), -made, 0, 1e-13 * scale);
            assert_close(cycle_work("wang", R1, R2, L, du, dth, parts), 0, 0, 1e-13 * scale);
        }
}

/* ---- greatest stiffness, as the bound on the step sees it */

/* Both steps are far below the bounds: 1e-3 m/s for 1e-4 s; the second is faster by 1e-4 m/s, for dashpots. */
static void shows_its_stiffness(const tr_law *normal, const tr_law *friction, const tr_law *rolling) {
    const double v = 1e-3, more = 1e-4, du = (v + more) * B.dt;
    if (!friction->step || !takes_v_r(rolling)) return;
    set_up(normal, friction, rolling);
    for (int i = 0; i < TR_TILE; i++)
        B.tile.delta[i] = 0.1 * B.R2[i], B.tile.v_n[i] = 0, B.tile.v_s[i] = v, B.tile.v_r[i] = v;
    run_laws(B.dt);
    tr_tile old = B.tile;
    for (int i = 0; i < TR_TILE; i++)
        B.tile.delta[i] += 1e-6, B.tile.v_n[i] = 0.01, B.tile.v_s[i] += more, B.tile.v_r[i] += more;
    run_laws(B.dt);
    for (int i = 0; i < TR_TILE; i++) {
        tr_pair_bodies b = bodies_of(i);
        tr_stiffness n = B.law[0]->stiffness(B.par[0], &b);
        b.f_n = old.f_n[i], b.k_n = n.k; /* laws that follow the normal one */
        tr_stiffness t = B.law[1]->stiffness(B.par[1], &b), q = B.law[2]->stiffness(B.par[2], &b);
        double d_n = B.tile.f_n[i] - old.f_n[i], T = q.k * du + q.c * more;
        /* differences of numbers 1e5 times larger: 1e-9 */
        assert_close(B.tile.f_elastic[i] - old.f_elastic[i], n.k * 1e-6, 1e-7, 0);
        assert_close(d_n, n.k * 1e-6 + n.c * 0.01, 1e-7, 0);
        assert_close(B.tile.f_t[i] - old.f_t[i], t.k * du + t.c * more, 1e-9, 0);
        assert_close(B.tile.m2[i] - old.m2[i], q.lever2 * T, 1e-9, 0);
        assert_close(B.tile.m1[i] - old.m1[i], -q.lever1 * T, 1e-9, 0);
    }
}

static void test_stiffness_is_what_the_law_shows(void **state) {
    (void)state, for_all_laws(shows_its_stiffness);
}

/* ---- the catalog */

static void check_law_kind(const tr_law *const *laws, const tr_param_table *const *tables, int n) {
    assert_true(n > 0);
    for (int i = 0; i < n; i++) {
        judged[0] = laws[i];
        assert_ptr_equal(&laws[i]->table, tables[i]);
        assert_non_null(laws[i]->table.name);
        assert_true(laws[i]->table.doc && strlen(laws[i]->table.doc) > 4);
        assert_true(laws[i]->formula && strlen(laws[i]->formula) > 4);
        assert_true(laws[i]->n_hist <= TR_MAX_HIST && laws[i]->n_pair <= TR_MAX_PAIR);
        assert_int_equal(laws[i]->n_pair > 0, laws[i]->pair != NULL);
        if (laws[i]->step) {
            assert_true(laws[i]->state && laws[i]->stiffness && laws[i]->source && laws[i]->source[0] == '[');
            assert_true(!laws[i]->differs || strlen(laws[i]->differs) > 20);
        } else if (!(laws[i]->needs & TR_SOLVED_BY_PATCH)) {
            assert_string_equal(laws[i]->table.name, "none");
            assert_int_equal(laws[i]->n_hist + laws[i]->n_pair + laws[i]->table.n, 0);
        }
        for (int j = 0; j < i; j++) assert_string_not_equal(laws[i]->table.name, laws[j]->table.name);
        for (int k = 0; k < laws[i]->table.n; k++) {
            const tr_param *p = &laws[i]->table.params[k];
            assert_false(tr_expression_reserved(p->key));
            assert_true(p->offset + sizeof(double) <= TR_LAW_PAR * sizeof(double));
            assert_true(p->doc && p->unit && p->min <= p->max);
            for (int j = 0; j < k; j++) {
                assert_string_not_equal(p->key, laws[i]->table.params[j].key);
                assert_int_not_equal(p->offset, laws[i]->table.params[j].offset);
            }
        }
    }
    judged[0] = NULL;
}

static void test_catalog(void **state) {
    (void)state;
    const tr_param_catalog *c = tr_laws_catalog();
    check_law_kind(tr_laws_normal, c->normal, c->n_normal);
    check_law_kind(tr_laws_friction, c->friction, c->n_friction);
    check_law_kind(tr_laws_rolling, c->rolling, c->n_rolling);
    char names[400] = "";
    for (int i = 0; i < tr_n_rolling_velocities; i++) {
        strcat(names, i ? "|" : ""), strcat(names, tr_rolling_velocities[i].name);
        assert_true(tr_rolling_velocities[i].source && tr_rolling_velocities[i].source[0] == '[');
    }
    assert_string_equal(names, c->rolling_velocities);
    int without = 0; /* a "none" for friction and one for rolling */
    for (int i = 0; i < c->n_friction; i++)
        without += !tr_laws_friction[i]->step && !(tr_laws_friction[i]->needs & TR_SOLVED_BY_PATCH);
    assert_int_equal(without, 1);
    for (int i = 0; i < c->n_rolling; i++) without += !tr_laws_rolling[i]->step;
    assert_int_equal(without, 2);
}

/* A key that two laws share means the same quantity in both: a scene gives it once. Its row stands in material.h. */
static void a_key_means_the_same_in_every_law(void **state) {
    (void)state;
    const tr_param_catalog *c = tr_laws_catalog();
    const tr_param_table *tables[64];
    int n = 0, shared = 0;
    for (int i = 0; i < c->n_normal; i++) tables[n++] = c->normal[i];
    for (int i = 0; i < c->n_friction; i++) tables[n++] = c->friction[i];
    for (int i = 0; i < c->n_rolling; i++) tables[n++] = c->rolling[i];
    for (int a = 0; a < n; a++)
        for (int b = 0; b < a; b++)
            for (int i = 0; i < tables[a]->n; i++)
                for (int j = 0; j < tables[b]->n; j++) {
                    const tr_param *p = &tables[a]->params[i], *q = &tables[b]->params[j];
                    if (strcmp(p->key, q->key)) continue;
                    shared++;
                    if (p->type != q->type || memcmp(&p->dim, &q->dim, sizeof p->dim) || strcmp(p->unit, q->unit) ||
                        strcmp(p->doc, q->doc) || p->max != q->max)
                        fail_msg("%s of %s and of %s: take the row of laws/material.h", p->key, tables[b]->name,
                                 tables[a]->name);
                }
    assert_true(shared > 20); /* mu, nu, E_star, mu_r, k_t, k_r, damping_ratio and more, each in two laws at least */
}

int main(void) {
    const struct CMUnitTest tests[] = {
        law_test(test_nothing_without_overlap),
        law_test(test_caps_signs_and_energy),
        law_test(test_spring_and_slider),
        law_test(test_rate_independence),
        cmocka_unit_test(test_closed_cycle),
        law_test(test_stiffness_is_what_the_law_shows),
        law_test(test_catalog),
        cmocka_unit_test(a_key_means_the_same_in_every_law),
    };
    return cmocka_run_group_tests_name("laws", tests, NULL, NULL);
}
