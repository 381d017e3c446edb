/* SPDX-License-Identifier: MIT */
/* One pair, or one disk on a wall, put into a tile and measured with the passes of laws/. */
#ifndef TR_TEST_MEASURES_H
#define TR_TEST_MEASURES_H

#include "assert_close.h"
#include "laws/kinematics.h"
#include "laws/law.h"
#include <string.h>

typedef struct motion {
    double R1, R2;
    double x1, y1, vx1, vy1, w1;
    double x2, y2, vx2, vy2, w2;
} motion;

typedef struct measured {
    double nx, ny, delta, r1, r2, v_n, v_s, s1, s2;
    double wang, bagi_kuhn, alonso_min, alonso_mean;                        /* rolling */
    double slide_wang, slide_iwashita_oda, slide_alonso, slide_full_radius; /* sliding */
} measured;

static tr_tile test_tile; /* aligned */
static double test_R1[TR_TILE], test_R2[TR_TILE], test_g1[TR_TILE];

static inline void run_measure(const tr_velocity_measure *measures, int n, const char *name) {
    for (int i = 0; i < n; i++)
        if (!strcmp(measures[i].name, name)) {
            measures[i].step(&test_tile, NULL);
            return;
        }
    fail_msg("no velocity is called %s", name);
}

static inline double rolling_by(const char *name, int i) {
    run_measure(tr_rolling_velocities, tr_n_rolling_velocities, name);
    return test_tile.v_r[i];
}

static inline double sliding_by(const char *name, int i) {
    run_measure(tr_sliding_velocities, tr_n_sliding_velocities, name);
    return test_tile.v_s[i];
}

static inline measured read_lane(int i) {
    const tr_tile *t = &test_tile;
    measured m = {.nx = t->nx[i],
                  .ny = t->ny[i],
                  .delta = t->delta[i],
                  .r1 = t->r1[i],
                  .r2 = t->r2[i],
                  .v_n = t->v_n[i],
                  .v_s = t->v_s[i],
                  .s1 = t->s1[i],
                  .s2 = t->s2[i]};
    m.wang = rolling_by("wang", i), m.bagi_kuhn = rolling_by("bagi-kuhn", i);
    m.alonso_min = rolling_by("alonso-min", i), m.alonso_mean = rolling_by("alonso-mean", i);
    m.slide_wang = sliding_by("wang", i), m.slide_iwashita_oda = sliding_by("iwashita-oda", i);
    m.slide_alonso = sliding_by("alonso", i), m.slide_full_radius = sliding_by("full-radius", i);
    return m;
}

enum { PROBE = 37 }; /* not the first lane, so that a pass that forgets its index is seen */

static inline measured measure(motion p) {
    tr_tile *t = &test_tile;
    memset(t, 0, sizeof *t);
    t->n = PROBE + 1, t->R1 = test_R1, t->R2 = test_R2, t->g1 = test_g1;
    for (int i = 0; i <= PROBE; i++) { /* the others: anything */
        test_R1[i] = 1 + 0.1 * i, test_R2[i] = 2, test_g1[i] = test_R1[i] / (test_R1[i] + 2);
        t->dx[i] = 0.5 * i, t->dy[i] = 1.5, t->dvx[i] = 1 - i, t->dvy[i] = i - 1, t->w1[i] = 2, t->w2[i] = -3;
    }
    test_R1[PROBE] = p.R1, test_R2[PROBE] = p.R2, test_g1[PROBE] = p.R1 / (p.R1 + p.R2);
    t->dx[PROBE] = p.x2 - p.x1, t->dy[PROBE] = p.y2 - p.y1;
    t->dvx[PROBE] = p.vx2 - p.vx1, t->dvy[PROBE] = p.vy2 - p.vy1, t->w1[PROBE] = p.w1, t->w2[PROBE] = p.w2;
    tr_kinematics_pair(t, NULL);
    return read_lane(PROBE);
}

/* Disk 2 at the distance from a wall of unit normal (nx, ny) that moves with (wx, wy). */
static inline measured measure_wall(double R, double distance, double nx, double ny, double wx, double wy, double vx,
                                    double vy, double w) {
    tr_tile *t = &test_tile;
    memset(t, 0, sizeof *t);
    t->n = PROBE + 1, t->R1 = test_R1, t->R2 = test_R2, t->g1 = test_g1;
    for (int i = 0; i <= PROBE; i++) test_R1[i] = 0, test_R2[i] = 3, test_g1[i] = 1, t->nx[i] = 0.6, t->ny[i] = 0.8;
    test_R2[PROBE] = R, t->nx[PROBE] = nx, t->ny[PROBE] = ny;
    t->dx[PROBE] = distance, t->dvx[PROBE] = vx - wx, t->dvy[PROBE] = vy - wy, t->w2[PROBE] = w;
    tr_kinematics_wall(t, NULL);
    return read_lane(PROBE);
}

#endif
