/* SPDX-License-Identifier: MIT */
/* The packing that sample.file names. A disk that is taken is in its box, and its numbers are finite. */
#include "fuzz.h"
#include "study/sample_file.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    tr_status st = {0};
    tr_scene scene = {.kind = TR_KIND_BIAXIAL, .boundary = size % 2 ? TR_PERIODIC : TR_WALLS};
    snprintf(scene.sample.file, sizeof scene.sample.file, "%.200s", fuzz_file("sample.csv", data, size));
    if (tr_sample_file_read(&scene, &st))
        for (int i = 0; i < scene.sample.disks; i++)
            for (int axis = 0; axis < 2; axis++) {
                double v = scene.sample.place[4 * i + axis];
                if (!(v >= 0 && v <= scene.sample.side[axis])) abort();
            }
    tr_scene_free(&scene);
    return 0;
}
