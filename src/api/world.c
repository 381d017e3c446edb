/* SPDX-License-Identifier: MIT */
/* Worlds of the public face. Between two calls a world has positions and forces of the same instant, and velocities
 * half a step behind (core/step.h). Velocities that are read belong to the instant. */
#include "api/api.h"
#include "base/alloc.h"
#include "core/biaxial.h"
#include "core/bodies.h"
#include "core/bodies_state.h"
#include "core/pipeline.h"
#include "core/step.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct trundle_world {
    const tr_scene *scene;
    bool failed;
    tr_world *world; /* of one of these */
    tr_bodies bodies;
    tr_biaxial biaxial;
    trundle_biaxial read; /* the last that was told */
    tr_record *records;
    int capacity;
};

static int fail(trundle_error *error, tr_code code, const char *text) {
    tr_status st = {0};
    tr_status_fail(&st, code, "error: %s", text);
    return tr_api_tell(&st, error);
}

static bool forces(trundle_world *w, tr_status *st) {
    return w->world == &w->biaxial.world ? tr_biaxial_forces(&w->biaxial, st) : tr_step_forces(w->world, st);
}

static bool begin_biaxial(trundle_world *w, tr_status *st) {
    double unbalanced;
    bool done = false;
    w->world = &w->biaxial.world;
    if (!tr_biaxial_init(&w->biaxial, w->scene, st)) return w->world = NULL, false;
    while (!done)
        if (!tr_biaxial_compact(&w->biaxial, 200, &unbalanced, &done, st)) return false;
    return tr_biaxial_begin_shear(&w->biaxial, st) && forces(w, st);
}

static bool begin_bodies(trundle_world *w, tr_status *st) {
    w->world = &w->bodies.world;
    if (!tr_bodies_init(&w->bodies, w->scene, st)) return w->world = NULL, false;
    return forces(w, st);
}

trundle_world *trundle_world_new(const trundle_scene *scene, trundle_error *error) {
    tr_status st = {0};
    trundle_world *w = tr_alloc(1, sizeof *w, &st);
    if (w) w->scene = &scene->scene;
    bool ok = false;
    if (w && scene->scene.n_more)
        tr_status_fail(&st, TR_BAD_CASE, "error: the case has several documents; a world needs a case of one");
    else if (w && scene->scene.kind == TR_KIND_BIAXIAL)
        ok = begin_biaxial(w, &st);
    else if (w && scene->scene.kind == TR_KIND_BODIES)
        ok = begin_bodies(w, &st);
    else if (w)
        tr_status_fail(&st, TR_BAD_CASE, "error: a world needs kind: bodies or kind: biaxial");
    tr_api_tell(&st, error);
    if (ok) return w;
    trundle_world_free(w);
    return NULL;
}

void trundle_world_free(trundle_world *w) {
    if (!w) return;
    if (w->world == &w->biaxial.world) tr_biaxial_free(&w->biaxial);
    if (w->world == &w->bodies.world) tr_bodies_free(&w->bodies);
    free(w->records);
    free(w);
}

int trundle_world_step(trundle_world *w, int n, trundle_error *error) {
    tr_status st = {0};
    if (n < 0) return fail(error, TR_BAD_CASE, "the number of steps is negative");
    if (w->failed)
        return fail(error, TR_BAD_CASE, "this world failed in an earlier step; it can only be read and freed");
    for (int k = 0; k < n && !st.code; k++) {
        if (w->world == &w->bodies.world)
            tr_bodies_advance(&w->bodies);
        else
            tr_step_advance(w->world);
        w->failed = !forces(w, &st);
    }
    return tr_api_tell(&st, error);
}

int trundle_world_set_threads(trundle_world *w, int n, trundle_error *error) {
    tr_status st = {0};
    if (n < 1 || n > TR_MOST_THREADS) return fail(error, TR_BAD_CASE, "1 to 1024 threads are allowed");
    tr_world_set_threads(w->world, n, &st);
    return tr_api_tell(&st, error);
}

