/* SPDX-License-Identifier: MIT */
/* Disks inside of rings, against rigid-body motion and closed forms that know no signed radius. */
#include "base/checkpoint.h"
#include "core/bodies.h"
#include "core/checkpoint.h"
#include "core/ledger.h"
#include "core/record.h"
#include "core/worlds.h"
#include "laws/law.h"
#include "scene/scene.h"
#include <unistd.h>

static const double G = 9.81;

typedef struct show {
    tr_scene scene;
    tr_bodies b;
} show;

static void start_text(show *s, const char *text) {
    tr_status st = {0};
    if (!tr_scene_read(&s->scene, &(tr_scene_source){"case", text, strlen(text), NULL, 0}, tr_laws_catalog(), &st) ||
        !tr_bodies_init(&s->b, &s->scene, &st))
        fail_msg("%s", st.text);
}

static void go(show *s) {
    tr_bodies_advance(&s->b);
    forces(&s->b.world);
}

static void end(show *s) {
    tr_bodies_free(&s->b);
    tr_scene_free(&s->scene);
}

static const double *at(const show *s, int i) {
    return s->b.world.disks.pos + 4 * (size_t)i;
}
static double velocity(const show *s, int i, int lane) {
    double v[3];
    tr_bodies_velocity(&s->b.world, i, v);
    return v[lane];
}
static double now(const show *s) {
    return (double)s->b.world.steps * s->b.world.dt;
}

/* ---- measures */

/* A ring (0) and a disk that touches it (1), with any motion. */
static void two_bodies(tr_world *w, tr_random *random, double Rr, double R, double overlap) {
    tr_status st = {0};
    double angle = 6 * tr_random_uniform(random), apart = Rr - R + overlap;
    new_world(w, 2);
    tr_world_set_disk(w, 0, &(tr_disk_start){0.3, -0.2, 0, Rr, 1000, false});
    if (!tr_world_set_ring(w, 0, Rr, 1.1 * Rr, 1000, &st)) fail_msg("%s", st.text);
    tr_world_set_disk(w, 1, &(tr_disk_start){0.3 + apart * cos(angle), -0.2 + apart * sin(angle), 0, R, 1000, false});
    w->n_rings = 1;
    for (int i = 0; i < 2; i++)
        set_velocity(w, i, tr_random_uniform(random) - 0.5, tr_random_uniform(random) - 0.5,
                     4 * tr_random_uniform(random) - 2);
    set_laws(w, (test_laws){1e6, 0, 0.5, 5e5, 0.2, 5e5, "wang", NULL}, 0);
    w->dt = 1e-6, w->allow_unstable = true;
}

static tr_record record_of(tr_world *w) {
    tr_record *records = NULL, r;
    int capacity = 0;
    tr_status st = {0};
    forces(w);
    assert_int_equal(tr_record_all(w, &records, &capacity, &st), 1);
    r = records[0];
    free(records);
    return r;
}

static double by_name(const tr_record *r, const char *name, bool rolling) {
    const tr_velocity_measure *m = rolling ? tr_rolling_velocities : tr_sliding_velocities;
    for (int v = 0; v < (rolling ? tr_n_rolling_velocities : tr_n_sliding_velocities); v++)
        if (!strcmp(m[v].name, name)) return (rolling ? r->v_r_by : r->v_s_by)[v];
    fail_msg("%s", name);
    return 0;
}

/* Sliding: velocity of disk less ring in their common material point, along t. s1, s2: how fast the point goes around
 * each rim: from the rates of the angles, by which the line of centres turns (of the ring it runs with the disk's
 * place, of the disk on the side away from the ring's centre). Both rims run forward where the disk rolls around. */
