/* SPDX-License-Identifier: MIT */
/* What each law of the registry claims, and law_template.c, shown to hold; what it does not claim, shown to fail in the
 * same motion: any flag turned over in the registry fails here; a choice that only kind: contact has is held to the
 * same. Then what holds for all laws: swapped bodies, bounds, forgetting, units, histories saved and restored. The law
 * under test is alone with a normal spring: pairs of 64 sizes and directions are driven along a path of changing
 * overlap, sliding and spins. No spin is so slow that a sign law would stop it within a step: that stop is the one
 * thing in which these depend on the rate. */
#include "base/random.h"
#include "laws/kinematics.h"
#include "laws/judged.h"
#include "laws/rolling_conjugate_spring.h"
#include "scene/scene.h"
#include <stdlib.h>
#include <string.h>

typedef struct units {
    double kg, m, s;
} units;

typedef struct bench {
    tr_tile tile;
    double R1[TR_TILE], R2[TR_TILE], g1[TR_TILE], m1[TR_TILE], m2[TR_TILE], nx[TR_TILE], ny[TR_TILE];
    double hist[3][TR_MAX_HIST][TR_TILE], pair[3][TR_MAX_PAIR][TR_TILE];
    double *hist_at[3][TR_MAX_HIST], *pair_at[3][TR_MAX_PAIR];
    double par[3][TR_LAW_PAR];
    tr_shape shape;
    const tr_law *law[3];
    units u;
} bench;

static bench A, B; /* static: aligned */

extern const tr_law tr_law_template; /* the start for a new law; not in the registry */

static double power(units u, tr_dim d) {
    return pow(u.kg, d.kg) * pow(u.m, d.m) * pow(u.s, d.s);
}

/* Does the law under test have the choice that only kind: contact may make? */
static bool driver;

/* Position of a choice in "a|b|c"; 0: not there. */
static int position(const char *choices, const char *choice) {
    const char *end = choice ? strstr(choices, choice) : NULL;
    int n = 0;
    for (const char *c = choices; c < end; c++) n += *c == '|';
    return n;
}

/* Defaults, or where there is none or it is an expression: a stiffness 2e6 Pa, a number 0.3. */
static void set_parameters(bench *b, int s) {
    for (int i = 0; i < b->law[s]->table.n; i++) {
        const tr_param *p = &b->law[s]->table.params[i];
        char *end = NULL, *at = (char *)b->par[s] + p->offset;
        double value = p->fallback ? strtod(p->fallback, &end) : 0;
        if (p->type == TR_CHOICE) {
            assert_int_equal(strncmp(p->fallback, p->choices, strlen(p->fallback)), 0);
            *(int *)(void *)at = position(p->choices, driver ? b->law[s]->table.driver_choice : NULL);
        }
        if (p->type == TR_SWITCH) assert_string_equal(p->fallback, "no");
        if (p->type != TR_REAL) continue;
        if (!end || *end || end == p->fallback) value = p->dim.kg ? 2e6 : 0.3;
        value *= power(b->u, tr_dim_of(p->dim, b->shape));
        memcpy(at, &value, sizeof value);
    }
}

/* The pass of every law in the shape or shapes that it is for. */
static tr_shape shape;

static const tr_law *normal_law(const char *name) {
    for (int i = 0; i < tr_laws_catalog()->n_normal; i++)
        if (!strcmp(tr_laws_normal[i]->table.name, name)) return tr_laws_normal[i];
    fail_msg("no normal law is called %s", name);
    return NULL;
}

/* Laws that follow the curve of the normal force get a curved normal law. */
static const tr_law *normal_for(const tr_law *law) {
    if (shape == TR_SHAPE_SPHERE) return normal_law("hertz-sphere");
    return normal_law(law->merged ? "hertz-line" : "linear");
}

static const tr_law *none(const tr_law *const *laws) {
    while ((*laws)->step) laws++;
    return *laws;
}

