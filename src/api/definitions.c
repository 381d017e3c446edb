/* SPDX-License-Identifier: MIT */
#include "api/api.h"
#include "base/math.h"
#include "laws/kinematics.h"
#include "laws/law.h"

#include <math.h>

int trundle_definition_count(trundle_velocity kind) {
    return kind == TRUNDLE_ROLLING ? tr_n_rolling_measures : kind == TRUNDLE_SLIDING ? tr_n_sliding_measures : 0;
}

static const tr_velocity_measure *row(trundle_velocity kind, int i) {
    if (i < 0 || i >= trundle_definition_count(kind)) return NULL;
    return kind == TRUNDLE_ROLLING ? &tr_rolling_velocities[i] : &tr_sliding_velocities[i];
}

const char *trundle_definition_name(trundle_velocity kind, int i) {
    const tr_velocity_measure *m = row(kind, i);
    return m ? m->name : NULL;
}

/* Seen from a plane, which then rests: its material, continued to the centre of the disk, moves there with
 * v1 + w1 k x X21. */
static void gather_plane(tr_tile *tile, const trundle_body *one, const trundle_body *two) {
    const double dx = two->x - one->x, dy = two->y - one->y, L = sqrt(dx * dx + dy * dy);
    tile->nx[0] = dx / L, tile->ny[0] = dy / L;
    tile->dx[0] = L, tile->dy[0] = 0;
    tile->dvx[0] = two->vx - one->vx + one->spin * dy, tile->dvy[0] = two->vy - one->vy - one->spin * dx;
    tile->w1[0] = 0, tile->w2[0] = two->spin - one->spin;
}

static void gather_disks(tr_tile *tile, const trundle_body *one, const trundle_body *two) {
    tile->dx[0] = two->x - one->x, tile->dy[0] = two->y - one->y;
    tile->dvx[0] = two->vx - one->vx, tile->dvy[0] = two->vy - one->vy;
    tile->w1[0] = one->spin, tile->w2[0] = two->spin;
}

double trundle_definition_value(trundle_velocity kind, int i, double R1, double R2, const trundle_body *one,
                                const trundle_body *two) {
    const tr_velocity_measure *m = row(kind, i);
    const bool plane = isinf(R1);
    const double arm = plane ? 0 : R1, g1 = plane ? 1 : R1 / (R1 + R2);
    if (!m || !(tr_hypot(two->x - one->x, two->y - one->y) > 0) || !(R2 > 0) || !(R1 > 0 || R1 < -R2)) return NAN;
    tr_tile tile = {.n = 1, .R1 = &arm, .R2 = &R2, .g1 = &g1};
    (plane ? gather_plane : gather_disks)(&tile, one, two);
    (plane ? tr_kinematics_wall : R1 < 0 ? tr_kinematics_ring : tr_kinematics_pair)(&tile, NULL);
    m->step(&tile, NULL);
    return kind == TRUNDLE_ROLLING ? tile.v_r[0] : tile.v_s[0];
}