double trundle_world_time(const trundle_world *w) {
    int64_t start = w->world == &w->biaxial.world ? w->biaxial.shear_start : 0;
    return (double)(w->world->steps - start) * w->world->dt;
}

double trundle_world_dt(const trundle_world *w) {
    return w->world->dt;
}

int trundle_world_count(const trundle_world *w) {
    return w->world->disks.n;
}

static bool has(const trundle_world *w, int i) {
    return i >= 0 && i < w->world->disks.n;
}

int trundle_world_disk(const trundle_world *w, int i, trundle_disk *disk, trundle_error *error) {
    const tr_disks *d = &w->world->disks;
    double v[3];
    if (!has(w, i)) return fail(error, TR_BAD_CASE, "there is no disk with that number");
    const double *pos = d->pos + tr_body(i), *force = d->force + tr_body(i);
    tr_bodies_velocity(w->world, i, v);
    *disk = (trundle_disk){.x = pos[0],
                           .y = pos[1],
                           .angle = pos[2],
                           .vx = v[0],
                           .vy = v[1],
                           .spin = v[2],
                           .fx = force[0],
                           .fy = force[1],
                           .torque = force[2],
                           .radius = pos[3],
                           .mass = d->mass[i]};
    return fail(error, TR_OK, "");
}

int trundle_world_set_velocity(trundle_world *w, int i, double vx, double vy, double spin, trundle_error *error) {
    const double v[] = {vx, vy, spin};
    if (!has(w, i)) return fail(error, TR_BAD_CASE, "there is no disk with that number");
    if (!isfinite(vx) || !isfinite(vy) || !isfinite(spin)) return fail(error, TR_BAD_CASE, "a velocity is not finite");
    const tr_disks *d = &w->world->disks;
    bool orbit = w->world == &w->bodies.world && w->scene->disks[i].motion == TR_ORBIT; /* which gives vx and vy */
    for (size_t k = orbit ? 2 : 0; k < 3; k++) { /* half a step back, as it is kept */
        size_t lane = tr_body(i) + k;
        d->vel[lane] = v[k] - 0.5 * w->world->dt * d->inv[lane] * d->force[lane];
    }
    return fail(error, TR_OK, "");
}

int trundle_world_change_laws(trundle_world *w, const trundle_scene *scene, trundle_error *error) {
    const bool biaxial = w->world == &w->biaxial.world;
    tr_status st = {0};
    if (scene->scene.shape != w->world->shape) return fail(error, TR_BAD_CASE, "the other scene has another shape");
    if (w->failed)
        return fail(error, TR_BAD_CASE, "this world failed in an earlier step; it can only be read and freed");
    w->failed = !tr_world_change_laws(w->world, &scene->scene.contact, biaxial && w->scene->shear.walls == 0,
                                      biaxial ? 0 : TR_SINK_ARCS, &st);
    w->world->fresh = false; /* the bodies have moved since the histories that stay were made */
    return tr_api_tell(&st, error);
}

int trundle_world_contacts(trundle_world *w, trundle_touch *touch, int room, trundle_error *error) {
    tr_status st = {0};
    int n = tr_record_all(w->world, &w->records, &w->capacity, &st);
    if (tr_api_tell(&st, error)) return -1;
    for (int i = 0; i < n && i < room; i++) touch[i] = tr_api_touch(&w->records[i]);
    return n;
}

int trundle_world_biaxial(trundle_world *w, trundle_biaxial *state, trundle_error *error) {
    if (w->world != &w->biaxial.world) return fail(error, TR_BAD_CASE, "this world is not a biaxial test");
    if (w->biaxial.stress_steps > 0) {
        tr_biaxial_state s = tr_biaxial_read(&w->biaxial);
        w->read = (trundle_biaxial){s.strain, s.stress_1, s.stress_2, s.sin_phi, s.void_ratio};
    }
    *state = w->read;
    return fail(error, TR_OK, "");
}
