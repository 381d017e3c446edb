/* SPDX-License-Identifier: MIT */
/* What the files of the group `exact` share. */
#include "verify/exact.h"

#include "core/pipeline.h"
#include "laws/law.h"
#include <stdio.h>
#include <string.h>

const void *tr_exact_find(const tr_verify *v, const char *prefix, const void *rows, size_t n, size_t size,
                          tr_status *st) {
    size_t used = strlen(prefix);
    bool fits = strncmp(v->now->name, prefix, used) == 0;
    for (const char *row = rows; fits && row < (const char *)rows + n * size; row += size)
        if (strcmp(*(const char *const *)(const void *)row, v->now->name + used) == 0) return row;
    tr_status_fail(st, TR_BAD_CASE, "error: the verification %s has no row in its table of laws", v->now->name);
    return NULL;
}

static bool drive(const tr_scene *scene, tr_contact_state *end, int n, tr_status *st) {
    tr_contact *contact = tr_contact_new(scene, st);
    tr_contact_state state[TR_MAX_LAWS];
    bool ok = contact != NULL;
    for (int64_t k = tr_contact_steps(scene); ok && k > 0; k--) {
        ok = tr_contact_step(contact, state, st);
        if (ok && state[0].segment < n) end[state[0].segment] = state[0];
    }
    tr_contact_free(contact);
    return ok;
}

bool tr_exact_path(const char *text, tr_contact_state *end, int n, tr_scene_pair *pair, tr_status *st) {
    tr_scene scene;
    if (!tr_scene_read(&scene, &(tr_scene_source){"path", text, strlen(text), NULL, 0}, tr_laws_catalog(), st))
        return false;
    if (pair) *pair = scene.pair;
    bool ok = drive(&scene, end, n, st);
    tr_scene_free(&scene);
    return ok;
}

bool tr_exact_laws(tr_world *world, const char *contact, unsigned sinks, tr_status *st) {
    char text[400];
    tr_scene scene;
    snprintf(text, sizeof text,
             "kind: bodies\ntime_end: 1\ncontact: {%s}\ndisks: [{radius: 1, density: 1, x: 0, y: 0}]\n", contact);
    if (!tr_scene_read(&scene, &(tr_scene_source){"laws", text, strlen(text), NULL, 0}, tr_laws_catalog(), st))
        return false;
    bool ok = tr_world_set_laws(world, &scene.contact, false, sinks, st);
    tr_scene_free(&scene);
    return ok;
}
