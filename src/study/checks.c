/* SPDX-License-Identifier: MIT */
#include "study/checks.h"

#include "base/alloc.h"
#include "core/step.h"
#include "scene/pick.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct tr_checking item;

bool tr_checks_open(tr_checks *c, const tr_scene *scene, tr_status *st) {
    *c = (tr_checks){.scene = scene};
    if (!(c->item = tr_alloc((size_t)scene->n_checks, sizeof *c->item, st))) return false;
    for (int k = 0; k < scene->n_checks; k++) c->item[k].value = NAN, c->item[k].before[0] = NAN;
    return true;
}

void tr_checks_free(tr_checks *c) {
    free(c->item);
    *c = (tr_checks){0};
}

static bool is_threshold(const tr_scene_check *check) {
    return check->what == TR_ROLLS_FROM || check->what == TR_SLIPS_FROM;
}

static bool is_event(const tr_scene_check *check) {
    return check->what == TR_SLIP_ENDS || check->what == TR_SLIP_STARTS || check->what == TR_STOP_TIME ||
           check->what == TR_STOP_DISTANCE;
}

static bool of_contact(const tr_scene_check *check) {
    return check->what <= TR_SLIP_STARTS;
}

/* Steps within half a step of the window, so that an instant has one. An acceleration without one spans the run. */
static bool in_window(const tr_scene_check *check, double time, double dt) {
    double over = check->what == TR_ACCELERATION && check->over == 0 ? check->at : check->over;
    return time > check->at - over - 0.5 * dt && time <= check->at + 0.5 * dt;
}

bool tr_checks_need_contacts(const tr_checks *c, double time, double dt) {
    for (int k = 0; k < c->scene->n_checks; k++) {
        const tr_scene_check *check = &c->scene->checks[k];
        if (of_contact(check) && !c->item[k].done && (is_event(check) || in_window(check, time, dt))) return true;
    }
    return false;
}

/* A disk, as it is now. */
typedef struct body {
    double x, y, v[3], force[3]; /* force: of its contacts; the third of each is of the rotation */
    double energy;
} body;

static body body_now(const tr_bodies *b, int disk) {
    const tr_disks *d = &b->world.disks;
    body now = {.x = d->pos[4 * disk], .y = d->pos[4 * disk + 1]};
    tr_bodies_velocity(&b->world, disk, now.v);
    for (int k = 0; k < 3; k++) now.force[k] = d->force[4 * disk + k] - (d->load ? d->load[4 * disk + k] : 0);
    double R = d->pos[4 * disk + 3], I = (b->world.shape == TR_SHAPE_SPHERE ? 0.4 : 0.5) * d->mass[disk] * R * R;
    now.energy = 0.5 * d->mass[disk] * (now.v[0] * now.v[0] + now.v[1] * now.v[1]) + 0.5 * I * now.v[2] * now.v[2];
    return now;
}

/* An event: when `watched` gets to 0 or changes its sign. */
static bool crosses(item *it, double time, double watched, double *when) {
    double t0 = it->before[0], w0 = it->before[1];
    bool crossed = t0 == t0 && w0 != 0 && w0 * watched <= 0;
    if (crossed) *when = t0 + (time - t0) * w0 / (w0 - watched);
    it->before[0] = time, it->before[1] = watched;
    return crossed;
}

/* What goes into a contact but for its normal force: -(forces and moments on the bodies times their velocities). */
static double power_lost(const tr_bodies *b, const tr_record *r) {
    const double *vel = b->world.disks.vel;
    double w1 = r->a < 0 ? 0 : vel[4 * r->a + 2], w2 = vel[4 * r->b + 2];
    return (r->f_t + r->f_r) * r->v_s - r->m1 * w1 - r->m2 * w2;
}

static void look_at_contact(item *it, const tr_scene_check *check, double time, const tr_bodies *b,
                            const tr_record *r) {
    switch (check->what) {
    case TR_SLIDING_VELOCITY:
        it->sum += r->v_s, it->weight += 1;
        break;
    case TR_ROLLING_VELOCITY:
        it->sum += r->v_r, it->weight += 1;
        break;
    case TR_CREEPAGE:
        it->sum += r->v_s, it->weight += 0.5 * (r->s1 + r->s2);
        break;
    case TR_POWER_LOST:
        it->sum += power_lost(b, r), it->weight += 1;
        break;
    case TR_SLIP_ENDS:
        it->done = crosses(it, time, r->v_s, &it->value);
        break;
    case TR_SLIP_STARTS: /* at the bound of the law to rounding */
        it->done = r->mobilisation > 1 - 1e-9;
        if (it->done) it->value = time;
        break;
    }
}

