/* SPDX-License-Identifier: MIT */
/* One driven contact: every law where its formula divides by a number that goes to 0. Rolling without sliding must make
 * no friction, sliding of equal disks without rolling no rolling moment; friction must stay within mu P when P falls to
 * 0 under it. */
#include "base/alloc.h"
#include "study/contact.h"
#include "verify/stability.h"
#include <float.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define HEAD "kind: contact\nbodies: {R1: 10 mm, R2: 10 mm, E: 70 GPa, nu: 0.3, density: 2700}\n"
#define FRICTION                                                                                                       \
    "laws:\n  - {friction: coulomb-spring, mu: 0.3, k_t: 10 GPa}\n  - {friction: dahlberg-alfredsson, mu: 0.3, k_t: "  \
    "10 GPa}\n"                                                                                                        \
    "  - {friction: cattaneo-mindlin, mu: 0.3}\n  - {friction: kuhn-creep, mu: 0.3}\n  - {friction: vu-quoc-zhang, "   \
    "mu: 0.3}\n"                                                                                                       \
    "  - {friction: exact, mu: 0.3, elements: 64}\n"
#define ROLLING                                                                                                        \
    "laws:\n  - {rolling: wang-spring, mu_r: 0.1, k_r: 1 GPa}\n  - {rolling: conjugate-spring, rolling_velocity: "     \
    "bagi-kuhn, mu_r: 0.1, k_r: 1 "                                                                                    \
    "GPa}\n"                                                                                                           \
    "  - {rolling: star-constant-torque, mu_r: 0.1}\n  - {rolling: star-displacement-damping, mu_r: 0.1, damping: "    \
    "yes}\n"                                                                                                           \
    "  - {rolling: star-force-proportional, mu_r: 0.1}\n"

enum { FRICTIONS = 6, ROLLINGS = 5 };
static const char *const friction_name[] = {"coulomb-spring", "dahlberg-alfredsson", "cattaneo-mindlin",
                                            "kuhn-creep",     "vu-quoc-zhang",       "exact"};
static const char *const rolling_name[] = {"wang-spring", "conjugate-spring", "star-constant-torque",
                                           "star-displacement-damping", "star-force-proportional"};

/* The largest over the path, of each law: |Q|/(mu P), rolling moment/(mu_r P R), |Q|, and the last Q/(mu P). */
typedef struct extremes {
    double q[TR_MAX_LAWS], moment[TR_MAX_LAWS], open[TR_MAX_LAWS], last[TR_MAX_LAWS];
} extremes;

static bool drive(tr_verify *v, const char *text, extremes *e, tr_status *st) {
    tr_scene scene;
    tr_contact_state s[TR_MAX_LAWS];
    *e = (extremes){0};
    if (!tr_scene_read(&scene, &(tr_scene_source){v->now->name, text, strlen(text), NULL, 0}, tr_laws_catalog(), st))
        return false;
    tr_contact *contact = tr_contact_new(&scene, st);
    bool ok = contact != NULL;
    for (int64_t k = 0; ok && k < tr_contact_steps(&scene) && (ok = tr_contact_step(contact, s, st)); k++)
        for (int i = 0; i < scene.n_laws; i++) {
            e->q[i] = fmax(e->q[i], fabs(s[i].q)), e->last[i] = s[i].q;
            if (s[i].P > 0) e->moment[i] = fmax(e->moment[i], fabs(s[i].moment_1) / (0.1 * s[i].P * 0.01));
            if (s[i].P == 0) e->open[i] = fmax(e->open[i], fabs(s[i].Q) + fabs(s[i].moment_1) + fabs(s[i].f_r));
        }
    tr_contact_free(contact);
    tr_scene_free(&scene);
    return ok && tr_verify_go_on(v, st);
}

/* Numbers of n laws. */
typedef struct values {
    const double *value;
    const char *const *law;
    int n;
} values;

/* The law that is furthest from the reference. */
static bool worst(tr_verify *v, const char *what, values of, double reference, double tolerance, const char *reason,
                  tr_status *st) {
    char quantity[80];
    int far = 0;
    for (int i = 1; i < of.n; i++)
        if (fabs(of.value[i] - reference) > fabs(of.value[far] - reference)) far = i;
    snprintf(quantity, sizeof quantity, "%s, worst %s", what, of.law[far]);
    return tr_verify_add(v, &(tr_verify_row){quantity, "1", reference, of.value[far], tolerance, reason, NAN, NULL},
                         st);
}

bool tr_stability_pure_motions(tr_verify *v, tr_status *st) {
    const char *const spin = rolling_name[ROLLINGS - 1]; /* brakes each body's own spin, also of equal ones */
    extremes e;
    return drive(v, HEAD FRICTION "path: [{force: 10 kN/m, roll: 20*a, steps: 200}]\n", &e, st) &&
           worst(v, "rolling alone: Q/(mu P)", (values){e.q, friction_name, FRICTIONS}, 0, 1e-9,
                 "rounding of s1 - s2 times k_t", st) &&
           drive(v, HEAD FRICTION "path: [{force: 10 kN/m, slide: 30 um, steps: 300}]\n", &e, st) &&
           worst(v, "sliding alone: Q/(mu P)", (values){e.last, friction_name, FRICTIONS}, 1, 1e-9, "rounding", st) &&
           drive(v, HEAD ROLLING "path: [{force: 10 kN/m, slide: 100 um, steps: 100, time: 1 s}]\n", &e, st) &&
           worst(v, "sliding alone: M/(mu_r P R)", (values){e.moment, rolling_name, ROLLINGS - 1}, 0, 1e-9, "rounding",
                 st) &&
           worst(v, "sliding alone: M/(mu_r P R)", (values){e.moment + ROLLINGS - 1, &spin, 1}, 1, 1e-9, "rounding",
                 st);
}

bool tr_stability_unloading(tr_verify *v, tr_status *st) {
    static const char path[] =
        "path: [{force: 10 kN/m, slide: 5 um, roll: 0.2*a, steps: 100},\n"
        "  {force: 1 N/m, roll: 0.02*a, steps: 100}, {force: 1e-12 N/m, slide: 1e-9 m, steps: 3},\n"
        "  {force: 0, slide: 1e-9 m, roll: 1e-9 m, steps: 3}, {force: 0, slide: 1e-9 m, roll: 1 um, steps: 2},\n"
        "  {force: 1e-12 N/m, slide: -1e-9 m, roll: 1e-9 m, steps: 3}, {force: 10 kN/m, slide: 1 um, steps: 50}]\n";
    char text[2000];
    extremes e;
    snprintf(text, sizeof text, "%s%s%s", HEAD, FRICTION, path);
    bool ok = drive(v, text, &e, st);
    return ok &&
           worst(v, "largest Q/(mu P) while P falls to 0", (values){e.q, friction_name, FRICTIONS}, 1, 1e-9,
                 "full slip, and no more", st) &&
           worst(v, "Q left at P = 0", (values){e.open, friction_name, FRICTIONS}, 0, 0, "no contact, no force", st);
}
