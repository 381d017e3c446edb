/* SPDX-License-Identifier: MIT */
#include "core/biaxial.h"
#include "base/math.h"

#include "base/vector.h"
#include "core/cell.h"
#include "core/contacts.h"
#include "core/crush.h"
#include "core/ledger.h"
#include "core/measures.h"
#include "core/pipeline.h"
#include "core/sample.h"
#include "core/step.h"
#include "core/timestep.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Soft modes of a frictionless packing are hardly damped by the dashpots; a weak drag against the frame ends them, and
 * halves the steps of compaction. It is so small that the drag on a row of moving disks stays well below the pressure.
 * The shear has none. */
static const double DRAG = 0.005; /* of sqrt(stiffness under the pressure / mean mass) */

/* Of its stability bound. Twice that halves the time of compaction and does not change e0 (mean of 24 seeds 0.2109
 * against 0.2100, spread 0.003), but it is not the default step of a shear. */
static const double COMPACTION_SAFETY = 0.4;

/* Of a row of disks: the mass of a piston between walls in the shear. See SERVO in biaxial.h. */
static const double SHARE_OF_ROW = 1.0 / 6;

/* The strain at which the driven sides are at full speed: this, or the strain in which sound crosses the sample, and at
 * most a fraction of all strain. */
static const double START = 1e-3, MOST_START = 0.2;

/* Allowed error of the held stress, as a mean over this strain. */
static const double MOST_OFF = 0.2, WINDOW = 0.01;

/* Lengths of the walls, and the forces on the pistons, follow the box. */
static void fit_walls(tr_biaxial *b, double horizontal, double lateral) {
    tr_wall *w = b->world.wall;
    tr_periodic_cell *cell = &b->world.cell;
    cell->load[0] = lateral * cell->side[1], cell->load[1] = horizontal * cell->side[0];
    double width = w[TR_RIGHT_WALL].x - w[TR_LEFT_WALL].x, height = w[TR_TOP_WALL].y - w[TR_BOTTOM_WALL].y;
    w[TR_BOTTOM_WALL].length = w[TR_TOP_WALL].length = width;
    w[TR_LEFT_WALL].length = w[TR_RIGHT_WALL].length = height;
    w[TR_BOTTOM_WALL].load = w[TR_TOP_WALL].load = horizontal * width;
    w[TR_LEFT_WALL].load = w[TR_RIGHT_WALL].load = lateral * height;
}

tr_scene_contact tr_biaxial_compaction_laws(const tr_scene *scene) {
    tr_scene_contact c = {.normal = scene->contact.normal};
    double mu = scene->compaction.mu;
    for (int i = 0; i < tr_laws_catalog()->n_rolling; i++)
        if (!tr_laws_rolling[i]->step) c.rolling.law = i;
    for (int i = 0; i < tr_laws_catalog()->n_friction; i++)
        if (!tr_laws_friction[i]->step) c.friction.law = i;
    if (mu > 0) c.friction = scene->contact.friction;
    double *friction_mu = tr_law_value(tr_laws_friction[c.friction.law], c.friction.par, "mu");
    if (friction_mu) *friction_mu = mu;
    return c;
}

double tr_biaxial_rest_mu(const tr_scene *scene) {
    tr_scene_law friction = scene->contact.friction;
    const double *mu = tr_law_value(tr_laws_friction[friction.law], friction.par, "mu");
    return mu && *mu < scene->compaction.mu ? *mu : scene->compaction.mu;
}

/* The friction of the compaction goes down to that of the shear: no list and no history changes. */
static void set_mu(tr_biaxial *b, double mu) {
    tr_group_law *friction = &b->world.group[0].laws[TR_FRICTION];
    double *value = friction->law ? tr_law_value(friction->law, friction->par, "mu") : NULL;
    b->mu = mu;
    if (value) *value = mu;
}

/* Steps in which the walls could cross the box at their largest speed. */
static double closing_steps(const tr_biaxial *b) {
    const tr_scene_compaction *c = &b->scene->compaction;
    return 1 / (c->inertial_number * sqrt(c->pressure / b->mean_mass) * b->world.dt);
}

static const double MOST_STEPS = 2e7; /* of compaction: minutes for 400 disks */

double tr_biaxial_stiffness(const tr_biaxial *b, double pressure) {
    const tr_group_law *normal = &b->world.group[0].laws[TR_NORMAL];
    double R = b->mean_radius, delta = normal->law->overlap(normal->par, R, R, 2 * R * pressure);
    return normal->law->elastic(normal->par, R, R, delta).stiffness;
}