/* slot: 0 normal, 1 friction, 2 rolling. Not for the normal law itself, its dashpot is off. */
static void set_up(bench *b, int slot, const tr_law *law, bool swapped, units u) {
    memset(b, 0, sizeof *b);
    tr_random r = tr_random_seed(21, 1);
    b->u = u, b->shape = shape;
    b->law[0] = slot == 0 ? law : normal_for(law);
    b->law[1] = slot == 1 ? law : none(tr_laws_friction);
    b->law[2] = slot == 2 ? law : none(tr_laws_rolling);
    for (int s = 0; s < 3; s++) set_parameters(b, s);
    for (int i = 0; i < b->law[0]->table.n && slot; i++)
        if (!strcmp(b->law[0]->table.params[i].key, "damping_ratio"))
            memset((char *)b->par[0] + b->law[0]->table.params[i].offset, 0, sizeof(double));
    b->tile.n = law->merged || driver ? 8 : TR_TILE; /* those take 100 times as long */
    b->tile.R1 = b->R1, b->tile.R2 = b->R2, b->tile.g1 = b->g1;
    for (int i = 0; i < TR_TILE; i++) {
        double one = pow(3, tr_random_uniform(&r)), two = pow(3, tr_random_uniform(&r)),
               angle = 2 * M_PI * tr_random_uniform(&r);
        if (i < 4) one = two = 1 + i; /* equal sizes too */
        b->R1[i] = u.m * (swapped ? two : one), b->R2[i] = u.m * (swapped ? one : two);
        b->nx[i] = (swapped ? -1 : 1) * cos(angle), b->ny[i] = (swapped ? -1 : 1) * sin(angle);
        b->g1[i] = b->R1[i] / (b->R1[i] + b->R2[i]);
        bool sphere = shape == TR_SHAPE_SPHERE;
        double density = 10 * u.kg / (u.m * u.m * u.m), of_mass = sphere ? 0.4 : 0.5;
        b->m1[i] = density * b->R1[i] * b->R1[i] * (sphere ? b->R1[i] : 1);
        b->m2[i] = density * b->R2[i] * b->R2[i] * (sphere ? b->R2[i] : 1);
        double I1 = of_mass * b->m1[i] * b->R1[i] * b->R1[i], I2 = of_mass * b->m2[i] * b->R2[i] * b->R2[i];
        tr_pair_bodies bodies = {b->R1[i], b->R2[i], b->m1[i], b->m2[i], I1, I2, 0, 0, 0, false, 1, 1, 0, 0};
        for (int s = 0; s < 3; s++) {
            double constants[TR_MAX_PAIR];
            if (!b->law[s]->pair) continue;
            b->law[s]->pair(b->par[s], &bodies, constants);
            for (int k = 0; k < b->law[s]->n_pair; k++) b->pair[s][k][i] = constants[k];
        }
    }
}

static tr_law_data data_of(bench *b, int s) {
    for (int k = 0; k < TR_MAX_HIST; k++) b->hist_at[s][k] = b->hist[s][k];
    for (int k = 0; k < TR_MAX_PAIR; k++) b->pair_at[s][k] = b->pair[s][k];
    return (tr_law_data){.par = b->par[s],
                         .hist = b->hist_at[s],
                         .pair = b->pair_at[s],
                         .normal = b->law[0],
                         .normal_par = b->par[0],
                         .shape = b->shape};
}

/* The motion of one pair: overlap and its rate, velocity of 2 along t, spins; W: the observer turns with -W. */
typedef struct motion {
    double delta, v_n, Vt, w1, w2, W;
} motion;

static void drive(bench *b, int i, motion p) {
    tr_tile *t = &b->tile;
    double L = b->R1[i] + b->R2[i] - p.delta, Vt = p.Vt - p.W * L;
    t->dx[i] = L * b->nx[i], t->dy[i] = L * b->ny[i];
    t->dvx[i] = -p.v_n * b->nx[i] + Vt * b->ny[i], t->dvy[i] = -p.v_n * b->ny[i] - Vt * b->nx[i];
    t->w1[i] = p.w1 + p.W, t->w2[i] = p.w2 + p.W;
}

