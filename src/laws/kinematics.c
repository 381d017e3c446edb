/* SPDX-License-Identifier: MIT */
/* Relative motion of two bodies at their contact, and the resultant force on them. Source [Wang2015 eqs. 7-12, 23-24].
 *
 *   X21 = x2 - x1, L = |X21|, n = X21/L, t = n x k = (n_y, -n_x)
 *   delta = R1 + R2 - L                       overlap
 *   r1, r2                                    arms, by the scene's row of the table below
 *   Vt = V21.t, betadot = -Vt/L               spin of the branch vector
 *   s1 = R1 (w1 - betadot), s2 = -R2 (w2 - betadot)
 *   Vs = r1 w1 + r2 w2 + Vt
 *
 * A rigid rotation w has Vt = -L w, so it slides by (r1 + r2 - L) w; torques -r1 Q, -r2 Q and forces -+Q t turn the two
 * by (L - r1 - r2) Q in all. Arms that add up to L leave neither, and with the same arms in velocity and in torque the
 * power of friction is -Q Vs. The arms of a scene do all three.
 *
 * differs: Wang's eq. 12 has the full radii for the arms. With overlap a rigid rotation w would then slide by delta*w
 * and angular momentum would drift; with r1, r2 in velocity and torque both vanish. Eqs. 16, 23, 24 as printed are
 * right only with t = k x n, the opposite of the paper's own t (and of ours).
 *
 * Ring (body 1, around body 2), of inner radius R: R1 = -R and L = -|X21| in all of this, so n points from the contact
 * to the ring's centre, r1 < 0 and g1 > 1. A disk in the middle has no normal; it does not touch, n = 0.
 *
 * Wall (body 1, a plane that does not rotate), in its frame: Vt = V21.t, s1 = Vt, s2 = -R2 w2, Vs = Vt + r2 w2, r1 = 0.
 * A limit of the arms for R1 -> infinity is not asked for: shared gives the whole overlap to the wall, r2 = R2;
 * midpoint takes all of it off the disk, r2 = R2 - delta.
 *
 * TO ADD ARMS, add their two formulas and a row.
 */
#include "laws/kinematics.h"

#include "base/vector.h"

#include <math.h>

/* ---- arms: of two disks, and of a disk at a wall */

typedef struct arms {
    double r1, r2;
} arms;
typedef struct contact {
    double R1, R2, g1, L, delta; /* g1 = R1/(R1+R2) */
} contact;
typedef arms arms_of(contact c);
typedef double wall_arm(double R2, double delta);

static inline arms shared(contact c) {
    double r1 = c.g1 * c.L;
    return (arms){r1, c.L - r1};
}
static inline double shared_wall(double R2, double delta) {
    (void)delta;
    return R2;
}

static inline arms midpoint(contact c) {
    double r1 = c.R1 - 0.5 * c.delta;
    return (arms){r1, c.L - r1};
}
static inline double midpoint_wall(double R2, double delta) {
    return R2 - delta;
}

static inline arms full(contact c) {
    return (arms){c.R1, c.R2};
}

/* ---- passes */

#define INLINE static inline __attribute__((always_inline))

/* side: 1, of a ring -1. */
INLINE void move_pair(tr_tile *restrict tile, arms_of *of, double side) {
    const double *restrict R1 = tile->R1, *restrict R2 = tile->R2, *restrict g1 = tile->g1;
    int touching = 0;
    for (int i = 0; i < tile->n; i++) {
        double dx = tile->dx[i], dy = tile->dy[i], dvx = tile->dvx[i], dvy = tile->dvy[i];
        double w1 = tile->w1[i], w2 = tile->w2[i];
        double L = side * sqrt(dx * dx + dy * dy), inv_L = side < 0 && L == 0 ? 0 : 1.0 / L, nx = dx * inv_L,
               ny = dy * inv_L;
        double Vt = dvx * ny - dvy * nx, betadot = -Vt * inv_L;
        double delta = R1[i] + R2[i] - L;
        arms r = of((contact){R1[i], R2[i], g1[i], L, delta});
        touching += delta > 0;
        tile->nx[i] = nx, tile->ny[i] = ny;
        tile->delta[i] = delta;
        tile->r1[i] = r.r1, tile->r2[i] = r.r2;
        tile->v_n[i] = -(dvx * nx + dvy * ny);
        tile->v_s[i] = r.r1 * w1 + r.r2 * w2 + Vt;
        tile->s1[i] = R1[i] * (w1 - betadot);
        tile->s2[i] = -R2[i] * (w2 - betadot);
    }
    tile->touching = touching;
}

