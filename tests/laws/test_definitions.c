/* SPDX-License-Identifier: MIT */
/* The tables of rolling and sliding definitions, row by row: the derivatives against central differences, Euler's
 * theorem for what is homogeneous of degree 1, and what a row claims of observers. A new row is tested by standing
 * there. */
#include "assert_close.h"
#include "base/random.h"
#include "laws/kinematics.h"
#include "laws/law.h"

#include <string.h>

enum { N = TR_TILE };

typedef struct bench {
    tr_tile tile;
    double R1[N], R2[N], g1[N];
} bench;

static bench B;

static double in(tr_random *r, double low, double high) {
    return low + (high - low) * tr_random_uniform(r);
}

/* Random pairs, and behind them disks on walls; overlaps up to a tenth of the smaller radius. */
static void throw_motions(tr_random *r, bool wall) {
    tr_tile *t = &B.tile;
    memset(&B, 0, sizeof B);
    t->n = N, t->R1 = B.R1, t->R2 = B.R2, t->g1 = B.g1;
    for (int i = 0; i < N; i++) {
        double R1 = pow(10, in(r, -0.5, 0.5)), R2 = pow(10, in(r, -0.5, 0.5)), angle = in(r, 0, 2 * M_PI);
        double L = (wall ? R2 : R1 + R2) - in(r, 0, 0.1) * fmin(R1, R2);
        B.R1[i] = wall ? 0 : R1, B.R2[i] = R2, B.g1[i] = wall ? 1 : R1 / (R1 + R2);
        t->nx[i] = cos(angle), t->ny[i] = sin(angle);
        t->dx[i] = wall ? L : L * t->nx[i], t->dy[i] = L * t->ny[i];
        t->dvx[i] = in(r, -1, 1), t->dvy[i] = in(r, -1, 1), t->w1[i] = wall ? 0 : in(r, -1, 1), t->w2[i] = in(r, -1, 1);
    }
}

static void kinematics(bool wall) {
    (wall ? tr_kinematics_wall : tr_kinematics_pair)(&B.tile, NULL);
}

static double *out(bool sliding) {
    return sliding ? B.tile.v_s : B.tile.v_r;
}

/* Of pairs: moves rim 1 by ds1 and rim 2 by ds2 more, the line of centres stands. At a wall s1 = Vt. */
static void move(double ds1, double ds2, bool wall) {
    tr_tile *t = &B.tile;
    for (int i = 0; i < N; i++) {
        t->w2[i] -= ds2 / B.R2[i];
        if (wall)
            t->dvx[i] += ds1 * t->ny[i], t->dvy[i] -= ds1 * t->nx[i];
        else
            t->w1[i] += ds1 / B.R1[i];
    }
    kinematics(wall);
}

/* A row of a table is judged at walls too, whichever they are. */
typedef void with_row(const tr_velocity_measure *row, bool sliding, bool wall, tr_random *r);

static void for_all_rows(with_row *judge) {
    tr_random r = tr_random_seed(5, 1);
    for (int round = 0; round < 20; round++)
        for (int wall = 0; wall < 2; wall++) {
            for (int k = 0; k < tr_n_rolling_measures; k++) judge(&tr_rolling_velocities[k], false, wall, &r);
            for (int k = 0; k < tr_n_sliding_measures; k++) judge(&tr_sliding_velocities[k], true, wall, &r);
        }
}

static bool near_a_change(int i, double h) {
    double s1 = fabs(B.tile.s1[i]), s2 = fabs(B.tile.s2[i]);
    return fmin(fmin(s1, s2), fabs(s1 - s2)) < 4 * h;
}

/* Velocities are linear within a case, so differences over 1e-4 are exact but for rounding, 1e-15 of 10 over 1e-4. */
static void has_its_derivatives(const tr_velocity_measure *row, bool sliding, bool wall, tr_random *r) {
    const double h = 1e-4;
    double V[4][N];
    throw_motions(r, wall), kinematics(wall);
    row->partials(&B.tile, NULL);
    const tr_tile start = B.tile;
    for (int k = 0; k < 4; k++) {
        move(k < 2 ? h * (k ? 1 : -1) : 0, k < 2 ? 0 : h * (k == 3 ? 1 : -1), wall);
        row->step(&B.tile, NULL);
        memcpy(V[k], out(sliding), sizeof V[k]);
        B.tile = start;
    }
    for (int i = 0; i < N; i++) {
        if (near_a_change(i, h)) continue;
        bool ok = fabs((V[1][i] - V[0][i]) / (2 * h) - start.p1[i]) < 1e-9 * (1 + fabs(start.p1[i])) &&
                  fabs((V[3][i] - V[2][i]) / (2 * h) - start.p2[i]) < 1e-9 * (1 + fabs(start.p2[i]));
        if (!ok)
            fail_msg("%s%s: derivatives %g, %g; by differences %g, %g", row->name, wall ? " at a wall" : "",
                     start.p1[i], start.p2[i], (V[1][i] - V[0][i]) / (2 * h), (V[3][i] - V[2][i]) / (2 * h));
    }
}