static void run(bench *b, double dt) {
    tr_tile *t = &b->tile;
    t->dt = dt;
    tr_kinematics_pair(t, NULL);
    for (int s = 0; s < 3; s++) {
        tr_law_data d = data_of(b, s);
        if (b->law[s]->needs & TR_NEEDS_V_R) {
            assert_string_equal(tr_rolling_velocities[0].name, "wang");
            tr_law_rolling_velocity(b->law[s], 0)(t, NULL);
        }
        if (b->law[s]->step) b->law[s]->step(t, &d);
    }
    (b->law[2]->needs & TR_GIVES_F_R ? tr_resultant_rolling_force : tr_resultant_full)(t, NULL);
}

/* ---- the path */

enum { LEGS = 10, PARTS = 60, STEPS = LEGS * PARTS };
static const double DT = 1e-5;

static motion on_path(const bench *b, int step, int i, double speed, double W) {
    static const double w1[LEGS] = {12, -25, 30, 14, -22, -31, 17, 11, -27, 19};
    static const double w2[LEGS] = {-20, 9, -13, 28, -33, 15, -26, 21, -8, 30};
    static const double Vt[LEGS] = {5, -12, 20, 0.3, -9, 15, -3, 10, 12, -7};
    int leg = step / PARTS, part = step % PARTS + 1;
    double R = fmin(b->R1[i], b->R2[i]), rate = (leg % 2 ? -0.01 : 0.01) / (PARTS * DT);
    double delta = 0.05 + (leg % 2 ? 0.01 : 0) + rate * part * DT;
    speed /= b->u.s;
    return (motion){R * delta,       speed * R * rate, speed * b->u.m * Vt[leg],
                    speed * w1[leg], speed * w2[leg],  W / b->u.s};
}

/* What the bodies feel at each step: force on 2 and both torques, in SI. */
typedef struct felt {
    double fx[STEPS][TR_TILE], fy[STEPS][TR_TILE], q1[STEPS][TR_TILE], q2[STEPS][TR_TILE];
} felt;

static felt F, G;

static void record(const bench *b, int step, felt *f) {
    const tr_dim of_force = TR_DIM_FORCE;
    double force = power(b->u, tr_dim_of(of_force, b->shape)), torque = force * b->u.m;
    for (int i = 0; i < TR_TILE; i++) {
        f->fx[step][i] = b->tile.fx[i] / force, f->fy[step][i] = b->tile.fy[i] / force;
        f->q1[step][i] = b->tile.q1[i] / torque, f->q2[step][i] = b->tile.q2[i] / torque;
    }
}

static void walk_thread(bench *b, int from, int to, double speed, double W, felt *f) {
    for (int step = from; step < to; step++) {
        for (int i = 0; i < TR_TILE; i++) drive(b, i, on_path(b, step, i, speed, W));
        run(b, DT * b->u.s / speed);
        record(b, step, f);
    }
}

static void walk(bench *b, double speed, double W, felt *f) {
    walk_thread(b, 0, STEPS, speed, W, f);
}

typedef double table[STEPS][TR_TILE];

static double largest(table x) {
    double m = 0;
    for (int s = 0; s < STEPS; s++)
        for (int i = 0; i < TR_TILE; i++) m = fmax(m, fabs(x[s][i]));
    return m;
}

static double gap(table x, table y, double sign) {
    double m = 0;
    for (int s = 0; s < STEPS; s++)
        for (int i = 0; i < TR_TILE; i++) {
            assert_true(isfinite(x[s][i]) && isfinite(y[s][i]));
            m = fmax(m, fabs(x[s][i] - sign * y[s][i]));
        }
    return m;
}

