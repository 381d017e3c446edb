/* SPDX-License-Identifier: MIT */
/* Arms of a contact: what each row of the table claims, against rigid motions, lengths and power worked out here; what
 * a world does with the arms of a scene: momentum, power and the energy ledger. */
#include "core/ledger.h"
#include "core/worlds.h"

typedef struct bench {
    tr_tile tile;
    double R1[TR_TILE], R2[TR_TILE], g1[TR_TILE];
} bench;

static bench B;

static double in(tr_random *r, double low, double high) {
    return low + (high - low) * tr_random_uniform(r);
}

/* Radii from 0.3 to 3, overlaps from 1 % to 10 % of the smaller. L is kept in dx before kinematics of walls. */
static void throw_motions(tr_random *r, bool wall) {
    tr_tile *t = &B.tile;
    memset(&B, 0, sizeof B);
    t->n = TR_TILE, t->R1 = B.R1, t->R2 = B.R2, t->g1 = B.g1;
    for (int i = 0; i < t->n; i++) {
        double R1 = pow(10, in(r, -0.5, 0.5)), R2 = pow(10, in(r, -0.5, 0.5)), angle = in(r, 0, 2 * M_PI);
        double L = (wall ? R2 : R1 + R2) - in(r, 0.01, 0.1) * fmin(R1, R2);
        B.R1[i] = wall ? 0 : R1, B.R2[i] = R2, B.g1[i] = wall ? 1 : R1 / (R1 + R2);
        t->nx[i] = cos(angle), t->ny[i] = sin(angle);
        t->dx[i] = wall ? L : L * t->nx[i], t->dy[i] = L * t->ny[i];
        t->dvx[i] = in(r, -1, 1), t->dvy[i] = in(r, -1, 1), t->w1[i] = wall ? 0 : in(r, -1, 1), t->w2[i] = in(r, -1, 1);
    }
}

static const tr_velocity_measure *sliding(const tr_arms *arms) {
    for (int k = 0; k < tr_n_sliding_measures; k++)
        if (!strcmp(tr_sliding_velocities[k].name, arms->sliding)) return &tr_sliding_velocities[k];
    fail_msg("%s: no sliding velocity is called %s", arms->name, arms->sliding);
    return NULL;
}

/* Its velocity into v_s and its arms into r1, r2. */
static void measure(const tr_arms *arms, bool wall) {
    (wall ? tr_kinematics_wall : tr_kinematics_pair)(&B.tile, NULL);
    sliding(arms)->step(&B.tile, NULL);
    arms->arms(&B.tile, NULL);
}

/* The most that arms miss of what they may claim: of a rigid rotation by 2 what it slides, what r1 + r2 lacks of |X21|,
 * power of a unit force less the sliding velocity. */
static void misses(const tr_arms *arms, double *rigid, double *length, double *power) {
    tr_random r = tr_random_seed(9, 1);
    for (int round = 0; round < 5; round++) {
        throw_motions(&r, false), measure(arms, false);
        bench before = B;
        for (int i = 0; i < B.tile.n; i++) {
            double L = hypot(B.tile.dx[i], B.tile.dy[i]);
            double Vt = B.tile.dvx[i] * B.tile.dy[i] / L - B.tile.dvy[i] * B.tile.dx[i] / L;
            *length = fmax(*length, fabs(B.tile.r1[i] + B.tile.r2[i] - L));
            *power = fmax(*power, fabs(Vt + B.tile.r1[i] * B.tile.w1[i] + B.tile.r2[i] * B.tile.w2[i] - B.tile.v_s[i]));
            B.tile.dvx[i] -= 2 * B.tile.dy[i], B.tile.dvy[i] += 2 * B.tile.dx[i];
            B.tile.w1[i] += 2, B.tile.w2[i] += 2;
        }
        measure(arms, false);
        for (int i = 0; i < B.tile.n; i++) *rigid = fmax(*rigid, fabs(B.tile.v_s[i] - before.tile.v_s[i]));
    }
}

static void judge(const tr_arms *arms, unsigned claim, const char *what, double off) {
    /* rounding of lengths up to 6 and velocities up to 20; without the claim off by the overlap, above 3e-3 */
    bool claims = arms->claims & claim;
    if (claims ? off > 1e-13 : off < 1e-3) fail_msg("%s %s, and is off by %g", arms->name, what, off);
}