static void every_row_has_its_derivatives(void **state) {
    (void)state, for_all_rows(has_its_derivatives);
}

/* V = s1 dV/ds1 + s2 dV/ds2 of what depends on s1 and s2 alone; of the others it is off by what the spin of the line
 * of centres adds. step and partials give the same V, bit for bit. */
static void is_homogeneous(const tr_velocity_measure *row, bool sliding, bool wall, tr_random *r) {
    double off = 0;
    throw_motions(r, wall), kinematics(wall);
    row->step(&B.tile, NULL);
    tr_lane V;
    memcpy(V, out(sliding), sizeof V);
    row->partials(&B.tile, NULL);
    assert_memory_equal(V, out(sliding), sizeof V);
    for (int i = 0; i < N; i++) off = fmax(off, fabs(V[i] - B.tile.s1[i] * B.tile.p1[i] - B.tile.s2[i] * B.tile.p2[i]));
    bool small = off < 1e-13 * 20; /* s up to 20 */
    if (row->claims & TR_DEFINES_OBJECTIVE) {
        if (!small) fail_msg("%s%s: V is not s1 dV/ds1 + s2 dV/ds2, by %g", row->name, wall ? " at a wall" : "", off);
    } else if (!wall && small) { /* a wall's frame turns with it */
        fail_msg("%s is a function of s1 and s2 and does not claim to be objective", row->name);
    }
}

static void every_objective_row_is_homogeneous_in_the_rims(void **state) {
    (void)state, for_all_rows(is_homogeneous);
}

static void is_objective(const tr_velocity_measure *row, bool sliding, bool wall, tr_random *r) {
    const double W = 7;
    tr_tile *t = &B.tile;
    double off = 0;
    if (wall) return; /* the wall's frame is taken before the tile */
    throw_motions(r, wall), kinematics(wall);
    row->step(t, NULL);
    tr_lane V;
    memcpy(V, out(sliding), sizeof V);
    for (int i = 0; i < N; i++) t->w1[i] += W, t->w2[i] += W, t->dvx[i] -= W * t->dy[i], t->dvy[i] += W * t->dx[i];
    kinematics(wall);
    row->step(t, NULL);
    for (int i = 0; i < N; i++) off = fmax(off, fabs(V[i] - out(sliding)[i]));
    bool same = off < 1e-12 * 10; /* rounding of velocities of W times 7 */
    if (same != !!(row->claims & TR_DEFINES_OBJECTIVE))
        fail_msg("%s: an observer who turns sees a difference of %g", row->name, off);
}

static void every_row_is_objective_or_does_not_claim_it(void **state) {
    (void)state, for_all_rows(is_objective);
}

/* Names and columns are told apart; all rows say where they come from and what they are. */
static void every_row_is_named(void **state) {
    (void)state;
    for (int sliding = 0; sliding < 2; sliding++) {
        const tr_velocity_measure *row = sliding ? tr_sliding_velocities : tr_rolling_velocities;
        int n = sliding ? tr_n_sliding_measures : tr_n_rolling_measures;
        assert_true(n > 4 && (sliding ? tr_n_sliding_velocities : tr_n_rolling_velocities) <= n);
        for (int k = 0; k < n; k++) {
            assert_true(row[k].source[0] && row[k].formula[0]);
            for (int other = 0; other < k; other++)
                assert_true(strcmp(row[k].name, row[other].name) && strcmp(row[k].column, row[other].column));
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_row_has_its_derivatives),
        cmocka_unit_test(every_objective_row_is_homogeneous_in_the_rims),
        cmocka_unit_test(every_row_is_objective_or_does_not_claim_it),
        cmocka_unit_test(every_row_is_named),
    };
    return cmocka_run_group_tests_name("definitions", tests, NULL, NULL);
}