/* Checks before the run: of the wanted stress, and of the cell at the end. */
static bool check_reach(const tr_biaxial *b, double dense, tr_status *st) {
    const tr_scene *scene = b->scene;
    const tr_group_law *normal = &b->world.group[0].laws[TR_NORMAL];
    const double R = b->mean_radius, asked[2] = {scene->compaction.pressure, scene->shear.lateral_pressure};
    for (int k = 0; k < 2; k++) {
        double overlap = normal->law->overlap(normal->par, R, R, 2 * R * asked[k]);
        if (!(overlap < TR_LARGEST_OVERLAP * R))
            return tr_status_fail(
                st, TR_BAD_CASE,
                "error: %s = %g is out of reach: it would press disks %.3g m into each other, more than "
                "0.3 of their mean radius %.3g m; give stiffer contacts or less",
                k ? "shear.lateral_pressure" : "compaction.pressure", asked[k], overlap, R);
    }
    double height = dense * (1 - scene->shear.strain_end), least = tr_cell_least_side(&b->world);
    if (b->world.n_walls || height > least) return true;
    return tr_status_fail(
        st, TR_BAD_CASE,
        "error: the periodic cell would be too thin: about %.3g m high at the end of the shear, and it "
        "must be above %.3g m, twice the largest disk and the skin of the contact list; give more "
        "sample.disks%s",
        height, least, dense > least ? " or a smaller shear.strain_end" : "");
}

bool tr_biaxial_init(tr_biaxial *b, const tr_scene *scene, tr_status *st) {
    double side[2], radius_sum = 0, mass = 0;
    int n = scene->sample.disks;
    *b = (tr_biaxial){.scene = scene};
    const tr_scene_law *friction = &scene->contact.friction;
    if (scene->compaction.mu > 0 && !tr_law_value(tr_laws_friction[friction->law], friction->par, "mu"))
        return tr_status_fail(
            st, TR_BAD_CASE,
            "error: compaction.mu = %g needs a friction law with a coefficient mu, not contact.friction: %s",
            scene->compaction.mu, tr_laws_friction[friction->law]->table.name);
    if (!tr_world_init(&b->world, n, scene->shape, st)) return false;
    bool placed = *scene->sample.file ? tr_sample_place(&b->world, &scene->sample, side, st)
                                      : tr_sample_throw(&b->world, &scene->sample, scene->boundary == TR_PERIODIC,
                                                        scene->seed, side, st);
    if (!placed) return tr_biaxial_free(b), false;
    if (!*scene->sample.file) side[1] = side[0];
    b->disk_area = tr_measures_disk_area(&b->world.disks);
    const tr_disks *d = &b->world.disks;
    for (int i = 0; i < n; i++) mass += d->mass[i], radius_sum += d->pos[tr_body(i) + TR_RADIUS];
    b->mean_mass = mass / n, b->mean_radius = radius_sum / n;

    /* side of the dense sample, for the mass of a row of disks and for the speed of an inertial number */
    double dense = sqrt(b->disk_area * 1.2), row = b->mean_mass * fmax(1, dense / (2 * b->mean_radius));
    double v_max = 0.5 * dense * scene->compaction.inertial_number * sqrt(scene->compaction.pressure / b->mean_mass);
    tr_wall walls[4] = {{.ny = 1}, {.y = side[1], .ny = -1}, {.nx = 1}, {.x = side[0], .nx = -1}};
    b->world.boxed = scene->boundary != TR_PERIODIC;
    b->world.n_walls = b->world.boxed ? 4 : 0;
    b->row_mass = row;
    for (int w = 0; w < b->world.n_walls; w++) {
        walls[w].mass = w < TR_LEFT_WALL ? 0 : SHARE_OF_ROW * row; /* of the shear, for its step */
        walls[w].length = dense, walls[w].v_max = v_max;
        b->world.wall[w] = walls[w];
    }
    if (scene->boundary == TR_PERIODIC) /* each side stands for two walls */
        b->world.cell =
            (tr_periodic_cell){.side = {side[0], side[1]}, .mass = {row, row}, .v_max = {2 * v_max, 2 * v_max}};
    tr_scene_contact laws = tr_biaxial_compaction_laws(scene);
    double bound;
    const tr_scene_step step = {.safety = COMPACTION_SAFETY};
    bool ok = tr_world_set_laws(&b->world, &scene->contact, scene->shear.walls == 0, 0, st) &&
              tr_timestep_choose(&b->world, &scene->step, 0, &b->dt_bound, st);
    b->dt = b->world.dt;
    for (int w = 0; w < b->world.n_walls; w++) b->world.wall[w].mass = row, b->world.wall[w].length = 0;
    b->mu = scene->compaction.mu;
    ok = ok && tr_world_set_laws(&b->world, &laws, true, 0, st) &&
         tr_timestep_choose(&b->world, &step, 0, &bound, st) && check_reach(b, dense, st);
    if (!ok) return tr_biaxial_free(b), false;
    if (closing_steps(b) > MOST_STEPS) {
        tr_status_fail(
            st, TR_BAD_CASE,
            "error: compaction would take about %.1g steps, more than %.0g; give a larger compaction.pressure or "
            "compaction.inertial_number, or softer contacts",
            closing_steps(b), MOST_STEPS);
        return tr_biaxial_free(b), false;
    }
    b->drag = DRAG * sqrt(tr_biaxial_stiffness(b, scene->compaction.pressure) / b->mean_mass);
    return true;
}

