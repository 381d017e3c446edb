/* SPDX-License-Identifier: MIT */
#include "study/contact.h"

#include "base/alloc.h"
#include "laws/kinematics.h"
#include "laws/law.h"
#include "patch/cut.h"
#include "patch/half_plane.h"
#include "scene/what.h"
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The laws of one item and their tile of one contact. */
typedef struct line {
    tr_tile tile;
    const tr_law *normal, *friction, *rolling;
    const void *normal_par;
    tr_pass_run *rolling_velocity; /* NULL: not needed */
    tr_law_data friction_data, rolling_data;
    double hist[2][TR_MAX_HIST], pair[2][TR_MAX_PAIR];
    double *hist_at[2][TR_MAX_HIST], *pair_at[2][TR_MAX_PAIR];
    tr_half_plane *exact; /* of the law that is solved by patch/, else NULL */
    double mu;            /* of it */
    bool creeps;          /* friction depends on the width of the contact, so on the rolled distance */
    double R1, R2, g1, E_star;
    double P, delta;             /* now */
    double P_start, delta_start; /* at the start of the segment */
} line;

struct tr_contact {
    const tr_scene *scene;
    int64_t step;                   /* taken so far */
    int segment, k;                 /* step k of this segment comes next, from 1 */
    double slide_start, roll_start; /* at the start of the segment */
    line *lines;                    /* one for each item of laws */
};

/* Of an item: from its friction law, its normal law, or the bodies. */
static double modulus(const tr_scene_contact *laws, const tr_scene *scene) {
    const double *friction = tr_law_value(tr_laws_friction[laws->friction.law], laws->friction.par, "E_star");
    const double *normal = tr_law_value(tr_laws_normal[laws->normal.law], laws->normal.par, "E_star");
    return friction ? *friction : normal ? *normal : scene->pair.E_star;
}

static void bind(line *l, int which, const tr_law *law, const tr_scene_law *chosen, const tr_pair_bodies *bodies,
                 tr_shape shape, tr_law_data *data) {
    for (int k = 0; k < TR_MAX_HIST; k++) l->hist_at[which][k] = &l->hist[which][k];
    for (int k = 0; k < TR_MAX_PAIR; k++) l->pair_at[which][k] = &l->pair[which][k];
    if (law->pair) law->pair(chosen->par, bodies, l->pair[which]);
    *data = (tr_law_data){.par = chosen->par,
                          .hist = l->hist_at[which],
                          .pair = l->pair_at[which],
                          .normal = l->normal,
                          .normal_par = l->normal_par,
                          .shape = shape};
}

static void set_line(line *l, const tr_scene_contact *laws, const tr_scene *scene) {
    const tr_scene_pair *pair = &scene->pair;
    bool sphere = scene->shape == TR_SHAPE_SPHERE;
    double R1 = pair->R1, R2 = pair->R2, of_mass = tr_law_inertia(scene->shape);
    /* The masses are those of free bodies. Density 0, not given: no law that is here asks for the inertia. */
    double m1 = pair->density * M_PI * R1 * R1 * (sphere ? 4 * R1 / 3 : 1);
    double m2 = pair->density * M_PI * R2 * R2 * (sphere ? 4 * R2 / 3 : 1);
    tr_pair_bodies bodies = {.R1 = R1,
                             .R2 = R2,
                             .m1 = m1,
                             .m2 = m2,
                             .I1 = of_mass * m1 * R1 * R1,
                             .I2 = of_mass * m2 * R2 * R2,
                             .on_path = true};
    l->R1 = R1, l->R2 = R2, l->g1 = R1 / (R1 + R2);
    l->E_star = modulus(laws, scene);
    l->normal = tr_laws_normal[laws->normal.law], l->normal_par = laws->normal.par;
    l->friction = tr_laws_friction[laws->friction.law];
    l->creeps = l->friction->step && tr_law_value(l->friction, laws->friction.par, "E_star");
    l->rolling = tr_laws_rolling[laws->rolling.law];
    l->rolling_velocity = tr_law_rolling_velocity(l->rolling, laws->rolling_velocity);
    bind(l, 0, l->friction, &laws->friction, &bodies, scene->shape, &l->friction_data);
    bind(l, 1, l->rolling, &laws->rolling, &bodies, scene->shape, &l->rolling_data);
    l->tile.n = 1;
    l->tile.R1 = &l->R1, l->tile.R2 = &l->R2, l->tile.g1 = &l->g1;
    l->tile.dx[0] = R1 + R2;
}

