/* SPDX-License-Identifier: MIT */
/* One contact of the public face: a world of two bodies that the caller moves. So a contact has the passes, the
 * histories and the bits of an assembly. Its list is made once, while the bodies touch, and is never renewed: there is
 * one pair. */
#include "api/api.h"
#include "base/math.h"
#include "base/alloc.h"
#include "core/step.h"
#include "core/pipeline.h"
#include "laws/law.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct trundle_contact {
    tr_scene scene;
    tr_world world;
    bool plane;
    tr_record *records;
    int capacity;
};

static bool check(const trundle_pair *p, tr_status *st) {
    bool plane = p->R1 == 0, sound = p->R2 > 0 && isfinite(p->R2) && isfinite(p->R1) && p->density2 > 0 &&
                                     isfinite(p->density2) && (plane || (p->density1 > 0 && isfinite(p->density1)));
    if (!sound)
        return tr_status_fail(st, TR_BAD_CASE,
                              "error: radii and densities must be positive (R1 = 0: a plane, R1 < 0: a ring)");
    if (p->R1 < 0 && !(p->R2 < -p->R1))
        return tr_status_fail(
            st, TR_BAD_CASE, "error: R1 = %g m is a ring, which holds smaller disks only, and R2 = %g m", p->R1, p->R2);
    return !plane || fabs(tr_hypot(p->nx, p->ny) - 1) < 1e-9 ||
           tr_status_fail(st, TR_BAD_CASE, "error: the normal of the plane must have the length 1");
}

/* Only the keys of `contact`: a brace would end the mapping, a name of `disks` would mean a disk of the frame. */
static bool check_laws(const char *laws, tr_status *st) {
    if (strpbrk(laws, "{}")) return tr_status_fail(st, TR_BAD_CASE, "error: laws: `{` and `}` are not allowed");
    return !strstr(laws, "disks.") || tr_status_fail(st, TR_BAD_CASE, "error: laws: `disks` is not allowed here");
}

/* The closing braces have their own line, because the laws may end with a comment. */
static bool read_laws(tr_scene *scene, const char *laws, tr_status *st) {
    static const char frame[] = "{kind: bodies, time_end: 1, disks: [{radius: 1, x: 0, y: 0}], contact: {%s\n}}\n";
    size_t room = sizeof frame + strlen(laws);
    if (!check_laws(laws, st)) return false;
    char *text = tr_alloc(room, 1, st);
    if (!text) return false;
    int size = snprintf(text, room, frame, laws);
    bool ok = tr_scene_read(scene, &(tr_scene_source){"laws", text, (size_t)size, NULL, 0}, tr_laws_catalog(), st);
    free(text);
    return ok;
}

static void place(trundle_contact *c, const trundle_body *one, const trundle_body *two) {
    const tr_disks *d = &c->world.disks;
    const trundle_body *disk[] = {c->plane ? two : one, two};
    for (int i = 0; i < d->n; i++) {
        double *pos = d->pos + tr_body(i), *vel = d->vel + tr_body(i);
        pos[0] = disk[i]->x, pos[1] = disk[i]->y;
        vel[0] = disk[i]->vx, vel[1] = disk[i]->vy, vel[2] = disk[i]->spin;
    }
    if (c->plane) {
        tr_wall *wall = c->world.wall;
        wall->x = one->x, wall->y = one->y, wall->vx = one->vx, wall->vy = one->vy;
    }
}

/* An open contact has no history. The first forces make the list, so the bodies touch then. */
static bool set_up(trundle_contact *c, const trundle_pair *p, tr_status *st) {
    tr_world *w = &c->world;
    c->plane = p->R1 == 0;
    if (!tr_world_init(w, c->plane ? 1 : 2, TR_SHAPE_DISK, st)) return false;
    if (!c->plane) tr_world_set_disk(w, 0, &(tr_disk_start){0, 0, 0, p->R1, p->density1, false});
    w->n_rings = p->R1 < 0; /* with the mass and inertia of a disk of that radius */
    tr_world_set_disk(w, c->plane ? 0 : 1, &(tr_disk_start){0, 0, 0, p->R2, p->density2, false});
    if (c->plane) w->wall[0] = (tr_wall){.nx = p->nx, .ny = p->ny}, w->n_walls = 1;
    double along[] = {c->plane ? p->nx : 1, c->plane ? p->ny : 0}, R = p->R1 + p->R2,
           reach = fabs(R) * (R < 0 ? 1 + 1e-9 : 1 - 1e-9);
    place(c, &(trundle_body){0}, &(trundle_body){.x = along[0] * reach, .y = along[1] * reach});
    w->dt = 1, w->allow_unstable = true; /* the step is the caller's */
    if (!tr_world_set_laws(w, &c->scene.contact, false, 0, st) || !tr_step_forces(w, st)) return false;
    trundle_contact_reset(c);
    return true;
}

