/* SPDX-License-Identifier: MIT */
#include "verify/path_reference.h"

#include "base/alloc.h"
#include <math.h>
#include <stdlib.h>

/* ---- the differential equation */

/* Over a segment of unit length. */
typedef struct equation {
    double k, mu, F0_per_root_P, slide, roll, P0, P1;
} equation;

static double rate(const equation *e, double s, double Q) {
    double P = e->P0 + s * (e->P1 - e->P0), q = P > 0 ? fmin(1, fabs(Q) / (e->mu * P)) : 0;
    return e->k * (e->slide - copysign(e->F0_per_root_P * sqrt(P) * (1 - sqrt(1 - q)) * fabs(e->roll), Q));
}

void tr_path_equation(const tr_scene *scene, double k, double mu, bool creeps, double *Q_at) {
    enum { STEPS = 100000 };
    const tr_scene_pair *b = &scene->pair;
    const double h = 1.0 / STEPS;
    equation e = {.k = k * b->E_star, .mu = mu, .P1 = scene->path[0].force};
    if (creeps) e.F0_per_root_P = mu * sqrt(4 / (M_PI * b->R_star * b->E_star));
    double Q = 0;
    for (int g = 0; g < scene->n_segments; g++) {
        const tr_scene_segment *leg = &scene->path[g];
        e.slide = leg->slide, e.roll = leg->roll, e.P0 = e.P1, e.P1 = leg->force;
        for (int i = 0; i < STEPS; i++) {
            double s = i * h, k1 = rate(&e, s, Q), k2 = rate(&e, s + h / 2, Q + h / 2 * k1);
            double k3 = rate(&e, s + h / 2, Q + h / 2 * k2), k4 = rate(&e, s + h, Q + h * k3);
            double bound = mu * (e.P0 + (s + h) * (e.P1 - e.P0));
            Q = fmin(fmax(Q + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4), -bound), bound);
            if ((i + 1) % (STEPS / TR_PATH_INSTANTS) == 0) *Q_at++ = Q;
        }
    }
}

/* ---- the bed */

typedef struct bed {
    const tr_scene_pair *pair;
    double mu, P_most;
    int n;
    double *s, *weight, *e;
    double delta, P, Q, Q_before;
} bed;

static double width(const tr_scene_pair *b, double P) {
    return sqrt(4 * P * b->R_star / (M_PI * b->E_star));
}
static double overlap(const tr_scene_pair *b, double P) {
    return P > 0 ? 2 * P / (M_PI * b->E_star) * (log(2 * b->d / width(b, P)) + 0.5) : 0;
}
static double stiffness(const tr_scene_pair *b, double P) {
    return P > 0 ? M_PI * b->E_star / (2 * log(2 * b->d / width(b, P))) : 0;
}

static bool bed_open(bed *o, const tr_scene *scene, tr_status *st) {
    o->pair = &scene->pair;
    for (int g = 0; g < scene->n_segments; g++) o->P_most = fmax(o->P_most, scene->path[g].force);
    o->s = tr_alloc((size_t)o->n * 3, sizeof *o->s, st);
    if (!o->s) return false;
    o->weight = o->s + o->n, o->e = o->weight + o->n;
    for (int i = 0; i < o->n; i++) {
        double dP = o->P_most / o->n, k0 = stiffness(o->pair, i * dP), k1 = stiffness(o->pair, (i + 1) * dP);
        o->weight[i] = k1 - k0;
        o->s[i] = (overlap(o->pair, (i + 1) * dP) * k1 - overlap(o->pair, i * dP) * k0 - dP) / (k1 - k0);
    }
    o->P = scene->path[0].force, o->delta = overlap(o->pair, o->P);
    return true;
}

static void bed_move(bed *o, double P, double du) {
    double delta = overlap(o->pair, P), Q = 0;
    for (int i = 0; i < o->n; i++) {
        double room = delta - o->s[i], part = o->s[i] < o->delta ? 1 : room / (delta - o->delta);
        double e = o->e[i] + du * part, most = room > 0 ? o->mu * room : 0;
        e = e > most ? most : e < -most ? -most : e;
        o->e[i] = e;
        Q += o->weight[i] * e;
    }
    o->delta = delta, o->P = P;
    o->Q_before = o->Q, o->Q = Q;
}

/* Q in the middle of the step: as it has changed over the step before. */
static double lost(const bed *o, tr_path_creep creep, double P, double roll) {
    double Q = o->Q + 0.5 * (o->Q - o->Q_before), a = width(o->pair, P);
    if (creep == TR_NO_CREEP || !(P > 0) || roll == 0) return 0;
    if (creep == TR_FADING) return 2 / M_PI * fabs(roll) / a * o->e[0];
    double q = fmin(1, fabs(Q) / (o->mu * P));
    return copysign(o->mu * a / o->pair->R_star * (1 - sqrt(1 - q)) * fabs(roll), Q);
}

bool tr_path_bed(const tr_scene *scene, double mu, tr_path_creep creep, double *Q_at, tr_status *st) {
    enum { STEPS = 8000, SLIDERS = 4000 };
    bed o = {.mu = mu, .n = SLIDERS};
    if (!bed_open(&o, scene, st)) return false;
    for (int g = 0; g < scene->n_segments; g++) {
        const tr_scene_segment *leg = &scene->path[g];
        double start = o.P, h = 1.0 / STEPS;
        for (int i = 0; i < STEPS; i++) {
            double P = start + (i + 1) * h * (leg->force - start), middle = 0.5 * (o.P + P);
            bed_move(&o, P, leg->slide * h - lost(&o, creep, middle, leg->roll * h));
            if ((i + 1) % (STEPS / TR_PATH_INSTANTS) == 0) *Q_at++ = o.Q;
        }
    }
    free(o.s);
    return true;
}
