/* SPDX-License-Identifier: MIT */
/* PCG32 random numbers (XSH-RR, 64-bit state), Source [ONeill2014]. Same seed, same numbers, on every machine. */
#ifndef TR_RANDOM_H
#define TR_RANDOM_H

#include <stdint.h>

typedef struct tr_random {
    uint64_t state, stream;
} tr_random;

tr_random tr_random_seed(uint64_t seed, uint64_t stream);
uint32_t tr_random_next(tr_random *r);
double tr_random_uniform(tr_random *r); /* uniform in [0, 1), 32 bits */

#endif
