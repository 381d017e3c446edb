/* SPDX-License-Identifier: MIT */
/* A case in the library of this machine: the number of all positions after STEPS steps, or why it is refused. What
 * tests/live/bits.mjs does in WebAssembly. usage: native STEPS CASE.yaml...
 *                                                or: native cycle R1,R2,overlap,du,dtheta,STEPS,LAWS... */
#include "live/cycle.h"
#include "live/hash.h"
#include <stdio.h>
#include <stdlib.h>

static unsigned long long bits_of(double x) {
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

/* All bits of the work of a cycle. */
static void cycle(const char *text) {
    trundle_error error = {0};
    live_cycle c = {0};
    int steps = 0, used = 0, code = TRUNDLE_OK;
    sscanf(text, "%lf,%lf,%lf,%lf,%lf,%d,%n", &c.R1, &c.R2, &c.overlap, &c.du, &c.dtheta, &steps, &used);
    const trundle_pair pair = {.R1 = c.R1, .R2 = c.R2, .density1 = 1000, .density2 = 1000};
    trundle_contact *contact = trundle_contact_new(text + used, &pair, &error);
    for (int k = 0; contact && k < steps && !code; k++) code = live_cycle_step(&c, contact, &error);
    if (contact && !code)
        printf("%llx\n", bits_of(c.work));
    else
        printf("%s\n", error.text);
    trundle_contact_free(contact);
}

int main(int argc, char **argv) {
    for (int i = 2; i < argc; i++) {
        if (!strcmp(argv[1], "cycle")) {
            cycle(argv[i]);
            continue;
        }
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
