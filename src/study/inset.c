/* SPDX-License-Identifier: MIT */
#include "study/inset.h"

#include "laws/law.h"
#include <math.h>

enum { ELEMENTS = 60 };

/* A parameter of the friction law, else of the normal law, else 0. */
static double value_of(const tr_group *g, const char *key) {
    for (int k = TR_FRICTION; k >= TR_NORMAL; k--) {
        const double *value = tr_law_value(g->laws[k].law, g->laws[k].par, key);
        if (value) return *value;
    }
    return 0;
}

bool tr_inset_open(tr_inset *inset, const tr_world *world, tr_contact_id pick, tr_status *st) {
    *inset = (tr_inset){.pick = pick};
    if (world->shape != TR_SHAPE_DISK) return false;
    const tr_group *g = tr_world_group(world, pick.a);
    tr_pair_bodies bodies = tr_world_pair(world, g, pick.a < 0 ? -1 - pick.a : pick.a, pick.b);
    inset->pair = (tr_patch_pair){.R_star = tr_law_R_star(bodies.R1, bodies.R2),
                                  .E_star = value_of(g, "E_star"),
                                  .d = tr_law_depth(value_of(g, "depth"), bodies.R1, bodies.R2),
                                  .mu = value_of(g, "mu")};
    return (inset->solver = tr_half_plane_new(&inset->pair, ELEMENTS, st)) != NULL; /* which refuses 0 */
}

void tr_inset_close(tr_inset *inset) {
    tr_half_plane_free(inset->solver);
    inset->solver = NULL;
}

static bool is_due(const tr_inset *inset, tr_path_point now) {
    const tr_patch_pair *pair = &inset->pair;
    const tr_path_point *at = &inset->at;
    double a = tr_patch_a(pair, now.P), before = tr_patch_a(pair, at->P);
    return (now.P > 0) != (at->P > 0) ||
           fabs(now.u_slide - at->u_slide) > 0.05 * pair->mu * a * a / (2 * pair->R_star) ||
           fabs(a - before) > 2 * a / ELEMENTS;
}

static bool step_to(tr_inset *inset, tr_path_point to, tr_status *st) {
    tr_patch_step step = {.P = to.P, .dr = to.u_roll - inset->at.u_roll, .du = to.u_slide - inset->at.u_slide};
    inset->at = to;
    return tr_half_plane_go(inset->solver, &step, st);
}

static tr_path_point between(const tr_path_point *p, const tr_path_point *q, double part) {
    return (tr_path_point){.u_slide = p->u_slide + part * (q->u_slide - p->u_slide),
                           .u_roll = p->u_roll + part * (q->u_roll - p->u_roll),
                           .P = p->P + part * (q->P - p->P)};
}

bool tr_inset_step(tr_inset *inset, tr_path_point now, tr_status *st) {
    const tr_path_point *at = &inset->at;
    const double h = 2 * tr_patch_a(&inset->pair, now.P) / ELEMENTS, roll = fabs(now.u_roll - at->u_roll);
    if (now.P > 0 && at->P > 0 && roll >= h * (1 - 1e-9)) {
        double whole = floor(roll / h * (1 + 1e-9)) * h;
        if (!step_to(inset, between(at, &now, fmin(whole / roll, 1)), st)) return false;
    }
    return !is_due(inset, now) || step_to(inset, now, st);
}

double tr_inset_law(const tr_inset *inset, tr_path_point now) {
    return now.P > 0 ? now.Q / (inset->pair.mu * now.P) : 0;
}

void tr_inset_checkpoint(tr_inset *inset, tr_checkpoint *c) {
    bool open = inset->solver != NULL;
    TR_KEEP(c, &open, 1);
    if (!open) tr_inset_close(inset);
    if (!inset->solver) return;
    TR_KEEP_NUMBERS(c, &inset->at, 1);
    tr_half_plane_checkpoint(inset->solver, c);
}