static void measures_are_those_of_the_rims(void **state) {
    (void)state;
    tr_random random = tr_random_seed(5, 1);
    for (int k = 0; k < 200; k++) {
        tr_world w;
        double R = 0.02 + 0.05 * tr_random_uniform(&random), Rr = R + 0.001 + 0.2 * tr_random_uniform(&random);
        two_bodies(&w, &random, Rr, R, 1e-3 * R * (k % 2));
        if (k % 2 == 0)
            w.disks.pos[4] += 1e-12 * (w.disks.pos[4] - 0.3), w.disks.pos[5] += 1e-12 * (w.disks.pos[5] + 0.2);
        tr_record r = record_of(&w);
        const double *p = w.disks.pos, *q = p + 4, *v = w.disks.vel, *u = v + 4;
        double dx = q[0] - p[0], dy = q[1] - p[1], apart = hypot(dx, dy), out[] = {dx / apart, dy / apart};
        assert_close(r.nx, -out[0], 1e-12, 0);
        assert_close(r.ny, -out[1], 1e-12, 0);
        assert_close(r.delta, apart + R - Rr, 0, 1e-15);
        /* both arms end there: R_i/(R_r - R) of the distance of the centres */
        assert_close(r.x, p[0] + Rr / (Rr - R) * dx, 1e-12, 0);
        double tx = r.ny, ty = -r.nx, turn = (dx * (u[1] - v[1]) - dy * (u[0] - v[0])) / (apart * apart);
        double of_disk[] = {u[0] - u[2] * (r.y - q[1]), u[1] + u[2] * (r.x - q[0])};
        double of_ring[] = {v[0] - v[2] * (r.y - p[1]), v[1] + v[2] * (r.x - p[0])};
        assert_close(r.v_s, (of_disk[0] - of_ring[0]) * tx + (of_disk[1] - of_ring[1]) * ty, 1e-9, 1e-12);
        /* t is counter-clockwise in the ring where n points inward: the point runs over the ring at Rr (turn - w1),
         * over the disk at R (turn - w2) */
        assert_close(r.s1, Rr * (turn - v[2]), 1e-9, 1e-12);
        assert_close(r.s2, R * (turn - u[2]), 1e-9, 1e-12);
        double between = (Rr + R) / (2 * (Rr - R)) * (r.s1 - r.s2);
        assert_close(by_name(&r, "bagi-kuhn", true) - by_name(&r, "wang", true), between, 1e-9, 1e-11);
        assert_close(by_name(&r, "wang", true), Rr * R / (Rr - R) * (v[2] - u[2]), 1e-9, 1e-11);
        tr_world_free(&w);
    }
}

/* A motion as of one rigid body slides and rolls by no objective measure; a disk that rolls rolls alike by all, and
 * does not slide; one that slides around without turning against the line of centres does not roll by bagi-kuhn's. */
static void pure_motions(void **state) {
    (void)state;
    tr_random random = tr_random_seed(5, 2);
    for (int k = 0; k < 60; k++) {
        tr_world w;
        double Rr = 0.1, R = 0.02 + 0.07 * tr_random_uniform(&random), W = 1.5, spin = 2 * tr_random_uniform(&random);
        two_bodies(&w, &random, Rr, R, 1e-9);
        double *v = w.disks.vel, *u = v + 4, dx = w.disks.pos[4] - 0.3, dy = w.disks.pos[5] + 0.2;
        int kind = k % 3; /* rigid, rolling, sliding; seen by an observer who moves and turns at `spin` */
        double turn = kind ? W : 0, w2 = kind == 1 ? W - W * Rr / R : kind == 2 ? W + W * Rr / R : 0;
        v[2] = spin, u[2] = spin + w2;
        u[0] = v[0] - (spin + turn) * dy, u[1] = v[1] + (spin + turn) * dx;
        tr_record r = record_of(&w);
        for (int m = 0; m < tr_n_rolling_velocities; m++)
            if (kind < 2) assert_close(r.v_r_by[m], kind ? W * Rr : 0, 1e-6, 1e-9);
        assert_close(r.v_s, kind == 2 ? 2 * W * Rr : 0, 1e-6, 1e-7);
        if (kind == 2) assert_close(by_name(&r, "bagi-kuhn", true), 0, 0, 1e-9);
        tr_world_free(&w);
    }
}

/* ---- motion */

/* Swings of 0.02 rad: sqrt(1 + I/(m R^2)) times the pendulum of length R_r - R, whose period is 1 + p^2/16 = 1.000025
 * times that of small ones. The springs, without damping, swing too: 2e-3 is asked for. */