INLINE void move_wall(tr_tile *restrict tile, wall_arm *of) {
    const double *restrict R2 = tile->R2;
    int touching = 0;
    for (int i = 0; i < tile->n; i++) {
        double nx = tile->nx[i], ny = tile->ny[i], dvx = tile->dvx[i], dvy = tile->dvy[i], w2 = tile->w2[i];
        double Vt = dvx * ny - dvy * nx, delta = R2[i] - tile->dx[i], r2 = of(R2[i], delta);
        touching += delta > 0;
        tile->delta[i] = delta;
        tile->r1[i] = 0, tile->r2[i] = r2;
        tile->v_n[i] = -(dvx * nx + dvy * ny);
        tile->v_s[i] = Vt + r2 * w2;
        tile->s1[i] = Vt;
        tile->s2[i] = -R2[i] * w2;
    }
    tile->touching = touching;
}

/* A wall with ends: g1 = 1 on its face; g1 = 0 at a corner, a body of radius 0, so that r2 = L whatever the arms, s1 =
 * 0 and the branch vector turns. dx: L, distance from the nearest point. */
INLINE void move_edge(tr_tile *restrict tile, wall_arm *of) {
    const double *restrict R2 = tile->R2, *restrict g1 = tile->g1;
    int touching = 0;
    for (int i = 0; i < tile->n; i++) {
        double nx = tile->nx[i], ny = tile->ny[i], dvx = tile->dvx[i], dvy = tile->dvy[i], L = tile->dx[i];
        double Vt = dvx * ny - dvy * nx, corner = 1 - g1[i], betadot = L > 0 ? -corner * Vt / L : 0;
        double delta = R2[i] - L, w2 = tile->w2[i], r2 = g1[i] * of(R2[i], delta) + corner * L;
        touching += delta > 0;
        tile->delta[i] = delta;
        tile->r1[i] = 0, tile->r2[i] = r2;
        tile->v_n[i] = -(dvx * nx + dvy * ny);
        tile->v_s[i] = r2 * w2 + Vt;
        tile->s1[i] = g1[i] * Vt;
        tile->s2[i] = R2[i] * (betadot - w2);
    }
    tile->touching = touching;
}

/* Arms alone, after either of the above; L is r1 + r2, of any arms of a scene. */
INLINE void set_arms(tr_tile *restrict tile, arms_of *of, wall_arm *of_wall) {
    for (int i = 0; i < tile->n; i++) {
        double R1 = tile->R1[i], R2 = tile->R2[i], g1 = tile->g1[i], delta = tile->delta[i];
        bool wall = g1 == 1; /* of a ring g1 > 1 */
        arms r = of((contact){R1, R2, g1, R1 + R2 - delta, delta});
        tile->r1[i] = wall ? 0 : r.r1, tile->r2[i] = wall ? of_wall(R2, delta) : r.r2;
    }
}

TR_VECTOR void tr_kinematics_pair(tr_tile *restrict tile, const tr_law_data *data) {
    (void)data, move_pair(tile, shared, 1);
}
TR_VECTOR void tr_kinematics_ring(tr_tile *restrict tile, const tr_law_data *data) {
    (void)data, move_pair(tile, shared, -1);
}
TR_VECTOR void tr_kinematics_wall(tr_tile *restrict tile, const tr_law_data *data) {
    (void)data, move_wall(tile, shared_wall);
}
TR_VECTOR static void edge(tr_tile *restrict tile, const tr_law_data *data) {
    (void)data, move_edge(tile, shared_wall);
}
TR_VECTOR static void midpoint_pair(tr_tile *restrict tile, const tr_law_data *data) {
    (void)data, move_pair(tile, midpoint, 1);
}
TR_VECTOR static void midpoint_ring(tr_tile *restrict tile, const tr_law_data *data) {
    (void)data, move_pair(tile, midpoint, -1);
}
TR_VECTOR static void midpoint_at_wall(tr_tile *restrict tile, const tr_law_data *data) {
    (void)data, move_wall(tile, midpoint_wall);
}
TR_VECTOR static void midpoint_at_edge(tr_tile *restrict tile, const tr_law_data *data) {
    (void)data, move_edge(tile, midpoint_wall);
}
static void shared_arms(tr_tile *restrict tile, const tr_law_data *data) {
    (void)data, set_arms(tile, shared, shared_wall);
}
static void midpoint_arms(tr_tile *restrict tile, const tr_law_data *data) {
    (void)data, set_arms(tile, midpoint, midpoint_wall);
}
static void full_arms(tr_tile *restrict tile, const tr_law_data *data) {
    (void)data, set_arms(tile, full, shared_wall);
}

