/* SPDX-License-Identifier: MIT */
/* A case in the library of this machine: the number of all positions after STEPS steps, or why it is refused. What
 * tests/live/bits.mjs does in WebAssembly. usage: native STEPS CASE.yaml... */
#include "live/hash.h"
#include <stdio.h>
#include <stdlib.h>

int main(int argc, char **argv) {
    for (int i = 2; i < argc; i++) {
        trundle_error error = {0};
        trundle_scene *scene = trundle_scene_read_file(argv[i], NULL, 0, &error);
        trundle_world *world = scene ? trundle_world_new(scene, &error) : NULL;
        int code = world ? trundle_world_step(world, atoi(argv[1]), &error) : error.code;
        if (code == TRUNDLE_OK)
            printf("%s %016llx\n", argv[i], (unsigned long long)live_hash_of(world));
        else
            printf("%s\n", error.text);
        trundle_world_free(world);
        trundle_scene_free(scene);
    }
    return 0;
}