static void a_disk_swings_in_a_ring(void **state) {
    (void)state;
    static const struct {
        const char *shape;
        double factor;
    } rows[] = {{"disk", 1.5}, {"sphere", 1.4}};
    for (int k = 0; k < 2; k++) {
        char text[800];
        show s;
        snprintf(text, sizeof text,
                 "kind: bodies\nshape: %s\ntime_end: 3\ngravity: {y: -9.81}\ncontact: {k_n: %s, mu: 0.5, mu_r: 0}\n"
                 "disks:\n - {radius: 100 mm, ring: 5 mm, x: 0, y: 0, motion: prescribed}\n"
                 " - {radius: 20 mm, x: 80 mm*sin(0.02), y: -80 mm*cos(0.02)}\noutput: {frames: 0}\n",
                 rows[k].shape, k ? "2 MN/m" : "100 MPa");
        start_text(&s, text);
        double crossed[16], before = at(&s, 1)[0], T = 2 * M_PI * sqrt(rows[k].factor * 0.08 / G);
        int n = 0;
        while (n < 8) {
            double t0 = now(&s);
            go(&s);
            double x = at(&s, 1)[0];
            if ((before > 0) != (x > 0)) crossed[n++] = t0 + (now(&s) - t0) * before / (before - x);
            before = x;
        }
        assert_close((crossed[7] - crossed[1]) / 3, T, 2e-3, 0);
        end(&s);
    }
}

/* In a drum that turns, a disk with rolling resistance stays where its weight balances the moment: R Q = R_eff mu_r N
 * with R_eff = R_r R/(R_r - R), so tan(p) = mu_r R_r/(R_r - R); it spins at w R_r/R. It comes to rest there by damping
 * of the swing: none but in the rolling spring, which is at its cap; so it starts there. */
static void a_disk_leans_in_a_drum(void **state) {
    (void)state;
    char text[900];
    show s;
    const double mu_r = 0.1, p = atan(mu_r * 0.1 / 0.08), w = 3;
    double weight = 2700 * M_PI * 0.02 * 0.02 * G, apart = 0.08 + weight * cos(p) / 1e7;
    snprintf(text, sizeof text,
             "kind: bodies\ntime_end: 0.5\ngravity: {y: -9.81}\ncontact: {k_n: 10 MPa, mu: 0.5, mu_r: %g}\n"
             "disks:\n - {radius: 100 mm, ring: 5 mm, x: 0, y: 0, motion: prescribed, spin: %g}\n"
             " - {radius: 20 mm, x: %.17g, y: %.17g, spin: %g}\noutput: {frames: 0}\n",
             mu_r, w, apart * sin(p), -apart * cos(p), w * 5);
    start_text(&s, text);
    double sum = 0, spin = 0, n = 0;
    while (s.b.world.steps < s.b.steps) {
        go(&s);
        sum += atan2(at(&s, 1)[0], -at(&s, 1)[1]), spin += velocity(&s, 1, 2), n++;
    }
    assert_close(sum / n, p, 1e-2, 0); /* the springs are not loaded at the start: it swings by mu_r f_n/k_r */
    assert_close(spin / n, w * 5, 1e-3, 0);
    end(&s);
}

/* A sun that turns, planets, a ring that stands: the planets go around at w R_s/(2 (R_s + R_p)). */
static void planets_go_around(void **state) {
    (void)state;
    show s;
    const double w = 4, Rs = 0.03, Rp = 0.02, carrier = w * Rs / (2 * (Rs + Rp)), v = carrier * (Rs + Rp);
    char text[1600];
    int n = snprintf(text, sizeof text,
                     "kind: bodies\ntime_end: 2\ncontact: {k_n: 10 MPa, mu: 0.5, mu_r: 0, damping_ratio: 0.1}\n"
                     "disks:\n - {radius: 69.99 mm, ring: 5 mm, x: 0, y: 0, motion: prescribed}\n"
                     " - {radius: 30.01 mm, x: 0, y: 0, motion: prescribed, spin: %g}\n",
                     w);
    for (int k = 0; k < 3; k++) {
        double a = 2 * M_PI * k / 3;
        n += snprintf(text + n, sizeof text - (size_t)n,
                      " - {radius: 20 mm, x: %.17g, y: %.17g, vx: %.17g, vy: %.17g, spin: %.17g}\n", 0.05 * cos(a),
                      0.05 * sin(a), -v * sin(a), v * cos(a), -v / Rp);
    }
    start_text(&s, text);
    double before = 0, turned = 0;
    while (s.b.world.steps < s.b.steps) {
        go(&s);
        double angle = atan2(at(&s, 2)[1], at(&s, 2)[0]), step = angle - before;
        turned += step < -M_PI ? step + 2 * M_PI : step, before = angle;
    }
    /* radii in contact differ from the round ones by 1e-5/0.03 */
    assert_close(turned, carrier * now(&s), 1e-3, 0);
    assert_close(velocity(&s, 3, 2), -v / Rp, 1e-3, 0);
    end(&s);
}

