/* SPDX-License-Identifier: MIT */
/* Error against time: one contact along a prescribed path with reversals of sliding, rolling and load,
 * cases/contact-reversal.yaml with the same number of steps in each segment. Error: the largest |Q - Q_exact| at 25
 * instants of each segment, over mu and the largest P.
 *
 * References: path_reference.h.
 */
#include "base/alloc.h"
#include "laws/law.h"
#include "study/contact.h"
#include "verify/path_reference.h"
#include "verify/precision.h"

#include <stdlib.h>
#include <string.h>

static const char text[] = "kind: contact\nbodies: {R1: 10 mm, R2: 10 mm, E: 70 GPa, nu: 0.3}\n"
                           "laws:\n"
                           "  - {friction: dahlberg-alfredsson, mu: 0.3, k_t: 0.35*E_star}\n"
                           "  - {friction: dahlberg-alfredsson, mu: 0.3, k_t: 0.35*E_star, step: exact}\n"
                           "  - {friction: coulomb-spring, mu: 0.3, k_t: 0.35*E_star}\n"
                           "  - {friction: cattaneo-mindlin, mu: 0.3}\n"
                           "  - {friction: kuhn-creep, mu: 0.3}\n"
                           "  - {friction: vu-quoc-zhang, mu: 0.3}\n"
                           "path:\n"
                           "  - {force: 10 kN/m, slide: 0.18 um, roll: 3*a, steps: 400}\n"
                           "  - {force: 22.5 kN/m, slide: -0.5 um, roll: -2*a, steps: 400}\n"
                           "  - {force: P, roll: 3*a, steps: 400}\n"
                           "  - {force: 0, slide: 0.3 um, steps: 400}\n"
                           "  - {force: 10 kN/m, slide: 0.3 um, steps: 400}\n";

enum {
    DAHLBERG,
    DAHLBERG_EXACT,
    SPRING,
    CATTANEO,
    KUHN,
    VU_QUOC,
    N_LAWS,
    INSTANTS = TR_PATH_INSTANTS,
    SEGMENTS = 5,
    COARSEST = 25,
    LEVELS = 9
};

typedef struct bench {
    tr_scene scene;
    double exact[N_LAWS][SEGMENTS * INSTANTS], finest[N_LAWS], largest[N_LAWS];
} bench;

/* ---- the laws */

static bool drive(const bench *b, int law, int steps, double *Q_at, double *seconds, tr_status *st) {
    tr_scene scene = b->scene; /* its arrays are shared; steps are set again for every run */
    for (int g = 0; g < SEGMENTS; g++) scene.path[g].steps = steps;
    scene.laws += law, scene.n_laws = 1;
    tr_contact *c = tr_contact_new(&scene, st);
    bool ok = c;
    double start = tr_sweep_now();
    for (int i = 1; i <= SEGMENTS * steps && ok; i++) {
        tr_contact_state s;
        ok = tr_contact_step(c, &s, st);
        if (i % (steps / INSTANTS) == 0) *Q_at++ = s.Q;
    }
    *seconds = tr_sweep_now() - start;
    tr_contact_free(c);
    return ok;
}

static bool run(void *context, int law, int k, tr_sweep_result *result, tr_status *st) {
    bench *b = context;
    double Q[SEGMENTS * INSTANTS], error = 0, seconds, size = 0.3 * 22.5e3;
    int steps = COARSEST << k;
    if (!drive(b, law, steps, Q, &seconds, st)) return false;
    for (int i = 0; i < SEGMENTS * INSTANTS; i++) error = fmax(error, fabs(Q[i] - b->exact[law][i]) / size);
    b->finest[law] = error, b->largest[law] = fmax(b->largest[law], error);
    *result = (tr_sweep_result){1.0 / steps, error, seconds};
    return true;
}

/* What no step removes. */
static bool add_limits(tr_verify *v, const bench *b, tr_status *st) {
    return tr_verify_add(v,
                         &(tr_verify_row){.quantity = "coulomb-spring: largest error at any step",
                                          .unit = "1",
                                          .computed = b->largest[SPRING],
                                          .tolerance = 1e-10,
                                          .reason = "exact at the end of any step; 1e5 roundings of the reference",
                                          .order = NAN},
                         st) &&
           tr_verify_add(
               v,
               &(tr_verify_row){
                   .quantity = "dahlberg-alfredsson exact: largest error at any step",
                   .unit = "1",
                   .computed = b->largest[DAHLBERG_EXACT],
                   .tolerance = 1e-10,
                   .reason = "a step to 1e-13 of mu P, and such errors do not grow; 1e5 roundings of the reference",
                   .order = NAN},
               st) &&
           tr_verify_add(
               v,
               &(tr_verify_row){.quantity = "laws on the bed: error that no step removes",
                                .unit = "1",
                                .computed = fmax(fmax(b->largest[CATTANEO], b->largest[KUHN]), b->finest[VU_QUOC]),
                                .tolerance = 9e-4,
                                .reason = "16 breakpoints: see laws/bed.h",
                                .order = NAN},
               st);
}

bool tr_precision_path(tr_verify *v, tr_status *st) {
    static const tr_sweep_method method[N_LAWS] = {
        {"dahlberg-alfredsson", 1, 0.2, "backward Euler: first order"},
        {"dahlberg-alfredsson exact", NAN, 0, NULL},
        {"coulomb-spring", NAN, 0, NULL},
        {"cattaneo-mindlin", NAN, 0, NULL},
        {"kuhn-creep", NAN, 0, NULL},
        {"vu-quoc-zhang", 1, 0.2, "a stands still over a step: first order, until breakpoints are merged"},
    };
    bench *b = tr_alloc(1, sizeof *b, st);
    bool ok =
        b && tr_scene_read(&b->scene, &(tr_scene_source){"case", text, strlen(text), NULL, 0}, tr_laws_catalog(), st);
    if (ok) {
        tr_path_equation(&b->scene, 0.35, 0.3, false, b->exact[SPRING]);
        tr_path_equation(&b->scene, 0.35, 0.3, true, b->exact[DAHLBERG]);
        memcpy(b->exact[DAHLBERG_EXACT], b->exact[DAHLBERG], sizeof *b->exact);
        ok = tr_path_bed(&b->scene, 0.3, TR_NO_CREEP, b->exact[CATTANEO], st) &&
             tr_path_bed(&b->scene, 0.3, TR_CARTER_CREEP, b->exact[KUHN], st) &&
             tr_path_bed(&b->scene, 0.3, TR_FADING, b->exact[VU_QUOC], st);
    }
    const tr_sweep sweep = {.step_name = "step / segment",
                            .method = method,
                            .methods = N_LAWS,
                            .steps = LEVELS,
                            .repeats = 7,
                            .floor = 1.4e-4, /* bed.h */
                            .usual = 4,      /* the 400 of the case */
                            .goal = 5e-3,
                            .reason = "first order: 400 steps of a roll of 3a, to q = 1 over Lambda a",
                            .run = run,
                            .context = b};
    ok = ok && tr_sweep_add(v, &sweep, st) && add_limits(v, b, st);
    if (b) tr_scene_free(&b->scene);
    free(b);
    return ok;
}
