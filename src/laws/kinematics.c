/* SPDX-License-Identifier: MIT */
/* Relative motion of two bodies at their contact, and the resultant force on them. Source [Wang2015 eqs. 7-12, 23-24].
 *
 *   X21 = x2 - x1, L = |X21|, n = X21/L, t = n x k = (n_y, -n_x)
 *   delta = R1 + R2 - L                       overlap
 *   r1 = g1 L, r2 = L - r1, g1 = R1/(R1+R2)   arms: they add up to L
 *   Vt = V21.t, betadot = -Vt/L               spin of the branch vector
 *   s1 = R1 (w1 - betadot), s2 = -R2 (w2 - betadot)
 *   Vs = r1 w1 + r2 w2 + Vt
 *
 * differs: Wang's eq. 12 has the full radii for the arms. With overlap a rigid rotation w would then slide by delta*w
 * and angular momentum would drift; with r1, r2 in velocity and torque both vanish. Eqs. 16, 23, 24 as printed are
 * right only with t = k x n, the opposite of the paper's own t (and of ours).
 *
 * Wall (body 1, a plane that does not rotate), in its frame: Vt = V21.t, s1 = Vt, s2 = -R2 w2, Vs = Vt + R2 w2: the
 * whole overlap falls to the wall, so r2 = R2.
 */
#include "laws/kinematics.h"

#include "base/vector.h"

#include <math.h>

TR_VECTOR void tr_kinematics_pair(tr_tile *restrict tile, const tr_law_data *data) {
    (void)data;
    const double *restrict R1 = tile->R1, *restrict R2 = tile->R2, *restrict g1 = tile->g1;
    int touching = 0;
    for (int i = 0; i < tile->n; i++) {
        double dx = tile->dx[i], dy = tile->dy[i], dvx = tile->dvx[i], dvy = tile->dvy[i];
        double w1 = tile->w1[i], w2 = tile->w2[i];
        double L = sqrt(dx * dx + dy * dy), inv_L = 1.0 / L, nx = dx * inv_L, ny = dy * inv_L;
        double Vt = dvx * ny - dvy * nx, betadot = -Vt * inv_L;
        double delta = R1[i] + R2[i] - L, r1 = g1[i] * L, r2 = L - r1;
        touching += delta > 0;
        tile->nx[i] = nx, tile->ny[i] = ny;
        tile->delta[i] = delta;
        tile->r1[i] = r1, tile->r2[i] = r2;
        tile->v_n[i] = -(dvx * nx + dvy * ny);
        tile->v_s[i] = r1 * w1 + r2 * w2 + Vt;
        tile->s1[i] = R1[i] * (w1 - betadot);
        tile->s2[i] = -R2[i] * (w2 - betadot);
    }
    tile->touching = touching;
}

TR_VECTOR void tr_kinematics_wall(tr_tile *restrict tile, const tr_law_data *data) {
    (void)data;
    const double *restrict R2 = tile->R2;
    int touching = 0;
    for (int i = 0; i < tile->n; i++) {
        double nx = tile->nx[i], ny = tile->ny[i], dvx = tile->dvx[i], dvy = tile->dvy[i], w2 = tile->w2[i];
        double Vt = dvx * ny - dvy * nx, delta = R2[i] - tile->dx[i];
        touching += delta > 0;
        tile->delta[i] = delta;
        tile->r1[i] = 0, tile->r2[i] = R2[i];
        tile->v_n[i] = -(dvx * nx + dvy * ny);
        tile->v_s[i] = Vt + R2[i] * w2;
        tile->s1[i] = Vt;
        tile->s2[i] = -R2[i] * w2;
    }
    tile->touching = touching;
}

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
