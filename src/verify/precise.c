/* SPDX-License-Identifier: MIT */
#include "laws/law.h"
#include "verify/precision.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_VARIANTS = 16 };

typedef struct bench {
    const tr_precise *what;
    tr_scene scene[MOST_VARIANTS];
    void *reference[MOST_VARIANTS];
} bench;

bool tr_precise_failed(tr_status *st) {
    if (st->code != TR_NUMERICAL) return false;
    *st = (tr_status){0};
    return true;
}

static bool run(void *context, int method, int k, tr_sweep_result *result, tr_status *st) {
    const bench *b = context;
    double sum = 0, seconds[MOST_VARIANTS];
    int n = b->what->variants;
    for (int i = 0; i < n; i++) {
        tr_scene scene = b->scene[i];
        scene.step.safety *= b->what->coarsest / (1 << k);
        tr_bodies bodies;
        if (!tr_bodies_init(&bodies, &scene, st)) return false;
        double start = tr_sweep_now();
        bool ok = tr_integrate(&bodies.world, (tr_integrator)method, bodies.steps, st);
        seconds[i] = tr_sweep_now() - start;
        double error = ok ? b->what->error(&bodies, b->reference[i]) : NAN;
        sum += error * error;
        *result = (tr_sweep_result){.step = bodies.world.dt, .error = sqrt(sum / n)};
        tr_bodies_free(&bodies);
        if (!ok && !tr_precise_failed(st)) return false;
    }
    result->seconds = tr_sweep_median(seconds, n);
    return true;
}

static bool read_scenes(bench *b, tr_status *st) {
    const tr_precise *c = b->what;
    for (int i = 0; i < c->variants; i++) {
        char set[80];
        const char *sets[] = {set};
        if (c->variants > 1)
            snprintf(set, sizeof set, "%s=%.17g", c->vary, c->from + (c->to - c->from) * i / c->variants);
        if (!tr_scene_read(&b->scene[i], &(tr_scene_source){"case", c->text, strlen(c->text), sets, c->variants > 1},
                           tr_laws_catalog(), st) ||
            (c->reference && !(b->reference[i] = c->reference(&b->scene[i], st))))
            return false;
    }
    return true;
}

bool tr_precise_add(tr_verify *v, const tr_precise *c, const tr_sweep_method *method, int methods, double goal,
                    const char *reason, tr_status *st) {
    bench b = {.what = c};
    const tr_sweep sweep = {.step_name = "dt [s]",
                            .method = method,
                            .methods = methods,
                            .steps = c->levels,
                            .repeats = c->repeats,
                            .usual = (int)lround(log2(c->coarsest)),
                            .goal = goal,
                            .reason = reason,
                            .run = run,
                            .context = &b};
    bool ok = read_scenes(&b, st) && tr_sweep_add(v, &sweep, st);
    for (int i = 0; i < c->variants; i++) tr_scene_free(&b.scene[i]), free(b.reference[i]);
    return ok;
}
