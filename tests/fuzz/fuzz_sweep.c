/* SPDX-License-Identifier: MIT */
/* The file of a sweep. Its base is base.yaml. */
#include "fuzz.h"
#include "study/sweep.h"
#include "study/sweep_read.h"

static const char base[] = "kind: biaxial\nsample: {disks: 60, r_min: 0.76 mm, r_max: 1.52 mm}\n"
                           "contact: {k_n: 160 MPa, mu: 0.5, mu_r: 0.5}\ncompaction: {pressure: 160 kPa}\n";

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static bool begun;
    tr_status st = {0};
    tr_grid g;
    if (!begun) fuzz_file("base.yaml", base, sizeof base - 1), begun = true;
    if (tr_grid_read(&g, fuzz_file("sweep.yaml", data, size), false, &st)) {
        char name[TR_POINT_NAME];
        for (int k = 0; k < g.n && k < 3; k++) {
            tr_scene scene;
            tr_grid_name(&g, k, name);
            if (tr_grid_scene(&g, k, &scene, &st)) tr_scene_free(&scene);
        }
    }
    tr_grid_free(&g);
    return 0;
}
