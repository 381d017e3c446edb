/* SPDX-License-Identifier: MIT */
#include "study/inside.h"

#include "base/alloc.h"
#include "patch/brush.h"
#include "patch/carter.h"
#include "patch/cattaneo.h"
#include "patch/half_plane.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct tr_inside {
    const tr_scene *scene;
    tr_patch_pair pair;
    /* one of them */
    tr_half_plane *half_plane;
    tr_brush *brush;
    tr_patch_state closed; /* of a closed form */
    /* along the path */
    int64_t step;
    int segment, k;                 /* step k of this segment comes next, from 1 */
    double P_start, Q_start;        /* at the start of the segment */
    double slide_start, roll_start; /* since the start of the path, there */
    double slide, dissipated;       /* since the start of the path, now */
};

tr_patch_pair tr_inside_pair(const tr_scene *scene) {
    return (tr_patch_pair){scene->pair.R_star, scene->pair.E_star, scene->pair.d, scene->patch.mu};
}

tr_inside *tr_inside_new(const tr_scene *scene, tr_status *st) {
    tr_inside *o = tr_alloc(1, sizeof *o, st);
    if (!o) return NULL;
    const int n = scene->patch.elements;
    *o = (tr_inside){.scene = scene, .pair = tr_inside_pair(scene), .k = 1, .P_start = scene->path[0].force};
    bool ok = true;
    switch ((tr_solver)scene->patch.solver) {
    case TR_HALF_PLANE:
        ok = (o->half_plane = tr_half_plane_new(&o->pair, n, st));
        break;
    case TR_BRUSH:
        ok = (o->brush = tr_brush_new(&o->pair, n, 0, st));
        break;
    case TR_CARTER:
    case TR_CATTANEO:
        ok = tr_patch_state_new(&o->closed, &o->pair, n, st);
        break;
    }
    if (ok) return o;
    tr_inside_free(o);
    return NULL;
}

void tr_inside_free(tr_inside *o) {
    if (!o) return;
    tr_half_plane_free(o->half_plane);
    tr_brush_free(o->brush);
    tr_patch_state_free(&o->closed);
    free(o);
}

const tr_patch_state *tr_inside_patch(const tr_inside *o) {
    if (o->half_plane) return tr_half_plane_state(o->half_plane);
    return o->brush ? tr_brush_state(o->brush) : &o->closed;
}

/* Steady rolling with the creepage, or the force, of this step. */
static void carter(tr_inside *o, const tr_patch_step *step) {
    tr_patch_state *s = &o->closed;
    const tr_patch_pair *c = &o->pair;
    double q = step->by_force ? step->Q / (c->mu * step->P) : tr_carter_q(c, step->P, step->du / fabs(step->dr));
    double zone[2];
    q = fmin(fmax(q, -1), 1);
    tr_carter_stick(c, step->P, q, step->dr, zone);
    s->Q = q * c->mu * step->P;
    s->du = step->by_force ? tr_carter_creepage(c, step->P, q) * fabs(step->dr) : step->du;
    double more = s->du - tr_carter_creepage(c, step->P, q) * fabs(step->dr); /* full slip: all points slide equally
                                                                               * further */
    for (int i = 0; i < s->n; i++) {
        s->tau[i] = tr_carter_tau(c, step->P, q, step->dr, s->x[i]);
        s->slip[i] = tr_carter_slip(c, step->P, q, step->dr, s->x[i]) * fabs(step->dr);
        bool sticks = s->x[i] >= zone[0] && s->x[i] <= zone[1];
        if (fabs(q) == 1) sticks = false, s->slip[i] += more;
        s->side[i] = (signed char)(sticks ? 0 : q < 0 ? -1 : 1);
    }
}

/* Sliding in one direction from rest. Sliding beyond full slip is the same everywhere. */
static void cattaneo(tr_inside *o, const tr_patch_step *step) {
    tr_patch_state *s = &o->closed;
    const tr_patch_pair *c = &o->pair;
    double q = step->by_force ? step->Q / (c->mu * step->P) : tr_cattaneo_q(c, step->P, o->slide + step->du);
    q = fmin(fmax(q, -1), 1);
    double stick = tr_cattaneo_stick(c, step->P, q), before = fmin(fmax(s->Q / (c->mu * step->P), -1), 1);
    s->Q = q * c->mu * step->P;
    s->du = step->by_force ? tr_cattaneo_u(c, step->P, q) - o->slide : step->du;
    double more = s->du - (tr_cattaneo_u(c, step->P, q) - tr_cattaneo_u(c, step->P, before));
    if (fabs(q) < 1) more = 0; /* but for rounding */
    for (int i = 0; i < s->n; i++) {
        s->tau[i] = tr_cattaneo_tau(c, step->P, q, s->x[i]);
        s->side[i] = (signed char)(fabs(s->x[i]) <= stick ? 0 : q < 0 ? -1 : 1);
        s->slip[i] = tr_cattaneo_slip(c, step->P, q, s->x[i]) - tr_cattaneo_slip(c, step->P, before, s->x[i]) + more;
    }
}

