/* SPDX-License-Identifier: MIT */
#include "study/contact.h"

#include "base/alloc.h"
#include "laws/law.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A law and its tile of one contact. */
typedef struct line {
    tr_tile tile;
    const tr_law *friction, *rolling;
    tr_pass_run *rolling_velocity; /* NULL: not needed */
    tr_law_data friction_data, rolling_data;
    double hist[2][TR_MAX_HIST], pair[2][TR_MAX_PAIR];
    double R1, R2, g1;
} line;

struct tr_contact {
    const tr_scene *scene;
    int64_t step;                            /* taken so far */
    int segment, k;                          /* step k of this segment comes next, from 1 */
    double P_start, slide_start, roll_start; /* at the start of the segment */
    line *lines;                             /* one for each law */
};

/* A law that knows the inertia of the bodies compares a moment with what stops them within a step. */
static bool needs_density(const tr_law *law) {
    return law->pair != NULL;
}

static bool needs_time(const tr_law *law) {
    return !(law->claims & TR_RATE_INDEPENDENT) || needs_density(law);
}

static bool check_law(const tr_scene *scene, int number, const char *slot, const tr_law *law, tr_status *st) {
    const char *name = law->table.name;
    if (needs_density(law) && scene->pair.density == 0)
        return tr_status_fail(st, TR_BAD_CASE,
                              "error: `laws.%d`: %s: %s depends on the inertia of the bodies: give `bodies.density`",
                              number, slot, name);
    for (int i = 0; i < scene->n_segments && needs_time(law); i++)
        if (scene->path[i].time == 0)
            return tr_status_fail(st, TR_BAD_CASE,
                                  "error: `laws.%d`: %s: %s depends on the rate: give `path.%d.time`, how long the "
                                  "segment takes",
                                  number, slot, name, i);
    return true;
}

bool tr_contact_check(const tr_scene *scene, tr_status *st) {
    for (int i = 0; i < scene->n_laws; i++) {
        const tr_scene_contact *c = &scene->laws[i];
        if (!check_law(scene, i, "friction", tr_laws_friction[c->friction.law], st) ||
            !check_law(scene, i, "rolling", tr_laws_rolling[c->rolling.law], st))
            return false;
    }
    return true;
}

/* What a law sees: its parameters from the scene, history and pair constants from the line. */
static tr_law_data bind(const tr_law *law, const tr_scene_law *chosen, const tr_pair_bodies *bodies, double *hist,
                        double *pair) {
    tr_law_data data = {.par = chosen->par};
    for (int k = 0; k < law->n_hist; k++) data.hist[k] = hist + k;
    for (int k = 0; k < law->n_pair; k++) data.pair[k] = pair + k;
    if (law->pair) law->pair(chosen->par, bodies, pair);
    return data;
}

static void set_line(line *l, const tr_scene_contact *laws, const tr_scene_pair *pair) {
    double m = pair->density * M_PI; /* unused where density is 0: see tr_contact_check */
    tr_pair_bodies bodies = {
        .R1 = pair->R1, .R2 = pair->R2, .m1 = m * pair->R1 * pair->R1, .m2 = m * pair->R2 * pair->R2};
    l->R1 = pair->R1, l->R2 = pair->R2, l->g1 = pair->R1 / (pair->R1 + pair->R2);
    l->friction = tr_laws_friction[laws->friction.law];
    l->rolling = tr_laws_rolling[laws->rolling.law];
    if (l->rolling->needs & TR_NEEDS_V_R) l->rolling_velocity = tr_rolling_velocities[laws->rolling_velocity].step;
    l->friction_data = bind(l->friction, &laws->friction, &bodies, l->hist[0], l->pair[0]);
    l->rolling_data = bind(l->rolling, &laws->rolling, &bodies, l->hist[1], l->pair[1]);
    l->tile.n = 1;
    l->tile.R1 = &l->R1, l->tile.R2 = &l->R2, l->tile.g1 = &l->g1;
    l->tile.dx[0] = pair->R1 + pair->R2;
}

