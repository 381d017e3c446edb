/* SPDX-License-Identifier: MIT */
#include "core/bodies.h"

#include "base/alloc.h"
#include "core/step.h"
#include "core/timestep.h"
#include <math.h>

static bool fill(tr_world *world, const tr_scene *scene, tr_status *st) {
    size_t lanes = (size_t)scene->n_disks * 4;
    bool weight = scene->gravity.x != 0 || scene->gravity.y != 0;
    if (weight && !(world->disks.load = tr_alloc(lanes, sizeof(double), st))) return false;
    for (int i = 0; i < scene->n_disks; i++) {
        const tr_scene_disk *d = &scene->disks[i];
        tr_world_set_disk(world, i, d->x, d->y, d->angle, d->radius, d->density, d->motion == 1);
        double *vel = world->disks.vel + 4 * (size_t)i, m = world->disks.mass[i];
        vel[0] = d->vx, vel[1] = d->vy, vel[2] = d->spin;
        if (weight)
            world->disks.load[4 * i] = m * scene->gravity.x, world->disks.load[4 * i + 1] = m * scene->gravity.y;
    }
    for (int w = 0; w < scene->n_walls; w++) {
        const tr_scene_wall *s = &scene->walls[w];
        world->wall[w] = (tr_wall){.x = s->x, .y = s->y, .nx = s->nx, .ny = s->ny, .vx = s->vx, .vy = s->vy};
    }
    world->n_walls = scene->n_walls;
    return true;
}

static bool choose_step(tr_bodies *b, const tr_scene *scene, tr_status *st) {
    tr_world *world = &b->world;
    double plenty = scene->time_end / 10000; /* where nothing that may touch can vibrate */
    if (!tr_timestep_choose(world, &scene->step, plenty, &b->dt_bound, st)) return false;
    double steps = ceil(scene->time_end / world->dt - 1e-9);
    if (!(steps <= TR_MOST_STEPS))
        return tr_status_fail(st, TR_BAD_CASE, "error: time_end would take %.1e steps; give a larger step.dt", steps);
    b->steps = (int64_t)steps;
    if (scene->step.dt == 0) world->dt = scene->time_end / steps; /* the last step ends at time_end */
    return true;
}

bool tr_bodies_init(tr_bodies *b, const tr_scene *scene, tr_status *st) {
    tr_world *world = &b->world;
    *b = (tr_bodies){0};
    bool ok = tr_world_init(world, scene->n_disks, scene->shape, st) && fill(world, scene, st) &&
              tr_world_set_laws(world, &scene->contact, false, TR_SINK_ARCS, st) && choose_step(b, scene, st) &&
              tr_step_forces(world, st);
    if (!ok) return tr_bodies_free(b), false;
    for (int k = 0; k < 4 * world->disks.n; k++)
        world->disks.vel[k] -= 0.5 * world->dt * world->disks.inv[k] * world->disks.force[k];
    world->fresh = true;
    world->contact_updates = 0;
    return true;
}

void tr_bodies_free(tr_bodies *b) {
    tr_world_free(&b->world);
}

void tr_bodies_velocity(const tr_world *world, int i, double velocity[3]) {
    for (int k = 0; k < 3; k++) {
        int lane = 4 * i + k;
        velocity[k] = world->disks.vel[lane] + 0.5 * world->dt * world->disks.inv[lane] * world->disks.force[lane];
    }
}