/* A free ring and the disk that knocks about in it: momentum and angular momentum stay, to a rounding a step; so does
 * the energy that the ledger sums, to the second order of the step. */
static void momenta_and_energy_of_a_free_ring(void **state) {
    (void)state;
    double residual[2];
    for (int half = 0; half < 2; half++) {
        tr_world w;
        tr_random random = tr_random_seed(5, 3);
        two_bodies(&w, &random, 0.1, 0.03, -0.01);
        set_laws(&w, (test_laws){1e6, 0.1, 0.5, 5e5, 0.2, 5e5, "wang", NULL}, TR_SINK_LEDGER);
        w.dt = 1e-4 / (1 + half);
        double momentum[2][3];
        forces(&w);
        tr_ledger_begin(&w);
        for (int k = 0; k < 2; k++) {
            memset(momentum[k], 0, sizeof momentum[k]);
            for (int i = 0; i < 2; i++) {
                const double *q = w.disks.pos + 4 * i, *v = w.disks.vel + 4 * i;
                for (int axis = 0; axis < 2; axis++) momentum[k][axis] += w.disks.mass[i] * v[axis];
                momentum[k][2] += w.disks.mass[i] * (q[0] * v[1] - q[1] * v[0]) + w.disks.inertia[i] * v[2];
            }
            for (int step = 0; k == 0 && step < 20000 * (1 + half); step++) {
                tr_step_advance(&w);
                forces(&w);
            }
        }
        for (int axis = 0; axis < 3; axis++) assert_close(momentum[1][axis], momentum[0][axis], 0, 1e-11);
        tr_energy e = tr_ledger_read(&w);
        double scale = e.kinetic + e.damped + e.friction + e.rolling;
        assert_true(e.damped > 1e-3 * scale && e.friction > 1e-3 * scale && e.rolling > 1e-4 * scale);
        residual[half] = fabs(e.residual) / scale;
        assert_true(e.made[TR_ROLLING] < 1e-12 * scale && e.made[TR_FRICTION] < 1e-12 * scale);
        tr_world_free(&w);
    }
    assert_true(residual[0] < 1e-3);
    assert_true(residual[1] < residual[0] / 2);
}

/* The same with a rolling law that also pulls, and with either arms: angular momentum stays. */
static void a_force_of_rolling_in_a_ring_is_balanced(void **state) {
    (void)state;
    for (int k = 0; k < 2 * tr_n_arms; k++) {
        tr_world w;
        tr_random random = tr_random_seed(5, 4);
        tr_status st = {0};
        two_bodies(&w, &random, 0.1, 0.03, -0.01);
        tr_scene_contact laws =
            contact_of((test_laws){1e6, 0.1, 0.5, 5e5, 0.2, 5e5, k % 2 ? "bagi-kuhn" : "alonso-min", NULL});
        const tr_param_catalog *catalog = tr_laws_catalog();
        laws.rolling = law_named(tr_laws_rolling, catalog->n_rolling, "conjugate-spring");
        set_parameter(&laws.rolling, catalog->rolling[laws.rolling.law], "mu_r", 0.2);
        set_parameter(&laws.rolling, catalog->rolling[laws.rolling.law], "k_r", 5e5);
        laws.arms = k / 2;
        assert_true(tr_world_set_laws(&w, &laws, false, 0, &st));
        w.dt = 1e-5;
        double before = 0, after = 0, pulled = 0;
        forces(&w);
        for (int step = 0; step < 100000; step++) {
            after = 0;
            for (int i = 0; i < 2; i++) {
                const double *q = w.disks.pos + 4 * i, *v = w.disks.vel + 4 * i;
                after += w.disks.mass[i] * (q[0] * v[1] - q[1] * v[0]) + w.disks.inertia[i] * v[2];
            }
            if (step == 0) before = after;
            tr_record *r = NULL;
            int capacity = 0;
            if (step % 50 == 0 && tr_record_all(&w, &r, &capacity, &st)) pulled = fmax(pulled, fabs(r->f_r));
            free(r);
            tr_step_advance(&w);
            forces(&w);
        }
        assert_true(pulled > 0);
        assert_close(after, before, 0, 1e-11);
        tr_world_free(&w);
    }
}

