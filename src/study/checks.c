/* SPDX-License-Identifier: MIT */
#include "study/checks.h"
#include "base/math.h"

#include "base/alloc.h"
#include "core/step.h"
#include "scene/contact_name.h"
#include "scene/what.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A disk and a contact, as they are now. */
typedef struct sight {
    const tr_bodies *b;
    const tr_record *contact; /* NULL: none */
    double time;
    double x, y, v[3], force[3]; /* force: of its contacts; the third of each is for the rotation */
    double speed, energy;
} sight;

typedef struct tr_checking {
    bool done;          /* value is final */
    double value;       /* NaN: has not happened yet */
    double sum, weight; /* of the mean; of a creepage, its two velocities */
    double before[2];   /* time, and value at the step before, of the watched quantity of an event; speed at the
                         * start */
    sight start;
} item;

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

/* An event is always due. A window contains the steps within half a step of it, so that an instant has one step. */
static bool is_due(const tr_scene_check *check, double time, double dt) {
    tr_when when = tr_whats[check->what].when;
    double over = when == TR_SINCE && check->over == 0 ? check->at : check->over;
    bool in_window = time > check->at - over - 0.5 * dt && time <= check->at + 0.5 * dt;
    return when == TR_EVENT || (when != TR_SLOPE && in_window);
}

bool tr_checks_need_contacts(const tr_checks *c, double time, double dt) {
    for (int k = 0; k < c->scene->n_checks; k++) {
        const tr_scene_check *check = &c->scene->checks[k];
        if (tr_whats[check->what].whose == TR_OF_CONTACT && !c->item[k].done && is_due(check, time, dt)) return true;
    }
    return false;
}

static sight look(const tr_bodies *b, int disk, const tr_record *contact) {
    const tr_disks *d = &b->world.disks;
    sight now = {.b = b, .contact = contact, .time = (double)b->world.steps * b->world.dt};
    now.x = d->pos[tr_body(disk)], now.y = d->pos[tr_body(disk) + TR_Y];
    tr_bodies_velocity(&b->world, disk, now.v);
    for (int k = 0; k < 3; k++) now.force[k] = d->force[tr_body(disk) + k] - (d->load ? d->load[tr_body(disk) + k] : 0);
    now.energy = 0.5 * d->mass[disk] * (now.v[0] * now.v[0] + now.v[1] * now.v[1]) +
                 0.5 * d->inertia[disk] * now.v[2] * now.v[2];
    now.speed = tr_hypot(now.v[0], now.v[1]);
    return now;
}

/* ---- the functions of TR_WHATS: each sets the value and, for an event, `done` */

static void mean(item *it, double value, double weight) {
    it->sum += value, it->weight += weight;
    it->value = it->sum / it->weight;
}

/* An event: when `watched` gets to 0 or changes its sign. */
static void crosses(item *it, double time, double watched) {
    double t0 = it->before[0], w0 = it->before[1];
    it->done = t0 == t0 && w0 != 0 && w0 * watched <= 0;
    if (it->done) it->value = t0 + (time - t0) * w0 / (w0 - watched);
    it->before[0] = time, it->before[1] = watched;
}

#define MEAN(function, value)                                                                                          \
    static void function(item *it, const sight *now) {                                                                 \
        mean(it, value, 1);                                                                                            \
    }
MEAN(sliding_velocity, now->contact->v_s)
MEAN(rolling_velocity, now->contact->v_r) /* by the definition of the scene */
MEAN(speed, now->speed)
MEAN(spin, now->v[2])
MEAN(place_x, now->x)
MEAN(place_y, now->y)
MEAN(torque, now->force[2]) /* of its contacts, as the power */
MEAN(power, now->force[0] * now->v[0] + now->force[1] * now->v[1] + now->force[2] * now->v[2])
MEAN(energy_lost, 1 - now->energy / it->start.energy) /* kinetic */

/* |V_s| over |(s1 + s2)/2|, each a mean. */
static void creepage(item *it, const sight *now) {
    mean(it, now->contact->v_s, 0.5 * (now->contact->s1 + now->contact->s2));
    it->value = fabs(it->value);
}

/* Power that the contact takes by friction and rolling: -(forces and moments on the bodies times their velocities). */
static void power_lost(item *it, const sight *now) {
    const tr_record *r = now->contact;
    const double *vel = now->b->world.disks.vel;
    double w1 = r->a < 0 ? 0 : vel[tr_body(r->a) + TR_TURN], w2 = vel[tr_body(r->b) + TR_TURN];
    mean(it, (r->f_t + r->f_r) * r->v_s - r->m1 * w1 - r->m2 * w2, 1);
}

static void slip_ends(item *it, const sight *now) {
    crosses(it, now->time, now->contact->v_s);
}

/* At the bound of the law, to rounding. */
static void slip_starts(item *it, const sight *now) {
    it->done = now->contact->mobilisation > 1 - 1e-9;
    if (it->done) it->value = now->time;
}

/* From the first to the last instant of the window. */
static void acceleration(item *it, const sight *now) {
    if (isnan(it->before[0])) it->before[0] = now->time, it->before[1] = now->speed;
    it->value = (now->speed - it->before[1]) / (now->time - it->before[0]);
}