/* Largest difference over the largest value, of the torques if there are any and of the forces. */
static double difference(felt *f, felt *g) {
    double force = fmax(gap(f->fx, g->fx, 1), gap(f->fy, g->fy, 1)) / largest(f->fx);
    double q = fmax(largest(f->q1), largest(f->q2)), torque = fmax(gap(f->q1, g->q1, 1), gap(f->q2, g->q2, 1));
    return fmax(force, q > 0 ? torque / q : torque);
}

static const units SI = {1, 1, 1};

typedef void with_law(int slot, const tr_law *law);

static void for_its_shapes(with_law *check, int slot, const tr_law *law) {
    judged[0] = law;
    for (int d = 0; d <= (law->table.driver_choice != NULL); d++) {
        driver = d;
        shape = TR_SHAPE_DISK;
        if (!(law->table.demands & TR_ONLY_SPHERES)) check(slot, law);
        shape = TR_SHAPE_SPHERE;
        if (!(law->table.demands & TR_ONLY_DISKS)) check(slot, law);
    }
    judged[0] = NULL;
}

static void for_all_laws(with_law *check) {
    const tr_param_catalog *c = tr_laws_catalog();
    for (int i = 0; i < c->n_normal; i++) for_its_shapes(check, 0, tr_laws_normal[i]);
    for (int i = 0; i < c->n_friction; i++) for_its_shapes(check, 1, tr_laws_friction[i]);
    for (int i = 0; i < c->n_rolling; i++) for_its_shapes(check, 2, tr_laws_rolling[i]);
    for_its_shapes(check, 2, &tr_law_template);
}

/* violation: relative. Far below `small` where claimed, far above where not. */
static void judge(const tr_law *law, unsigned claim, const char *what, double violation) {
    const double small = 1e-9, seen = 1e-4;
    bool claimed = tr_law_claims(law) & claim;
    if (!claimed) print_message("%s is not %s: %.2g\n", law->table.name, what, violation);
    if (claimed && !(violation <= small)) fail_msg("%s is not %s: %g", law->table.name, what, violation);
    if (!claimed && !(violation > seen))
        fail_msg("%s is %s but does not claim it: %g", law->table.name, what, violation);
}

/* ---- rate independence: half the time step at twice the speed. A law that depends on the rate need not show it at the
 * first speed: a dashpot may be at its bound all the way. It has slower walks. */

static double of_rate(int slot, const tr_law *law, double speed) {
    set_up(&A, slot, law, false, SI), set_up(&B, slot, law, false, SI);
    walk(&A, speed, 0, &F), walk(&B, 2 * speed, 0, &G);
    return difference(&F, &G);
}

static void rate(int slot, const tr_law *law) {
    double worst = of_rate(slot, law, 1);
    for (double speed = 0.1; speed > 1e-7 && !(tr_law_claims(law) & TR_RATE_INDEPENDENT); speed *= 0.1)
        worst = fmax(worst, of_rate(slot, law, speed));
    judge(law, TR_RATE_INDEPENDENT, "rate-independent", worst);
}

static void test_rate(void **state) {
    (void)state, for_all_laws(rate);
}

/* ---- objectivity: an observer who turns; a pair that turns as a rigid body */

static void objective(int slot, const tr_law *law) {
    double worst = 0;
    static const double W[] = {3, -50};
    set_up(&A, slot, law, false, SI);
    walk(&A, 1, 0, &F);
    for (int k = 0; k < 2; k++) {
        set_up(&B, slot, law, false, SI);
        walk(&B, 1, W[k], &G);
        worst = fmax(worst, difference(&F, &G));
        /* rigid rotation: nothing but the normal force, which the bodies' distance gives */
        set_up(&B, slot, law, false, SI);
        for (int step = 0; step < PARTS; step++) {
            for (int i = 0; i < TR_TILE; i++) drive(&B, i, (motion){.delta = 0.05 * fmin(B.R1[i], B.R2[i]), .W = W[k]});
            run(&B, DT);
            double q = fmax(largest(F.q1), largest(F.q2)), f = largest(F.fx);
            for (int i = 0; i < TR_TILE; i++) {
                double along = B.tile.fx[i] * B.ny[i] - B.tile.fy[i] * B.nx[i];
                worst = fmax(worst, fabs(along) / f);
                if (q > 0) worst = fmax(worst, fmax(fabs(B.tile.q1[i]), fabs(B.tile.q2[i])) / q);
                assert_true(q > 0 || (B.tile.q1[i] == 0 && B.tile.q2[i] == 0));
            }
        }
    }
    judge(law, TR_OBJECTIVE, "objective", worst);
}

