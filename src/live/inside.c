/* SPDX-License-Identifier: MIT */
/* The inside of one contact, for the page: a case of kind: patch, step by step, as `trundle run` takes it. */
#include "study/inside.h"
#include "laws/law.h"
#include "live/live.h"

#include <stdio.h>
#include <string.h>

static tr_scene scene;
static tr_inside *inside;
static int64_t left; /* steps of the path to come */

static struct inside_now { double steps, n, rolls, P, a, Q, q, u_slide, u_roll, creepage, stick, dissipated; } now;
static struct inside_element { double x, p, tau, slip, side; } element[TR_PATCH_MAX];

static int tell(const tr_status *st) {
    live_failed.code = (int)st->code;
    snprintf(live_failed.text, sizeof live_failed.text, "%s", st->text);
    return live_failed.code;
}

/* The case in the text buffer. Returns the code of the error. */
int EXPORT(live_inside_open)(void) {
    tr_status st = {0};
    tr_inside_free(inside), inside = NULL;
    tr_scene_free(&scene);
    now = (struct inside_now){0}, left = 0;
    if (!tr_scene_read(&scene, &(tr_scene_source){"case.yaml", live_text(), strlen(live_text()), NULL, 0},
                       tr_laws_catalog(), &st) ||
        !(inside = tr_inside_new(&scene, &st)))
        return tell(&st);
    for (int i = 0; i < scene.n_segments; i++) left += scene.path[i].steps;
    now.n = scene.patch.elements;
    return TRUNDLE_OK;
}

/* Up to n steps: the path has an end. */
int EXPORT(live_inside_go)(int n) {
    tr_status st = {0};
    tr_contact_state s = {0};
    for (; n > 0 && left > 0; n--, left--) {
        if (!tr_inside_step(inside, &s, &st)) return tell(&st);
        now = (struct inside_now){(double)s.step,
                                  now.n,
                                  scene.path[s.segment].roll,
                                  s.P,
                                  s.a,
                                  s.Q,
                                  s.q,
                                  s.u_slide,
                                  s.u_roll,
                                  s.creepage,
                                  s.stick,
                                  s.dissipated};
    }
    return TRUNDLE_OK;
}

/* From steps on, 12 doubles. */
const struct inside_now *EXPORT(live_inside_state)(void) {
    return &now;
}

/* n times x, p, tau, slip of the last step, side. */
const struct inside_element *EXPORT(live_inside_elements)(void) {
    const tr_patch_state *s = tr_inside_patch(inside);
    for (int i = 0; i < s->n; i++)
        element[i] = (struct inside_element){s->x[i], s->p[i], s->tau[i], s->slip[i], s->side[i]};
    return element;
}