void tr_biaxial_free(tr_biaxial *b) {
    tr_world_free(&b->world);
}

/* On the disks at a wall, or at the sides of the cell. */
static double stress(const tr_biaxial *b, int wall) {
    const tr_wall *w = &b->world.wall[wall];
    const tr_periodic_cell *cell = &b->world.cell;
    int axis = wall == TR_LEFT_WALL || wall == TR_RIGHT_WALL ? 0 : 1;
    return b->world.n_walls ? -(w->fx * w->nx + w->fy * w->ny) / w->length
                            : tr_cell_force(cell, axis) / cell->side[1 - axis];
}

TR_VECTOR static void drag(tr_biaxial *b) {
    const tr_disks *d = &b->world.disks;
    const tr_quad flow = {tr_cell_strain_rate(&b->world.cell, 0), tr_cell_strain_rate(&b->world.cell, 1)};
    const tr_quad *pos = (const tr_quad *)d->pos, *vel = (const tr_quad *)d->vel;
    tr_quad *force = (tr_quad *)d->force;
    for (int i = 0; i < d->n; i++) {
        double c = b->drag * d->mass[i];
        force[i] -= (tr_quad){c, c} * (vel[i] - flow * pos[i]); /* spins are free */
    }
}

/* A contact was pressed too deep: the stiffness that would hold. Samples of 400 disks (mu = mu_r = 0.5) came to 5.8
 * sigma_2, and to forces of 4.7 sigma_1 2R between disks of radius R, soft ones to less: 6 of both. The force of this
 * contact, as the stresses may still grow, with a fifth more, counts too. */
static bool fail_soft(const tr_biaxial *b, tr_status *st) {
    const tr_world *world = &b->world;
    const tr_crush *c = &world->crush;
    if (!c->found) return false;
    const tr_scene_shear *shear = &b->scene->shear;
    const tr_group_law *normal = &world->group[c->walls].laws[TR_NORMAL];
    const double *pos = world->disks.pos, R1 = c->walls ? 0 : pos[tr_body(c->a) + TR_RADIUS];
    const double R2 = pos[tr_body(c->b) + TR_RADIUS];
    double one = fmax(stress(b, TR_TOP_WALL), stress(b, TR_RIGHT_WALL)),
           two = fmin(stress(b, TR_TOP_WALL), stress(b, TR_RIGHT_WALL)), R = c->walls ? R2 : fmin(R1, R2);
    double most = (shear->hold == TR_HOLD_MEAN ? 1.75 : 6) * shear->lateral_pressure; /* both at sin phi = 0.72 */
    most = fmax(fmax(most, b->scene->compaction.pressure), 1.25 * one);
    double force = normal->law->elastic(normal->par, R1, R2, c->delta).force * fmin(6, most / fmax(one, 1e-9 * most));
    tr_crush_limit limit = tr_crush_find(normal, world->shape, R1, R2, fmax(6 * most * 2 * R, 1.2 * force), 0);
    const char *unit = world->shape == TR_SHAPE_SPHERE ? "N/m" : "Pa";
    if (!limit.key) return false;
    return tr_status_more(st,
                          "; contact.%s = %.3g %s is too soft for these stresses (now %.3g and %.3g %s, and they may "
                          "grow to some %.2g): from about %.2g %s it would hold",
                          limit.key, limit.is, limit.unit, one, two, unit, most, limit.holds, limit.unit);
}

