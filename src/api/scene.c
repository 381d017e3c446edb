/* SPDX-License-Identifier: MIT */
#include "api/api.h"
#include "base/alloc.h"
#include "base/version.h"
#include "laws/law.h"

#include <stdlib.h>
#include <string.h>

const char *trundle_version(void) {
    return TR_VERSION;
}

static trundle_scene *finish(trundle_scene *s, bool ok, const tr_status *st, trundle_error *error) {
    tr_api_tell(st, error);
    if (ok) return s;
    free(s);
    return NULL;
}

trundle_scene *trundle_scene_read_file(const char *path, const char *const *sets, int n_sets, trundle_error *error) {
    tr_status st = {0};
    trundle_scene *s = tr_alloc(1, sizeof *s, &st);
    bool ok = s && tr_scene_read_file(&s->scene, path, sets, n_sets, tr_laws_catalog(), &st);
    return finish(s, ok, &st, error);
}

trundle_scene *trundle_scene_read(const char *name, const char *text, const char *const *sets, int n_sets,
                                  trundle_error *error) {
    tr_status st = {0};
    trundle_scene *s = tr_alloc(1, sizeof *s, &st);
    bool ok = s && tr_scene_read(&s->scene, name, text, strlen(text), sets, n_sets, tr_laws_catalog(), &st);
    return finish(s, ok, &st, error);
}

void trundle_scene_free(trundle_scene *s) {
    if (!s) return;
    tr_scene_free(&s->scene);
    free(s);
}