/* ---- traps */

/* Hertz in a ring knows 1/R = 1/R2 - 1/Rr: the disk of radius R_r R/(R_r - R) on a wall. The default depth is that at a
 * wall. */
static void normal_laws_know_the_ring(void **state) {
    (void)state;
    const tr_param_catalog *catalog = tr_laws_catalog();
    for (int i = 0; i < catalog->n_normal; i++) {
        tr_scene_law law = {.law = i};
        const tr_law *row = tr_laws_normal[i];
        for (int p = 0; p < row->table.n; p++) *(double *)((char *)law.par + row->table.params[p].offset) = 0;
        double *E = tr_law_value(row, law.par, "E_star"), *d = tr_law_value(row, law.par, "depth");
        if (!E) continue;
        *E = 1e9;
        tr_elastic plain = row->elastic(law.par, -0.1, 0.02, 1e-5);
        assert_true(plain.force > 0 && isfinite(plain.force + plain.energy + plain.stiffness));
        if (d) *d = 0.03;
        tr_elastic ring = row->elastic(law.par, -0.1, 0.02, 1e-5), wall = row->elastic(law.par, 0, 0.025, 1e-5);
        assert_close(ring.force, wall.force, 1e-12, 0);
        assert_close(ring.energy, wall.energy, 1e-12, 0);
    }
    assert_close(tr_law_depth(0, -0.1, 0.02), 2 * 0.02 / M_E, 1e-15, 0);
}

/* A disk in the middle of a ring that nearly fills it is listed but has no normal: nothing is made of it. */
static void a_disk_in_the_middle_has_no_normal(void **state) {
    (void)state;
    show s;
    start_text(&s, "kind: bodies\ntime_end: 1e-3\ncontact: {k_n: 10 MPa, mu: 0.5, mu_r: 0.1}\n"
                   "disks: [{radius: 20.01 mm, ring: 1 mm, x: 1, y: 2, motion: prescribed, spin: 3}, "
                   "{radius: 20 mm, x: 1, y: 2, spin: 1}]\n");
    assert_int_equal(s.b.world.group[s.b.world.n_groups - 1].n, 1);
    while (s.b.world.steps < s.b.steps) go(&s);
    assert_true(at(&s, 1)[0] == 1 && at(&s, 1)[1] == 2 && velocity(&s, 1, 2) == 1);
    end(&s);
}

/* Every rolling law in a drum, with every definition: its moments oppose the drum, and nothing is lost to NaN. The
 * moments of a balanced law are opposite. A law of STAR's by each spin brakes the disk, whatever the sign of the arm.
 */
