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

/* path NULL: of the text. */
static trundle_scene *scene_of(const char *path, const char *name, const char *text, const char *const *sets,
                               int n_sets, trundle_error *error) {
    tr_status st = {0};
    trundle_scene *s = NULL;
    tr_api_locale l = tr_api_locale_enter(&st);
    if (n_sets < 0) tr_status_fail(&st, TR_BAD_CASE, "error: the number of sets is negative");
    bool ok = !st.code && (s = tr_alloc(1, sizeof *s, &st)) &&
              (path ? tr_scene_read_file(&s->scene, path, sets, n_sets, tr_laws_catalog(), &st)
                    : tr_scene_read(&s->scene, &(tr_scene_source){name, text, strlen(text), sets, n_sets},
                                    tr_laws_catalog(), &st));
    tr_api_locale_leave(l);
    tr_api_tell(&st, error);
    if (ok) return s;
    free(s);
    return NULL;
}

trundle_scene *trundle_scene_read_file(const char *path, const char *const *sets, int n_sets, trundle_error *error) {
    return scene_of(path, NULL, NULL, sets, n_sets, error);
}

trundle_scene *trundle_scene_read(const char *name, const char *text, const char *const *sets, int n_sets,
                                  trundle_error *error) {
    return scene_of(NULL, name, text, sets, n_sets, error);
}

void trundle_scene_free(trundle_scene *s) {
    if (!s) return;
    tr_scene_free(&s->scene);
    free(s);
}
