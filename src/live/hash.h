/* SPDX-License-Identifier: MIT */
/* A number made of all bits of the positions of a world: two programs with the same number have moved alike. */
#ifndef TR_LIVE_HASH_H
#define TR_LIVE_HASH_H

#include "trundle.h"
#include <stdint.h>
#include <string.h>

static inline uint64_t live_hash_of(const trundle_world *world) {
    uint64_t hash = 0xcbf29ce484222325u; /* FNV-1a, of 64 bits at a time */
    for (int i = 0; i < trundle_world_count(world); i++) {
        trundle_disk d;
        trundle_world_disk(world, i, &d, NULL);
        const double x[] = {d.x, d.y, d.angle};
        uint64_t bits[3];
        memcpy(bits, x, sizeof bits);
        for (int k = 0; k < 3; k++) hash = (hash ^ bits[k]) * 0x100000001b3u, hash ^= hash >> 29;
    }
    return hash;
}

#endif