static void every_rolling_law_in_a_drum(void **state) {
    (void)state;
    const tr_param_catalog *c = tr_laws_catalog();
    for (int k = 0; k < c->n_rolling; k++) {
        if (!tr_laws_rolling[k]->step) continue;
        for (int v = 0; v < tr_n_rolling_velocities; v++) {
            char text[900];
            show s;
            snprintf(text, sizeof text,
                     "kind: bodies\ntime_end: 0.05\ngravity: {y: -9.81}\ncontact: {k_n: 10 MPa, mu: 0.5, mu_r: 0.1, "
                     "rolling: %s, rolling_velocity: %s}\n"
                     "disks:\n - {radius: 100 mm, ring: 5 mm, x: 0, y: 0, motion: prescribed, spin: 3}\n"
                     " - {radius: 20 mm, x: 0, y: -80.003 mm, spin: 15}\noutput: {frames: 0}\n",
                     tr_laws_rolling[k]->table.name, tr_rolling_velocities[v].name);
            start_text(&s, text);
            double most = 0, least = 0;
            while (s.b.world.steps < s.b.steps) {
                go(&s);
                tr_record *r = NULL;
                int capacity = 0;
                tr_status st = {0};
                int n = tr_record_all(&s.b.world, &r, &capacity, &st);
                if (n) {
                    most = fmax(most, r->m2), least = fmin(least, r->m2);
                    assert_true(isfinite(r->m1 + r->m2 + r->f_r + r->rolling_mobilisation));
                    assert_true(r->rolling_mobilisation <= 1 + 1e-9);
                    if (tr_laws_rolling[k]->claims & TR_BALANCED) assert_true(r->m1 == -r->m2);
                }
                free(r);
            }
            assert_true(least < 0 && least < -most); /* against its spin */
            end(&s);
        }
    }
}

static const char *const drum =
    "kind: bodies\ntime_end: 0.2\ngravity: {y: -9.81}\ncontact: {k_n: 1 MPa, mu: 0.5, mu_r: 0.1}\n"
    "disks:\n - {radius: 100 mm, ring: 5 mm, x: 0, y: 0, motion: prescribed, spin: 5}\n"
    " - {radius: 40 mm, ring: 2 mm, x: 1, y: 0, motion: prescribed, spin: -9}\n";

/* 60 disks in one drum, two in the other: with Box2D's tree as pair finder, and threads. */
static void start_drum(show *s, int threads) {
    char text[6000];
    int n = snprintf(text, sizeof text, "%s", drum);
    tr_status st = {0};
    for (int i = 0; i < 60; i++)
        n += snprintf(text + n, sizeof text - (size_t)n, " - {radius: %g mm, x: %g mm, y: %g mm}\n", 6 + 0.01 * i,
                      -56 + 16 * (i % 8) + 0.1 * (i % 3), -56 + 16.0 * (i / 8));
    snprintf(text + n, sizeof text - (size_t)n, " - {radius: 9 mm, x: 1, y: 0}\n - {radius: 9 mm, x: 1.02, y: 0}\n");
    start_text(s, text);
    s->b.world.alone_to = 0;
    if (!tr_world_set_threads(&s->b.world, threads, &st)) fail_msg("%s", st.text);
}

static void a_full_drum_goes_on_alike(void **state) {
    (void)state;
    char dir[] = "/tmp/trundle-ring-XXXXXX";
    show s, t, u;
    tr_checkpoint c;
    tr_status st = {0}, instead = {0};
    assert_non_null(mkdtemp(dir));
    start_drum(&s, 1), start_drum(&t, 3), start_drum(&u, 2);
    while (s.b.world.steps < s.b.steps / 2) go(&s);
    tr_bodies_advance(&s.b); /* forces are made anew, so a checkpoint is between a step and its forces */
    tr_checkpoint_begin(&c, "case", &st);
    tr_world_checkpoint(&s.b.world, &c);
    if (!tr_checkpoint_write(&c, dir, TR_CHECKPOINT)) fail_msg("%s", st.text);
    assert_true(tr_checkpoint_open(&c, dir, TR_CHECKPOINT, "case", &instead, &st));
    tr_world_checkpoint(&u.b.world, &c);
    if (!tr_checkpoint_close(&c)) fail_msg("%s", st.text);
    forces(&s.b.world), forces(&u.b.world);
    while (s.b.world.steps < s.b.steps) go(&s);
    while (t.b.world.steps < t.b.steps) go(&t);
    while (u.b.world.steps < u.b.steps) go(&u);
    assert_same_bits(&s.b.world, &t.b.world);
    assert_same_bits(&s.b.world, &u.b.world);
    for (int i = 2; i < 64; i++)
        assert_true(hypot(at(&s, i)[0] - (i > 61), at(&s, i)[1]) < (i > 61 ? 0.04 : 0.1) - 0.9 * at(&s, i)[3]);
    assert_true(s.b.world.group[0].n > 30);
    tr_checkpoint_remove(dir);
    rmdir(dir);
    end(&s), end(&t), end(&u);
}

