/* SPDX-License-Identifier: MIT */
/* FNV-1a, 64 bits: sees any change of one byte. Not against malice. */
#ifndef TR_HASH_H
#define TR_HASH_H

#include <stddef.h>
#include <stdint.h>

static const uint64_t TR_HASH_BEGIN = 0xcbf29ce484222325;

/* Continues from `hash`; starts with TR_HASH_BEGIN. */
static inline uint64_t tr_hash(uint64_t hash, const void *bytes, size_t n) {
    const unsigned char *p = (const unsigned char *)bytes;
    for (size_t i = 0; i < n; i++) hash = (hash ^ p[i]) * 0x100000001b3;
    return hash;
}

#endif