static void look_at_disk(item *it, const tr_scene_check *check, double time, const body *now) {
    double speed = hypot(now->v[0], now->v[1]), when;
    switch (check->what) {
    case TR_SPEED:
        it->sum += speed, it->weight += 1;
        break;
    case TR_ACCELERATION: /* from the first to the last of the window */
        if (it->n == 0) it->before[1] = time, it->before[2] = speed;
        it->sum = speed - it->before[2], it->weight = time - it->before[1];
        break;
    case TR_SPIN:
        it->sum += now->v[2], it->weight += 1;
        break;
    case TR_TORQUE:
        it->sum += now->force[2], it->weight += 1;
        break;
    case TR_POWER:
        it->sum += now->force[0] * now->v[0] + now->force[1] * now->v[1] + now->force[2] * now->v[2], it->weight += 1;
        break;
    case TR_ENERGY_LOST:
        it->sum += 1 - now->energy / it->energy, it->weight += 1;
        break;
    case TR_STOP_TIME:
    case TR_STOP_DISTANCE:
        it->done = crosses(it, time, now->v[0] * it->way[0] + now->v[1] * it->way[1], &when);
        if (it->done) it->value = check->what == TR_STOP_TIME ? when : hypot(now->x - it->x, now->y - it->y);
        break;
    }
}

static const tr_record *find(const tr_record *records, int n, tr_scene_pick pick) {
    for (int i = 0; i < n; i++)
        if (records[i].a == pick.a && records[i].b == pick.b) return &records[i];
    return NULL;
}

void tr_checks_step(tr_checks *c, const tr_bodies *b, const tr_record *records, int n) {
    double time = (double)b->world.steps * b->world.dt;
    for (int k = 0; k < c->scene->n_checks; k++) {
        const tr_scene_check *check = &c->scene->checks[k];
        item *it = &c->item[k];
        if (it->done || is_threshold(check)) continue;
        body now = body_now(b, check->disk);
        if (b->world.steps == 0) {
            it->x = now.x, it->y = now.y, it->way[0] = now.v[0], it->way[1] = now.v[1], it->energy = now.energy;
        }
        if (!is_event(check) && !in_window(check, time, b->world.dt)) continue;
        const tr_record *r = of_contact(check) ? find(records, n, check->contact.item[0]) : NULL;
        if (of_contact(check) && !r) continue;
        if (r)
            look_at_contact(it, check, time, b, r);
        else
            look_at_disk(it, check, time, &now);
        it->n++;
        if (is_event(check)) continue;
        it->value = it->sum / it->weight;
        if (check->what == TR_CREEPAGE) it->value = fabs(it->value);
        if (!isfinite(it->value)) it->value = NAN; /* over a rolling, an energy, a time of 0 */
    }
}

void tr_checks_results(const tr_checks *c, tr_check_result *result) {
    for (int k = 0; k < c->scene->n_checks; k++) {
        const tr_scene_check *check = &c->scene->checks[k];
        double measured = c->item[k].value;
        result[k] = (tr_check_result){.lane = c->scene->label, .shape = c->scene->shape, .check = check};
        result[k].measured = measured;
        result[k].ok = fabs(measured - check->exact) <= check->tolerance; /* false for NaN */
        if (of_contact(check))
            tr_scene_pick_name(check->contact.item[0], result[k].of);
        else
            snprintf(result[k].of, sizeof result[k].of, "disk %d", check->disk);
    }
}

/* ---- thresholds ---- */

/* On a slope: the normal of wall 0, and the way down that gravity already leans to, else along t. */
static void lean(tr_scene *scene, double slope) {
    const tr_scene_wall *w = scene->walls;
    double g = hypot(scene->gravity.x, scene->gravity.y), tx = w->ny, ty = -w->nx;
    double side = scene->gravity.x * tx + scene->gravity.y * ty < 0 ? -1 : 1;
    scene->gravity.x = g * (side * sin(slope) * tx - cos(slope) * w->nx);
    scene->gravity.y = g * (side * sin(slope) * ty - cos(slope) * w->ny);
    scene->gravity.turn = 0;
}

