/* SPDX-License-Identifier: MIT */
#include "study/converge_cost.h"

#include "laws/law.h"
#include "base/math.h"
#include <math.h>
#include <stdlib.h>

/* The least of sqrt(m/k) over the bodies, in seconds, with the stiffness that the normal law gives by a name. */
static double swing(const tr_scene *s, double mass) {
    const tr_scene_law *normal = &s->contact.normal;
    const double *k = tr_law_value(tr_laws_normal[normal->law], normal->par, "k_n");
    if (!k) k = tr_law_value(tr_laws_normal[normal->law], normal->par, "E_star");
    return k && *k > 0 ? sqrt(mass / *k) : 1e-6;
}

static double mass_of(const tr_scene *s, double radius, double density) {
    return density * M_PI * radius * radius * (s->shape == TR_SHAPE_SPHERE ? 4. / 3 * radius : 1);
}

static double steps_per_second(const tr_scene *s, double mass) {
    double dt = s->step.dt > 0 ? s->step.dt : s->step.safety * 0.3 * swing(s, mass);
    return 1 / dt;
}

double tr_converge_guess(const tr_scene *s) {
    enum { START = 15 };                                            /* of a program, of a file [ms] */
    static const double CONTACT = 6e-8, LAW = 3e-6, ELEMENT = 1e-8; /* a step of one, of this machine's kind [s] */
    double work = 0;
    int64_t path = 0;
    for (int i = 0; i < s->n_segments; i++) path += s->path[i].steps;
    if (s->kind == TR_KIND_BIAXIAL) {
        double light = mass_of(s, s->sample.r_min, s->sample.density);
        double mean = mass_of(s, 0.5 * (s->sample.r_min + s->sample.r_max), s->sample.density);
        double rate = s->shear.inertial_number * sqrt(s->shear.lateral_pressure / mean);
        double steps = s->shear.strain_end / rate * steps_per_second(s, light) + 5e4; /* 5e4: a compaction */
        work = steps * 1.6 * s->sample.disks * CONTACT;
    } else if (s->kind == TR_KIND_BODIES) {
        double light = INFINITY;
        for (int i = 0; i < s->n_disks; i++) light = fmin(light, mass_of(s, s->disks[i].radius, s->disks[i].density));
        work = s->time_end * steps_per_second(s, light) * (s->n_disks + 1) * 5 * CONTACT * (1 + s->n_more);
    } else if (s->kind == TR_KIND_CONTACT) {
        work = (double)path * s->n_laws * LAW;
    } else {
        work = (double)path * s->patch.elements * s->patch.elements * ELEMENT;
    }
    return work + START * 1e-3;
}

double tr_converge_wall(const tr_converge *c, double seconds, int runs) {
    static const double START = 0.05; /* of a process, and its files [s] */
    int jobs = c->options->jobs < runs ? c->options->jobs : runs;
    return ceil((double)runs / jobs) * (seconds + START);
}

double tr_converge_cost(const tr_converge *c, const tr_converge_ladder *l, int level) {
    int near = l->own;
    for (int k = 0; k < l->n; k++)
        if (l->level[k].state == TR_LEVEL_DONE && abs(k - level) < abs(near - level)) near = k;
    return tr_converge_wall(c, l->level[near].seconds * tr_pow(l->cause->cost, level - near), c->n_seeds);
}