tr_contact *tr_contact_new(const tr_scene *scene, tr_status *st) {
    if (!tr_contact_check(scene, st)) return NULL;
    tr_contact *c = tr_alloc(1, sizeof *c, st);
    if (!c) return NULL;
    *c = (tr_contact){.scene = scene, .k = 1, .P_start = scene->path[0].force};
    c->lines = tr_alloc((size_t)scene->n_laws, sizeof *c->lines, st);
    if (!c->lines) return free(c), NULL;
    for (int i = 0; i < scene->n_laws; i++) set_line(&c->lines[i], &scene->laws[i], &scene->pair);
    return c;
}

void tr_contact_free(tr_contact *c) {
    if (!c) return;
    free(c->lines);
    free(c);
}

int64_t tr_contact_steps(const tr_scene *scene) {
    int64_t steps = 0;
    for (int i = 0; i < scene->n_segments; i++) steps += scene->path[i].steps;
    return steps;
}

/* The pipeline of an assembly, less the normal law. */
static void run_passes(line *l, double P, double w1, double w2, double dt) {
    tr_tile *t = &l->tile;
    t->dt = dt;
    t->w1[0] = w1, t->w2[0] = w2;
    tr_kinematics_pair(t, NULL);
    t->f_elastic[0] = t->f_n[0] = P;
    if (l->friction->step) l->friction->step(t, &l->friction_data);
    if (l->rolling_velocity) l->rolling_velocity(t, NULL);
    if (l->rolling->step) l->rolling->step(t, &l->rolling_data);
}

static void read_line(const line *l, tr_contact_state *s) {
    tr_lane energy, bound = {0};
    if (l->friction->step) l->friction->state(&l->tile, &l->friction_data, energy, bound);
    s->Q = l->tile.f_t[0] + 0.0; /* a zero has no sign in a table */
    s->q = bound[0] > 0 ? fabs(s->Q) / bound[0] : 0;
    s->moment_1 = l->tile.m1[0] + 0.0, s->moment_2 = l->tile.m2[0] + 0.0;
    s->f_r = l->tile.f_r[0] + 0.0;
}

static bool is_finite(const tr_contact_state *s) {
    return isfinite(s->u_slide) && isfinite(s->u_roll) && isfinite(s->P) && isfinite(s->a) && isfinite(s->Q) &&
           isfinite(s->q) && isfinite(s->moment_1) && isfinite(s->moment_2) && isfinite(s->f_r);
}

bool tr_contact_step(tr_contact *c, tr_contact_state *state, tr_status *st) {
    const tr_scene_pair *pair = &c->scene->pair;
    const tr_scene_segment *g = &c->scene->path[c->segment];
    const double dt = (g->time > 0 ? g->time : 1) / g->steps; /* no law that asks for a time is without one */
    const double v_slide = g->slide / (dt * g->steps), v_roll = g->roll / (dt * g->steps);
    const double w1 = (v_slide / 2 - v_roll) / pair->R1, w2 = (v_slide / 2 + v_roll) / pair->R2;
    const double part = (double)c->k / g->steps;
    tr_contact_state s = {.step = ++c->step, .segment = c->segment};
    s.u_slide = c->slide_start + part * g->slide, s.u_roll = c->roll_start + part * g->roll;
    s.P = c->k == g->steps ? g->force : c->P_start + part * (g->force - c->P_start);
    s.a = sqrt(4 * s.P * pair->R_star / (M_PI * pair->E_star));
    for (int i = 0; i < c->scene->n_laws; i++) {
        s.law = i;
        run_passes(&c->lines[i], s.P, w1, w2, dt);
        read_line(&c->lines[i], &s);
        if (!is_finite(&s))
            return tr_status_fail(st, TR_NUMERICAL, "error: a number of laws.%d is not finite at step %lld (path.%d)",
                                  i, (long long)s.step, s.segment);
        state[i] = s;
    }
    if (c->k++ == g->steps) {
        c->P_start = s.P, c->slide_start = s.u_slide, c->roll_start = s.u_roll;
        c->segment++, c->k = 1;
    }
    return true;
}