static void every_row_is_what_it_claims(void **state) {
    (void)state;
    for (int k = 0; k < tr_n_arms_measured; k++) {
        const tr_arms *arms = &tr_arms_rows[k];
        double rigid = 0, length = 0, power = 0;
        misses(arms, &rigid, &length, &power);
        judge(arms, TR_ARMS_OBJECTIVE, "is objective or not", rigid);
        judge(arms, TR_ARMS_BALANCED, "is balanced or not", length);
        judge(arms, TR_ARMS_CONJUGATE, "is conjugate or not", power);
        if (k < tr_n_arms) assert_int_equal(arms->claims, 7);
    }
}

/* R_i - delta/2, at a wall R2 - delta: the sliding velocity of the rims there, from the pass of a scene. */
static void midpoint_arms_end_in_the_middle_of_the_overlap(void **state) {
    (void)state;
    tr_random r = tr_random_seed(10, 1);
    const tr_arms *midpoint = &tr_arms_rows[1];
    assert_string_equal(midpoint->name, "midpoint");
    for (int wall = 0; wall < 2; wall++) {
        throw_motions(&r, wall);
        double L[TR_TILE];
        for (int i = 0; i < B.tile.n; i++) L[i] = hypot(B.tile.dx[i], B.tile.dy[i] * !wall);
        (wall ? midpoint->wall : midpoint->pair)(&B.tile, NULL);
        for (int i = 0; i < B.tile.n; i++) {
            const tr_tile *t = &B.tile;
            double overlap = B.R1[i] + B.R2[i] - L[i], r1 = wall ? 0 : B.R1[i] - overlap / 2;
            double r2 = wall ? L[i] : B.R2[i] - overlap / 2, Vt = t->dvx[i] * t->ny[i] - t->dvy[i] * t->nx[i];
            assert_close(t->r1[i], r1, 1e-14, 0); /* three roundings of a radius */
            assert_close(t->r2[i], r2, 2e-14, 0);
            assert_close(t->v_s[i], Vt + r1 * t->w1[i] + r2 * t->w2[i], 0, 1e-14 * 20);
        }
        tr_lane by_kinematics;
        memcpy(by_kinematics, B.tile.v_s, sizeof by_kinematics);
        sliding(midpoint)->step(&B.tile, NULL);
        for (int i = 0; i < B.tile.n; i++) assert_close(B.tile.v_s[i], by_kinematics[i], 0, 1e-14 * 20);
        const tr_tile t = B.tile; /* and the others see the same contact, whichever arms kinematics had */
        for (int k = 0; k < tr_n_sliding_measures; k++) {
            B.tile = t;
            tr_sliding_velocities[k].step(&B.tile, NULL);
            memcpy(by_kinematics, B.tile.v_s, sizeof by_kinematics);
            (wall ? tr_kinematics_wall : tr_kinematics_pair)(&B.tile, NULL);
            tr_sliding_velocities[k].step(&B.tile, NULL);
            for (int i = 0; i < B.tile.n; i++) assert_close(B.tile.v_s[i], by_kinematics[i], 0, 1e-14 * 20);
        }
    }
}

/* ---- a pair and a disk on a wall, with friction and conjugate-spring of bagi-kuhn */

static void set_conjugate_laws(tr_world *w, const char *arms, double mu_r) {
    test_laws p = {1e6, 0, 100, 1e5, 0, 0, "bagi-kuhn", arms};
    tr_scene_contact c = contact_of(p);
    tr_status st = {0};
    c.rolling = law_named(tr_laws_rolling, tr_laws_catalog()->n_rolling, "conjugate-spring");
    set_parameter(&c.rolling, tr_laws_catalog()->rolling[c.rolling.law], "mu_r", mu_r);
    set_parameter(&c.rolling, tr_laws_catalog()->rolling[c.rolling.law], "k_r", 2e5);
    if (!tr_world_set_laws(w, &c, false, TR_SINK_LEDGER, &st)) fail_msg("%s", st.text);
}

/* Body 1: a disk of R1, or with R1 = 0 a floor. Overlap: a tenth of R2. */
static void put_pair(tr_world *w, double R1, const char *arms, double mu_r) {
    const double R2 = 0.01, distance = R1 + 0.9 * R2;
    int last = R1 > 0;
    new_world(w, last + 1);
    if (last) tr_world_set_disk(w, 0, &(tr_disk_start){0, 0, 0, R1, 1000, false}), set_velocity(w, 0, 0.1, 0.2, 30);
    tr_world_set_disk(w, last,
                      &(tr_disk_start){last ? 0.6 * distance : 0, (last ? 0.8 : 1) * distance, 0, R2, 1000, false});
    set_velocity(w, last, -0.4, 0.3, -70);
    if (!last) w->wall[0] = (tr_wall){.ny = 1}, w->n_walls = 1;
    set_conjugate_laws(w, arms, mu_r);
    w->dt = 1e-6, w->allow_unstable = true;
}