static void test_objectivity(void **state) {
    (void)state, for_all_laws(objective);
}

/* ---- balance: q1 + q2 + X21 x f = 0 */

static void balanced(int slot, const tr_law *law) {
    double worst = 0, scale = 0;
    set_up(&A, slot, law, false, SI);
    for (int step = 0; step < STEPS; step++) {
        walk_thread(&A, step, step + 1, 1, 0, &F);
        const tr_tile *t = &A.tile;
        for (int i = 0; i < TR_TILE; i++) {
            double couple = t->dx[i] * t->fy[i] - t->dy[i] * t->fx[i];
            worst = fmax(worst, fabs(t->q1[i] + t->q2[i] + couple));
            scale = fmax(scale, fabs(t->q1[i]) + fabs(t->q2[i]));
        }
    }
    /* without torques: the rounding of a central force */
    judge(law, TR_BALANCED, "balanced", worst / (scale > 0 ? scale : largest(F.fx)));
}

static void test_balance(void **state) {
    (void)state, for_all_laws(balanced);
}

/* ---- closed cycles: +x, +y, -x, -y for any two of: 2 along t, spin of 1, spin of 2, overlap */

enum { COORDINATES = 4, MANY = 200 };

/* Work of the contact on the bodies over the cycle, of the size of all work that went either way: the largest lane. */
static double cycle_gain(bench *b, int x, int y, double ax, double ay) {
    const double dt = DT;
    double work[TR_TILE] = {0}, turned[TR_TILE] = {0}, delta[TR_TILE], before[TR_TILE][4] = {{0}};
    for (int i = 0; i < TR_TILE; i++) delta[i] = 0.05 * fmin(b->R1[i], b->R2[i]);
    for (int step = -1; step < 4 * MANY; step++) {
        int leg = step < 0 ? 0 : step / MANY, which = leg % 2 ? y : x;
        double amplitude = (leg % 2 ? ay : ax) * (leg < 2 ? 1 : -1);
        for (int i = 0; i < TR_TILE; i++) {
            double rate[COORDINATES] = {0}, R = fmin(b->R1[i], b->R2[i]);
            if (step >= 0) rate[which] = amplitude / (MANY * dt) * (which == 0 || which == 3 ? R : 1);
            delta[i] += rate[3] * dt;
            drive(b, i, (motion){delta[i], rate[3], rate[0], rate[1], rate[2], 0});
        }
        run(b, step < 0 ? 0 : dt);
        const tr_tile *t = &b->tile;
        for (int i = 0; i < TR_TILE; i++) {
            double now[4] = {t->fx[i], t->fy[i], t->q1[i], t->q2[i]};
            double v[4] = {t->dvx[i], t->dvy[i], t->w1[i], t->w2[i]}, gain = 0;
            for (int k = 0; k < 4; k++) gain += 0.5 * (before[i][k] + now[k]) * v[k] * dt, before[i][k] = now[k];
            if (step >= 0) work[i] += gain, turned[i] += fabs(gain);
        }
    }
    double most = 0; /* works are 0.1 to 1e5 J per m, their rounding 1e-12 */
    for (int i = 0; i < TR_TILE; i++) most = fmax(most, work[i] / (turned[i] + 0.01));
    return most;
}