trundle_contact *trundle_contact_new(const char *laws, const trundle_pair *pair, trundle_error *error) {
    tr_status st = {0};
    trundle_contact *c = NULL;
    tr_api_locale l = tr_api_locale_enter(&st);
    bool ok = !st.code && check(pair, &st) && (c = tr_alloc(1, sizeof *c, &st)) && read_laws(&c->scene, laws, &st) &&
              set_up(c, pair, &st);
    tr_api_locale_leave(l);
    tr_api_tell(&st, error);
    if (ok) return c;
    trundle_contact_free(c);
    return NULL;
}

void trundle_contact_free(trundle_contact *c) {
    if (!c) return;
    tr_world_free(&c->world);
    tr_scene_free(&c->scene);
    free(c->records);
    free(c);
}

/* Histories are set to 0. Opening the contact is not enough: a number that is not finite would stay. */
void trundle_contact_reset(trundle_contact *c) {
    const tr_disks *d = &c->world.disks;
    tr_group *g = &c->world.group[c->plane ? 1 : c->world.n_rings ? c->world.n_groups - 1 : 0];
    const double far = 4 * (d->pos[3] + d->pos[tr_body(d->n - 1) + TR_RADIUS]);
    tr_status st = {0};
    trundle_body two = {.x = c->world.n_rings ? 0 : far, .y = 0}; /* the middle of a ring is nowhere near it */
    if (c->plane) two.x = far * c->world.wall->nx, two.y = far * c->world.wall->ny;
    for (int k = 0; k < g->n_hist; k++)
        for (int i = 0; i < g->n; i++) g->hist[k][i] = 0;
    place(c, &(trundle_body){0}, &two);
    c->world.dt = 1;
    tr_step_forces(&c->world, &st); /* of an open contact: nothing can fail */
}

static bool is_finite(const trundle_body *b, bool plane) {
    return isfinite(b->x) && isfinite(b->y) && isfinite(b->vx) && isfinite(b->vy) && (plane || isfinite(b->spin));
}

/* Input that no step may use: the contact stays as it is. */
static bool can_step(const trundle_contact *c, double dt, const trundle_body *one, const trundle_body *two,
                     tr_status *st) {
    if (!(dt > 0) || !isfinite(dt)) return tr_status_fail(st, TR_BAD_CASE, "error: dt = %g s; it must be positive", dt);
    if (!is_finite(one, c->plane) || !is_finite(two, false))
        return tr_status_fail(st, TR_NUMERICAL, "error: a position or a velocity is not finite");
    return c->plane || one->x != two->x || one->y != two->y ||
           tr_status_fail(st, TR_NUMERICAL, "error: both centres are at (%g, %g): the contact has no normal", one->x,
                          one->y);
}

int trundle_contact_step(trundle_contact *c, double dt, const trundle_body *one, const trundle_body *two,
                         trundle_force *force, trundle_error *error) {
    tr_status st = {0};
    const tr_disks *d = &c->world.disks;
    const double *on2 = d->force + tr_body(d->n - 1);
    *force = (trundle_force){0};
    if (!can_step(c, dt, one, two, &st)) return tr_api_tell(&st, error);
    c->world.dt = dt;
    place(c, one, two);
    if (tr_step_forces(&c->world, &st)) {
        *force = (trundle_force){on2[0], on2[1], c->plane ? 0 : d->force[2], on2[2]};
        if (!isfinite(force->fx) || !isfinite(force->fy) || !isfinite(force->torque1) || !isfinite(force->torque2)) {
            tr_status_fail(&st, TR_NUMERICAL, "error: a force is not finite; the contact has lost its history");
            *force = (trundle_force){0};
            trundle_contact_reset(c);
        }
    }
    return tr_api_tell(&st, error);
}

int trundle_contact_read(trundle_contact *c, trundle_touch *touch, trundle_error *error) {
    tr_status st = {0};
    int n = tr_record_all(&c->world, &c->records, &c->capacity, &st);
    *touch = n > 0 ? tr_api_touch(&c->records[0]) : (trundle_touch){0};
    return tr_api_tell(&st, error);
}