/* ---- the table */

enum { ALL = TR_ARMS_OBJECTIVE | TR_ARMS_BALANCED | TR_ARMS_CONJUGATE };

#define IN_SCENES(X)                                                                                                   \
    X("shared", "wang", ALL, "[Wang2015 eq. 12] mended", "R_i |X21|/(R1+R2), at a wall R2", shared_arms,               \
      tr_kinematics_pair, tr_kinematics_ring, tr_kinematics_wall, edge)                                                \
    X("midpoint", "midpoint", ALL, "[Luding2008]; LIGGGHTS 3.8.0", "R_i - overlap/2, at a wall R2 - overlap",          \
      midpoint_arms, midpoint_pair, midpoint_ring, midpoint_at_wall, midpoint_at_edge)
#define ONLY_MEASURED(X)                                                                                               \
    X("full", "full-radius", TR_ARMS_CONJUGATE, "[Wang2015 eq. 12]", "R_i", full_arms, NULL, NULL, NULL, NULL)         \
    X("full-midpoint", "full-radius", TR_ARMS_BALANCED, "LAMMPS 29Sep2021", "velocity R_i, torque R_i - overlap/2",    \
      midpoint_arms, NULL, NULL, NULL, NULL)                                                                           \
    X("stretched-midpoint", "alonso", TR_ARMS_OBJECTIVE | TR_ARMS_BALANCED, "YADE 2023.02a",                           \
      "velocity s1-s2, torque R_i - overlap/2", midpoint_arms, NULL, NULL, NULL, NULL)
#define ROW(name, sliding, claims, source, formula, arms, pair, ring, wall, edge)                                      \
    {name, sliding, source, formula, claims, arms, pair, ring, wall, edge},
#define ONE(...) +1
#define CHOICE(name, ...) "|" name

const tr_arms tr_arms_rows[] = {IN_SCENES(ROW) ONLY_MEASURED(ROW)};
const int tr_n_arms = IN_SCENES(ONE);
const int tr_n_arms_measured = sizeof tr_arms_rows / sizeof *tr_arms_rows;
const char tr_arms_choices[] = IN_SCENES(CHOICE);

/* ---- resultants */

/* Force on body 2: f_n n - f_t t. */
TR_VECTOR void tr_resultant_central(tr_tile *restrict tile, const tr_law_data *data) {
    (void)data;
    for (int i = 0; i < tile->n; i++) {
        tile->fx[i] = tile->f_n[i] * tile->nx[i];
        tile->fy[i] = tile->f_n[i] * tile->ny[i];
        tile->q1[i] = tile->q2[i] = 0;
    }
}

/* Torques: friction acts at the contact point, -r1 Q on 1 and -r2 Q on 2. */
TR_VECTOR void tr_resultant_full(tr_tile *restrict tile, const tr_law_data *data) {
    (void)data;
    for (int i = 0; i < tile->n; i++) {
        tile->fx[i] = tile->f_n[i] * tile->nx[i] - tile->f_t[i] * tile->ny[i];
        tile->fy[i] = tile->f_n[i] * tile->ny[i] + tile->f_t[i] * tile->nx[i];
        tile->q1[i] = tile->m1[i] - tile->r1[i] * tile->f_t[i];
        tile->q2[i] = tile->m2[i] - tile->r2[i] * tile->f_t[i];
    }
}