static bool set_exact(line *l, const tr_scene_contact *laws, const tr_scene *scene, tr_status *st) {
    const double *par = laws->friction.par;
    if (!(l->friction->needs & TR_SOLVED_BY_PATCH)) return true;
    double depth = tr_law_depth(*tr_law_value(l->friction, par, "depth"), l->R1, l->R2);
    l->mu = *tr_law_value(l->friction, par, "mu");
    tr_patch_pair pair = {scene->pair.R_star, l->E_star, depth, l->mu};
    return (l->exact = tr_half_plane_new(&pair, *tr_law_count(l->friction, par, "elements"), st)) != NULL;
}

/* The normal law is a curve here, without its dashpot: force gives overlap, or the reverse. */
static void press(line *l, bool by_force, double value) {
    if (by_force) {
        l->P = value;
        l->delta = l->normal->overlap(l->normal_par, l->R1, l->R2, value);
    } else {
        l->delta = value;
        l->P = value > 0 ? l->normal->elastic(l->normal_par, l->R1, l->R2, value).force : 0;
    }
}

/* The segment begins at the present point of the path; the first one begins with its own force or overlap. */
static void begin_segment(tr_contact *c) {
    const tr_scene_segment *g = &c->scene->path[c->segment];
    bool by_force = !isnan(g->force);
    for (int i = 0; i < c->scene->n_laws; i++) {
        line *l = &c->lines[i];
        if (c->step == 0) press(l, by_force, by_force ? g->force : g->overlap);
        l->P_start = l->P, l->delta_start = l->delta;
    }
}

tr_contact *tr_contact_new(const tr_scene *scene, tr_status *st) {
    tr_contact *c = tr_alloc(1, sizeof *c, st);
    if (!c) return NULL;
    *c = (tr_contact){.scene = scene, .k = 1};
    c->lines = tr_alloc((size_t)scene->n_laws, sizeof *c->lines, st);
    if (!c->lines) return free(c), NULL;
    bool ok = true;
    for (int i = 0; ok && i < scene->n_laws; i++) {
        set_line(&c->lines[i], &scene->laws[i], scene);
        ok = set_exact(&c->lines[i], &scene->laws[i], scene, st);
    }
    if (!ok) return tr_contact_free(c), NULL;
    begin_segment(c);
    return c;
}

void tr_contact_free(tr_contact *c) {
    if (!c) return;
    for (int i = 0; i < c->scene->n_laws; i++) tr_half_plane_free(c->lines[i].exact);
    free(c->lines);
    free(c);
}

double tr_contact_value(const tr_contact_state *state, int column) {
#define FIELD(name, ...) [TR_COLUMN_##name] = offsetof(tr_contact_state, name),
    static const size_t field[TR_N_PATCH_COLUMNS] = {TR_COLUMNS(FIELD) TR_PATCH_COLUMNS(FIELD)};
    return *(const double *)(const void *)((const char *)state + field[column]);
}

int64_t tr_contact_steps(const tr_scene *scene) {
    int64_t steps = 0;
    for (int i = 0; i < scene->n_segments; i++) steps += scene->path[i].steps;
    return steps;
}

/* The pipeline of an assembly, without the normal law. */
static bool run_passes(line *l, double w1, double w2, double dt, tr_status *st) {
    tr_tile *t = &l->tile;
    t->dt = dt;
    t->w1[0] = w1, t->w2[0] = w2;
    tr_kinematics_pair(t, NULL);
    t->delta[0] = l->delta;
    t->f_elastic[0] = t->f_n[0] = l->P;
    if (l->friction->step) l->friction->step(t, &l->friction_data);
    if (l->exact) {
        tr_patch_step step = {.P = l->P, .dr = -0.5 * (t->s1[0] + t->s2[0]) * dt, .du = t->v_s[0] * dt};
        if (!tr_half_plane_go(l->exact, &step, st)) return false;
        t->f_t[0] = tr_half_plane_state(l->exact)->Q;
    }
    if (l->rolling_velocity) l->rolling_velocity(t, NULL);
    if (l->rolling->step) l->rolling->step(t, &l->rolling_data);
    return true;
}

