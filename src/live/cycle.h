/* SPDX-License-Identifier: MIT */
/* One contact around a closed cycle, and the work that it does on the two disks. Disk 2 goes a distance around disk 1
 * without spin, then disk 1 turns, then both are undone: four legs. The overlap stays the same. */
#ifndef TR_LIVE_CYCLE_H
#define TR_LIVE_CYCLE_H

#include "base/math.h"
#include "trundle.h"

enum { LIVE_LEG = 100 }; /* steps of a leg; each takes dt = 1 s/LIVE_LEG */

typedef struct live_cycle {
    double R1, R2, overlap, du, dtheta; /* what a leg goes [m, rad] */
    double beta, theta1;                /* where 2 lies around 1, the angle of 1, now */
    double work;                        /* done on the disks since the start [J/m] */
    double pull, torque1, torque2;      /* force along t on 2, torques, now */
    int steps;
} live_cycle;

/* t = (ny, -nx) of the normal n from 1 to 2. Force on 2 along t times its way, and torques times angles; by the
 * mean of the forces at both ends of the step, which is exact for springs. The spring presses along the normal,
 * where nothing moves. */
static inline int live_cycle_step(live_cycle *c, trundle_contact *contact, trundle_error *error) {
    const int leg = c->steps / LIVE_LEG % 4;
    const double L = c->R1 + c->R2 - c->overlap, sense = leg < 2 ? 1 : -1;
    const double way = leg % 2 ? 0 : sense * c->du / LIVE_LEG, turn = leg % 2 ? sense * c->dtheta / LIVE_LEG : 0;
    c->beta -= way / L, c->theta1 += turn, c->steps++;
    const double nx = tr_cos(c->beta), ny = tr_sin(c->beta), V = way * LIVE_LEG;
    const trundle_body one = {.spin = turn * LIVE_LEG}, two = {.x = L * nx, .y = L * ny, .vx = V * ny, .vy = -V * nx};
    trundle_force f;
    int code = trundle_contact_step(contact, 1.0 / LIVE_LEG, &one, &two, &f, error);
    if (code) return code;
    const double pull = f.fx * ny - f.fy * nx;
    c->work += 0.5 * (c->pull + pull) * way + 0.5 * (c->torque1 + f.torque1) * turn;
    c->pull = pull, c->torque1 = f.torque1, c->torque2 = f.torque2;
    return code;
}

#endif
