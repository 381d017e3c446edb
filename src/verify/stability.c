/* SPDX-License-Identifier: MIT */
/* Group `stability`: the registry. */
#include "verify/verify.h"

const tr_verification tr_verify_stability[1] = {{0}};
const int tr_n_verify_stability = 0;