/* How far the centre (rolls-from), or the contact in sliding (slips-from), goes in the second half of a run from rest. In
 * the first half the springs take up the load. */
static bool creeps(tr_bodies *b, const tr_scene_check *check, double *distance, const tr_run_options *options,
                   tr_status *st) {
    tr_record *records = NULL;
    int capacity = 0;
    double x = 0, y = 0, slid = 0;
    for (int64_t k = 0; k <= b->steps; k++) {
        if (k % 256 == 0 && tr_run_stopped(options)) {
            tr_status_fail(st, TR_INTERRUPTED, "stopped in the search of a threshold");
            break;
        }
        if (k) tr_bodies_advance(b);
        if (!tr_step_forces(&b->world, st)) break;
        const double *p = b->world.disks.pos + 4 * check->disk;
        if (k == b->steps / 2) x = p[0], y = p[1], slid = 0;
        if (check->what == TR_ROLLS_FROM) {
            *distance = hypot(p[0] - x, p[1] - y);
            continue;
        }
        int n = tr_record_all(&b->world, &records, &capacity, st);
        const tr_record *r = find(records, n, (tr_scene_pick){-1, check->disk});
        if (r) slid += r->v_s * b->world.dt;
        *distance = fabs(slid);
    }
    free(records);
    return !st->code;
}

/* Just above a threshold the acceleration is about g times the excess of the slope, 2/3 of it if it rolls: 0.01 degrees
 * give (3/8) (2/3) 1.7e-4 g T^2 in the second half of T. */
static bool moves_on(const tr_scene *given, const tr_scene_check *check, double slope, bool *moves,
                     const tr_run_options *options, tr_status *st) {
    tr_scene scene = *given;
    scene.time_end *= 4;
    tr_scene_disk *disks = tr_alloc((size_t)scene.n_disks, sizeof *disks, st);
    tr_bodies *b = tr_alloc(1, sizeof *b, st);
    double distance = 0;
    bool ok = disks && b;
    if (ok) {
        memcpy(disks, scene.disks, (size_t)scene.n_disks * sizeof *disks);
        disks[check->disk].vx = disks[check->disk].vy = disks[check->disk].spin = 0;
        scene.disks = disks;
        lean(&scene, slope);
        ok = tr_bodies_init(b, &scene, st) && creeps(b, check, &distance, options, st);
        if (ok) tr_bodies_free(b);
    }
    double g = hypot(given->gravity.x, given->gravity.y);
    *moves = distance > 0.25 * 1.7e-4 * g * scene.time_end * scene.time_end;
    free(disks), free(b);
    return ok;
}

static bool bisect(const tr_scene *scene, const tr_scene_check *check, double *threshold, const tr_run_options *options,
                   tr_status *st) {
    const double degree = M_PI / 180, apart = 0.05 * degree;
    double low = 0, high = 85 * degree;
    bool moves;
    *threshold = NAN;
    if (!moves_on(scene, check, low, &moves, options, st) || moves) return !st->code;
    if (!moves_on(scene, check, high, &moves, options, st) || !moves) return !st->code;
    while (high - low > apart) {
        double middle = 0.5 * (low + high);
        if (!moves_on(scene, check, middle, &moves, options, st)) return false;
        if (moves)
            high = middle;
        else
            low = middle;
    }
    *threshold = 0.5 * (low + high);
    return true;
}

bool tr_checks_thresholds(tr_checks *c, const tr_run_options *options, tr_status *st) {
    for (int k = 0; k < c->scene->n_checks; k++) {
        const tr_scene_check *check = &c->scene->checks[k];
        if (!is_threshold(check)) continue;
        if (!bisect(c->scene, check, &c->item[k].value, options, st)) return false;
        c->item[k].done = true;
    }
    return true;
}

void tr_checks_adopt(tr_checks *c, const tr_checks *found) {
    for (int k = 0; k < c->scene->n_checks; k++)
        if (is_threshold(&c->scene->checks[k])) c->item[k] = found->item[k];
}