static bool advance(tr_inside *o, const tr_patch_step *step, tr_status *st) {
    if (o->half_plane) return tr_half_plane_go(o->half_plane, step, st);
    if (o->brush) return tr_brush_go(o->brush, step, st);
    if (!tr_patch_step_check(step, &o->pair, st)) return false;
    if (step->P == 0) return tr_patch_state_clear(&o->closed), true;
    tr_patch_state_grid(&o->closed, &o->pair, step->P);
    (o->scene->patch.solver == TR_CARTER ? carter : cattaneo)(o, step);
    tr_patch_state *s = &o->closed;
    s->dissipated = 0;
    for (int i = 0; i < s->n; i++) s->dissipated += s->h * s->tau[i] * s->slip[i];
    return true;
}

/* The path starts under the force of its first segment, without friction. */
static bool start(tr_inside *o, tr_status *st) {
    return o->P_start == 0 || o->scene->patch.solver > TR_BRUSH || advance(o, &(tr_patch_step){.P = o->P_start}, st);
}

/* A failure of a solver does not know step and segment: add them. */
static bool tell_where(const tr_inside *o, tr_status *st) {
    size_t used = strlen(st->text);
    snprintf(st->text + used, sizeof st->text - used, ", at step %lld (path.%d)", (long long)o->step, o->segment);
    return false;
}

/* Elements that stick, as a width. */
static double stick_of(const tr_patch_state *s) {
    int n = 0;
    for (int i = 0; i < s->n && s->P > 0; i++) n += s->side[i] == 0;
    return n * s->h;
}

bool tr_inside_step(tr_inside *o, tr_contact_state *state, tr_status *st) {
    const tr_scene_segment *g = &o->scene->path[o->segment];
    const bool last = o->k == g->steps;
    const double part = (double)o->k / g->steps;
    tr_patch_step step = {.P = last ? g->force : o->P_start + part * (g->force - o->P_start),
                          .dr = g->roll / g->steps,
                          .by_force = !isnan(g->tangential)};
    if (step.by_force)
        step.Q = last ? g->tangential : o->Q_start + part * (g->tangential - o->Q_start);
    else
        step.du = g->slide / g->steps;
    o->step++;
    if (o->step == 1 && !start(o, st)) return tell_where(o, st);
    if (!advance(o, &step, st)) return tell_where(o, st);
    const tr_patch_state *s = tr_inside_patch(o);
    const tr_patch_pair *c = &o->pair;
    const double before = o->slide;
    o->slide = step.by_force ? o->slide + s->du : o->slide_start + part * g->slide;
    o->dissipated += s->dissipated;
    double bound = c->mu * step.P, Lambda = step.P > 0 ? tr_patch_Lambda(c, step.P) : 0;
    *state = (tr_contact_state){.step = o->step,
                                .segment = o->segment,
                                .u_slide = o->slide,
                                .u_roll = o->roll_start + part * g->roll,
                                .P = step.P,
                                .overlap = 2 * step.P / (M_PI * c->E_star) * (Lambda + 0.5),
                                .a = tr_patch_a(c, step.P),
                                .Q = s->Q + 0.0,
                                .q = bound > 0 ? fmin(fmax(s->Q / bound, -1), 1) + 0.0 : 0,
                                .p_max = tr_patch_p0(c, step.P),
                                .stick = stick_of(s),
                                .creepage = step.dr != 0 ? (o->slide - before) / fabs(step.dr) : NAN,
                                .dissipated = o->dissipated};
    if (!isfinite(state->Q) || !isfinite(state->u_slide)) {
        tr_status_fail(st, TR_NUMERICAL, "error: a force or displacement is not finite");
        return tell_where(o, st);
    }
    if (last) {
        o->P_start = step.P, o->Q_start = s->Q;
        o->slide_start = o->slide, o->roll_start = state->u_roll;
        o->segment++, o->k = 1;
    } else {
        o->k++;
    }
    return true;
}
