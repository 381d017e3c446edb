/* SPDX-License-Identifier: MIT */
#include "study/converge_causes.h"

#include "laws/bed.h"
#include "laws/law.h"
#include "base/math.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { BIAXIAL = 1 << TR_KIND_BIAXIAL, BODIES = 1 << TR_KIND_BODIES, CONTACT = 1 << TR_KIND_CONTACT };
enum { PATCH = 1 << TR_KIND_PATCH };

static double safety(const tr_scene *s, int item) {
    (void)item;
    return s->step.dt > 0 ? NAN : s->step.safety;
}
static double dt(const tr_scene *s, int item) {
    (void)item;
    return s->step.dt > 0 ? s->step.dt : NAN;
}
static int segments(const tr_scene *s) {
    return s->n_segments;
}
static double path_steps(const tr_scene *s, int item) {
    return s->path_file ? NAN : s->path[item].steps;
}

static int laws(const tr_scene *s) {
    return s->n_laws;
}
static double law_elements(const tr_scene *s, int item) {
    const tr_scene_law *friction = &s->laws[item].friction;
    const int *elements = tr_law_count(tr_laws_friction[friction->law], friction->par, "elements");
    return elements ? *elements : NAN;
}
static double law_breakpoints(const tr_scene *s, int item) {
    const tr_scene_law *friction = &s->laws[item].friction;
    const int *n = tr_law_count(tr_laws_friction[friction->law], friction->par, "breakpoints");
    return !n ? NAN : *n ? *n : TR_BED_POINTS;
}
static double breakpoints(const tr_scene *s, int item) {
    (void)item;
    const tr_scene_law *friction = &s->contact.friction;
    const int *n = tr_law_count(tr_laws_friction[friction->law], friction->par, "breakpoints");
    return !n ? NAN : *n ? *n : TR_BED_POINTS;
}
static double patch_elements(const tr_scene *s, int item) {
    (void)item;
    return s->patch.elements;
}

static double inertial_number(const tr_scene *s, int item) {
    (void)item;
    return s->shear.inertial_number;
}
static double stiffness(const tr_scene *s, int item) {
    (void)item;
    const tr_scene_law *normal = &s->contact.normal;
    const double *k_n = tr_law_value(tr_laws_normal[normal->law], normal->par, "k_n");
    return k_n ? *k_n : NAN;
}
static double unbalanced(const tr_scene *s, int item) {
    (void)item;
    return s->compaction.unbalanced;
}
static double disks(const tr_scene *s, int item) {
    (void)item;
    return s->sample.disks;
}

/* The order of a row is that of the columns of the table. */
const tr_cause tr_causes[] = {
    {"step", "the time step", BIAXIAL, "step.safety", 0.5, 2, 1, 3, NAN, false, true, 1e-6, 1, NULL, safety},
    {"step", "the time step", BODIES, "step.safety", 0.5, 2, 1, 8, 2, false, true, 1e-6, 1, NULL, safety},
    {"step", "the time step", BIAXIAL, "step.dt", 0.5, 2, 1, 3, NAN, false, true, 0, 1e6, NULL, dt},
    {"step", "the time step", BODIES, "step.dt", 0.5, 2, 1, 8, 2, false, true, 0, 1e6, NULL, dt},
    {"step", "the steps of the path", CONTACT | PATCH, "path.*.steps", 2, 2, 1, 6, 1, true, true, 1, 1e6, segments,
     path_steps},
    {"elements", "the elements of the half-plane", CONTACT, "laws.*.elements", 2, 4, 1, 4, 1, true, true, 3, 4000, laws,
     law_elements},
    {"elements", "the elements of the contact", PATCH, "elements", 2, 4, 1, 4, 1, true, true, 3, 4000, NULL,
     patch_elements},
    {"merging", "the merging of the bed's history", CONTACT, "laws.*.breakpoints", M_SQRT2, 1.1, 4, 0, NAN, true, true,
     4, 16, laws, law_breakpoints},
    {"merging", "the merging of the bed's history", BODIES, "contact.breakpoints", M_SQRT2, 1.1, 4, 0, NAN, true, true,
     4, 16, NULL, breakpoints},
    {"inertia", "the speed of the test", BIAXIAL, "shear.inertial_number", 0.5, 2, 1, 3, NAN, false, true, 0, 1e6, NULL,
     inertial_number},
    {"stiffness", "the stiffness of the contacts", BIAXIAL, "contact.k_n", 2, 1.4, 1, 3, NAN, false, true, 0, 1e15,
     NULL, stiffness},
    {"compaction", "the end of the compaction", BIAXIAL, "compaction.unbalanced", 0.25, 1.2, 1, 3, NAN, false, true,
     1e-12, 0.1, NULL, unbalanced},
    {"size", "the size of the sample", BIAXIAL, "sample.disks", 4, 4.5, 1, 3, NAN, true, false, 100, 6400, NULL, disks},
};
const int tr_n_causes = sizeof tr_causes / sizeof *tr_causes;

int tr_cause_keys(const tr_cause *cause, const tr_scene *scene) {
    return cause->items ? cause->items(scene) : 1;
}

void tr_cause_key(const tr_cause *cause, int item, char *key, size_t size) {
    const char *star = strchr(cause->key, '*');
    if (star)
        snprintf(key, size, "%.*s%d%s", (int)(star - cause->key), cause->key, item, star + 1);
    else
        snprintf(key, size, "%s", cause->key);
}

bool tr_cause_applies(const tr_cause *cause, const tr_scene *scene) {
    bool applies = false;
    if (!(cause->kinds & 1u << scene->kind)) return false;
    for (int i = 0; i < tr_cause_keys(cause, scene); i++) applies |= !isnan(cause->own(scene, i));
    return applies;
}

double tr_cause_setting(const tr_cause *cause, const tr_scene *scene, int item, int level) {
    double x = cause->own(scene, item) * tr_pow(cause->finer, level);
    if (cause->whole && cause->finer != floor(cause->finer)) x = round(x);
    bool fits = x >= cause->least && x <= cause->most && (!cause->whole || x == floor(x));
    return fits ? x : NAN;
}