static void closed(int slot, const tr_law *law) {
    static const double amplitude[] = {0.002, 0.005, 0.05}; /* below the bounds, at some, beyond all */
    double worst = 0;
    for (int x = 0; x < COORDINATES; x++)
        for (int y = 0; y < COORDINATES; y++)
            for (int sign = 0; sign < 4 && x != y; sign++)
                for (int k = 0; k < 3; k++) {
                    double ax = amplitude[k] * (sign & 1 ? -1 : 1), ay = amplitude[k] * (sign & 2 ? -1 : 1);
                    if (x == 3) ax = sign & 1 ? -0.03 : 0.03;
                    if (y == 3) ay = sign & 2 ? -0.03 : 0.03;
                    set_up(&A, slot, law, false, SI);
                    worst = fmax(worst, cycle_gain(&A, x, y, ax, ay));
                }
    judge(law, TR_ENERGY_CLOSED, "energy-closed", worst);
}

static void test_closed_cycles(void **state) {
    (void)state, for_all_laws(closed);
}

/* ---- what holds for all */

/* Bodies swapped: the same forces on the same bodies. */
static void swap(int slot, const tr_law *law) {
    set_up(&A, slot, law, false, SI), set_up(&B, slot, law, true, SI);
    for (int step = 0; step < STEPS; step++) {
        for (int i = 0; i < TR_TILE; i++) {
            motion p = on_path(&A, step, i, 1, 0), q = p;
            q.w1 = p.w2, q.w2 = p.w1; /* n and t turn round with the pair, so do velocities of 2 against 1 */
            drive(&A, i, p), drive(&B, i, q);
        }
        run(&A, DT), run(&B, DT);
        record(&A, step, &F), record(&B, step, &G);
    }
    double f = largest(F.fx), q = fmax(largest(F.q1), largest(F.q2));
    assert_close(gap(F.fx, G.fx, -1), 0, 0, 1e-12 * f);
    assert_close(gap(F.fy, G.fy, -1), 0, 0, 1e-12 * f);
    assert_close(gap(F.q1, G.q2, 1), 0, 0, 1e-12 * q);
    assert_close(gap(F.q2, G.q1, 1), 0, 0, 1e-12 * q);
}

static void test_swap(void **state) {
    (void)state, for_all_laws(swap);
}

static void bounds(int slot, const tr_law *law) {
    if (!law->step || slot == 0) return;
    tr_random r = tr_random_seed(3, 1);
    tr_lane energy, bound;
    int at = 0;
    set_up(&A, slot, law, false, SI);
    A.tile.n = driver ? 8 : TR_TILE;
    for (int step = 0; step < 2000; step++) {
        for (int i = 0; i < TR_TILE; i++) {
            double u = pow(10, 6 * tr_random_uniform(&r) - 3);
            drive(&A, i,
                  (motion){0.1 * tr_random_uniform(&r) - 0.02, 0, u * (tr_random_uniform(&r) - 0.5),
                           u * (tr_random_uniform(&r) - 0.5), u * (tr_random_uniform(&r) - 0.5), 0});
        }
        run(&A, step % 100 ? DT : 0);
        tr_law_data d = data_of(&A, slot);
        law->state(&A.tile, &d, energy, bound);
        for (int i = 0; i < A.tile.n; i++) {
            double x = slot == 1 ? fabs(A.tile.f_t[i]) : fmax(fabs(A.tile.m1[i]), fabs(A.tile.m2[i]));
            assert_true(x <= bound[i] * (1 + 4e-16) && energy[i] >= 0 &&
                        isfinite(energy[i])); /* the bound's rounding */
            assert_true(A.tile.f_n[i] > 0 || (x == 0 && energy[i] == 0));
            at += x > 0 && x >= bound[i] * (1 - 1e-15);
            for (int k = 0; k < law->n_hist; k++) assert_true(A.tile.f_n[i] > 0 || A.hist[slot][k][i] == 0);
        }
    }
    assert_true(at * TR_TILE > 1000 * A.tile.n); /* the same share, however many lanes */
}