bool tr_biaxial_compact(tr_biaxial *b, int steps, double *unbalanced, bool *done, tr_status *st) {
    const double too_many = fmin(MOST_STEPS, 100 * closing_steps(b)); /* it takes one or two of the latter */
    const double pressure = b->scene->compaction.pressure, pressure_error = 1e-3;
    tr_world *world = &b->world;
    set_mu(b, b->mu); /* also after a restart */
    for (int k = 0; k < steps; k++) {
        fit_walls(b, pressure, pressure);
        if (!tr_step_forces(world, st)) return fail_soft(b, st);
        if (k == steps - 1) break;
        drag(b);
        tr_step_advance(world);
    }
    tr_record *records = NULL;
    int capacity = 0, n = tr_record_all(world, &records, &capacity, st);
    tr_measures m = tr_measures_of(world, records, n);
    free(records);
    if (st->code) return false;
    *unbalanced = n ? m.unbalanced : 1;
    *done = n > 0 && m.unbalanced < b->scene->compaction.unbalanced;
    for (int w = 0; w < 4; w++) *done = *done && fabs(stress(b, w) / pressure - 1) < pressure_error;
    drag(b);
    tr_step_advance(world);
    if (*done && b->mu > tr_biaxial_rest_mu(b->scene)) set_mu(b, tr_biaxial_rest_mu(b->scene)), *done = false;
    if ((double)world->steps > too_many)
        return tr_status_fail(
            st, TR_NUMERICAL,
            "error: compaction is not at rest after %lld steps (unbalanced ratio %.3g, asked %.3g; stresses "
            "%.4g and %.4g, asked %.4g); is there damping (contact.damping_ratio) or friction (compaction.mu)?",
            (long long)world->steps, *unbalanced, b->scene->compaction.unbalanced, stress(b, TR_TOP_WALL),
            stress(b, TR_RIGHT_WALL), pressure);
    return true;
}

bool tr_biaxial_begin_shear(tr_biaxial *b, tr_status *st) {
    const tr_scene_shear *shear = &b->scene->shear;
    tr_wall *w = b->world.wall;
    tr_biaxial_state now;
    tr_biaxial_shape(b, &now);
    b->height0 = now.height;
    b->rate = shear->inertial_number * sqrt(shear->lateral_pressure / b->mean_mass);
    b->shear_start = b->world.steps;
    b->world.dt = b->dt;
    b->world.allow_unstable = b->scene->step.allow_unstable;
    double a_step = b->rate * b->world.dt; /* of strain */
    double stiffness = tr_biaxial_stiffness(b, shear->lateral_pressure);
    double crossing = 0.5 * b->rate * b->row_mass / sqrt(stiffness * b->mean_mass); /* at half of the speed */
    b->start_steps = ceil(2 * fmin(fmax(START, crossing), MOST_START * shear->strain_end) / a_step);
    double shear_steps = ceil(shear->strain_end / a_step + 0.5 * b->start_steps);
    if (!(shear_steps <= TR_MOST_STEPS))
        return tr_status_fail(st, TR_BAD_CASE,
                              "error: the shear would take %.1e steps; give a larger shear.inertial_number",
                              shear_steps);
    b->shear_steps = (int64_t)shear_steps;
    for (int k = 0; k < 4; k++) w[k].v_max = INFINITY, w[k].mass = k < TR_LEFT_WALL ? 0 : SHARE_OF_ROW * b->row_mass;
    w[TR_BOTTOM_WALL].vy = w[TR_TOP_WALL].vy = 0;
    if (!b->world.n_walls) {
        b->world.cell.mass[0] = b->mean_mass, b->world.cell.mass[1] = 0, b->world.cell.v_max[0] = INFINITY;
        tr_cell_set_rate(&b->world, 1, 0);
    }
    return tr_world_change_laws(&b->world, &b->scene->contact, shear->walls == 0,
                                b->scene->output.energy ? TR_SINK_LEDGER : 0, st);
}

/* Fraction of the full speed `steps` steps after the start; its sum over the start is half the number of steps. */
static double speed(const tr_biaxial *b, double steps) {
    double s = fmin(fmax(steps / b->start_steps, 0), 1);
    return s * s * (3 - 2 * s);
}

/* Change of the driven sides' velocities in the next step: velocities are those of the middle of steps. */
static void drive(tr_biaxial *b) {
    double k = (double)(b->world.steps - b->shear_start), before = k > 0 ? speed(b, k - 0.5) : 0;
    double gain = b->rate * b->height0 * (speed(b, k + 0.5) - before) / b->world.dt;
    b->world.wall[TR_BOTTOM_WALL].gain = b->world.wall[TR_TOP_WALL].gain = 0.5 * gain;
    b->world.cell.gain[1] = -gain;
}