static void read_line(const line *l, tr_contact_state *s) {
    tr_lane energy, bound = {0};
    if (l->friction->step) l->friction->state(&l->tile, &l->friction_data, energy, bound);
    if (l->exact) bound[0] = l->mu * l->P;
    s->Q = l->tile.f_t[0] + 0.0; /* a zero has no sign in a table */
    s->q = bound[0] > 0 ? s->Q / bound[0] : 0;
    s->moment_1 = l->tile.m1[0] + 0.0, s->moment_2 = l->tile.m2[0] + 0.0;
    s->f_r = l->tile.f_r[0] + 0.0;
    s->merged = l->friction->merged ? (int64_t)l->hist[0][l->friction->merged - 1] : 0;
}

static bool is_finite(const tr_contact_state *s) {
    return isfinite(s->u_slide) && isfinite(s->u_roll) && isfinite(s->P) && isfinite(s->overlap) && isfinite(s->a) &&
           isfinite(s->Q) && isfinite(s->q) && isfinite(s->moment_1) && isfinite(s->moment_2) && isfinite(s->f_r);
}

/* Steps of a friction law that creeps, in a row of a file: the row is a piece of a path, not a step that an assembly
 * takes. */
static int steps_of_row(const tr_contact *c, const line *l, double P, double roll) {
    enum { ELEMENTS = 200 };
    if (!c->scene->path_file || !l->creeps) return 1;
    double a = tr_law_width(c->scene->shape, P, c->scene->pair.R_star, l->E_star);
    return tr_patch_pieces(a, a, ELEMENTS, roll);
}

/* To the force or the overlap `to`. */
static bool advance(const tr_contact *c, line *l, double to, double w1, double w2, double dt, tr_status *st) {
    const tr_scene_segment *g = &c->scene->path[c->segment];
    const bool by_force = !isnan(g->force);
    const double from = by_force ? l->P : l->delta;
    const int n = by_force ? steps_of_row(c, l, to, g->roll) : 1;
    for (int k = 1; k <= n; k++) {
        press(l, by_force, k == n ? to : from + (to - from) * k / n);
        if (!run_passes(l, w1, w2, dt / n, st)) return false;
    }
    return true;
}

bool tr_contact_step(tr_contact *c, tr_contact_state *state, tr_status *st) {
    const tr_scene_pair *pair = &c->scene->pair;
    const tr_scene_segment *g = &c->scene->path[c->segment];
    const bool by_force = !isnan(g->force), last = c->k == g->steps;
    const double dt = (g->time > 0 ? g->time : 1) / g->steps; /* a law that needs a time has one */
    const double v_slide = g->slide / (dt * g->steps), v_roll = g->roll / (dt * g->steps);
    const double w1 = (v_slide / 2 - v_roll) / pair->R1, w2 = (v_slide / 2 + v_roll) / pair->R2;
    const double part = (double)c->k / g->steps, goal = by_force ? g->force : g->overlap;
    tr_contact_state s = {.step = ++c->step, .segment = c->segment};
    s.u_slide = c->slide_start + part * g->slide, s.u_roll = c->roll_start + part * g->roll;
    for (int i = 0; i < c->scene->n_laws; i++) {
        line *l = &c->lines[i];
        double start = by_force ? l->P_start : l->delta_start;
        bool ok = s.step > 1 || run_passes(l, 0, 0, dt, st); /* at its first force the contact is at rest, Q = 0 */
        if (!ok || !advance(c, l, last ? goal : start + part * (goal - start), w1, w2, dt, st)) {
            size_t used = strlen(st->text);
            snprintf(st->text + used, sizeof st->text - used, ", in laws.%d at step %lld (path.%d)", i,
                     (long long)s.step, s.segment);
            return false;
        }
        s.law = i, s.P = l->P, s.overlap = l->delta, s.a = tr_law_width(c->scene->shape, l->P, pair->R_star, l->E_star);
        read_line(l, &s);
        if (!is_finite(&s))
            return tr_status_fail(st, TR_NUMERICAL, "error: a number of laws.%d is not finite at step %lld (path.%d)",
                                  i, (long long)s.step, s.segment);
        state[i] = s;
    }
    if (last) {
        c->slide_start = s.u_slide, c->roll_start = s.u_roll;
        c->k = 1;
        if (++c->segment < c->scene->n_segments) begin_segment(c);
    } else {
        c->k++;
    }
    return true;
}
