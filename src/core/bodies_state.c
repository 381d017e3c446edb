/* SPDX-License-Identifier: MIT */
#include "core/bodies_state.h"
#include "base/math.h"

#include <math.h>

void tr_bodies_gravity(const tr_bodies *b, double gravity[2]) {
    const struct tr_scene_gravity *g = &b->scene->gravity;
    double angle = g->turn * (double)b->world.steps * b->world.dt, c = tr_cos(angle), s = tr_sin(angle);
    gravity[0] = c * g->x - s * g->y, gravity[1] = s * g->x + c * g->y;
}

void tr_bodies_velocity(const tr_world *world, int i, double velocity[3]) {
    for (int k = 0; k < 3; k++) {
        int lane = TR_LANES * i + k;
        velocity[k] = world->disks.vel[lane] + 0.5 * world->dt * world->disks.inv[lane] * world->disks.force[lane];
    }
}
