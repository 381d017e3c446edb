/* SPDX-License-Identifier: MIT */
#include "base/random.h"

/* state' = state * M + (2 stream + 1); output: xorshift the high bits down, rotate by the top five. [ONeill2014 6.3] */
uint32_t tr_random_next(tr_random *r) {
    uint64_t old = r->state;
    r->state = old * 6364136223846793005u + r->stream;
    uint32_t shifted = (uint32_t)(((old >> 18) ^ old) >> 27);
    unsigned turn = (unsigned)(old >> 59);
    return shifted >> turn | shifted << (-turn & 31u);
}

tr_random tr_random_seed(uint64_t seed, uint64_t stream) {
    tr_random r = {0, stream << 1 | 1u};
    tr_random_next(&r);
    r.state += seed;
    tr_random_next(&r);
    return r;
}

double tr_random_uniform(tr_random *r) {
    return tr_random_next(r) * 0x1p-32;
}