static void what_is_in_no_ring_is_told_where(void **state) {
    (void)state;
    static const char *const rows[][2] = {
        {"{radius: 1, ring: 0.1, x: 0, y: 0}, {radius: 1, x: 0, y: 0}",
         "case:2:54: error: `disks.1` is as large as the ring"},
        {"{radius: 1, ring: 0.1, x: 0, y: 0}, {radius: 0.5, x: 0.7, y: 0}",
         "case:2:62: error: `disks.1` overlaps the ring `disks.0` by 0.2 m"},
        {"{radius: 1, ring: 0.1, x: 0, y: 0}, {radius: 0.5, x: 1.3, y: 0}",
         "case:2:62: error: `disks.1` lies across the ring"},
        {"{radius: 1, ring: 0.1, x: 0, y: 0}", "there are only rings"},
        {"{radius: 1, x: 0, y: 0}, {radius: 1, ring: 0.1, x: 3, y: 0}", "rings come first"},
        {"{radius: 1, ring: -0.1, x: 0, y: 0}", "`ring` is -0.1, allowed is 0 to 1000 m"},
        {"{radius: 1, ring: yes, x: 0, y: 0}", "unknown name `yes`"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char text[600];
        tr_scene scene;
        tr_status st = {0};
        snprintf(text, sizeof text, "kind: bodies\ndisks: [%s]\ntime_end: 1\ncontact: {k_n: 1e7, mu: 0, mu_r: 0}\n",
                 rows[i][0]);
        if (tr_scene_read(&scene, &(tr_scene_source){"case", text, strlen(text), NULL, 0}, tr_laws_catalog(), &st))
            fail_msg("%s", text);
        if (!strstr(st.text, rows[i][1])) fail_msg("no \"%s\" in: %s", rows[i][1], st.text);
    }
}

/* m = rho pi (b^2 - a^2), I = int r^2 dm, of a shell 2/3 int r^2 dm: by sums over thin hoops. */
static void the_inertia_of_a_ring_is_that_of_its_hoops(void **state) {
    (void)state;
    const double a = 0.1, b = 0.13, n = 20000;
    for (tr_shape shape = TR_SHAPE_DISK; shape <= TR_SHAPE_SPHERE; shape++) {
        tr_world w;
        tr_status st = {0};
        double m = 0, I = 0;
        new_world_of(&w, 1, shape);
        tr_world_set_disk(&w, 0, &(tr_disk_start){0, 0, 0, a, 1000, false});
        assert_true(tr_world_set_ring(&w, 0, a, b, 1000, &st));
        for (int i = 0; i < n; i++) {
            double r = a + (i + 0.5) * (b - a) / n, dr = (b - a) / n;
            double dm = 1000 * dr * (shape == TR_SHAPE_SPHERE ? 4 * M_PI * r * r : 2 * M_PI * r);
            m += dm, I += dm * r * r * (shape == TR_SHAPE_SPHERE ? 2.0 / 3 : 1);
        }
        assert_close(w.disks.mass[0], m, 1e-8, 0);
        assert_close(w.disks.inertia[0], I, 1e-8, 0);
        assert_close(w.disks.inv[0], 1 / m, 1e-8, 0);
        assert_close(w.disks.inv[2], 1 / I, 1e-8, 0);
        tr_world_free(&w);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(measures_are_those_of_the_rims),
        cmocka_unit_test(pure_motions),
        cmocka_unit_test(a_disk_swings_in_a_ring),
        cmocka_unit_test(a_disk_leans_in_a_drum),
        cmocka_unit_test(planets_go_around),
        cmocka_unit_test(momenta_and_energy_of_a_free_ring),
        cmocka_unit_test(a_force_of_rolling_in_a_ring_is_balanced),
        cmocka_unit_test(normal_laws_know_the_ring),
        cmocka_unit_test(a_disk_in_the_middle_has_no_normal),
        cmocka_unit_test(every_rolling_law_in_a_drum),
        cmocka_unit_test(a_full_drum_goes_on_alike),
        cmocka_unit_test(what_is_in_no_ring_is_told_where),
        cmocka_unit_test(the_inertia_of_a_ring_is_that_of_its_hoops),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