static void test_bounds(void **state) {
    (void)state, for_all_laws(bounds);
}

/* Far beyond full slip friction is mu P: with a dashpot that doubles the normal force, P is what TR_ELASTIC_P says. */
static void dashpot(int slot, const tr_law *law) {
    if (!law->step || slot != 1) return;
    set_up(&A, slot, law, false, SI);
    for (int i = 0; i < TR_TILE; i++) drive(&A, i, (motion){.delta = 0.05, .Vt = 1e9});
    run(&A, DT);
    tr_law_data d = data_of(&A, slot);
    for (int i = 0; i < A.tile.n; i++) A.tile.f_n[i] = 2 * A.tile.f_elastic[i];
    law->step(&A.tile, &d);
    for (int i = 0; i < A.tile.n; i++)
        assert_close(A.tile.f_t[i],
                     *tr_law_value(law, A.par[1], "mu") * A.tile.f_elastic[i] * (law->needs & TR_ELASTIC_P ? 1 : 2),
                     1e-12, 0);
}

static void test_dashpot(void **state) {
    (void)state, for_all_laws(dashpot);
}

/* An opening between two walks: the second is the first, bit by bit. Histories copied in mid-path to another bench: it
 * goes on as if it had been there. A look with dt = 0 finds the forces of the step and changes nothing. */
static void memory(int slot, const tr_law *law) {
    set_up(&A, slot, law, false, SI);
    walk(&A, 1, 0, &F);
    for (int i = 0; i < TR_TILE; i++) drive(&A, i, (motion){.delta = -0.01, .Vt = 5, .w1 = 3});
    run(&A, DT);
    walk(&A, 1, 0, &G);
    assert_memory_equal(&F, &G, sizeof F);
    int half = STEPS / 2 + 7;
    set_up(&A, slot, law, false, SI), set_up(&B, slot, law, false, SI);
    walk_thread(&A, 0, half, 1, 0, &G);
    run(&A, 0);
    record(&A, half - 1, &G);
    memcpy(B.hist, A.hist, sizeof A.hist);
    walk_thread(&B, half, STEPS, 1, 0, &G);
    assert_memory_equal(&F, &G, sizeof F);
}

static void test_memory(void **state) {
    (void)state, for_all_laws(memory);
}

/* Other units: powers of two whose roots are, so every number is the same but for its exponent. */
static void rescale(int slot, const tr_law *law) {
    set_up(&A, slot, law, false, SI), set_up(&B, slot, law, false, (units){64, 4, 2});
    walk(&A, 1, 0, &F), walk(&B, 1, 0, &G);
    assert_close(difference(&F, &G), 0, 0, 1e-14);
}

static void test_units(void **state) {
    (void)state, for_all_laws(rescale);
}

/* Each law does something on the path, and each claim is denied by someone. */
static unsigned denied;
static void acts(int slot, const tr_law *law) {
    set_up(&A, slot, law, false, SI);
    walk(&A, 1, 0, &F);
    assert_true(slot == 0 || (largest(F.q1) > 0 && largest(F.q2) > 0) == (law->step != NULL));
    denied |= ~tr_law_claims(law);
}

static void test_the_test_sees_something(void **state) {
    (void)state, for_all_laws(acts);
    unsigned all = TR_RATE_INDEPENDENT | TR_OBJECTIVE | TR_BALANCED | TR_ENERGY_CLOSED;
    assert_int_equal(denied & all, all);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        law_test(test_rate),    law_test(test_objectivity),
        law_test(test_balance), law_test(test_closed_cycles),
        law_test(test_swap),    law_test(test_bounds),
        law_test(test_dashpot), law_test(test_memory),
        law_test(test_units),   law_test(test_the_test_sees_something),
    };
    return cmocka_run_group_tests_name("claims", tests, NULL, NULL);
}