/* The wanted lateral stress at this time. */
static double asked(const tr_biaxial *b) {
    double from = b->scene->compaction.pressure, to = b->scene->shear.lateral_pressure;
    return from + (to - from) * speed(b, (double)(b->world.steps - b->shear_start));
}

static double held(const tr_biaxial *b) {
    double other = stress(b, b->scene->shear.hold == TR_HOLD_MEAN ? TR_TOP_WALL : TR_LEFT_WALL);
    return 0.5 * (other + stress(b, TR_RIGHT_WALL));
}

/* Whether the servo has held its stress over each whole window. Its error goes as I at the start, then as I^2, and
 * grows as the sample gets flat. The message gives the speed for a tenth of the allowed error. */
static bool check_held(tr_biaxial *b, tr_status *st) {
    const tr_scene_shear *shear = &b->scene->shear;
    double part = b->rate * b->world.dt * speed(b, (double)(b->world.steps - b->shear_start)); /* of strain */
    b->held_sum += part * held(b) / asked(b);
    b->held_strain += part;
    if (b->held_strain < WINDOW) return true;
    double off = b->held_sum / b->held_strain - 1;
    b->held_sum = b->held_strain = 0;
    if (fabs(off) <= MOST_OFF) return true;
    tr_biaxial_state s;
    tr_biaxial_shape(b, &s);
    return tr_status_fail(
        st, TR_NUMERICAL,
        "error: the %s stress is not held: over 1 %% of strain it was %.4g on average, asked %.4g, at strain %.4g, "
        "step %lld, time %.9g s; the test is too fast for it, and shear.inertial_number = %.2g would do",
        shear->hold == TR_HOLD_MEAN ? "mean" : "lateral", (1 + off) * shear->lateral_pressure, shear->lateral_pressure,
        s.strain, (long long)b->world.steps, (double)b->world.steps * b->world.dt,
        shear->inertial_number * 0.1 * MOST_OFF / fabs(off));
}

bool tr_biaxial_forces(tr_biaxial *b, tr_status *st) {
    tr_world *world = &b->world;
    fit_walls(b, 0, asked(b));
    if (!tr_step_forces(world, st)) return fail_soft(b, st);
    if (b->scene->shear.hold == TR_HOLD_MEAN) /* stress above the lateral stress helps the disks */
        world->cell.load[0] -= (held(b) - stress(b, TR_RIGHT_WALL)) * world->cell.side[1];
    drive(b);
    if (world->ledger) {
        if (world->steps == b->shear_start)
            tr_ledger_begin(world);
        else
            tr_ledger_walls(world);
    }
    for (int k = 0; k < 4; k++) b->stress_sum[k] += stress(b, k);
    b->stress_steps++;
    return check_held(b, st);
}

void tr_biaxial_shape(const tr_biaxial *b, tr_biaxial_state *s) {
    const tr_wall *w = b->world.wall;
    const tr_periodic_cell *cell = &b->world.cell; /* its sides are 0 if there are walls */
    s->height = w[TR_TOP_WALL].y - w[TR_BOTTOM_WALL].y + cell->side[1];
    s->width = w[TR_RIGHT_WALL].x - w[TR_LEFT_WALL].x + cell->side[0];
    s->strain = (b->height0 - s->height) / b->height0;
    s->time = (double)(b->world.steps - b->shear_start) * b->world.dt;
    s->void_ratio = s->height * s->width / b->disk_area - 1;
}

tr_biaxial_state tr_biaxial_read(tr_biaxial *b) {
    tr_biaxial_state s;
    double steps = (double)b->stress_steps;
    tr_biaxial_shape(b, &s);
    s.stress_1 = (b->stress_sum[TR_BOTTOM_WALL] + b->stress_sum[TR_TOP_WALL]) / (2 * steps);
    s.stress_2 = (b->stress_sum[TR_LEFT_WALL] + b->stress_sum[TR_RIGHT_WALL]) / (2 * steps);
    double sum = s.stress_1 + s.stress_2;
    s.sin_phi = sum > 0 ? (s.stress_1 - s.stress_2) / sum : 0;
    memset(b->stress_sum, 0, sizeof b->stress_sum);
    b->stress_steps = 0;
    return s;
}

double tr_biaxial_tan_phi(double sin_phi) {
    return fabs(sin_phi) < 1 ? tr_tan(tr_asin(sin_phi)) : NAN;
}
