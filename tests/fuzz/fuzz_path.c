/* SPDX-License-Identifier: MIT */
/* The path of a contact from a file. */
#include "fuzz.h"
#include "laws/law.h"
#include "study/path.h"

static const char text[] = "kind: contact\nbodies: {R1: 10 mm, R2: 10 mm, E: 70 GPa, nu: 0.3, density: 2700}\n"
                           "laws:\n  - {friction: dahlberg-alfredsson, mu: 0.3, k_t: 10 GPa}\n"
                           "  - {friction: none, rolling: star-displacement-damping, mu_r: 0.1}\npath: {}\n";

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    char set[TR_PATH + 8];
    const char *sets[] = {set};
    tr_status st = {0};
    tr_scene scene;
    snprintf(set, sizeof set, "path=%s", fuzz_file("path.csv", data, size));
    if (!tr_scene_read(&scene, &(tr_scene_source){"fuzz", text, sizeof text - 1, sets, 1}, tr_laws_catalog(), &st)) {
        fprintf(stderr, "%s\n", st.text);
        abort();
    }
    if (tr_path_read(&scene, &st)) free(scene.path), scene.path = NULL;
    tr_scene_free(&scene);
    return 0;
}