/* One step from rest: Q = k_t Vs dt, T = k_r V_r dt, by the velocities of the rims at the arms. The power of all forces
 * on the disks is f_n v_n - Q Vs - T V_r. */
static void the_power_of_forces_and_torques_is_that_of_the_springs(void **state) {
    (void)state;
    for (int wall = 0; wall < 2; wall++)
        for (int a = 0; a < tr_n_arms; a++) {
            double R1 = wall ? 0 : 0.03, R2 = 0.01, L = R1 + 0.9 * R2, overlap = 0.1 * R2;
            tr_world w;
            put_pair(&w, R1, tr_arms_rows[a].name, 100);
            forces(&w), forces(&w); /* the first has dt = 0 */
            double r1 = a ? R1 - overlap / 2 : R1 * L / (R1 + R2), r2 = a ? R2 - overlap / 2 : R2 * L / (R1 + R2);
            if (wall) r1 = 0, r2 = a ? R2 - overlap : R2;
            double nx = wall ? 0 : 0.6, ny = wall ? 1 : 0.8, dvx = -0.4 - 0.1 * !wall, dvy = 0.3 - 0.2 * !wall;
            double Vt = dvx * ny - dvy * nx, w1 = wall ? 0 : 30, w2 = -70, Vs = Vt + r1 * w1 + r2 * w2;
            double s1 = wall ? Vt : R1 * (w1 + Vt / L), s2 = wall ? -R2 * w2 : -R2 * (w2 + Vt / L), Vr = (s1 + s2) / 2;
            double wanted = 1e6 * overlap * (dvx * nx + dvy * ny) - 1e5 * Vs * Vs * w.dt - 2e5 * Vr * Vr * w.dt;
            double power = 0, scale = 0, turn = 0;
            for (int i = 0; i < 4 * w.disks.n; i++)
                power += w.disks.force[i] * w.disks.vel[i], scale += fabs(w.disks.force[i] * w.disks.vel[i]);
            assert_close(power, wanted, 0, 1e-13 * scale); /* a dozen roundings; arms move it by 0.01 of the springs */
            if (!(fabs(wanted) > 1e-3 * scale)) fail_msg("%g of %g", wanted, scale);
            if (!wall) {
                const double *x = w.disks.pos + 4, *f = w.disks.force;
                turn = x[0] * f[5] - x[1] * f[4] + f[2] + f[6]; /* body 1 is at the origin */
                assert_close(turn, 0, 0, 1e-14 * (fabs(f[2]) + fabs(f[6]) + hypot(x[0], x[1]) * hypot(f[4], f[5])));
            }
            tr_world_free(&w);
        }
}

/* A pair that sticks and swings for 4000 steps: springs hold what the disks lost, and no contact makes energy. The
 * couple of the rolling spring is booked by its own arms: with those of friction it would make 1e-5 of the work. */
static void the_ledger_closes_with_all_arms(void **state) {
    (void)state;
    for (int wall = 0; wall < 2; wall++)
        for (int a = 0; a < tr_n_arms; a++) {
            double off[2], made = 0, moved = 0;
            for (int k = 0; k < 2; k++) { /* dt, and half of it */
                tr_world w;
                put_pair(&w, wall ? 0 : 0.03, tr_arms_rows[a].name, 100);
                w.dt = 2e-6 / (k + 1);
                forces(&w), tr_ledger_begin(&w);
                double start = tr_ledger_read(&w).kinetic;
                tr_step_advance(&w);
                for (int n = 1; n < 300 * (k + 1); n++) steps(&w, 1);
                forces(&w);
                tr_energy e = tr_ledger_read(&w);
                off[k] = fabs(e.residual) / start, made = e.made[TR_ROLLING] / start;
                moved = (e.elastic_friction + e.elastic_rolling) / start;
                assert_true(w.contact_updates >= 300 * (k + 1)); /* touches all the time */
                tr_world_free(&w);
            }
            assert_true(moved > 1e-3);
            assert_true(off[0] < 1e-3);
            assert_true(off[1] < 0.6 * off[0] + 1e-12); /* of first order in dt: the velocities of the start are half a
                                                           step late; half, and second order */
            assert_true(made < 1e-12);                  /* sums of 600 roundings */
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_row_is_what_it_claims),
        cmocka_unit_test(midpoint_arms_end_in_the_middle_of_the_overlap),
        cmocka_unit_test(the_power_of_forces_and_torques_is_that_of_the_springs),
        cmocka_unit_test(the_ledger_closes_with_all_arms),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
