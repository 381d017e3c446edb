/* SPDX-License-Identifier: MIT */
/* The reader of cases, with --set. Parts: the case, then one text KEY=VALUE for each --set. What is read must come back
 * from the resolved case as the same text. */
#include "fuzz.h"
#include "laws/law.h"
#include "scene/scene.h"
#include "scene/write.h"

enum { SETS = 4 };

static void check_again(const tr_scene *scene) {
    tr_status st = {0};
    tr_scene again;
    char *text = tr_scene_write(scene, tr_laws_catalog(), &st);
    if (!text) abort();
    if (!tr_scene_read(&again, &(tr_scene_source){"resolved", text, strlen(text), NULL, 0}, tr_laws_catalog(), &st)) {
        fprintf(stderr, "%s\n%s\n", text, st.text);
        abort();
    }
    char *twice = tr_scene_write(&again, tr_laws_catalog(), &st);
    if (!twice || strcmp(text, twice)) abort();
    free(text), free(twice);
    tr_scene_free(&again);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const uint8_t *part;
    char *set[SETS];
    const char *given[SETS];
    int n = 0;
    size_t length = fuzz_part(data, size, 0, &part);
    for (int k = 1; k <= SETS; k++) {
        const uint8_t *text;
        size_t m = fuzz_part(data, size, k, &text);
        if (m) given[n] = set[n] = strndup((const char *)text, m), n++;
    }
    tr_status st = {0};
    tr_scene scene;
    if (tr_scene_read(&scene, &(tr_scene_source){"fuzz", (const char *)part, length, given, n}, tr_laws_catalog(),
                      &st)) {
        check_again(&scene);
        tr_scene_free(&scene);
    }
    while (n) free(set[--n]);
    return 0;
}
