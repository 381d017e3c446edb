/* SPDX-License-Identifier: MIT */
#include "broad/choose.h"

const tr_broad_finder *tr_broad_choose(int n) {
    return n <= 32 ? &tr_broad_brute : &tr_broad_box2d;
}