/* The first time when the velocity along the initial direction is 0. */
static void stop_time(item *it, const sight *now) {
    crosses(it, now->time, now->v[0] * it->start.v[0] + now->v[1] * it->start.v[1]);
}

static void stop_distance(item *it, const sight *now) {
    stop_time(it, now);
    if (it->done) it->value = tr_hypot(now->x - it->start.x, now->y - it->start.y);
}

/* How far the centre went. */
static void rolls_from(item *it, const sight *now) {
    it->value = tr_hypot(now->x - it->start.x, now->y - it->start.y);
}

/* How far the contact slid. */
static void slips_from(item *it, const sight *now) {
    if (now->contact) it->sum += now->contact->v_s * now->b->world.dt;
    it->value = fabs(it->sum);
}

#define FUNCTION(choice, name, dim, unit, whose, when, function) [choice] = function,
static void (*const measure[TR_N_WHATS])(item *, const sight *) = {TR_WHATS(FUNCTION)};

static const tr_record *find(const tr_record *records, int n, tr_contact_id pick) {
    for (int i = 0; i < n; i++)
        if (records[i].a == pick.a && records[i].b == pick.b) return &records[i];
    return NULL;
}

void tr_checks_step(tr_checks *c, const tr_bodies *b, const tr_record *records, int n) {
    for (int k = 0; k < c->scene->n_checks; k++) {
        const tr_scene_check *check = &c->scene->checks[k];
        item *it = &c->item[k];
        bool of_contact = tr_whats[check->what].whose == TR_OF_CONTACT, first = b->world.steps == 0;
        bool due = is_due(check, (double)b->world.steps * b->world.dt, b->world.dt);
        if (it->done || !(first || due)) continue;
        sight now = look(b, check->disk, of_contact ? find(records, n, check->contact.item[0]) : NULL);
        if (first) it->start = now;
        if (!due || (of_contact && !now.contact)) continue;
        measure[check->what](it, &now);
        if (!isfinite(it->value)) it->value = NAN; /* over a rolling, an energy, a time of 0 */
    }
}

void tr_checks_results(const tr_checks *c, tr_check_result *result) {
    for (int k = 0; k < c->scene->n_checks; k++) {
        const tr_scene_check *check = &c->scene->checks[k];
        double measured = c->item[k].value;
        const tr_what_row *row = &tr_whats[check->what];
        result[k] = (tr_check_result){
            .lane = c->scene->label, .shape = c->scene->shape, .check = check, .what = row->name, .unit = row->unit};
        result[k].measured = measured;
        result[k].ok = fabs(measured - check->exact) <= check->tolerance; /* false for NaN */
        if (row->whose == TR_OF_CONTACT)
            tr_contact_name_write(check->contact.item[0], result[k].of);
        else
            snprintf(result[k].of, sizeof result[k].of, "disk %d", check->disk);
    }
}

/* ---- thresholds ---- */

/* On a slope: the normal of wall 0, and the direction down along gravity, else along t. */
static void lean(tr_scene *scene, double slope) {
    const tr_scene_wall *w = scene->walls;
    double g = tr_hypot(scene->gravity.x, scene->gravity.y), tx = w->ny, ty = -w->nx;
    double side = scene->gravity.x * tx + scene->gravity.y * ty < 0 ? -1 : 1;
    scene->gravity.x = g * (side * tr_sin(slope) * tx - tr_cos(slope) * w->nx);
    scene->gravity.y = g * (side * tr_sin(slope) * ty - tr_cos(slope) * w->ny);
    scene->gravity.turn = 0;
}

/* The result of the function of the check in the second half of a run from rest. In the first half the springs take up
 * the load. */
static bool creeps(tr_bodies *b, const tr_scene_check *check, double *distance, const tr_run_options *options,
                   tr_status *st) {
    item it = {0};
    tr_record *records = NULL;
    int capacity = 0;
    bool of_floor = tr_whats[check->what].whose == TR_OF_FLOOR;
    for (int64_t k = 0; k <= b->steps; k++) {
        if (k % 256 == 0 && tr_run_stopped(options)) {
            tr_status_fail(st, TR_INTERRUPTED, "stopped in the search of a threshold");
            break;
        }
        if (k) tr_bodies_advance(b);
        if (!tr_step_forces(&b->world, st)) break;
        if (k < b->steps / 2) continue;
        int n = of_floor ? tr_record_all(&b->world, &records, &capacity, st) : 0;
        sight now = look(b, check->disk, find(records, n, (tr_contact_id){-1, check->disk}));
        if (k == b->steps / 2) it.start = now;
        measure[check->what](&it, &now);
    }
    free(records);
    *distance = it.value;
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
    double g = tr_hypot(given->gravity.x, given->gravity.y);
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
        if (tr_whats[check->what].when != TR_SLOPE) continue;
        if (!bisect(c->scene, check, &c->item[k].value, options, st)) return false;
        c->item[k].done = true;
    }
    return true;
}

void tr_checks_adopt(tr_checks *c, const tr_checks *found) {
    for (int k = 0; k < c->scene->n_checks; k++)
        if (tr_whats[c->scene->checks[k].what].when == TR_SLOPE) c->item[k] = found->item[k];
}
