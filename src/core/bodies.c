/* SPDX-License-Identifier: MIT */
#include "core/bodies.h"
#include "base/math.h"

#include "base/alloc.h"
#include "core/pipeline.h"
#include "core/resolution.h"
#include "core/step.h"
#include "core/timestep.h"
#include <math.h>

/* ---- motions that are prescribed over time */

/* The place on an orbit, from the start and the time, so that no error grows. */
static void aim(tr_bodies *b, double time) {
    const tr_disks *all = &b->world.disks;
    for (int i = 0; i < all->n; i++) {
        const tr_scene_disk *d = &b->scene->disks[i];
        if (d->motion != TR_ORBIT) continue;
        const double *pos = all->pos + tr_body(i), c = tr_cos(d->orbit * time), s = tr_sin(d->orbit * time);
        double *vel = all->vel + tr_body(i), x = d->x - d->orbit_x, y = d->y - d->orbit_y;
        vel[0] = (d->orbit_x + c * x - s * y - pos[0]) / b->world.dt;
        vel[1] = (d->orbit_y + s * x + c * y - pos[1]) / b->world.dt;
    }
}

/* The velocity on an orbit at the time of the position; contacts see it. */
static void circle(tr_bodies *b) {
    const tr_disks *all = &b->world.disks;
    for (int i = 0; i < all->n; i++) {
        const tr_scene_disk *d = &b->scene->disks[i];
        if (d->motion != TR_ORBIT) continue;
        const double *pos = all->pos + tr_body(i);
        double *vel = all->vel + tr_body(i);
        vel[0] = -d->orbit * (pos[1] - d->orbit_y), vel[1] = d->orbit * (pos[0] - d->orbit_x);
    }
}

static void weigh(tr_bodies *b) {
    const tr_disks *d = &b->world.disks;
    double g[2];
    tr_bodies_gravity(b, g);
    for (int i = 0; d->load && i < d->n; i++) { /* what moves a centre as it is told carries its weight too */
        const tr_scene_pull *pull = &b->scene->disks[i].pull;
        const double force[] = {d->mass[i] * g[0] + pull->force * tr_cos(pull->angle),
                                d->mass[i] * g[1] + pull->force * tr_sin(pull->angle)};
        for (int k = 0; k < 2; k++) d->load[tr_body(i) + k] = d->inv[tr_body(i) + k] > 0 ? force[k] : 0;
    }
}

void tr_bodies_advance(tr_bodies *b) {
    aim(b, (double)(b->world.steps + 1) * b->world.dt);
    tr_step_advance(&b->world);
    circle(b);
    if (b->scene->gravity.turn != 0) weigh(b);
}

/* ---- the start */

static bool fill(tr_bodies *b, const tr_scene *scene, tr_status *st) {
    tr_world *world = &b->world;
    bool load = scene->gravity.x != 0 || scene->gravity.y != 0;
    for (int i = 0; i < scene->n_disks; i++) load |= scene->disks[i].torque != 0 || scene->disks[i].pull.force != 0;
    if (load && !(world->disks.load = tr_alloc((size_t)scene->n_disks * 4, sizeof(double), st))) return false;
    for (int i = 0; i < scene->n_disks; i++) {
        const tr_scene_disk *d = &scene->disks[i];
        tr_world_set_disk(world, i, &(tr_disk_start){d->x, d->y, d->angle, d->radius, d->density, false});
        if (d->ring > 0 && !tr_world_set_ring(world, i, d->radius, d->radius + d->ring, d->density, st)) return false;
        world->n_rings += d->ring > 0;
        if (d->inertia > 0)
            tr_world_set_inertia(world, i, d->inertia * world->disks.mass[i] * d->radius * d->radius);
        double *vel = world->disks.vel + tr_body(i), *inv = world->disks.inv + tr_body(i);
        vel[0] = d->vx, vel[1] = d->vy, vel[2] = d->spin;
        if (d->motion != TR_FREE && d->motion != TR_DRIVEN) inv[0] = inv[1] = 0;
        if (d->motion != TR_FREE && d->motion != TR_PINNED) inv[2] = 0;
        if (load) world->disks.load[tr_body(i) + TR_TURN] = d->torque + d->pull.force * d->pull.radius;
    }
    weigh(b);
    circle(b);
    for (int w = 0; w < scene->n_walls; w++) {
        const tr_scene_wall *s = &scene->walls[w];
        world->wall[w] = (tr_wall){.x = s->x, .y = s->y, .nx = s->nx, .ny = s->ny, .vx = s->vx, .vy = s->vy,
                                   .belt = s->belt, .from = -INFINITY, .to = INFINITY};
        if (s->from < s->to && s->from > -TR_ENDLESS) world->wall[w].from = s->from, world->wall[w].ends = true;
        if (s->from < s->to && s->to < TR_ENDLESS) world->wall[w].to = s->to, world->wall[w].ends = true;
        if (!tr_world_set_wall_laws(world, w, s->own ? &s->contact : NULL, st)) return false;
    }
    world->n_walls = scene->n_walls;
    return true;
}

static bool choose_step(tr_bodies *b, const tr_scene *scene, tr_status *st) {
    tr_world *world = &b->world;
    double plenty = scene->time_end / 10000; /* if no contact can vibrate */
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
    *b = (tr_bodies){.scene = scene};
    bool ok = tr_world_init(world, scene->n_disks, scene->shape, st) && fill(b, scene, st) &&
              tr_world_set_laws(world, &scene->contact, false, TR_SINK_ARCS, st) && choose_step(b, scene, st) &&
              tr_resolution_check(b, st) && tr_step_forces(world, st);
    if (!ok) return tr_bodies_free(b), false;
    for (int k = 0; k < TR_LANES * world->disks.n; k++)
        world->disks.vel[k] -= 0.5 * world->dt * world->disks.inv[k] * world->disks.force[k];
    world->fresh = true;
    world->contact_updates = 0;
    return true;
}

void tr_bodies_free(tr_bodies *b) {
    tr_world_free(&b->world);
}
