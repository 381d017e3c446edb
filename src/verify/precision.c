/* SPDX-License-Identifier: MIT */
/* Group `precision`: the registry. */
#include "verify/verify.h"

const tr_verification tr_verify_precision[1] = {{0}};
const int tr_n_verify_precision = 0;
